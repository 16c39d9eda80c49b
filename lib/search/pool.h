/* Routes that collect enough: all that a seeker may go in a game better than a target.
 *
 * Under prices (search/duals.h) that prove a bound on all games, a route that collects less than the most of its squad,
 * by what there is between bound and target or more, is in no game better than the target. What a route begun can still
 * collect C knows, filled with the same prices, for every place, moment and memory: so routes are grown place by place
 * from the starts, and given up as soon as they cannot collect enough. Of two that end at one place and have been to
 * the same ones, one that is there later and has collected no more is given up as well (Baldacci, Christofides,
 * Mingozzi 2008: route enumeration). */
#ifndef QUARTER_SEARCH_POOL_H
#define QUARTER_SEARCH_POOL_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "quarter/config.h"
#include "search/bound.h"
#include "search/duals.h"
#include "search/label.h"

/* Seekers of one kind that set out together: what one can go all can. */
typedef struct {
  uint8_t kind, count;
  uint16_t node;
  qtr_steps ready;
} qtr_squad;

/* A triple that a place is of: the other two of it, and its toll. */
typedef struct {
  uint16_t other[2];
  double toll;
} qtr_toll;

enum qtr_listing { QTR_LISTING = 0, QTR_LISTED = 1, QTR_POOL_FULL = 2 };

typedef struct {
  const qtr_bound *bound;
  const qtr_duals *duals;        /* in force */
  double least[QTR_MAX_SEEKERS]; /* of each squad: routes that collect no more are not listed */
  uint32_t squads;
  qtr_squad squad[QTR_MAX_SEEKERS];
  uint8_t squad_of[QTR_MAX_SEEKERS];
  uint32_t toll_begin[QTR_MAX_PLACES + 1]; /* of each place: the first of its triples in `toll` */
  qtr_toll toll[3 * QTR_MOST_TRIPLES];
  uint8_t *label; /* labels, `stride` bytes apart */
  uint32_t words; /* of a label's set */
  uint32_t stride, labels, labels_most, labels_room;
  uint32_t kept;                   /* of them in front, with the routes kept, whatever is listed behind */
  uint32_t layer_begin, layer_end; /* labels of as many places each, being grown from */
  uint32_t cursor;                 /* the next of them */
  uint32_t routes;                 /* labels that are routes: the best of their places and squad */
  uint32_t *head;                  /* of the layer being grown, by hash: the first label */
  uint32_t heads_most, heads;
} qtr_pool;

/* No routes, in a block aligned for a double. The bound, without aggregation, must outlive the pool. */
void qtr_pool_init(qtr_pool *pool, void *block, size_t bytes, const qtr_bound *bound);

/* What a bound's own prices come to as duals: C must be filled with them. */
void qtr_pool_duals(const qtr_pool *pool, qtr_duals *duals);

/* The bound on all games that duals prove, if no route of a squad collects more than its own. */
double qtr_pool_upper(const qtr_pool *pool, const qtr_duals *duals);

/* Begin to list the routes of each squad that collect more than its least, behind those kept. C must be filled with the
 * duals' prices (and tolls: qtr_gains_charge()), and both must stay as they are. */
void qtr_pool_begin(qtr_pool *pool, const qtr_duals *duals, const double *least);

/* Grow from so many labels at most. QTR_POOL_FULL: there is no room for more, and the list is of no use. */
enum qtr_listing qtr_pool_go_on(qtr_pool *pool, uint32_t count);

/* Keep routes: mark them one by one, then forget all others, and what was found of those being listed. Labels go by
 * other numbers then, in the order that they had; `count` numbers of marked ones are changed to those. */
void qtr_pool_mark(qtr_pool *pool, uint32_t label);
void qtr_pool_keep_marked(qtr_pool *pool, uint32_t *number, uint32_t count);

/* Forget all that are listed behind those kept. */
void qtr_pool_forget_listed(qtr_pool *pool);

static inline qtr_label *qtr_pool_label(const qtr_pool *pool, uint32_t label) {
  return (qtr_label *)(void *)(pool->label + (size_t)label * pool->stride);
}

/* Whether a label, once all are listed, is a route that counts. */
bool qtr_pool_is_route(const qtr_pool *pool, uint32_t label);

/* What a route collects, net of the duals in force, its way home counted; and what it is worth. */
double qtr_pool_net(const qtr_pool *pool, uint32_t label);
double qtr_pool_worth(const qtr_pool *pool, uint32_t label);

/* How many places are on it. */
unsigned qtr_pool_length(const qtr_pool *pool, uint32_t label);

/* Its places in the order of their visits; returns how many. */
unsigned qtr_pool_places(const qtr_pool *pool, uint32_t label, uint16_t *place);

/* What of the block so many labels take. What is behind those listed is free once all are; and what is behind
 * labels_most always, which may be set to less than labels_room. */
size_t qtr_pool_bytes(const qtr_pool *pool, uint32_t labels);

#endif

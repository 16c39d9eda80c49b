/* Routes within the gap: all that a seeker may go in a game better than a target.
 *
 * Under prices (search/bound.h) a game is worth no more than the sum of prices and of what each seeker's route
 * collects net of them. Where the bound on all games is `gap` above the target, a route that collects less than the
 * most of its seeker, by the gap or more, is in no game better than the target. What a route begun can still collect
 * C knows, for every place, moment and memory: so routes are grown place by place from the starts, and given up as
 * soon as they cannot be within the gap. Of two that end at one place and have been to the same ones, one that is
 * there later and has collected no more is given up as well (Baldacci, Christofides, Mingozzi 2008: route
 * enumeration). */
#ifndef QUARTER_SEARCH_POOL_H
#define QUARTER_SEARCH_POOL_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "quarter/config.h"
#include "search/bound.h"

#define QTR_NO_LABEL UINT32_MAX

/* A route up to its last place. */
typedef struct {
  double net;      /* worth of its visits, less their prices */
  qtr_steps when;  /* of the last one */
  uint32_t before; /* the label that it was grown from */
  uint32_t next;   /* with the same hash */
  uint16_t node;   /* where it ends */
  uint8_t squad;
  uint8_t state;
  uint32_t set[]; /* the places on it, bit p % 32 of word p / 32 for place p */
} qtr_label;

/* Seekers of one kind that set out together: what one can go all can. */
typedef struct {
  uint8_t kind, count;
  uint16_t node;
  qtr_steps ready;
  double most; /* that a route of theirs collects net of prices, as C has it */
} qtr_squad;

enum qtr_listing { QTR_LISTING = 0, QTR_LISTED = 1, QTR_POOL_FULL = 2 };

typedef struct {
  const qtr_bound *bound;
  double upper;   /* the bound on all games, as the prices in force have it */
  double gap;     /* from there to the target */
  uint32_t words; /* of a label's set */
  uint32_t squads;
  qtr_squad squad[QTR_MAX_SEEKERS];
  uint8_t squad_of[QTR_MAX_SEEKERS];
  uint8_t *label; /* labels, `stride` bytes apart */
  uint32_t stride, labels, labels_most;
  uint32_t layer_begin, layer_end; /* labels of as many places each, being grown from */
  uint32_t cursor;                 /* the next of them */
  uint32_t routes;                 /* labels that are routes: the best of their places and squad */
  uint32_t *head;                  /* of the layer being grown, by hash: the first label */
  uint32_t heads_most, heads;
} qtr_pool;

/* Begin to list the routes of games that are worth more than `target`, in a block aligned for a double. The bound must
 * be settled, without aggregation, and stay as it is. */
void qtr_pool_begin(qtr_pool *pool, void *block, size_t bytes, const qtr_bound *bound, double target);

/* Grow from so many labels at most. QTR_POOL_FULL: the block holds no more, and the list is of no use. */
enum qtr_listing qtr_pool_go_on(qtr_pool *pool, uint32_t count);

static inline qtr_label *qtr_pool_label(const qtr_pool *pool, uint32_t label) {
  return (qtr_label *)(void *)(pool->label + (size_t)label * pool->stride);
}

/* Whether a label, once all are listed, is a route that counts. */
bool qtr_pool_is_route(const qtr_pool *pool, uint32_t label);

/* What a route is worth, its way home counted. */
double qtr_pool_worth(const qtr_pool *pool, uint32_t label);

/* Its places in the order of their visits; returns how many. */
unsigned qtr_pool_places(const qtr_pool *pool, uint32_t label, uint16_t *place);

/* What of the block the labels take; what is behind is free once all are listed. */
size_t qtr_pool_bytes(const qtr_pool *pool);

static inline bool qtr_label_has(const qtr_label *label, unsigned place) {
  return (label->set[place / 32] >> (place % 32) & 1u) != 0;
}

#endif

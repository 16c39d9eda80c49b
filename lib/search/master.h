/* The linear programme that chooses among listed routes: a route for each seeker, each place on one of them, of each
 * triple's routes one at most (search/duals.h). Its columns are the routes of a pool, of which the simplex method sees
 * those that gain most; the programme is solved when none of them does.
 *
 * The simplex method only proposes prices. What they prove is added up anew from all routes, by qtr_master_look().
 */
#ifndef QUARTER_SEARCH_MASTER_H
#define QUARTER_SEARCH_MASTER_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "search/duals.h"
#include "search/pool.h"
#include "search/simplex.h"
#include "search/triples.h"

#define QTR_MASTER_ACTIVE 512u
#define QTR_MASTER_ROWS (QTR_MAX_PLACES + QTR_MAX_SEEKERS + QTR_MOST_TRIPLES)
#define QTR_MASTER_LEAST_SHARE 1e-4 /* of a route: what is less is none, or rows that are shifted */

/* A route that may be chosen. */
typedef struct {
  double worth; /* its way home counted */
  double net;   /* of prices, when last looked at */
  uint32_t label;
  uint8_t off; /* what rules it out, from 1 on; 0: nothing does */
  bool in_basis;
  uint8_t counts[QTR_MOST_TRIPLES / 8]; /* bit t % 8 of byte t / 8: for triple t */
} qtr_choice;

typedef struct {
  const qtr_pool *pool;
  qtr_choice *choice;
  uint32_t choices;
  qtr_simplex simplex;
  qtr_triple triple[QTR_MOST_TRIPLES];
  uint32_t triples;
  double scale;        /* what a place counts for, about */
  double least_gain;   /* of a column: what is less is nothing */
  double penalty;      /* for each row of a column that is ruled out */
  uint32_t entered;    /* columns since all were looked at */
  double *price;       /* as looked at with: no slack's below 0 */
  double *sum_of_byte; /* of prices, for each byte of a set and its 256 values */
  double *toll_of_byte;
  uint32_t *active; /* choices that may enter, their rows behind one another */
  uint32_t actives;
  uint16_t *row;
  uint32_t *row_begin;
  const qtr_label **mixed; /* routes in a mixture, and their shares */
  double *share;
} qtr_master;

/* How far prices may go from those that they begin at, in parts of the scale. */
typedef struct {
  double of_places, of_squads;
} qtr_boxes;

/* What a programme ended in, for one of the same rows, and more behind them, to begin with. */
typedef struct {
  uint32_t rows; /* 0: nothing is known */
  uint32_t routes;
  uint32_t label[QTR_MASTER_ROWS]; /* routes in the basis */
  int32_t elastic[QTR_MASTER_ROWS];
} qtr_basis;

/* Rows that there is room for: of triples. */
uint32_t qtr_master_triples_most(const qtr_pool *pool);

/* Begin with the routes of a pool, whose listing is over, in a block aligned for a double, at prices that are near the
 * programme's, and with a basis of routes among them. False: the block is too small. */
bool qtr_master_begin(qtr_master *master, const qtr_pool *pool, void *block, size_t bytes, const qtr_duals *from,
                      const qtr_basis *basis, const qtr_boxes *boxes);

void qtr_master_basis(const qtr_master *master, qtr_basis *basis);

/* A gain is nothing that is next to nothing beside a gap, and beside the worth that is aimed at. */
void qtr_master_be_as_fine(qtr_master *master, double gap, double target);

/* Look at all routes by the prices at hand. Returns the bound on games of the routes that are not ruled out, and the
 * most that one of each squad collects. */
double qtr_master_look(qtr_master *master, double *most);

/* List the routes that may enter, after a look. */
void qtr_master_list_active(qtr_master *master);

/* Some pivots. False: no more of those listed gains, and it is time to look again; the programme is solved when nothing
 * has entered since the last look. */
bool qtr_master_pivot(qtr_master *master);

static inline bool qtr_master_is_solved(const qtr_master *master) {
  return master->entered == 0;
}

/* What prices the programme is at, tolls of 0 or more, and the squads' left as they are. */
void qtr_master_duals(const qtr_master *master, qtr_duals *duals);

/* Routes in shares, as the programme has them at hand; until the next pivot. */
qtr_mixture qtr_master_mixture(const qtr_master *master);

/* Mark what is in the basis, or no more. */
void qtr_master_mark_basis(qtr_master *master, bool in_basis);

/* Drop what is ruled out for good. */
void qtr_master_compact(qtr_master *master);

/* Add triples that a mixture breaks; those without a toll give way where there is no room. False: there are none. */
bool qtr_master_add_triples(qtr_master *master, const qtr_mixture *mixture);

/* Ruled out, and yet in use: what it costs is raised. False: there is none. */
bool qtr_master_raise_penalty(qtr_master *master);

static inline const qtr_label *qtr_master_label(const qtr_master *master, uint32_t choice) {
  return qtr_pool_label(master->pool, master->choice[choice].label);
}

#endif

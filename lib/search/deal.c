#include "search/deal.h"

#include <math.h>
#include <stdint.h>

#include "core/block.h"
#include "model/rounding.h"
#include "quarter/status.h"

typedef struct {
  const qtr_pool *pool;
  uint32_t sets;    /* of places: a bit each */
  double *before;   /* of each set: what those dealt to collect of it at most, the last one left out; */
  double *now;      /* and with the last one */
  uint32_t *choice; /* a row of sets a seeker: the label of its route there */
} table;

static unsigned seekers_of(const qtr_pool *pool) {
  return pool->bound->game->board.seekers;
}

static uint32_t sets_of(const qtr_pool *pool) {
  return (uint32_t)1 << pool->bound->game->board.places;
}

size_t qtr_deal_bytes(const qtr_pool *pool) {
  return sets_of(pool) * (2 * sizeof(double) + seekers_of(pool) * sizeof(uint32_t));
}

static table lay_out(const qtr_pool *pool, void *block) {
  uint8_t *left = block;
  table t = {.pool = pool, .sets = sets_of(pool)};
  t.before = block_cut(&left, t.sets * sizeof(double));
  t.now = block_cut(&left, t.sets * sizeof(double));
  t.choice = block_cut(&left, seekers_of(pool) * t.sets * sizeof(uint32_t));
  return t;
}

static void forget(const table *t, double *best) {
  for (uint32_t set = 0; set < t->sets; set++) best[set] = -HUGE_VAL;
}

/* A seeker goes a route, those before it share any of the other places. */
static void go(const table *t, uint32_t *choice, uint32_t label) {
  const uint32_t own = qtr_pool_label(t->pool, label)->set[0];
  const double worth = qtr_pool_worth(t->pool, label);
  const uint32_t others = (t->sets - 1) & ~own;
  uint32_t set = others;
  do {
    if (t->before[set] + worth > t->now[set | own]) {
      t->now[set | own] = t->before[set] + worth;
      choice[set | own] = label;
    }
    set = (set - 1) & others;
  } while (set != others);
}

static void deal_to(table *t, unsigned seeker) {
  const qtr_pool *pool = t->pool;
  double *before = t->now;
  t->now = t->before;
  t->before = before;
  forget(t, t->now);
  for (uint32_t label = 0; label < pool->labels; label++)
    if (qtr_pool_is_route(pool, label) && qtr_pool_label(pool, label)->squad == pool->squad_of[seeker])
      go(t, t->choice + seeker * t->sets, label);
}

/* All places, or those that are best visited, where some may be left out. */
static uint32_t best_set(const table *t) {
  uint32_t best = t->sets - 1;
  if (qtr_objective_needs_all(&t->pool->bound->game->objective)) return best;
  for (uint32_t set = 0; set < t->sets; set++)
    if (t->now[set] > t->now[best]) best = set;
  return best;
}

static void take_routes(const table *t, uint32_t set, qtr_routes *routes) {
  for (unsigned i = 0; i < QTR_MAX_ROUTES; i++) routes->length[i] = 0;
  for (unsigned seeker = seekers_of(t->pool); seeker-- > 0;) {
    const uint32_t label = t->choice[seeker * t->sets + set];
    routes->length[seeker] = (uint16_t)qtr_pool_places(t->pool, label, routes->place[seeker]);
    set &= ~qtr_pool_label(t->pool, label)->set[0];
  }
}

bool qtr_deal(const qtr_pool *pool, void *block, qtr_routes *routes) {
  QTR_ASSERT(pool->bound->game->board.places <= QTR_DEALT_MOST);
  table t = lay_out(pool, block);
  forget(&t, t.now);
  t.now[0] = 0.0;
  for (unsigned seeker = 0; seeker < seekers_of(pool); seeker++) deal_to(&t, seeker);
  const uint32_t set = best_set(&t);
  if (t.now[set] == -HUGE_VAL) return false;
  take_routes(&t, set, routes);
  return true;
}

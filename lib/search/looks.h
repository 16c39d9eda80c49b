/* Looks at one place (quarter/terms.h): in which order walks take them.
 *
 * The m-th look at a place counts P q (1-q)^(m-1), whoever takes it, and worth falls with time: of all ways to deal the
 * looks that are taken to their moments none is worth more than the sorted one, the first look first (rearrangement).
 * So some best game is sorted, and then each of its routes is: none goes from a look back to one that comes before it.
 * Of games from some state on the same holds for the looks that are free there. So walks (search/gains.h) and routes
 * (search/pool.h) that go back are left out, and the bounds hold.
 */
#ifndef QUARTER_SEARCH_LOOKS_H
#define QUARTER_SEARCH_LOOKS_H

#include <stdbool.h>
#include <stdint.h>

#include "aggregate/environment.h"
#include "quarter/config.h"

typedef struct {
  uint16_t count;                                /* of targets */
  uint16_t firsts;                               /* targets that are first looks: those in front */
  uint16_t before[QTR_IF_TERMS(QTR_MAX_PLACES)]; /* of each look: the one that comes before it; */
  uint16_t next[QTR_IF_TERMS(QTR_MAX_PLACES)];   /* the one that follows it; QTR_STAND_DOWN: none does */
} qtr_looks;

/* Without aggregation targets are looks; with it each target is the only look at itself. */
void qtr_looks_init(qtr_looks *looks, const qtr_environment *environment);

/* Whether there are places with several looks. */
static inline bool qtr_looks_in_use(const qtr_looks *looks) {
  return QTR_TERMS && looks->firsts < looks->count;
}

/* QTR_STAND_DOWN: there is none. */
static inline unsigned qtr_looks_before(const qtr_looks *looks, unsigned look) {
  return qtr_looks_in_use(looks) ? looks->before[look] : QTR_STAND_DOWN;
}
static inline unsigned qtr_looks_next(const qtr_looks *looks, unsigned look) {
  return qtr_looks_in_use(looks) ? looks->next[look] : QTR_STAND_DOWN;
}

/* The first look at a look's place. */
static inline unsigned qtr_looks_first(const qtr_looks *looks, unsigned look) {
  if (!qtr_looks_in_use(looks)) return look;
  while (looks->before[look] != QTR_STAND_DOWN) look = looks->before[look];
  return look;
}

/* Whether a target is the first of several looks. */
static inline bool qtr_looks_are_several(const qtr_looks *looks, unsigned first) {
  return qtr_looks_next(looks, first) != QTR_STAND_DOWN && qtr_looks_before(looks, first) == QTR_STAND_DOWN;
}

/* Whether a look comes before another one at its place. */
static inline bool qtr_looks_is_before(const qtr_looks *looks, unsigned look, unsigned of) {
  for (of = qtr_looks_before(looks, of); of != QTR_STAND_DOWN; of = qtr_looks_before(looks, of))
    if (of == look) return true;
  return false;
}

#endif

/* Route memory (ng-routes: Baldacci, Mingozzi and Roberti, 2011): what a walk remembers of where it has been.
 *
 * Each target has a few neighbours. A walk that comes to a target knows which of the target's neighbours it has been
 * to, and forgets all else for good; it does not return to what it knows. That rules short cycles out, and they are
 * what a bound on walks loses most by. The walk of a real seeker, which comes to each target once, is never ruled out.
 */
#ifndef QUARTER_SEARCH_NEAR_H
#define QUARTER_SEARCH_NEAR_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "quarter/config.h"
#include "quarter/places.h"
#include "search/looks.h"

/* Neighbours of a target. Each doubles what is kept of it, which the smallest builds have no room for. */
#define QTR_NEAR_MOST (QTR_MAX_PLACES < 16 ? 3u : 6u)

/* A set of a target's neighbours: bit i for its i-th. */
typedef uint8_t qtr_memory;

typedef struct {
  uint16_t targets;
  uint8_t count[QTR_MAX_PLACES]; /* neighbours of each target */
  uint16_t near[QTR_MAX_PLACES][QTR_NEAR_MOST];
  const qtr_looks *looks;
  qtr_memory *bit; /* in the caller's block, a row of targets a target: each one's bit in its memory; 0: no neighbour */
} qtr_near;

/* Nobody has neighbours. `bit` is the caller's: targets^2 of them; the targets' looks are kept. */
void qtr_near_init(qtr_near *near, qtr_memory *bit, const qtr_looks *looks);

/* Add to a target's neighbours, fewer than QTR_NEAR_MOST, one that is not among them. */
void qtr_near_add(qtr_near *near, unsigned target, unsigned neighbour);

static inline unsigned qtr_near_memories(const qtr_near *near, unsigned target) {
  return 1u << near->count[target];
}

static inline qtr_memory qtr_near_bit(const qtr_near *near, unsigned target, unsigned of) {
  return near->bit[(size_t)target * near->targets + of];
}

/* What is remembered at a target of a walk that has been at another one: of a look, those that come before it, too, for
 * it does not go back to them. */
static inline qtr_memory qtr_near_mark(const qtr_near *near, unsigned target, unsigned been) {
  qtr_memory mark = qtr_near_bit(near, target, been);
  for (been = qtr_looks_before(near->looks, been); been != QTR_STAND_DOWN; been = qtr_looks_before(near->looks, been))
    mark |= qtr_near_bit(near, target, been);
  return mark;
}

/* What is remembered at `to` of a walk that comes from `from`, with a memory of its own there. */
static inline qtr_memory qtr_near_move(const qtr_near *near, unsigned from, qtr_memory memory, unsigned to) {
  qtr_memory kept = qtr_near_mark(near, to, from);
  for (unsigned i = 0; memory >> i != 0; i++)
    if (memory >> i & 1) kept |= qtr_near_mark(near, to, near->near[from][i]);
  return kept;
}

/* What is remembered at a target of all that two sets hold. */
qtr_memory qtr_near_of(const qtr_near *near, unsigned target, const qtr_places *been, const qtr_places *or_been);

#endif

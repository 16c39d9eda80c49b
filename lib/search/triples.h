/* Subset-row inequalities on three places (Jepsen, Petersen, Spoorendonk, Pisinger 2008): of the routes that visit two
 * of the three or all of them, one is in a game at most. Routes in halves, which the linear programme of choosing among
 * routes mixes, break them; what is a game keeps them.
 */
#ifndef QUARTER_SEARCH_TRIPLES_H
#define QUARTER_SEARCH_TRIPLES_H

#include <stdbool.h>
#include <stdint.h>

#include "search/label.h"

#define QTR_MOST_TRIPLES 256u

typedef struct {
  uint16_t place[3]; /* ascending */
} qtr_triple;

/* Routes in shares. */
typedef struct {
  uint32_t count;
  const qtr_label *const *route;
  const double *share;
} qtr_mixture;

static inline bool qtr_triple_counts(const qtr_triple *triple, const qtr_label *route) {
  return qtr_label_has(route, triple->place[0]) + qtr_label_has(route, triple->place[1]) +
             qtr_label_has(route, triple->place[2]) >=
         2;
}

/* The triples that a mixture breaks most, so many at most, in an array of the caller's; returns how many. No place
 * is in more than a few. */
unsigned qtr_triples_broken(const qtr_mixture *mixture, unsigned places, qtr_triple *triple, unsigned most);

#endif

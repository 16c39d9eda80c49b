#include "search/closure.h"

#include <stddef.h>

/* The ways on from `place` for one that comes there from a node after `to_there` steps. */
static void go_by(qtr_steps *from, const qtr_steps *on, unsigned places, qtr_steps to_there) {
  for (unsigned to = 0; to < places; to++) {
    if (on[to] == QTR_NEVER) continue;
    const uint64_t by_way = (uint64_t)to_there + on[to];
    if (by_way < from[to]) from[to] = (qtr_steps)by_way;
  }
}

void qtr_closure_fill(qtr_steps *steps, unsigned nodes, unsigned places) {
  for (unsigned by = 0; by < places; by++) {
    for (unsigned node = 0; node < nodes; node++) {
      qtr_steps *from = steps + (size_t)node * places;
      if (from[by] != QTR_NEVER) go_by(from, steps + (size_t)by * places, places, from[by]);
    }
  }
}

#include "gossip.h"

#include <stddef.h>

#include "quarter/seeker.h"

bool gossip_learn(gossip *g, int signal, int territory) {
  bool *known = NULL;
  if (signal == QTR_SIGNAL_FOUND) known = &g->found;
  if (signal == QTR_SIGNAL_TERRITORY_DONE && territory >= 0 && territory < DEMO_MOST_ROBOTS)
    known = &g->done[territory];
  if (known == NULL || *known) return false;
  *known = true;
  g->news = true;
  return true;
}

void gossip_repeat(gossip *g, int64_t utime, void (*say)(void *user, int signal, int territory), void *user) {
  /* The moments come from outside, so without a sign: one that lies more than a period before the next is a clock set
   * anew. */
  const uint64_t left = (uint64_t)g->next - (uint64_t)utime;
  if (!g->news && left - 1 < GOSSIP_PERIOD) return;
  g->news = false;
  g->next = (int64_t)((uint64_t)utime + GOSSIP_PERIOD);
  if (g->found) say(user, QTR_SIGNAL_FOUND, 0);
  for (int territory = 0; territory < DEMO_MOST_ROBOTS; territory++)
    if (g->done[territory]) say(user, QTR_SIGNAL_TERRITORY_DONE, territory);
}

/* Termination signals that get through although any one copy may be lost: what a robot knows, found out or heard, it
 * repeats for as long as it lives, at once when it is new. Modelled in tests/model/. */
#ifndef QUARTER_DEMO_GOSSIP_H
#define QUARTER_DEMO_GOSSIP_H

#include <stdbool.h>
#include <stdint.h>

#include "demo_limits.h"

#define GOSSIP_PERIOD 100000 /* microseconds between repetitions */

typedef struct {
  bool found;                  /* FOUND is known */
  bool done[DEMO_MOST_ROBOTS]; /* territories known to be done */
  bool news;                   /* something to say at once */
  int64_t next;                /* utime of the next repetition */
} gossip;

/* Learn a signal. True if it is new. What is no signal is ignored. */
bool gossip_learn(gossip *g, int signal, int territory);

/* Say what is due at `utime`, through `say`. */
void gossip_repeat(gossip *g, int64_t utime, void (*say)(void *user, int signal, int territory), void *user);

#endif

/* The viewer's page and a stream of what happens, served on this machine alone while a game runs. live.c is the only file
 * that includes the web server's library. */
#ifndef QUARTER_DEMO_LIVE_H
#define QUARTER_DEMO_LIVE_H

#include "record.h"

#define LIVE_PATIENCE 30.0 /* seconds to wait for the first viewer */

typedef struct live live;

/* Serve at 127.0.0.1:port, 0 for a free one, and say where on standard error. 0, or -1 with *why set. */
int live_open(live **view, int port, fault *why);

/* Wait until somebody watches, for some seconds at most, or until interrupted. */
void live_await(live *view, double seconds, const volatile int *interrupted);

/* After a tick of the game, and after its end. */
void live_frame(live *view, const record *r, const arena *a, uint64_t seed);
void live_end(live *view, const record *r, const arena *a, const game_result *result);

/* Let those who watch see the end, then stop serving. NULL does nothing. */
void live_close(live *view);

#endif

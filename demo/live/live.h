/* The viewer's page and a stream of what happens, served on this machine alone while a game runs. live.c is the only
 * file that includes the web server's library.
 *
 * It answers to localhost, 127.0.0.1 and [::1] alone, as host and as origin, and gives up connections that ask for
 * nothing or do not read. */
#ifndef QUARTER_DEMO_LIVE_H
#define QUARTER_DEMO_LIVE_H

#include "record.h"

#define LIVE_PATIENCE 30.0 /* seconds to wait for the first viewer */
#define LIVE_VIEWERS 24    /* at a time */

typedef struct live live;

/* Serve at 127.0.0.1:port, 0 for a free one, and say where on standard error. 0, or -1 with *why set. */
int live_open(live **view, int port, fault *why);

/* Say what is watched: the JSON of record_hello(). Before the first frame. */
void live_hello(live *view, const plan *p, const record_head *head);

/* Wait until somebody watches, for some seconds at most, or until interrupted. */
void live_await(live *view, double seconds, const volatile int *interrupted);

/* Something happened; it goes out with the next frame. ARENA_EVENTS are kept of a game. */
void live_event(live *view, const plan *p, const arena_event *e);

/* Another game begins: what happened in the one before is forgotten. */
void live_restart(live *view);

/* Where the robots are at `now`, in seconds of the world's clock. Frames that come too fast are left out. */
void live_frame(live *view, double now, int robots, int rows, const world_pose *poses);

/* The game is over. */
void live_end(live *view, const plan *p, const game_result *result);

/* Let those who watch see the end, then stop serving. NULL does nothing. */
void live_close(live *view);

#endif

/* The messages of lcmtypes/ as plain structs: only bus.c knows how they travel. Lengths in metres of the map frame. */
#ifndef QUARTER_DEMO_MESSAGES_H
#define QUARTER_DEMO_MESSAGES_H

#include <stdbool.h>
#include <stdint.h>

#include "demo_limits.h"

#define MESSAGE_FARTHEST 1e9 /* metres, and metres a second: what lies beyond is no place on earth */
#define MESSAGE_TURN 1e6     /* radians */

typedef struct {
  int64_t utime; /* microseconds of the world's clock */
  int robot;
  double x, y;
  double heading; /* radians, counter-clockwise from x */
} message_pose;

typedef struct {
  int64_t utime;
  int robot;
  bool read;              /* a look of the mine sensor, which the last command asked for, has ended */
  bool mine;              /* and it saw a mine within its range */
  float range[DEMO_RAYS]; /* to the nearest thing, ray r at heading + r / DEMO_RAYS of a turn */
} message_scan;

/* What a robot is about, for viewers: it searches, waits until it is ready, goes home with all done or, its battery too
 * low for what it leaves, without. */
enum message_intent { INTENT_SEARCH = 0, INTENT_WAIT = 1, INTENT_HOME = 2, INTENT_TIRED = 3 };

typedef struct {
  int64_t utime;
  int robot;
  double left, right; /* metres a second */
  bool read;          /* read the mine sensor */
  int intent;         /* enum message_intent */
} message_command;

typedef struct {
  int64_t utime;
  int sender;
  int signal; /* enum qtr_signal_kind */
  int territory;
  uint32_t identity, run; /* as of a qtr_signal */
} message_terminate;

enum message_state {
  STATE_ALIVE = 0,
  STATE_STOPPED = 1,
  STATE_LOST = 2,
  STATE_STUCK = 3,
  STATE_OFF = 4,
  STATE_TIRED = 5
};

typedef struct {
  int64_t utime;
  int robots, places, mines_found;
  int8_t state[DEMO_MOST_ROBOTS];      /* enum message_state */
  int8_t scanned_by[DEMO_MOST_PLACES]; /* -1: nobody yet */
  int8_t found[DEMO_MOST_PLACES];
} message_status;

enum message_kind { KIND_POSE, KIND_SCAN, KIND_COMMAND, KIND_TERMINATE, KIND_STATUS, KINDS };

#endif

/* The world with all that surrounds it: mines, clock, faults, and what happened. It publishes each robot's pose and
 * scan and takes its wheel commands; it is the same whether the robots are in this process or in others. */
#ifndef QUARTER_DEMO_ARENA_H
#define QUARTER_DEMO_ARENA_H

#include "body.h"
#include "bus.h"
#include "faults.h"
#include "host/table/table.h"
#include "plan.h"
#include "world.h"

#define ARENA_TICK 0.05    /* seconds between messages: three steps of the world */
#define ARENA_SILENCE 10.0 /* seconds without a command after which a robot counts as lost: its program has ended */

enum arena_kind {
  EVENT_SCANNED, /* the first look at a place, and nothing is there */
  EVENT_LOOKED,  /* a later one */
  EVENT_MISSED,  /* a look that did not find what is there */
  EVENT_FOUND,
  EVENT_DONE,
  EVENT_STOPPED,
  EVENT_READY,    /* it sets out, later than others */
  EVENT_HOMEWARD, /* all is done, and it goes home for its battery */
  EVENT_TIRED,    /* its battery does not last for what is left: it goes home */
  EVENT_HOME,
  EVENT_EMPTY, /* its battery ended on the way: it is lost */
  EVENT_LOST,
  EVENT_STUCK,
  EVENT_UNSTUCK,
  EVENT_SLIP,
  EVENT_LOSS,
  EVENT_DEADLOCK,
  EVENT_SHUT,
  EVENT_RESET,
  EVENT_RESTARTED,
  EVENT_MORE /* more happened than is kept */
};

typedef struct {
  double at;                   /* seconds */
  int kind;                    /* enum arena_kind */
  int robot, place, territory; /* -1: none */
  double share;
  point middle; /* of what is shut, in cells from the top left corner of the grid */
} arena_event;

#define ARENA_EVENTS 2048

typedef struct {
  uint64_t seed;
  bool clear_all;
  int mine;                   /* place; -1: drawn by the likelihoods; -2: there is none */
  const fault_script *faults; /* NULL: none */
  double time_limit;          /* seconds */
  uint32_t run;               /* of the robots' signals */
  const plan_truth *truth;    /* NULL: as the table has it, and nothing is missed */
} arena_setup;

/* Of a robot's sensor: the look that is being taken, or the last one where it still is. */
typedef struct {
  int place;    /* -1: none */
  double since; /* seconds */
  bool ended, saw;
} arena_look;

/* Of one robot. */
typedef struct {
  enum message_state state;
  bool stuck;    /* its wheels do nothing */
  bool off;      /* it has no power */
  bool heard;    /* a command came */
  bool silent;   /* none came for long: it is lost, for its program has ended */
  bool read;     /* and asks for its mine sensor to be read */
  int intent;    /* enum message_intent */
  bool homeward; /* when it drove last it was on its way home */
  robot_body body;
  arena_look look;
  int64_t commanded;              /* utime of the last one */
  bool still;                     /* it is told to stand */
  double still_since, stopped_at; /* seconds; stopped_at below 0: it drives */
  point anchor;                   /* where it was when it last made way */
  double anchored;                /* seconds: when that was */
  bool deadlocked;
  qtr_places scanned;
} arena_robot;

typedef struct {
  const table *t;
  bus *b;
  arena_setup setup;
  world *w;
  ground g;
  int robots, places; /* places: the mission's own, whatever is looked at more than once */
  int mine;
  double now; /* seconds */
  uint64_t ticks;
  int next_fault;
  bool closed[FAULTS_MOST]; /* what the fault of that number shuts is shut */
  arena_robot robot[DEMO_MOST_ROBOTS];
  int8_t scanned_by[QTR_MAX_PLACES]; /* -1: nobody yet */
  double scanned_at[QTR_MAX_PLACES];
  uint16_t looks[QTR_MAX_PLACES]; /* that were taken at each place */
  uint16_t owed[QTR_MAX_PLACES];  /* that the plan has there */
  int counted;                    /* of those looks that were owed, in the order of their times */
  uint16_t look_place[QTR_MAX_PLACES];
  double look_at[QTR_MAX_PLACES]; /* seconds */
  bool done[DEMO_MOST_ROBOTS];    /* territories announced */
  double found_at;                /* seconds; below 0: not yet */
  int duplicates, deadlocks;
  uint64_t commands, signals; /* heard */
  uint32_t identity;          /* of the signals of robots that play this table */
  int stranger;               /* a robot that said something of another table or run; -1: none */
  int events;
  arena_event event[ARENA_EVENTS];
} arena;

/* Set up over an open bus, which must outlive it. 0, or -1 with *why set and nothing to free. */
int arena_open(arena *a, const table *t, bus *b, const arena_setup *setup, fault *why);
void arena_close(arena *a);

/* Send every robot's pose and scan, and what viewers should know. */
void arena_publish(arena *a);

/* After the robots' commands were drained: advance by ARENA_TICK. */
void arena_advance(arena *a);

/* Every robot that is not lost has stopped, or time is up. */
bool arena_over(const arena *a);

/* When the last robot stopped, in seconds; below 0 if one still drives, or none is left. Lost ones do not count. */
double arena_all_stopped_at(const arena *a);

/* How many robots fell silent, and whether no other is left: such a game was broken off, not played to its end. */
int arena_silent(const arena *a);
bool arena_abandoned(const arena *a);

#endif

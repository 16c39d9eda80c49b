/* A robot: hears its own pose and scan and TERMINATE, says its own command and TERMINATE, and nothing else. It runs the
 * policy table by the core's executor, and links nothing of Quarter but the robot side. */
#ifndef QUARTER_DEMO_ROBOT_H
#define QUARTER_DEMO_ROBOT_H

#include <stdbool.h>

#include "body.h"
#include "gossip.h"
#include "ground.h"
#include "hope.h"
#include "messages.h"
#include "quarter/robot.h"

/* Where a robot goes next. The plan's pilot is the policy table's; there are others to compare it with. */
typedef struct {
  void *self;
  uint32_t identity, run;                             /* of its signals */
  uint16_t (*target)(void *self);                     /* place; QTR_STAND_DOWN: nothing left to do */
  void (*visited)(void *self, uint16_t place);        /* it was there and found nothing */
  void (*blocked)(void *self, uint16_t place);        /* it does not get there */
  void (*found)(void *self);                          /* it was there and found the target */
  bool (*hear)(void *self, const qtr_signal *signal); /* false: it is of another search */
  bool (*announce)(void *self, qtr_signal *signal);   /* what it has finished, or found */
  /* The signals that it knows of when it sets out, after a reset: false from the first index on that there is none. */
  bool (*known)(void *self, unsigned index, qtr_signal *signal);
} robot_pilot;

/* The pilot of the plan; `seeker` must be initialised and outlive it. */
robot_pilot robot_pilot_of_plan(qtr_seeker *seeker);

/* How a robot is heard. */
typedef struct {
  void *user;
  void (*command)(void *user, const message_command *m);
  void (*terminate)(void *user, const message_terminate *m);
} robot_voice;

/* Large: it holds the way to its target. */
typedef struct {
  const qtr_policy *policy;
  ground g; /* as it may enter it */
  robot_body body;
  int self;
  bool clear_all; /* a find stops nobody */
  bool off;       /* it has no power: it hears nothing, and so it says nothing */
  bool tired;     /* its battery did not last for a place any more */
  bool home;      /* it has a battery, nothing left to do, and is back at its start */
  robot_pilot pilot;
  robot_voice voice;
  gossip known;
  message_pose pose;
  uint64_t poses;  /* heard so far */
  uint16_t target; /* QTR_STAND_DOWN: home */
  bool way_known;  /* `way` leads to the target */
  hope hope;       /* of getting there */
  uint16_t asked;  /* the place for which the mine sensor is being read; QTR_STAND_DOWN: none */
  int64_t utime;
  point anchor;     /* where it was when it last made way */
  int64_t anchored; /* utime: when that was */
  bool left;        /* it keeps left for a while: the right side is blocked */
  int64_t switched; /* utime: since when */
  qtr_field way;
} robot;

/* At its start, or after a reset, with a pilot that knows what it knew: what that has heard the robot repeats. Its body
 * is as the table says, until it is given another. */
void robot_init(robot *r, const qtr_policy *policy, int self, bool clear_all, robot_pilot pilot, robot_voice voice);

/* Let it be as another table says, of the same places and ground, which may know more of the field's terms. */
void robot_embody(robot *r, const qtr_policy *policy);

void robot_hear_pose(robot *r, const message_pose *m);
void robot_hear_terminate(robot *r, const message_terminate *m);
/* The moment to act: sends a command, and the signals that are due. */
void robot_hear_scan(robot *r, const message_scan *m);

/* It drives no more, of its own will: the target is found, or there is nothing left to do, and who tires is home. */
bool robot_stopped(const robot *r);

#endif

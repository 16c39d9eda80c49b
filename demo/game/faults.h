/* What is to go wrong in a game, when: a YAML file.
 *
 *   faults:
 *     - {at: 20, lost: 1}              robot 1 is lost: it does and says nothing more, and stays in the way
 *     - {at: 15, stuck: 0, for: 10}    robot 0's wheels do nothing for 10 seconds
 *     - {at: 0, slip: 0.3, robot: 2}   robot 2's wheels lose up to 30 % of their speed, at random; all robots' without it
 *     - {at: 0, loss: 0.3}             30 % of the termination signals are lost on their way to each robot
 */
#ifndef QUARTER_DEMO_FAULTS_H
#define QUARTER_DEMO_FAULTS_H

#include "host/base/fault.h"

#define FAULTS_MOST 64

enum fault_kind { FAULT_LOST, FAULT_STUCK, FAULT_UNSTUCK, FAULT_SLIP, FAULT_LOSS };

typedef struct {
  double at; /* seconds */
  int kind;  /* enum fault_kind */
  int robot; /* -1: all */
  double share;
} fault_event;

typedef struct {
  int count;
  fault_event event[FAULTS_MOST]; /* in the order of their times */
} fault_script;

/* Read a script for this many robots. 0, or -1 with *why set. */
int faults_read(fault_script *script, const char *path, int robots, fault *why);

/* Add an event, keeping the order. 0, or -1 if there is no room. */
int faults_add(fault_script *script, fault_event event);

#endif

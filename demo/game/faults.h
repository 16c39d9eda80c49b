/* What is to go wrong in a game, when: a YAML file.
 *
 *   faults:
 *     - {at: 20, lost: 1}              robot 1 is lost: it does and says nothing more, and stays in the way
 *     - {at: 15, stuck: 0, for: 10}    robot 0's wheels do nothing for 10 seconds
 *     - {at: 0, slip: 0.3, robot: 2}   robot 2's wheels lose up to 30 % of their speed; all robots' without it
 *     - {at: 0, loss: 0.3}             30 % of the termination signals are lost on their way to each robot
 *     - {at: 12, shut: 7}              place 7 is shut: nobody gets to it any more, once none is in its cell
 *     - {at: 12, shut: {column: 4, row: 9}}   so is this cell of the map: a door
 *     - {at: 20, reset: 1, for: 3}     robot 1 has no power for 3 seconds, and goes on from what it had saved
 *
 * Robots and places go by their names, or else by their numbers.
 */
#ifndef QUARTER_DEMO_FAULTS_H
#define QUARTER_DEMO_FAULTS_H

#include "host/base/fault.h"
#include "host/table/table.h"

#define FAULTS_MOST 64

enum fault_kind {
  FAULT_LOST,
  FAULT_STUCK,
  FAULT_UNSTUCK,
  FAULT_SLIP,
  FAULT_LOSS,
  FAULT_SHUT,
  FAULT_RESET,  /* its power fails */
  FAULT_RESTART /* and is there again */
};

typedef struct {
  double at; /* seconds of the world's clock; in a file, of the mission */
  int kind;  /* enum fault_kind */
  int robot; /* -1: all */
  double share;
  qtr_cell cell; /* of the table's grid: what is shut */
} fault_event;

typedef struct {
  int count;
  fault_event event[FAULTS_MOST]; /* in the order of their times */
} fault_script;

/* Read a script for the robots, places and map of a table. 0, or -1 with *why set. */
int faults_read(fault_script *script, const char *path, const table *t, fault *why);

/* Add an event, keeping the order. 0, or -1 if there is no room. */
int faults_add(fault_script *script, fault_event event);

/* How many events of a kind there are. */
int faults_count(const fault_script *script, int kind);

#endif

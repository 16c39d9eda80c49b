/* The board that main.c runs on: wheels, sensor, radio, and memory that outlasts a reset. Replace board.c by your own;
 * the one here makes a world up, in which the power fails once, a door is shut for a while, robot 1 is done early and
 * robot 2 is lost. */
#ifndef BOARD_H
#define BOARD_H

#include <quarter/robot.h>

/* Power is on. The policy tells where this robot starts, and of which search the others' signals are. */
void board_begin(const qtr_policy *policy, unsigned my_number);

/* QTR_SAVE_BYTES that hold what they held before a reset. */
uint8_t *board_memory(void);

/* Whether this is a start anew, and no reset in the midst of a search. */
bool board_is_new(void);

/* The cell that the robot is in, by its localisation. */
qtr_cell board_cell(void);

/* Drive to a neighbouring cell. False: something is in the way. */
bool board_drive(qtr_cell cell);

/* Scan the place that the robot is at: whether it is here what is searched for. */
bool board_scan(void);

void board_send(const qtr_signal *signal);
bool board_receive(qtr_signal *signal);

#endif

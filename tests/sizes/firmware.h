/* What README.md's robot loop leaves to the firmware, and the loop as a function. */
#ifndef QUARTER_TESTS_SIZES_FIRMWARE_H
#define QUARTER_TESTS_SIZES_FIRMWARE_H

#include "quarter/robot.h"

extern const unsigned my_number;
extern const uint32_t run_number, patrol_size;
extern const uint8_t patrol[];

void halt(void);
uint8_t *memory_that_lasts(void);
qtr_cell my_cell(void);
void broadcast(const qtr_signal *signal);
bool receive(qtr_signal *signal);
bool drive_to(qtr_cell cell);
bool scan_finds_it(void);

void loop(void);

#endif

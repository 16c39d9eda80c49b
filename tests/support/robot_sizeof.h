/* What the robot's structures take in builds of several sizes: tests/support/robot_sizeof.c is compiled once for
 * each. */
#ifndef QUARTER_TESTS_ROBOT_SIZEOF_H
#define QUARTER_TESTS_ROBOT_SIZEOF_H

#include <stdint.h>

typedef struct {
  uint32_t cells, places, seekers;
  uint32_t policy, seeker, field; /* bytes */
  uint8_t pointer, alignment;     /* of the processor's */
} robot_sizeof;

#endif

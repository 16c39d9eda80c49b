/* Travel times as a board has them: 4 bytes each, the lowest first. */
#ifndef QUARTER_TESTS_STEPS_H
#define QUARTER_TESTS_STEPS_H

#include <stddef.h>

#include "quarter/config.h"

static inline void steps_put(uint8_t *steps, size_t index, qtr_steps value) {
  for (unsigned i = 0; i < 4; i++) steps[4 * index + i] = (uint8_t)(value >> 8 * i);
}

static inline qtr_steps steps_get(const uint8_t *steps, size_t index) {
  qtr_steps value = 0;
  for (unsigned i = 4; i-- > 0;) value = value << 8 | steps[4 * index + i];
  return value;
}

#endif

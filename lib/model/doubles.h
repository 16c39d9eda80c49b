/* Doubles as bytes: IEEE 754, little-endian. Apart from core/bytes.h, for a robot has no floating point. */
#ifndef QUARTER_DOUBLES_H
#define QUARTER_DOUBLES_H

#include <string.h>

#include "core/bytes.h"

static inline void store_double(uint8_t *bytes, double value) {
  uint64_t bits;
  memcpy(&bits, &value, sizeof bits);
  qtr_store64(bytes, bits);
}

static inline double load_double(const uint8_t *bytes) {
  const uint64_t bits = qtr_load64(bytes);
  double value;
  memcpy(&value, &bits, sizeof value);
  return value;
}

#endif

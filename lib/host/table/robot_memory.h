/* The RAM that a robot's build of other sizes than this one's takes. */
#ifndef QUARTER_HOST_ROBOT_MEMORY_H
#define QUARTER_HOST_ROBOT_MEMORY_H

#include <stdint.h>

#include "host/table/robot_sizes.h"

/* How a processor's compiler lays out structures. */
typedef struct {
  uint8_t pointer;   /* bytes of one */
  uint8_t alignment; /* the greatest that a number has, in bytes */
} robot_processor;

/* Cortex-M, RV32: what --profile reckons with. */
extern const robot_processor robot_processor_32_bits;

/* Bytes of README.md's three structures: qtr_policy, qtr_seeker, qtr_field. */
typedef struct {
  uint64_t policy, seeker, field, all;
} robot_memory;

robot_memory robot_memory_of(const robot_sizes *sizes, const robot_processor *processor);

#endif

/* Blocks of memory that callers hand over. */
#ifndef QUARTER_CORE_BLOCK_H
#define QUARTER_CORE_BLOCK_H

#include <stddef.h>
#include <stdint.h>

#include "quarter/status.h"

/* Whether a block of so many bytes holds those needed, aligned for whatever stands in it. */
static inline int block_check(const void *block, size_t bytes, size_t needed) {
  if ((uintptr_t)block % sizeof(uint64_t) != 0) {
    return QTR_ERR_ARGUMENT;
  }
  return block != NULL && bytes >= needed ? QTR_OK : QTR_ERR_SPACE;
}

/* What a piece of a block takes, so that the next one is aligned too. */
static inline size_t block_piece(size_t bytes) {
  return (bytes + sizeof(uint64_t) - 1) / sizeof(uint64_t) * sizeof(uint64_t);
}

/* Cut a piece of so many bytes off the front of what is left of a block. */
static inline void *block_cut(uint8_t **left, size_t bytes) {
  void *piece = *left;
  *left += block_piece(bytes);
  return piece;
}

#endif

/* Bytes, and numbers in them by little-endian loads and stores: bytes from outside are never overlaid with structs. */
#ifndef QUARTER_BYTES_H
#define QUARTER_BYTES_H

#include <stdbool.h>
#include <stdint.h>

/* A compiler for no operating system may come without <string.h>. It makes memset() and the like of these where they
 * are long. */
static inline void bytes_clear(void *to, uint32_t count) {
  uint8_t *at = (uint8_t *)to;
  for (uint32_t i = 0; i < count; i++) {
    at[i] = 0;
  }
}

static inline void bytes_copy(void *to, const void *from, uint32_t count) {
  uint8_t *at = (uint8_t *)to;
  const uint8_t *of = (const uint8_t *)from;
  for (uint32_t i = 0; i < count; i++) {
    at[i] = of[i];
  }
}

/* Whether they begin with the characters of `text`. */
static inline bool bytes_begin(const uint8_t *bytes, const char *text) {
  unsigned i = 0;
  while ((text[i] != '\0') && (bytes[i] == (uint8_t)text[i])) {
    i++;
  }
  return text[i] == '\0';
}

/* Inline as C99 means it: where the compiler would rather call, there is one copy, in bytes.c. */
inline uint32_t qtr_load16(const uint8_t *bytes) {
  return (uint32_t)bytes[0] | ((uint32_t)bytes[1] << 8);
}

inline uint32_t qtr_load32(const uint8_t *bytes) {
  return qtr_load16(bytes) | (qtr_load16(bytes + 2u) << 16);
}

inline uint64_t qtr_load64(const uint8_t *bytes) {
  return (uint64_t)qtr_load32(bytes) | ((uint64_t)qtr_load32(bytes + 4u) << 32);
}

inline void qtr_store16(uint8_t *bytes, uint32_t value) {
  bytes[0] = (uint8_t)(value & 0xFFu);
  bytes[1] = (uint8_t)((value >> 8) & 0xFFu);
}

inline void qtr_store32(uint8_t *bytes, uint32_t value) {
  qtr_store16(bytes, value & 0xFFFFu);
  qtr_store16(bytes + 2u, value >> 16);
}

inline void qtr_store64(uint8_t *bytes, uint64_t value) {
  qtr_store32(bytes, (uint32_t)(value & 0xFFFFFFFFu));
  qtr_store32(bytes + 4u, (uint32_t)(value >> 32));
}

#endif

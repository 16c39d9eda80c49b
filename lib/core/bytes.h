/* Bytes, and numbers in them by little-endian loads and stores: bytes from outside are never overlaid with structs. */
#ifndef QUARTER_BYTES_H
#define QUARTER_BYTES_H

#include <stdbool.h>
#include <stdint.h>

/* A compiler for no operating system may come without <string.h>. It makes memset() and the like of these where they are long. */
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

static inline uint32_t load16_le(const uint8_t *bytes) {
  return (uint32_t)bytes[0] | ((uint32_t)bytes[1] << 8);
}

static inline uint32_t load32_le(const uint8_t *bytes) {
  return load16_le(bytes) | (load16_le(bytes + 2u) << 16);
}

static inline uint64_t load64_le(const uint8_t *bytes) {
  return (uint64_t)load32_le(bytes) | ((uint64_t)load32_le(bytes + 4u) << 32);
}

static inline void store16_le(uint8_t *bytes, uint32_t value) {
  bytes[0] = (uint8_t)(value & 0xFFu);
  bytes[1] = (uint8_t)((value >> 8) & 0xFFu);
}

static inline void store32_le(uint8_t *bytes, uint32_t value) {
  store16_le(bytes, value & 0xFFFFu);
  store16_le(bytes + 2u, value >> 16);
}

static inline void store64_le(uint8_t *bytes, uint64_t value) {
  store32_le(bytes, (uint32_t)(value & 0xFFFFFFFFu));
  store32_le(bytes + 4u, (uint32_t)(value >> 32));
}

#endif

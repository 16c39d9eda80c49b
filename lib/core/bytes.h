/* Little-endian loads and stores, byte by byte: bytes from outside are never overlaid with structs. */
#ifndef QUARTER_BYTES_H
#define QUARTER_BYTES_H

#include <stdint.h>

static inline uint32_t load16_le(const uint8_t *bytes) {
  return (uint32_t)bytes[0] | (uint32_t)bytes[1] << 8;
}

static inline uint32_t load32_le(const uint8_t *bytes) {
  return load16_le(bytes) | load16_le(bytes + 2) << 16;
}

static inline uint64_t load64_le(const uint8_t *bytes) {
  return (uint64_t)load32_le(bytes) | (uint64_t)load32_le(bytes + 4) << 32;
}

static inline void store16_le(uint8_t *bytes, uint32_t value) {
  bytes[0] = (uint8_t)(value & 0xFFu);
  bytes[1] = (uint8_t)(value >> 8 & 0xFFu);
}

static inline void store32_le(uint8_t *bytes, uint32_t value) {
  store16_le(bytes, value & 0xFFFFu);
  store16_le(bytes + 2, value >> 16);
}

static inline void store64_le(uint8_t *bytes, uint64_t value) {
  store32_le(bytes, (uint32_t)(value & 0xFFFFFFFFu));
  store32_le(bytes + 4, (uint32_t)(value >> 32));
}

#endif

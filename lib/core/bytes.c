#include "core/bytes.h"

/* The copies that are called. */
extern inline uint32_t qtr_load16(const uint8_t *bytes);
extern inline uint32_t qtr_load32(const uint8_t *bytes);
extern inline uint64_t qtr_load64(const uint8_t *bytes);
extern inline void qtr_store16(uint8_t *bytes, uint32_t value);
extern inline void qtr_store32(uint8_t *bytes, uint32_t value);
extern inline void qtr_store64(uint8_t *bytes, uint64_t value);

/* CRC-32 (IEEE 802.3, reflected polynomial EDB88320), as in zlib. */
#ifndef QUARTER_CRC_H
#define QUARTER_CRC_H

#include <stdint.h>

/* Continue a checksum over `size` more bytes; begin with 0. */
uint32_t qtr_crc32_add(uint32_t crc, const uint8_t *bytes, uint32_t size);

/* Continue it over the lowest `size` bytes of a number, 4 at most, the least significant first. */
uint32_t qtr_crc32_add_number(uint32_t crc, uint32_t number, uint32_t size);

#endif

#include "core/crc.h"

#include "core/bytes.h"

/* Four bits at a time: 16 words of flash, twice the speed of bit by bit. */
static const uint32_t nibble_table[16] = {0x00000000u, 0x1DB71064u, 0x3B6E20C8u, 0x26D930ACu, 0x76DC4190u, 0x6B6B51F4u,
                                          0x4DB26158u, 0x5005713Cu, 0xEDB88320u, 0xF00F9344u, 0xD6D6A3E8u, 0xCB61B38Cu,
                                          0x9B64C2B0u, 0x86D3D2D4u, 0xA00AE278u, 0xBDBDF21Cu};

/* Complemented before and after, so that zeros in front count; and a sum is taken up again as it was given, for the
 * first complement undoes the last one of the bytes before. */
uint32_t qtr_crc32_add(uint32_t crc, const uint8_t *bytes, uint32_t size) {
  crc = ~crc;
  for (uint32_t i = 0; i < size; i++) {
    crc ^= bytes[i];
    crc = (crc >> 4) ^ nibble_table[crc & 15u];
    crc = (crc >> 4) ^ nibble_table[crc & 15u];
  }
  return ~crc;
}

uint32_t qtr_crc32_add_number(uint32_t crc, uint32_t number, uint32_t size) {
  uint8_t bytes[4];
  qtr_store32(bytes, number);
  return qtr_crc32_add(crc, bytes, size);
}

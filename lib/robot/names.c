#include "quarter/names.h"

#include <stdbool.h>
#include <stddef.h>

#include "core/bytes.h"
#include "core/crc.h"
#include "quarter/status.h"

/* "QTRH", u16 version, u16 0, u32 bytes in all, u32 CRC-32 of the entries; then entries: u16 what, u16 length, as many
 * bytes. Entries of a later version are passed over. */
enum { MAGIC = 4, VERSION = 1, SIZE_AT = 8, CRC_AT = 12, HEAD = 16, ENTRY = 4, MISSION_NAME = 1 };

/* A name that is cut would be another name: one that is too long is left out whole. */
uint32_t qtr_names_size(const char *mission) {
  uint32_t length = 0;
  while ((length < QTR_NAME_BYTES) && (mission[length] != '\0')) {
    length++;
  }
  return ((length == 0u) || (length >= QTR_NAME_BYTES)) ? 0 : (HEAD + ENTRY + length);
}

/* The sum is over the entries, so that a torn write behind the table is seen without a look at the table. */
void qtr_names_write(uint8_t *bytes, const char *mission) {
  const uint32_t size = qtr_names_size(mission);
  if (size == 0u) {
    return;
  }
  bytes_clear(bytes, HEAD);
  bytes_copy(bytes, "QTRH", MAGIC);
  qtr_store16(bytes + MAGIC, VERSION);
  qtr_store32(bytes + SIZE_AT, size);
  qtr_store16(bytes + HEAD, MISSION_NAME);
  qtr_store16(bytes + HEAD + 2u, size - HEAD - ENTRY);
  bytes_copy(bytes + HEAD + ENTRY, mission, size - HEAD - ENTRY);
  qtr_store32(bytes + CRC_AT, qtr_crc32_add(0, bytes + HEAD, size - HEAD));
}

/* Sizes must agree to the byte: behind the names nothing more is kept. */
static bool is_whole(const uint8_t *bytes, uint32_t size) {
  return (size >= HEAD) && bytes_begin(bytes, "QTRH") && (qtr_load32(bytes + SIZE_AT) == size) &&
         (qtr_load32(bytes + CRC_AT) == qtr_crc32_add(0, bytes + HEAD, size - HEAD));
}

/* Into an array of QTR_NAME_BYTES. */
static void take(char *mission, uint32_t what, const uint8_t *text, uint32_t length) {
  if ((what != MISSION_NAME) || (length >= QTR_NAME_BYTES)) {
    return;
  }
  bytes_copy(mission, text, length);
  mission[length] = '\0';
}

/* Each length is held against what is left before it is used, so that no bytes lead outside. */
int qtr_names_read(char *mission, const uint8_t *bytes, uint32_t size) {
  mission[0] = '\0';
  if (size == 0u) {
    return QTR_OK;
  }
  if (!is_whole(bytes, size)) {
    return QTR_ERR_CORRUPT;
  }
  for (uint32_t at = HEAD; at < size;) {
    if (((size - at) < ENTRY) || (qtr_load16(bytes + at + 2u) > (size - at - ENTRY))) {
      return QTR_ERR_CORRUPT;
    }
    const uint32_t length = qtr_load16(bytes + at + 2u);
    take(mission, qtr_load16(bytes + at), bytes + at + ENTRY, length);
    at += ENTRY + length;
  }
  return QTR_OK;
}

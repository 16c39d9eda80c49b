#include "quarter/names.h"

#include <stddef.h>

#include "core/bytes.h"
#include "core/crc.h"
#include "quarter/status.h"

/* "QTRH", u16 version, u16 0, u32 bytes in all, u32 CRC-32 of the entries; then entries: u16 what, u16 length, as many
 * bytes. Entries of a later version are passed over. */
enum {
  MAGIC = 4,
  VERSION = 1,
  SIZE_AT = 8,
  CRC_AT = 12,
  HEAD = 16,
  ENTRY = 4,
  MISSION_NAME = 1,
  GEOGRAPHIC_ORIGIN = 2,
  PLACE_NAME = 3,
  SEEKER_NAME = 4,
  ORIGIN_BYTES = 24,
  INDEX_BYTES = 2
};

/* A name that is cut would be another name: one that is too long is left out whole. */
static uint32_t length_of(const char *name, uint32_t room) {
  uint32_t length = 0;
  while ((length < room) && (name[length] != '\0')) {
    length++;
  }
  return (length < room) ? length : 0u;
}

/* Bytes of the entry that names a place or a seeker. */
static uint32_t site_size(const char *name) {
  const uint32_t length = length_of(name, QTR_SITE_NAME_BYTES);
  return (length > 0u) ? ((uint32_t)ENTRY + INDEX_BYTES + length) : 0u;
}

uint32_t qtr_names_size(const qtr_names *names, const qtr_geo *geo) {
  const uint32_t length = length_of(names->mission, QTR_NAME_BYTES);
  uint32_t size = HEAD;
  if (length > 0u) {
    size += ENTRY + length;
  }
  if (geo->given) {
    size += (uint32_t)ENTRY + ORIGIN_BYTES;
  }
  for (uint32_t i = 0; i < (uint32_t)QTR_MAX_PLACES; i++) {
    size += site_size(names->place[i]);
  }
  for (uint32_t i = 0; i < (uint32_t)QTR_MAX_SEEKERS; i++) {
    size += site_size(names->seeker[i]);
  }
  return (size > (uint32_t)HEAD) ? size : 0u;
}

/* The head of an entry; where its bytes go. */
static uint8_t *begin_entry(uint8_t *at, uint32_t what, uint32_t length) {
  qtr_store16(at, what);
  qtr_store16(at + 2u, length);
  return at + ENTRY;
}

/* The entry of a place or a seeker that has a name; what comes behind it. */
static uint8_t *write_site(uint8_t *bytes, uint32_t what, uint32_t index, const char *name) {
  const uint32_t length = length_of(name, QTR_SITE_NAME_BYTES);
  uint8_t *at = bytes;
  if (length > 0u) {
    at = begin_entry(at, what, INDEX_BYTES + length);
    qtr_store16(at, index);
    bytes_copy(at + INDEX_BYTES, name, length);
    at = &at[INDEX_BYTES + length];
  }
  return at;
}

/* The sum is over the entries, so that a torn write behind the table is seen without a look at the table. */
void qtr_names_write(uint8_t *bytes, const qtr_names *names, const qtr_geo *geo) {
  const uint32_t size = qtr_names_size(names, geo);
  const uint32_t length = length_of(names->mission, QTR_NAME_BYTES);
  if (size == 0u) {
    return;
  }
  bytes_clear(bytes, HEAD);
  bytes_copy(bytes, "QTRH", MAGIC);
  qtr_store16(bytes + MAGIC, VERSION);
  qtr_store32(bytes + SIZE_AT, size);
  uint8_t *at = bytes + HEAD;
  if (length > 0u) {
    at = begin_entry(at, MISSION_NAME, length);
    bytes_copy(at, names->mission, length);
    at = &at[length];
  }
  if (geo->given) {
    at = begin_entry(at, GEOGRAPHIC_ORIGIN, ORIGIN_BYTES);
    qtr_store64(at, (uint64_t)geo->latitude);
    qtr_store64(at + 8u, (uint64_t)geo->longitude);
    qtr_store64(at + 16u, (uint64_t)geo->yaw);
    at = &at[ORIGIN_BYTES];
  }
  for (uint32_t i = 0; i < (uint32_t)QTR_MAX_PLACES; i++) {
    at = write_site(at, PLACE_NAME, i, names->place[i]);
  }
  for (uint32_t i = 0; i < (uint32_t)QTR_MAX_SEEKERS; i++) {
    at = write_site(at, SEEKER_NAME, i, names->seeker[i]);
  }
  qtr_store32(bytes + CRC_AT, qtr_crc32_add(0, bytes + HEAD, size - HEAD));
}

/* Sizes must agree to the byte: behind the names nothing more is kept. */
static bool is_whole(const uint8_t *bytes, uint32_t size) {
  return (size >= HEAD) && bytes_begin(bytes, "QTRH") && (qtr_load32(bytes + MAGIC) == (uint32_t)VERSION) &&
         (qtr_load32(bytes + SIZE_AT) == size) &&
         (qtr_load32(bytes + CRC_AT) == qtr_crc32_add(0, bytes + HEAD, size - HEAD));
}

static bool is_within(int64_t value, int64_t most) {
  return (value >= -most) && (value <= most);
}

static bool take_origin(qtr_geo *geo, const uint8_t *bytes, uint32_t length) {
  if (length != (uint32_t)ORIGIN_BYTES) {
    return false;
  }
  geo->given = true;
  geo->latitude = (int64_t)qtr_load64(bytes);
  geo->longitude = (int64_t)qtr_load64(bytes + 8u);
  geo->yaw = (int64_t)qtr_load64(bytes + 16u);
  return is_within(geo->latitude, 90 * QTR_GEO_ONE) && is_within(geo->longitude, 180 * QTR_GEO_ONE) &&
         is_within(geo->yaw, QTR_GEO_TURN);
}

/* The name of one of `count`, `all` of QTR_SITE_NAME_BYTES each. */
static bool take_site(char *all, uint32_t count, const uint8_t *bytes, uint32_t length) {
  if ((length <= (uint32_t)INDEX_BYTES) || ((length - INDEX_BYTES) >= (uint32_t)QTR_SITE_NAME_BYTES) ||
      (qtr_load16(bytes) >= count)) {
    return false;
  }
  char *name = &all[qtr_load16(bytes) * (uint32_t)QTR_SITE_NAME_BYTES];
  bytes_copy(name, &bytes[INDEX_BYTES], length - INDEX_BYTES);
  name[length - INDEX_BYTES] = '\0';
  return true;
}

/* Whether an entry is sound; one that is not known is. */
static bool take(qtr_names *names, qtr_geo *geo, uint32_t what, const uint8_t *bytes, uint32_t length) {
  bool sound = true;
  switch (what) {
  case MISSION_NAME:
    if (length < (uint32_t)QTR_NAME_BYTES) {
      bytes_copy(names->mission, bytes, length);
      names->mission[length] = '\0';
    }
    break;
  case GEOGRAPHIC_ORIGIN: sound = take_origin(geo, bytes, length); break;
  case PLACE_NAME: sound = take_site(names->place[0], QTR_MAX_PLACES, bytes, length); break;
  case SEEKER_NAME: sound = take_site(names->seeker[0], QTR_MAX_SEEKERS, bytes, length); break;
  default: break;
  }
  return sound;
}

/* Each length is held against what is left before it is used, so that no bytes lead outside. */
int qtr_names_read(qtr_names *names, qtr_geo *geo, const uint8_t *bytes, uint32_t size) {
  bytes_clear(names, (uint32_t)sizeof *names);
  bytes_clear(geo, (uint32_t)sizeof *geo);
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
    if (!take(names, geo, qtr_load16(bytes + at), bytes + at + ENTRY, length)) {
      return QTR_ERR_CORRUPT;
    }
    at += ENTRY + length;
  }
  return QTR_OK;
}

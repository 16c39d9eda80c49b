/* Policy tables changed byte by byte, and made right again. */
#ifndef QUARTER_TESTS_FORGING_H
#define QUARTER_TESTS_FORGING_H

#include "core/bytes.h"
#include "core/crc.h"
#include "robot/layout.h"
#include "tables.h"

/* Make the checksum right again. */
static inline void table_seal(uint8_t *bytes, uint32_t size) {
  qtr_store32(bytes + QTR_POLICY_CRC, qtr_crc32_add(0, bytes + QTR_POLICY_COLUMNS, size - QTR_POLICY_COLUMNS));
}

/* Open, and check as a host does. */
static inline int table_open_checked(qtr_policy *policy, const uint8_t *bytes, uint32_t size) {
  const int status = qtr_policy_open(policy, bytes, size);
  return status == QTR_OK ? qtr_policy_check(policy) : status;
}

/* Make checksum and digest right for what the bytes say now, as a forger would, and open as a robot does. */
static inline int table_forge_for_robots(qtr_policy *policy, uint8_t *bytes, uint32_t size) {
  table_seal(bytes, size);
  const int status = qtr_policy_open(policy, bytes, size);
  if (status != QTR_ERR_SELFTEST || (policy->records_shape.key_bytes + 3u) / 4u != bytes[QTR_POLICY_KEY_WORDS])
    return status;
  qtr_store32(bytes + QTR_POLICY_DIGEST, qtr_policy_digest(policy));
  table_seal(bytes, size);
  return qtr_policy_open(policy, bytes, size);
}

/* The same as a host does. */
static inline int table_forge(qtr_policy *policy, uint8_t *bytes, uint32_t size) {
  const int status = table_forge_for_robots(policy, bytes, size);
  return status == QTR_OK ? qtr_policy_check(policy) : status;
}

#endif

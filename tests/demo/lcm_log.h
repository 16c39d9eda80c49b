/* LCM logs, read and written byte by byte as LCM's documentation has them: for each event, big-endian, a mark of 4
 * bytes, the event's number (8), its time in microseconds (8), the lengths of channel and data (4 each), then these. */
#ifndef QUARTER_TESTS_DEMO_LCM_LOG_H
#define QUARTER_TESTS_DEMO_LCM_LOG_H

#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include "unity.h"

#define LOG_MARK 0xEDA1DA01u

enum { LOG_DATA_MOST = 1024 };

typedef struct {
  uint64_t number;
  int64_t time;
  char channel[64];
  int length;
  uint8_t data[LOG_DATA_MOST];
} log_event;

static inline void log_put(FILE *file, uint64_t value, int bytes) {
  for (int i = bytes - 1; i >= 0; i--) fputc((int)(value >> 8 * i & 255u), file);
}

static inline uint64_t log_get(FILE *file, int bytes) {
  uint64_t value = 0;
  for (int i = 0; i < bytes; i++) value = value << 8 | ((uint64_t)fgetc(file) & 255u);
  return value;
}

static inline void log_write(FILE *file, const log_event *e) {
  log_put(file, LOG_MARK, 4);
  log_put(file, e->number, 8);
  log_put(file, (uint64_t)e->time, 8);
  log_put(file, strlen(e->channel), 4);
  log_put(file, (uint64_t)e->length, 4);
  fputs(e->channel, file);
  fwrite(e->data, 1, (size_t)e->length, file);
}

/* False at the end of the log. */
static inline int log_read(FILE *file, log_event *e) {
  const int first = fgetc(file);
  if (first == EOF) return 0;
  ungetc(first, file);
  TEST_ASSERT_EQUAL_HEX32(LOG_MARK, (uint32_t)log_get(file, 4));
  e->number = log_get(file, 8);
  e->time = (int64_t)log_get(file, 8);
  const uint64_t name = log_get(file, 4);
  const uint64_t length = log_get(file, 4);
  TEST_ASSERT_LESS_THAN_UINT64(sizeof e->channel, name);
  TEST_ASSERT_LESS_OR_EQUAL_UINT64(LOG_DATA_MOST, length);
  TEST_ASSERT_EQUAL_size_t(name, fread(e->channel, 1, name, file));
  TEST_ASSERT_EQUAL_size_t(length, fread(e->data, 1, length, file));
  e->channel[name] = '\0';
  e->length = (int)length;
  return 1;
}

#endif

/* What the readers' tests share: files in a scratch folder of their own, and what reading one must give. */
#ifndef QUARTER_TESTS_READER_SCRATCH_H
#define QUARTER_TESTS_READER_SCRATCH_H

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "host/input/read.h"
#include "unity.h"

#define SCRATCH_FILES 64

static input scratch_input;
static fault scratch_fault;
static input_options scratch_options;
static char scratch_folder[32];
static char scratch_names[SCRATCH_FILES][64];
static int scratch_count;

static inline void scratch_open(void) {
  strcpy(scratch_folder, "reader_XXXXXX");
  TEST_ASSERT_NOT_NULL(mkdtemp(scratch_folder));
  scratch_count = 0;
  memset(&scratch_options, 0, sizeof scratch_options);
  scratch_fault.text[0] = '\0';
}

static inline const char *scratch_path(const char *name) {
  static char path[128];
  snprintf(path, sizeof path, "%s/%s", scratch_folder, name);
  return path;
}

static inline void scratch_close(void) {
  while (scratch_count > 0) unlink(scratch_path(scratch_names[--scratch_count]));
  rmdir(scratch_folder);
}

static inline void scratch_write_bytes(const char *name, const void *data, size_t size) {
  int known = 0;
  while (known < scratch_count && strcmp(scratch_names[known], name) != 0) known++;
  TEST_ASSERT_LESS_THAN_INT(SCRATCH_FILES, known);
  if (known == scratch_count) snprintf(scratch_names[scratch_count++], sizeof *scratch_names, "%s", name);
  remove(scratch_path(name)); /* some file systems wait for the disk when a file is cut to nothing and written anew */
  FILE *file = fopen(scratch_path(name), "wb");
  TEST_ASSERT_NOT_NULL(file);
  TEST_ASSERT_EQUAL_size_t(size, fwrite(data, 1, size, file));
  TEST_ASSERT_EQUAL_INT(0, fclose(file));
}

static inline void scratch_write(const char *name, const char *text) {
  scratch_write_bytes(name, text, strlen(text));
}

/* Read a scratch file, which must work. */
static inline void scratch_read(const char *name) {
  int result = input_read(&scratch_input, scratch_path(name), &scratch_options, &scratch_fault);
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, result, scratch_fault.text);
}

static inline void scratch_expect_text(const char *wanted) {
  if (strstr(scratch_fault.text, wanted) != NULL) return;
  static char message[FAULT_SIZE + 400];
  snprintf(message, sizeof message, "\"%s\" is not in: %s", wanted, scratch_fault.text);
  TEST_FAIL_MESSAGE(message);
}

/* Read a scratch file, which must be refused in one line that starts with "where: ", a place in the scratch folder, and
 * holds `what` and `mend`. */
static inline void scratch_refuse(const char *name, const char *where, const char *what, const char *mend) {
  char start[160];
  scratch_fault.text[0] = '\0';
  int result = input_read(&scratch_input, scratch_path(name), &scratch_options, &scratch_fault);
  TEST_ASSERT_EQUAL_INT_MESSAGE(-1, result, name);
  TEST_ASSERT_NULL_MESSAGE(strchr(scratch_fault.text, '\n'), scratch_fault.text);
  snprintf(start, sizeof start, "%s/%s: ", scratch_folder, where);
  if (strncmp(scratch_fault.text, start, strlen(start)) != 0) scratch_expect_text(start);
  scratch_expect_text(what);
  scratch_expect_text(mend);
}

/* The cells as a drawing: # blocked, the cost of others as a digit; rows end with '|'. */
static inline void scratch_expect_cells(const char *wanted) {
  static char drawn[4096];
  const qtr_mission *mission = &scratch_input.mission;
  size_t used = 0;
  for (int row = 0; row < mission->rows; row++) {
    for (int column = 0; column < mission->columns && used + 2 < sizeof drawn; column++) {
      int cost = mission->cost[row * mission->columns + column];
      drawn[used++] = cost == 0 ? '#' : (char)('0' + cost);
    }
    if (used + 2 < sizeof drawn) drawn[used++] = '|';
  }
  drawn[used] = '\0';
  TEST_ASSERT_EQUAL_STRING(wanted, drawn);
}

/* A ROS map, its image, and a mission on it. */
static inline void scratch_write_rosmap(const char *yaml, const char *pgm, const char *mission) {
  scratch_write("m.yaml", yaml);
  scratch_write("m.pgm", pgm);
  scratch_write("mission.yaml", mission);
}

#endif

/* Output files: whole or not at all, and never in the place of something that is no file. */
#include <dirent.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "host/base/outfile.h"
#include "unity.h"

static char folder[32];
static outfile out;
static fault why;

void setUp(void) {
  strcpy(folder, "outfile_XXXXXX");
  TEST_ASSERT_NOT_NULL(mkdtemp(folder));
  why.text[0] = '\0';
}

static const char *path_of(const char *name) {
  static char path[600];
  snprintf(path, sizeof path, "%s/%s", folder, name);
  return path;
}

/* The names in the folder, but for . and .. */
static int count_entries(void) {
  int count = 0;
  DIR *listing = opendir(folder);
  while (readdir(listing) != NULL) count++;
  closedir(listing);
  return count - 2;
}

void tearDown(void) {
  DIR *listing = opendir(folder);
  for (struct dirent *entry; (entry = readdir(listing)) != NULL;)
    if (entry->d_name[0] != '.' || strlen(entry->d_name) > 2) remove(path_of(entry->d_name));
  closedir(listing);
  rmdir(folder);
}

static void put(const char *path, const char *text) {
  FILE *file = fopen(path, "w");
  fputs(text, file);
  fclose(file);
}

static void assert_holds(const char *path, const char *expected) {
  char text[64] = "";
  FILE *file = fopen(path, "r");
  TEST_ASSERT_NOT_NULL_MESSAGE(file, path);
  TEST_ASSERT_EQUAL_size_t(strlen(expected), fread(text, 1, sizeof text - 1, file));
  fclose(file);
  TEST_ASSERT_EQUAL_STRING(expected, text);
}

static void assert_fault(const char *path, const char *reason, const char *mend) {
  TEST_ASSERT_EQUAL_STRING_LEN_MESSAGE(path, why.text, strlen(path), why.text);
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(why.text, reason), why.text);
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(why.text, mend), why.text);
  TEST_ASSERT_NULL(strchr(why.text, '\n'));
}

static void test_file_appears_at_commit_and_no_sooner(void) {
  const char *path = path_of("table.qtr");
  TEST_ASSERT_EQUAL_INT(0, outfile_open(&out, path, &why));
  fputs("whole", out.file);
  TEST_ASSERT_EQUAL_INT(-1, access(path, F_OK));
  TEST_ASSERT_EQUAL_INT(0, outfile_commit(&out, &why));
  assert_holds(path, "whole");
  TEST_ASSERT_EQUAL_INT(1, count_entries());
}

static void test_abort_leaves_the_old_file_and_nothing_else(void) {
  const char *path = path_of("table.qtr");
  put(path, "old");
  TEST_ASSERT_EQUAL_INT(0, outfile_open(&out, path, &why));
  fputs("half", out.file);
  outfile_abort(&out);
  outfile_abort(&out); /* once more does no harm */
  assert_holds(path, "old");
  TEST_ASSERT_EQUAL_INT(1, count_entries());
}

static void test_commit_replaces_the_old_file(void) {
  const char *path = path_of("table.qtr");
  put(path, "old and longer");
  TEST_ASSERT_EQUAL_INT(0, outfile_open(&out, path, &why));
  fputs("new", out.file);
  TEST_ASSERT_EQUAL_INT(0, outfile_commit(&out, &why));
  assert_holds(path, "new");
  TEST_ASSERT_EQUAL_INT(1, count_entries());
}

static void test_permissions_follow_the_umask(void) {
  struct stat about;
  const mode_t before = umask(027);
  TEST_ASSERT_EQUAL_INT(0, outfile_open(&out, path_of("a"), &why));
  TEST_ASSERT_EQUAL_INT(0, outfile_commit(&out, &why));
  TEST_ASSERT_EQUAL_HEX(027, umask(before));
  TEST_ASSERT_EQUAL_INT(0, stat(path_of("a"), &about));
  TEST_ASSERT_EQUAL_HEX(0640, about.st_mode & 0777);
}

static void test_link_stays_and_the_file_behind_it_is_replaced(void) {
  struct stat about;
  put(path_of("real"), "old");
  TEST_ASSERT_EQUAL_INT(0, symlink("real", path_of("link")));
  TEST_ASSERT_EQUAL_INT(0, outfile_open(&out, path_of("link"), &why));
  fputs("new", out.file);
  TEST_ASSERT_EQUAL_INT(0, outfile_commit(&out, &why));
  assert_holds(path_of("real"), "new");
  TEST_ASSERT_EQUAL_INT(0, lstat(path_of("link"), &about));
  TEST_ASSERT_TRUE(S_ISLNK(about.st_mode));
  TEST_ASSERT_EQUAL_INT(2, count_entries());
}

static void test_folder_that_does_not_exist_is_refused(void) {
  const char *path = path_of("missing/table.qtr");
  TEST_ASSERT_EQUAL_INT(-1, outfile_open(&out, path, &why));
  assert_fault(path, "No such file or directory", "make its folder first");
}

static void test_folder_as_a_file_is_refused(void) {
  TEST_ASSERT_EQUAL_INT(-1, outfile_open(&out, folder, &why));
  assert_fault(folder, "Is a directory", "name a file in it");
  TEST_ASSERT_EQUAL_INT(0, count_entries());
}

static void test_file_as_a_folder_is_refused(void) {
  put(path_of("file"), "");
  const char *path = path_of("file/table.qtr");
  TEST_ASSERT_EQUAL_INT(-1, outfile_open(&out, path, &why));
  assert_fault(path, "Not a directory", "not a folder");
}

static void test_folder_without_permission_is_refused(void) {
  const char *path = path_of("table.qtr");
  if (geteuid() == 0) TEST_IGNORE_MESSAGE("root may write anywhere");
  chmod(folder, 0500);
  const int status = outfile_open(&out, path, &why);
  chmod(folder, 0700);
  TEST_ASSERT_EQUAL_INT(-1, status);
  assert_fault(path, "Permission denied", "may write to");
}

static void test_empty_and_endless_names_are_refused(void) {
  static char endless[3 * OUTFILE_PATH_SIZE];
  TEST_ASSERT_EQUAL_INT(-1, outfile_open(&out, "", &why));
  memset(endless, 'x', sizeof endless - 1);
  TEST_ASSERT_EQUAL_INT(-1, outfile_open(&out, endless, &why));
}

static void test_full_disk_is_reported_at_commit(void) {
  if (access("/dev/full", W_OK) != 0) TEST_IGNORE_MESSAGE("no /dev/full here");
  struct stat about;
  TEST_ASSERT_EQUAL_INT(0, outfile_open(&out, "/dev/full", &why));
  fputs("text", out.file);
  TEST_ASSERT_EQUAL_INT(-1, outfile_commit(&out, &why));
  assert_fault("/dev/full", "No space left", "free some space");
  TEST_ASSERT_EQUAL_INT(0, stat("/dev/full", &about));
  TEST_ASSERT_TRUE(S_ISCHR(about.st_mode));
}

static void test_full_disk_is_reported_when_it_showed_while_writing(void) {
  if (access("/dev/full", W_OK) != 0) TEST_IGNORE_MESSAGE("no /dev/full here");
  TEST_ASSERT_EQUAL_INT(0, outfile_open(&out, "/dev/full", &why));
  for (int line = 0; line < 5000; line++) fputs("more than a buffer holds\n", out.file);
  fflush(out.file);
  TEST_ASSERT_EQUAL_INT(-1, outfile_commit(&out, &why));
  assert_fault("/dev/full", "No space left", "free some space");
}

static void test_pipe_is_written_to_and_stays_a_pipe(void) {
  struct stat about;
  char text[16] = "";
  const char *path = path_of("pipe");
  TEST_ASSERT_EQUAL_INT(0, mkfifo(path, 0600));
  const int reader = open(path, O_RDONLY | O_NONBLOCK);
  TEST_ASSERT_EQUAL_INT(0, outfile_open(&out, path, &why));
  fputs("through", out.file);
  TEST_ASSERT_EQUAL_INT(0, outfile_commit(&out, &why));
  TEST_ASSERT_EQUAL_INT(7, read(reader, text, sizeof text - 1));
  close(reader);
  TEST_ASSERT_EQUAL_STRING("through", text);
  TEST_ASSERT_EQUAL_INT(0, stat(path, &about));
  TEST_ASSERT_TRUE(S_ISFIFO(about.st_mode));
}

static void test_dash_is_standard_output_and_stays_open(void) {
  TEST_ASSERT_EQUAL_INT(0, outfile_open(&out, "-", &why));
  TEST_ASSERT_EQUAL_PTR(stdout, out.file);
  TEST_ASSERT_EQUAL_INT(0, outfile_commit(&out, &why));
  TEST_ASSERT_EQUAL_INT(0, outfile_open(&out, "/dev/stdout", &why));
  TEST_ASSERT_EQUAL_PTR(stdout, out.file);
  outfile_abort(&out);
  TEST_ASSERT_EQUAL_INT(0, fflush(stdout));
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_file_appears_at_commit_and_no_sooner);
  RUN_TEST(test_abort_leaves_the_old_file_and_nothing_else);
  RUN_TEST(test_commit_replaces_the_old_file);
  RUN_TEST(test_permissions_follow_the_umask);
  RUN_TEST(test_link_stays_and_the_file_behind_it_is_replaced);
  RUN_TEST(test_folder_that_does_not_exist_is_refused);
  RUN_TEST(test_folder_as_a_file_is_refused);
  RUN_TEST(test_file_as_a_folder_is_refused);
  RUN_TEST(test_folder_without_permission_is_refused);
  RUN_TEST(test_empty_and_endless_names_are_refused);
  RUN_TEST(test_full_disk_is_reported_at_commit);
  RUN_TEST(test_full_disk_is_reported_when_it_showed_while_writing);
  RUN_TEST(test_pipe_is_written_to_and_stays_a_pipe);
  RUN_TEST(test_dash_is_standard_output_and_stays_open);
  return UNITY_END();
}

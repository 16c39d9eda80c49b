#include "outputs.h"

#include <errno.h>
#include <fcntl.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "host/base/file.h"
#include "host/base/outfile.h"

#define FILES 8
#define OUTPUTS 4 /* of them, the first */

static bool exists(const char *path, struct stat *about) {
  return path != NULL && stat(path, about) == 0;
}

static bool is_file(const char *path) {
  return path != NULL && strcmp(path, "-") != 0;
}

/* By what they are, whatever they are called. Devices may be named twice. */
static bool is_same(const char *a, const char *b) {
  struct stat about;
  if (!is_file(a) || !is_file(b) || (exists(a, &about) && !S_ISREG(about.st_mode))) return false;
  return outfile_is_same(a, b);
}

/* The log is written as the game goes on. What is there already is not touched yet. */
static int try_log(const char *path, fault *why) {
  struct stat about;
  if (path == NULL || (exists(path, &about) && S_ISFIFO(about.st_mode))) return 0;
  const bool there = lstat(path, &about) == 0;
  const int file = open(path, O_WRONLY | O_CREAT | O_APPEND, 0666);
  if (file < 0) return fault_set(why, "%s: the log cannot be written: %s; name another", path, strerror(errno));
  close(file);
  if (!there) unlink(path);
  return 0;
}

static void list(const char *file[FILES], const settings *s) {
  const char *const all[FILES] = {s->replay, s->save, s->json_path, s->log, s->mission, s->table, s->faults, s->key};
  memcpy(file, all, sizeof all);
}

int outputs_check(const settings *s, fault *why) {
  const char *file[FILES];
  list(file, s);
  for (int i = 0; i < OUTPUTS; i++)
    for (int j = i + 1; j < FILES; j++)
      if (is_same(file[i], file[j]))
        return fault_set(why, "%s: named twice, and %s; name another file for one of them", file[i],
                         j < OUTPUTS ? "one output would overwrite the other" : "the output would overwrite the input");
  for (int i = 0; i < OUTPUTS - 1; i++)
    if (is_file(file[i]) && outfile_try(file[i], why) != 0) return -1;
  return try_log(s->log, why);
}

int outputs_spare_read(const settings *s, fault *why) {
  const char *file[FILES];
  list(file, s);
  for (int i = 0; i < OUTPUTS; i++)
    if (is_file(file[i]) && file_was_read(file[i]))
      return fault_set(why, "%s: is what %s names, and the output would overwrite the input; name another file",
                       file[i], s->mission);
  return 0;
}

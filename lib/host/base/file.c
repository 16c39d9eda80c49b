#include "host/base/file.h"

#include <errno.h>
#include <fcntl.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#define SHOWN_PATH 400
#define READ_MOST 64

/* What has been read, so that nothing is written over it. */
static struct {
  dev_t device;
  ino_t number;
} read_files[READ_MOST];
static int read_count;

const char *file_short_path(const char *path) {
  size_t length = strlen(path);
  return length <= SHOWN_PATH ? path : path + length - SHOWN_PATH;
}

int file_fault(fault *why, const char *path, long line, long column, const char *format, ...) {
  char message[FAULT_LINE];
  va_list arguments;
  va_start(arguments, format);
  vsnprintf(message, sizeof message, format, arguments);
  va_end(arguments);
  const char *shown = file_short_path(path);
  if (line <= 0) return fault_set(why, "%s: %s", shown, message);
  if (column <= 0) return fault_set(why, "%s:%ld: %s", shown, line, message);
  return fault_set(why, "%s:%ld:%ld: %s", shown, line, column, message);
}

/* The fault of a file that cannot be read at all, with who asked for it. */
static int no_file(fault *why, const char *path, const char *named_by, const char *what) {
  if (named_by == NULL) return file_fault(why, path, 0, 0, "%s", what);
  return file_fault(why, path, 0, 0, "%s (named by %s)", what, file_short_path(named_by));
}

static int too_large(fault *why, const char *path, size_t limit) {
  const bool small = limit < (size_t)1 << 20;
  return file_fault(why, path, 0, 0,
                    "holds more than the %zu %s that such a file may have; check that it is the right one",
                    small ? limit : limit >> 20, small ? "bytes" : "MiB");
}

/* What keeps an open file from being read, NULL if nothing does. */
static const char *kind_fault(const struct stat *status) {
  if (S_ISDIR(status->st_mode)) return "is a folder; name a file in it";
  if (!S_ISREG(status->st_mode)) return "is a device or pipe; save what it gives in a file and name that";
  return NULL;
}

/* Append what is left of the file, at most limit + 1 bytes in all. False: errno says why. */
static bool read_all(int descriptor, file_bytes *bytes, size_t limit) {
  size_t room = 0;
  for (;;) {
    if (bytes->size + 1 >= room) {
      room = room == 0 ? 65536 : room * 2;
      unsigned char *larger = realloc(bytes->data, room);
      if (larger == NULL) return false;
      bytes->data = larger;
    }
    ssize_t got = read(descriptor, bytes->data + bytes->size, room - bytes->size - 1);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return false;
    if (got == 0 || bytes->size > limit) break;
    bytes->size += (size_t)got;
  }
  bytes->data[bytes->size] = '\0';
  return true;
}

static int open_fault(fault *why, const char *path, const char *named_by) {
  switch (errno) {
  case ENOENT:
  case ENOTDIR: return no_file(why, path, named_by, "no such file; check its name");
  case EACCES: return no_file(why, path, named_by, "may not be read; check its permissions");
  case ENAMETOOLONG: return no_file(why, path, named_by, "the name is too long for a file; shorten it");
  default: return no_file(why, path, named_by, strerror(errno));
  }
}

static int find_read(const struct stat *status) {
  int i = 0;
  while (i < read_count && (read_files[i].device != status->st_dev || read_files[i].number != status->st_ino)) i++;
  return i;
}

static void note_read(const struct stat *status) {
  const int i = find_read(status);
  if (i == READ_MOST) return;
  read_files[i].device = status->st_dev;
  read_files[i].number = status->st_ino;
  if (i == read_count) read_count++;
}

bool file_was_read(const char *path) {
  struct stat status;
  return stat(path, &status) == 0 && find_read(&status) < read_count;
}

void file_forget(const char *path) {
  struct stat status;
  if (stat(path, &status) != 0) return;
  const int i = find_read(&status);
  if (i < read_count) read_files[i] = read_files[--read_count];
}

/* The size that the system states may be wrong either way: of a file that grows, or of one under /proc. */
static int read_open(int descriptor, file_bytes *bytes, const char *path, size_t limit, const char *named_by,
                     fault *why) {
  struct stat status;
  if (fstat(descriptor, &status) != 0) return no_file(why, path, named_by, strerror(errno));
  const char *wrong = kind_fault(&status);
  if (wrong != NULL) return no_file(why, path, named_by, wrong);
  if (status.st_size > (off_t)limit) return too_large(why, path, limit);
  if (!read_all(descriptor, bytes, limit)) return no_file(why, path, named_by, strerror(errno));
  if (bytes->size > limit) return too_large(why, path, limit);
  if (bytes->size == 0) return no_file(why, path, named_by, "is empty; check that it was written or copied whole");
  note_read(&status);
  return 0;
}

int file_read(file_bytes *bytes, const char *path, size_t limit, const char *named_by, fault *why) {
  bytes->data = NULL;
  bytes->size = 0;
  if (path[0] == '\0') return fault_set(why, "the name of the input is empty; name a file");
  /* Without O_NONBLOCK opening a pipe that nobody writes to would hang. */
  int descriptor = open(path, O_RDONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY);
  if (descriptor < 0) return open_fault(why, path, named_by);
  int result = read_open(descriptor, bytes, path, limit, named_by, why);
  close(descriptor);
  if (result != 0) file_free(bytes);
  return result;
}

void file_free(file_bytes *bytes) {
  free(bytes->data);
  bytes->data = NULL;
  bytes->size = 0;
}

int file_path_beside(char *out, size_t size, const char *beside, const char *name, fault *why) {
  const char *slash = strrchr(beside, '/');
  size_t folder = slash == NULL || name[0] == '/' ? 0 : (size_t)(slash - beside) + 1;
  size_t length = strlen(name);
  if (folder + length + 1 > size) {
    return file_fault(why, beside, 0, 0, "the path of a file that it names is longer than %zu bytes; shorten it",
                      size - 1);
  }
  memcpy(out, beside, folder);
  memcpy(out + folder, name, length + 1);
  return 0;
}

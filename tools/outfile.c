#define _XOPEN_SOURCE 700 /* realpath() */

#include "outfile.h"

#include <errno.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static const char *mend_of(int error) {
  switch (error) {
  case ENOENT: return "make its folder first";
  case ENOTDIR: return "a part of the path is a file, not a folder";
  case EACCES:
  case EPERM:
  case EROFS: return "choose a folder that you may write to";
  case EISDIR: return "name a file in it";
  case ENOSPC:
  case EDQUOT: return "free some space or write elsewhere";
  default: return "write elsewhere";
  }
}

static int cannot_write(const outfile *out, int error, fault *why) {
  return fault_set(why, "%s: cannot write: %s; %s", out->path, strerror(error), mend_of(error));
}

/* Under these a name stands for what is open elsewhere, and may lead to a plain file all the same. */
static bool is_device_name(const char *path) {
  return strncmp(path, "/dev/", 5) == 0 || strncmp(path, "/proc/", 6) == 0;
}

/* Standard output, devices and pipes are written to as they are: a rename would put a file in their place. */
static int open_directly(outfile *out, fault *why) {
  const bool standard = strcmp(out->path, "-") == 0 || strcmp(out->path, "/dev/stdout") == 0;
  out->file = standard ? stdout : fopen(out->path, "w");
  return out->file != NULL ? 0 : cannot_write(out, errno, why);
}

/* The file to replace, in `target`. False if there is a link that leads nowhere. */
static bool find_target(outfile *out) {
  struct stat about;
  if (lstat(out->path, &about) == 0 && S_ISLNK(about.st_mode)) {
    char *resolved = realpath(out->path, NULL);
    const bool fits = resolved != NULL && strlen(resolved) < sizeof out->target;
    if (fits) strcpy(out->target, resolved);
    free(resolved);
    return fits;
  }
  if (strlen(out->path) < sizeof out->target) strcpy(out->target, out->path);
  return true;
}

static int open_temporary(outfile *out, fault *why) {
  const int length = snprintf(out->temporary, sizeof out->temporary, "%s.XXXXXX", out->target);
  if (out->target[0] == '\0' || length < 0 || (size_t)length >= sizeof out->temporary) {
    out->temporary[0] = '\0';
    return cannot_write(out, out->path[0] == '\0' ? ENOENT : ENAMETOOLONG, why);
  }
  const int descriptor = mkstemp(out->temporary);
  if (descriptor < 0) {
    out->temporary[0] = '\0';
    return cannot_write(out, errno, why);
  }
  const mode_t mask = umask(0);
  umask(mask);
  fchmod(descriptor, 0666 & ~mask);
  out->file = fdopen(descriptor, "w");
  if (out->file != NULL) return 0;
  const int error = errno;
  close(descriptor);
  unlink(out->temporary);
  return cannot_write(out, error, why);
}

int outfile_open(outfile *out, const char *path, fault *why) {
  struct stat about;
  *out = (outfile){NULL, path, "", ""};
  if (strcmp(path, "-") == 0 || is_device_name(path)) return open_directly(out, why);
  const bool exists = stat(path, &about) == 0;
  if (exists && S_ISDIR(about.st_mode)) return cannot_write(out, EISDIR, why);
  if ((exists && !S_ISREG(about.st_mode)) || !find_target(out)) return open_directly(out, why);
  return open_temporary(out, why);
}

/* Flush and close. The first error counts: a full disk may show at any of these. */
static int close_file(outfile *out) {
  int error = 0;
  if (ferror(out->file) != 0) error = ENOSPC;
  errno = 0;
  if (fflush(out->file) != 0) error = errno;
  if (error == 0 && out->temporary[0] != '\0' && fsync(fileno(out->file)) != 0) error = errno;
  if (out->file != stdout && fclose(out->file) != 0 && error == 0) error = errno;
  out->file = NULL;
  return error;
}

int outfile_commit(outfile *out, fault *why) {
  int error = close_file(out);
  if (error == 0 && out->temporary[0] != '\0' && rename(out->temporary, out->target) != 0) error = errno;
  if (error == 0) return 0;
  if (out->temporary[0] != '\0') unlink(out->temporary);
  return cannot_write(out, error, why);
}

void outfile_abort(outfile *out) {
  if (out->file == NULL) return;
  if (out->file != stdout) fclose(out->file);
  if (out->temporary[0] != '\0') unlink(out->temporary);
  out->file = NULL;
}

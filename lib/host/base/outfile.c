#define _XOPEN_SOURCE 700 /* realpath() */

#include "host/base/outfile.h"

#include <errno.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "host/base/file.h"

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

/* That of the file to be replaced, or of any new file. */
static mode_t mode_of(const outfile *out) {
  struct stat about;
  const mode_t mask = umask(0);
  umask(mask);
  return stat(out->target, &about) == 0 ? about.st_mode & 0777 : 0666 & ~mask;
}

/* ---- temporary files, known to whoever ends the program ---- */

static outfile *volatile under_way;

/* No signal sees a file that is there and not in the list, or a list that is half changed. */
static sigset_t hold_signals(void) {
  sigset_t all, before;
  sigfillset(&all);
  sigprocmask(SIG_BLOCK, &all, &before);
  return before;
}

static int make_temporary(outfile *out) {
  const sigset_t before = hold_signals();
  const int descriptor = mkstemp(out->temporary);
  const int error = errno;
  if (descriptor >= 0) {
    out->next = under_way;
    under_way = out;
  }
  sigprocmask(SIG_SETMASK, &before, NULL);
  errno = error;
  return descriptor;
}

/* It gets its target's name, or goes. 0 or an errno: then it has gone. */
static int end_temporary(outfile *out, bool keep) {
  const sigset_t before = hold_signals();
  const int error = keep && rename(out->temporary, out->target) != 0 ? errno : 0;
  if (!keep || error != 0) unlink(out->temporary);
  if (under_way == out) under_way = out->next;
  for (outfile *at = under_way; at != NULL; at = at->next)
    if (at->next == out) at->next = out->next;
  sigprocmask(SIG_SETMASK, &before, NULL);
  return error;
}

void outfile_abort_all(void) {
  for (const outfile *out = under_way; out != NULL; out = out->next) unlink(out->temporary);
}

static int open_temporary(outfile *out, fault *why) {
  const int length = snprintf(out->temporary, sizeof out->temporary, "%s.XXXXXX", out->target);
  if (out->target[0] == '\0' || length < 0 || (size_t)length >= sizeof out->temporary) {
    out->temporary[0] = '\0';
    return cannot_write(out, out->path[0] == '\0' ? ENOENT : ENAMETOOLONG, why);
  }
  const int descriptor = make_temporary(out);
  if (descriptor < 0) {
    out->temporary[0] = '\0';
    return cannot_write(out, errno, why);
  }
  fchmod(descriptor, mode_of(out));
  out->file = fdopen(descriptor, "w");
  if (out->file != NULL) return 0;
  const int error = errno;
  close(descriptor);
  end_temporary(out, false);
  return cannot_write(out, error, why);
}

int outfile_open(outfile *out, const char *path, fault *why) {
  struct stat about;
  *out = (outfile){NULL, path, "", "", NULL};
  if (strcmp(path, "-") == 0 || is_device_name(path)) return open_directly(out, why);
  const bool exists = stat(path, &about) == 0;
  if (file_was_read(path)) return fault_set(why, "%s: is what is read; name another file", path);
  if (exists && S_ISDIR(about.st_mode)) return cannot_write(out, EISDIR, why);
  if ((exists && !S_ISREG(about.st_mode)) || !find_target(out)) return open_directly(out, why);
  return open_temporary(out, why);
}

/* The folder of a name that is not there yet, without links. NULL: none. */
static char *folder_of(const char *path) {
  char folder[OUTFILE_PATH_SIZE];
  const char *slash = strrchr(path, '/');
  if (slash == NULL) return realpath(".", NULL);
  if (strlen(path) >= sizeof folder) return NULL;
  memcpy(folder, path, (size_t)(slash - path) + 1);
  folder[slash - path + 1] = '\0';
  return realpath(folder, NULL);
}

static const char *name_in_folder(const char *path) {
  const char *slash = strrchr(path, '/');
  return slash != NULL ? slash + 1 : path;
}

static bool is_same_to_be(const char *a, const char *b) {
  char *first = folder_of(a), *second = folder_of(b);
  const bool same = first != NULL && second != NULL && strcmp(first, second) == 0 &&
                    strcmp(name_in_folder(a), name_in_folder(b)) == 0;
  free(first);
  free(second);
  return same;
}

bool outfile_is_same(const char *a, const char *b) {
  struct stat x, y;
  const bool standard = strcmp(a, "-") == 0 || strcmp(b, "-") == 0;
  if (strcmp(a, b) == 0) return strncmp(a, "/dev/null", 10) != 0;
  if (standard) return false;
  const bool there = stat(a, &x) == 0;
  if ((stat(b, &y) == 0) != there) return false;
  if (there) return S_ISREG(x.st_mode) && x.st_dev == y.st_dev && x.st_ino == y.st_ino;
  return is_same_to_be(a, b);
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
  if (out->temporary[0] != '\0') {
    const int failed = end_temporary(out, error == 0);
    if (error == 0) error = failed;
  }
  if (error == 0) return 0;
  return cannot_write(out, error, why);
}

void outfile_abort(outfile *out) {
  if (out->file == NULL) return;
  if (out->file != stdout) fclose(out->file);
  if (out->temporary[0] != '\0') end_temporary(out, false);
  out->file = NULL;
}

/* A pipe is not opened for a trial: its reader would take that for the end, or there is none yet to open it for. */
int outfile_try(const char *path, fault *why) {
  struct stat about;
  outfile out;
  if (stat(path, &about) == 0 && S_ISFIFO(about.st_mode)) return 0;
  if (outfile_open(&out, path, why) != 0) return -1;
  outfile_abort(&out);
  return 0;
}

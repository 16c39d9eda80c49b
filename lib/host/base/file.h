/* Files read whole, paths, and faults that name a file and a place in it. */
#ifndef QUARTER_HOST_FILE_H
#define QUARTER_HOST_FILE_H

#include <stdbool.h>
#include <stddef.h>

#include "host/base/fault.h"

#define FILE_MAP_LIMIT ((size_t)256 << 20) /* bytes of a drawing, map or image */
#define FILE_TEXT_LIMIT ((size_t)4 << 20)  /* bytes of a YAML or CSV */

typedef struct {
  unsigned char *data; /* followed by a NUL, which is not counted */
  size_t size;
} file_bytes;

/* Read a regular file of at most `limit` bytes. `named_by` says who asked for it ("mission.yaml:3"), NULL for the
 * user. 0, or -1 with *fault set and nothing to free. */
int file_read(file_bytes *bytes, const char *path, size_t limit, const char *named_by, fault *why);

void file_free(file_bytes *bytes);

/* Whether the path leads to a file that this process has read, under whatever name. */
bool file_was_read(const char *path);

/* Count it as not read: it is to be replaced. */
void file_forget(const char *path);

/* `name` as seen from the folder of the file `beside`, into out[size]. -1 with *fault set if it does not fit. */
int file_path_beside(char *out, size_t size, const char *beside, const char *name, fault *why);

/* "path:line:column: " and the message; line or column 0 are left out. Always -1. */
int file_fault(fault *why, const char *path, long line, long column, const char *format, ...)
    __attribute__((format(printf, 5, 6)));

/* The end of `path` that is short enough to leave room for a message beside it. */
const char *file_short_path(const char *path);

#endif

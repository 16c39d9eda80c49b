/* PGM grey images: P5 (binary, 8 bits or 16 with the high byte first) and P2 (plain), with comments in the header. */
#ifndef QUARTER_READER_PGM_H
#define QUARTER_READER_PGM_H

#include <stdbool.h>
#include <stdint.h>

#include "file.h"

#define PGM_MAX_SIDE 65535        /* pixels */
#define PGM_MAX_PIXELS (1L << 26) /* in all, 8192 x 8192 */

typedef struct {
  int width, height; /* 1..PGM_MAX_SIDE, at most PGM_MAX_PIXELS in all */
  int maximum;       /* the sample that is white, 1..65535 */
  uint16_t *samples; /* row by row from the top, none above `maximum` */
} pgm;

/* Decode `bytes`; `path` is for faults. 0, or -1 with *fault set and nothing to free. Nothing is allocated before the
 * header is known to agree with the size of the file. */
int pgm_read(pgm *image, const char *path, const file_bytes *bytes, fault *why);

void pgm_free(pgm *image);

/* Whether it starts as an image of any kind does. */
bool pgm_looks_like_image(const file_bytes *bytes);

#endif

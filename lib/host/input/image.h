/* Images of maps: PGM, PNG and BMP, map_server's own formats, as grey samples.
 *
 * As in map_server (nav2's map_io.cpp) a pixel's shade is the average of its colour channels. Alpha, where the image
 * has it, depends on the map's mode: in `trinary` it is averaged in as a fourth channel, opaque being bright; in
 * `scale` what is not opaque is unknown; in `raw` it does not count. */
#ifndef QUARTER_HOST_IMAGE_H
#define QUARTER_HOST_IMAGE_H

#include <stdbool.h>
#include <stdint.h>

#include "host/base/file.h"

#define IMAGE_MAX_SIDE 65535        /* pixels */
#define IMAGE_MAX_PIXELS (1L << 26) /* in all, 8192 x 8192 */

enum image_alpha { IMAGE_ALPHA_AVERAGED, IMAGE_ALPHA_MARKED, IMAGE_ALPHA_IGNORED };

typedef struct {
  int width, height;    /* 1..IMAGE_MAX_SIDE, at most IMAGE_MAX_PIXELS in all */
  int maximum;          /* the sample that is white and, where alpha is averaged in, opaque; 1..65535 */
  uint16_t *samples;    /* row by row from the top, none above `maximum` */
  uint8_t *transparent; /* as many, 1: not opaque; NULL: all are opaque, or nobody asked */
  bool averaged;        /* alpha is in the samples */
} image;

void image_free(image *it);

/* The sample of an opaque grey of `level` of 255; -1 if none is exactly that. */
int image_grey(const image *it, int level);

/* ---- for the decoders ---- */

/* -1 with *fault set: more than the limits. */
int image_check_size(const char *path, double width, double height, fault *why);

/* Samples of `bits` (8 or 16, as the machine has them) from red, green, blue and alpha. Width and height are set and
 * checked. 0, or -1 with no memory. */
int image_from_rgba(image *it, const void *rgba, int bits, bool alpha, enum image_alpha how);

#endif

/* PGM grey images: P5 (binary, 8 bits or 16 with the high byte first) and P2 (plain), with comments in the header. */
#ifndef QUARTER_HOST_PGM_H
#define QUARTER_HOST_PGM_H

#include "host/input/image.h"

/* As decode_image(). */
int pgm_read(image *it, const char *path, const file_bytes *bytes, fault *why);

/* Whether it starts as a PGM or one of its siblings does. */
bool pgm_looks_like_image(const file_bytes *bytes);

#endif

/* An image of whatever format. */
#ifndef QUARTER_HOST_DECODE_H
#define QUARTER_HOST_DECODE_H

#include "host/input/image.h"

/* Decode `bytes`, whatever format they are in; `path` is for faults. 0, or -1 with *fault set and nothing to free. What
 * a header promises is checked against the size of the file and the limits of image.h before anything is allocated for
 * it. */
int decode_image(image *it, const char *path, const file_bytes *bytes, enum image_alpha how, fault *why);

/* Whether it starts as an image of any kind does, ours or not. */
bool decode_is_image(const file_bytes *bytes);

/* "a PNG image", for a message. */
const char *decode_format_name(const file_bytes *bytes);

#endif

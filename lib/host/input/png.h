/* PNG images, through libspng: the one file that includes it. */
#ifndef QUARTER_HOST_PNG_H
#define QUARTER_HOST_PNG_H

#include "host/input/image.h"

/* As decode_image(). A build without libspng says so. */
int png_read(image *it, const char *path, const file_bytes *bytes, enum image_alpha how, fault *why);

bool png_looks_like_one(const file_bytes *bytes);

#endif

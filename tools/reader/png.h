/* PNG images, through libspng: the one file that includes it. */
#ifndef QUARTER_READER_PNG_H
#define QUARTER_READER_PNG_H

#include "image.h"

/* As image_read(). A build without libspng says so. */
int png_read(image *it, const char *path, const file_bytes *bytes, enum image_alpha how, fault *why);

bool png_looks_like_one(const file_bytes *bytes);

#endif

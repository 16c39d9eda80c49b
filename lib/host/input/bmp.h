/* BMP images without compression, through stb_image: the one file that includes it. */
#ifndef QUARTER_HOST_BMP_H
#define QUARTER_HOST_BMP_H

#include "host/input/image.h"

/* As decode_image(). A build without stb_image says so. */
int bmp_read(image *it, const char *path, const file_bytes *bytes, enum image_alpha how, fault *why);

bool bmp_looks_like_one(const file_bytes *bytes);

#endif

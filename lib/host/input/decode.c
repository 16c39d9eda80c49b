#include "host/input/decode.h"

#include <string.h>

#include "host/input/bmp.h"
#include "host/input/pgm.h"
#include "host/input/png.h"

int decode_image(image *it, const char *path, const file_bytes *bytes, enum image_alpha how, fault *why) {
  memset(it, 0, sizeof *it);
  if (png_looks_like_one(bytes)) return png_read(it, path, bytes, how, why);
  if (bmp_looks_like_one(bytes)) return bmp_read(it, path, bytes, how, why);
  return pgm_read(it, path, bytes, why);
}

const char *decode_format_name(const file_bytes *bytes) {
  if (png_looks_like_one(bytes)) return "a PNG image";
  if (bmp_looks_like_one(bytes)) return "a BMP image";
  return pgm_looks_like_image(bytes) ? "a PGM image" : "an image";
}

bool decode_is_image(const file_bytes *bytes) {
  const unsigned char *data = bytes->data;
  if (pgm_looks_like_image(bytes) || png_looks_like_one(bytes) || bmp_looks_like_one(bytes)) return true;
  if (bytes->size < 3) return false;
  return memcmp(data, "\xff\xd8\xff", 3) == 0 || memcmp(data, "GIF", 3) == 0 || memcmp(data, "II*", 3) == 0 ||
         memcmp(data, "MM\0", 3) == 0;
}

#include "host/input/raster_read.h"

#include <stdlib.h>

#include "host/input/asc.h"
#include "host/input/decode.h"

static int read_image(raster *it, const char *path, const file_bytes *bytes, fault *why) {
  image picture;
  if (decode_image(&picture, path, bytes, IMAGE_ALPHA_IGNORED, why) != 0) return -1;
  const size_t count = (size_t)picture.width * (size_t)picture.height;
  *it = (raster){.columns = picture.width, .rows = picture.height, .value = malloc(count * sizeof *it->value)};
  for (size_t i = 0; it->value != NULL && i < count; i++) it->value[i] = picture.samples[i] * 255.0 / picture.maximum;
  image_free(&picture);
  return it->value != NULL ? 0 : file_fault(why, path, 0, 0, "no memory for its pixels; scale the image down");
}

static int read_bytes(raster *it, const char *path, const file_bytes *bytes, fault *why) {
  if (asc_looks_like_one(bytes)) return asc_read(it, path, bytes, why);
  if (decode_is_image(bytes)) return read_image(it, path, bytes, why);
  return file_fault(why, path, 0, 0, "is no raster that is read; give a PGM, a PNG, or an ESRI ASCII grid");
}

int raster_read(raster *it, const char *path, const char *named_by, fault *why) {
  file_bytes bytes;
  if (file_read(&bytes, path, FILE_MAP_LIMIT, named_by, why) != 0) return -1;
  const int result = read_bytes(it, path, &bytes, why);
  file_free(&bytes);
  return result;
}

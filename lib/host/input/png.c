#include "host/input/png.h"

#include <string.h>

bool png_looks_like_one(const file_bytes *bytes) {
  return bytes->size >= 4 && memcmp(bytes->data, "\x89PNG", 4) == 0;
}

#ifdef QUARTER_HAVE_SPNG

#include <spng.h>
#include <stdlib.h>

#define CHUNK_MOST ((size_t)1 << 20) /* bytes of a chunk beside the pixels, and of all that are kept */

static int decode_fault(const char *path, int status, fault *why) {
  if (status == SPNG_EMEM) return file_fault(why, path, 0, 0, "no memory for its pixels; scale the map down");
  return file_fault(why, path, 0, 0, "is not a whole PNG: %s; copy the file anew", spng_strerror(status));
}

/* Pixels as red, green, blue and alpha, newly allocated; NULL with *status set. */
static void *decode_pixels(spng_ctx *context, int format, int *status) {
  size_t size;
  *status = spng_decoded_image_size(context, format, &size);
  if (*status != 0) return NULL;
  void *rgba = malloc(size);
  *status = rgba == NULL ? SPNG_EMEM : spng_decode_image(context, rgba, size, format, SPNG_DECODE_TRNS);
  if (*status == 0) *status = spng_decode_chunks(context); /* to the end: a file that is cut off there is not whole */
  if (*status == 0) return rgba;
  free(rgba);
  return NULL;
}

static int decode(image *it, spng_ctx *context, const char *path, enum image_alpha how, fault *why) {
  struct spng_ihdr head;
  struct spng_trns transparency;
  int status = spng_get_ihdr(context, &head);
  if (status != 0) return decode_fault(path, status, why);
  it->width = (int)head.width;
  it->height = (int)head.height;
  const bool alpha = (head.color_type & 4) != 0 || spng_get_trns(context, &transparency) == 0;
  const int bits = head.bit_depth == 16 ? 16 : 8;
  void *rgba = decode_pixels(context, bits == 16 ? SPNG_FMT_RGBA16 : SPNG_FMT_RGBA8, &status);
  if (rgba == NULL) return decode_fault(path, status, why);
  status = image_from_rgba(it, rgba, bits, alpha, how);
  free(rgba);
  return status == 0 ? 0 : decode_fault(path, SPNG_EMEM, why);
}

/* The longest rows of zeros shrink about a thousandfold: a file that promises far more than that is not decoded. */
static int check_promise(spng_ctx *context, const char *path, const file_bytes *bytes, fault *why) {
  struct spng_ihdr head;
  int status = spng_get_ihdr(context, &head);
  if (status != 0) return decode_fault(path, status, why);
  if (image_check_size(path, head.width, head.height, why) != 0) return -1;
  const double bits = (double)head.width * head.height * head.bit_depth; /* a channel's at least */
  if (bits / 8.0 <= (double)bytes->size * 1100.0) return 0;
  return file_fault(why, path, 0, 0,
                    "is cut off: its header says %u x %u pixels, but it holds %zu bytes; copy the file anew",
                    (unsigned)head.width, (unsigned)head.height, bytes->size);
}

int png_read(image *it, const char *path, const file_bytes *bytes, enum image_alpha how, fault *why) {
  spng_ctx *context = spng_ctx_new(0);
  if (context == NULL) return decode_fault(path, SPNG_EMEM, why);
  spng_set_image_limits(context, INT32_MAX, INT32_MAX); /* our own are checked, with a better message */
  spng_set_chunk_limits(context, CHUNK_MOST, CHUNK_MOST);
  int result = spng_set_png_buffer(context, bytes->data, bytes->size);
  if (result != 0)
    result = decode_fault(path, result, why);
  else
    result = check_promise(context, path, bytes, why) != 0 ? -1 : decode(it, context, path, how, why);
  spng_ctx_free(context);
  return result;
}

#else

int png_read(image *it, const char *path, const file_bytes *bytes, enum image_alpha how, fault *why) {
  (void)it;
  (void)bytes;
  (void)how;
  return file_fault(
      why, path, 0, 0,
      "is a PNG, which this build cannot read; install libspng-dev and build again, or convert the image to "
      "PGM");
}

#endif

#include "host/input/image.h"

#include <stdlib.h>

void image_free(image *it) {
  free(it->samples);
  free(it->transparent);
  it->samples = NULL;
  it->transparent = NULL;
}

int image_grey(const image *it, int level) {
  const int64_t most = it->averaged ? 4 * 255 : 255, bright = it->averaged ? 3 * level + 255 : level;
  const int64_t scaled = bright * it->maximum;
  /* The average of 16-bit channels is rounded as below. */
  if (it->averaged && it->maximum == UINT16_MAX) return (int)((scaled + most / 2) / most);
  return scaled % most == 0 ? (int)(scaled / most) : -1;
}

int image_check_size(const char *path, double width, double height, fault *why) {
  if (width < 1.0 || height < 1.0) return file_fault(why, path, 0, 0, "the image has no pixels; copy the file anew");
  if (width <= IMAGE_MAX_SIDE && height <= IMAGE_MAX_SIDE && width * height <= (double)IMAGE_MAX_PIXELS) return 0;
  return file_fault(why, path, 0, 0,
                    "%.0f x %.0f pixels are more than %ld, or than %d along a side, the most that are read; check the "
                    "file, or scale the map down",
                    width, height, IMAGE_MAX_PIXELS, IMAGE_MAX_SIDE);
}

static unsigned channel(const void *rgba, int bits, size_t index) {
  return bits == 8 ? ((const uint8_t *)rgba)[index] : ((const uint16_t *)rgba)[index];
}

static bool allocate(image *it, size_t pixels, bool mark) {
  it->samples = malloc(pixels * sizeof *it->samples);
  it->transparent = mark ? malloc(pixels) : NULL;
  if (it->samples != NULL && (!mark || it->transparent != NULL)) return true;
  image_free(it);
  return false;
}

/* Sums of 8-bit channels are exact; those of 16 bits are averaged, or they would not fit. */
static void add_channels(image *it, const void *rgba, int bits, size_t channels, size_t pixels) {
  const unsigned divisor = bits == 8 ? 1 : (unsigned)channels;
  for (size_t i = 0; i < pixels; i++) {
    unsigned sum = 0;
    for (size_t c = 0; c < channels; c++) sum += channel(rgba, bits, 4 * i + c);
    it->samples[i] = (uint16_t)((sum + divisor / 2) / divisor);
  }
}

int image_from_rgba(image *it, const void *rgba, int bits, bool alpha, enum image_alpha how) {
  const size_t pixels = (size_t)it->width * (size_t)it->height;
  const unsigned opaque = bits == 8 ? UINT8_MAX : UINT16_MAX;
  const bool mark = alpha && how == IMAGE_ALPHA_MARKED;
  it->averaged = alpha && how == IMAGE_ALPHA_AVERAGED;
  const unsigned channels = it->averaged ? 4 : 3;
  it->maximum = (int)(bits == 8 ? opaque * channels : opaque);
  if (!allocate(it, pixels, mark)) return -1;
  add_channels(it, rgba, bits, channels, pixels);
  for (size_t i = 0; mark && i < pixels; i++) it->transparent[i] = channel(rgba, bits, 4 * i + 3) != opaque;
  return 0;
}

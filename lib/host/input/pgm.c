#include "host/input/pgm.h"
#include "host/base/count.h"

#include <stdlib.h>
#include <string.h>

/* Where decoding stands. */
typedef struct {
  const char *path;
  const unsigned char *at, *end;
  int line;
  fault *why;
} cursor;

static bool is_space(unsigned char c) {
  return c == ' ' || (c >= '\t' && c <= '\r');
}

static bool is_digit(unsigned char c) {
  return c >= '0' && c <= '9';
}

static void skip_comment(cursor *c) {
  while (c->at < c->end && *c->at != '\n') c->at++;
}

static void skip_blanks(cursor *c) {
  while (c->at < c->end) {
    if (*c->at == '#') {
      skip_comment(c);
    } else if (is_space(*c->at)) {
      if (*c->at == '\n') c->line++;
      c->at++;
    } else {
      return;
    }
  }
}

/* A decimal number from 0 to `most`, which is below 10^8. */
static int read_number(cursor *c, const char *what, long most, long *out) {
  skip_blanks(c);
  if (c->at == c->end) {
    return file_fault(c->why, c->path, c->line, 0, "ends before the %s; copy the file anew", what);
  }
  if (!is_digit(*c->at)) {
    return file_fault(c->why, c->path, c->line, 0,
                      "the %s is not a whole number of 0 or more; check that the file is a whole PGM", what);
  }
  long value = 0;
  for (; c->at < c->end && is_digit(*c->at); c->at++) {
    value = value * 10 + (*c->at - '0');
    if (value > most) {
      return file_fault(c->why, c->path, c->line, 0,
                        "the %s is above %ld, the most that is read; check the file, or scale the map down", what,
                        most);
    }
  }
  *out = value;
  return 0;
}

static int read_size(cursor *c, const char *what, long most, int *out) {
  long value;
  if (read_number(c, what, most, &value)) return -1;
  if (value < 1) {
    return file_fault(c->why, c->path, c->line, 0, "the %s is 0; check that the file is a whole PGM", what);
  }
  *out = (int)value;
  return 0;
}

static int read_header(cursor *c, image *it) {
  if (read_size(c, "width", IMAGE_MAX_SIDE, &it->width)) return -1;
  if (read_size(c, "height", IMAGE_MAX_SIDE, &it->height)) return -1;
  if ((long)it->width * it->height > IMAGE_MAX_PIXELS) {
    return file_fault(c->why, c->path, c->line, 0,
                      "%d x %d pixels are more than %ld, the most that are read; check the file, or scale the map down",
                      it->width, it->height, IMAGE_MAX_PIXELS);
  }
  return read_size(c, "maximum grey", 65535, &it->maximum);
}

/* The single blank between the header and binary samples. A comment and \r\n count as one. */
static int skip_header_end(cursor *c, size_t samples_size) {
  if (c->at < c->end && *c->at == '#') skip_comment(c);
  if (c->at == c->end) return 0; /* truncated: reported with the number of bytes */
  if (!is_space(*c->at)) {
    return file_fault(c->why, c->path, c->line, 0,
                      "the maximum grey is not followed by a blank; check that the file is a whole PGM");
  }
  size_t left = (size_t)(c->end - c->at);
  bool both = left > samples_size + 1 && c->at[0] == '\r' && c->at[1] == '\n';
  c->at += both ? 2 : 1;
  return 0;
}

static int truncated(const cursor *c, const image *it, size_t got, size_t wanted, const char *unit) {
  return file_fault(
      c->why, c->path, 0, 0,
      "is cut off: its header says %d x %d pixels, which take %zu %s, but it holds %zu; copy the file anew", it->width,
      it->height, wanted, unit, got);
}

static int allocate(cursor *c, image *it, size_t pixels) {
  it->samples = malloc(pixels * sizeof *it->samples);
  if (it->samples != NULL) return 0;
  return file_fault(c->why, c->path, 0, 0, "no memory for %zu pixels; scale the map down", pixels);
}

static int check_sample(const cursor *c, const image *it, size_t index, long sample) {
  if (sample <= it->maximum) return 0;
  return file_fault(
      c->why, c->path, 0, 0,
      "the pixel in column %zu, row %zu is %ld, above the maximum grey %d; check that the file is a whole PGM",
      index % (size_t)it->width, index / (size_t)it->width, sample, it->maximum);
}

static int read_binary(cursor *c, image *it, size_t pixels) {
  size_t width = it->maximum > 255 ? 2 : 1, wanted = pixels * width;
  if (skip_header_end(c, wanted)) return -1;
  size_t got = (size_t)(c->end - c->at);
  if (got < wanted) return truncated(c, it, got, wanted, "bytes");
  if (allocate(c, it, pixels)) return -1;
  const unsigned char *from = c->at;
  for (size_t i = 0; i < pixels; i++, from += width) {
    unsigned sample = width == 1 ? from[0] : (unsigned)from[0] << 8 | from[1];
    it->samples[i] = (uint16_t)sample;
    if (check_sample(c, it, i, (long)sample)) return -1;
  }
  c->at = from;
  return 0;
}

static int read_plain(cursor *c, image *it, size_t pixels) {
  /* Every sample takes a digit and a blank before it: a header that promises more than that is refused at once. */
  size_t most = (size_t)(c->end - c->at) / 2;
  if (most < pixels) return truncated(c, it, most, pixels, "samples at least");
  if (allocate(c, it, pixels)) return -1;
  for (size_t i = 0; i < pixels; i++) {
    long sample;
    skip_blanks(c);
    if (c->at == c->end) return truncated(c, it, i, pixels, "samples");
    if (read_number(c, "sample", 99999, &sample) || check_sample(c, it, i, sample)) return -1;
    it->samples[i] = (uint16_t)sample;
  }
  skip_blanks(c); /* comments too, which only a plain file may have here */
  return 0;
}

/* More pixels than the header says make a map that is sheared, not one that is safe to plan on. */
static int check_end(cursor *c) {
  size_t left = (size_t)(c->end - c->at);
  while (c->at < c->end && is_space(*c->at)) c->at++;
  if (c->at == c->end) return 0;
  return file_fault(
      c->why, c->path, 0, 0,
      "goes on for %s after the pixels that its header says; mend the width and height, or copy the file anew",
      counted(left, "byte").text);
}

/* "P" and a digit from `kinds`, then a blank or comment; a file that ends there is one too. */
static bool has_magic(const file_bytes *bytes, const char *kinds) {
  const unsigned char *data = bytes->data; /* a NUL follows the last byte */
  if (bytes->size < 2 || data[0] != 'P' || data[1] == '\0' || strchr(kinds, data[1]) == NULL) return false;
  return bytes->size == 2 || is_space(data[2]) || data[2] == '#';
}

int pgm_read(image *it, const char *path, const file_bytes *bytes, fault *why) {
  cursor c = {path, bytes->data, bytes->data + bytes->size, 1, why};
  memset(it, 0, sizeof *it);
  if (!has_magic(bytes, "25")) {
    return file_fault(why, path, 0, 0,
                      "is not a PGM, PNG or BMP (no P5 or P2 at its start); convert the image to a grey PGM");
  }
  c.at += 2;
  if (read_header(&c, it)) return -1;
  size_t pixels = (size_t)it->width * (size_t)it->height;
  int result = bytes->data[1] == '5' ? read_binary(&c, it, pixels) : read_plain(&c, it, pixels);
  if (result == 0) result = check_end(&c);
  if (result != 0) image_free(it);
  return result;
}

bool pgm_looks_like_image(const file_bytes *bytes) {
  return has_magic(bytes, "1234567");
}

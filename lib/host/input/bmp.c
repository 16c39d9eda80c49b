#include "host/input/bmp.h"

#include <stdlib.h>
#include <string.h>

#define FILE_HEAD 14 /* bytes before the info header */

/* "BM", then four reserved bytes that are 0: text may start with the two letters. */
bool bmp_looks_like_one(const file_bytes *bytes) {
  if (bytes->size < 2 || memcmp(bytes->data, "BM", 2) != 0) return false;
  return bytes->size < 10 ? memchr(bytes->data, '\0', bytes->size) != NULL
                          : memcmp(bytes->data + 6, "\0\0\0\0", 4) == 0;
}

#ifdef QUARTER_HAVE_STB

#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_BMP
#define STBI_NO_STDIO
#define STBI_NO_LINEAR
#define STBI_NO_HDR
#define STBI_NO_FAILURE_STRINGS
#include <stb_image.h>

/* What stb_image takes on trust is checked before: it reads past the end as zeros, and colours that no palette has as
 * whatever the stack holds. */
typedef struct {
  uint32_t offset;              /* of the pixels */
  uint32_t size;                /* of the info header */
  int32_t width, height;        /* negative height: the top row comes first */
  uint32_t bits, compression;   /* of a pixel */
  uint32_t masks_size, colours; /* bytes of masks behind the header; entries of the palette */
  bool alpha;
} header;

static uint32_t load16(const unsigned char *at) {
  return (uint32_t)(at[0] | at[1] << 8);
}

static uint32_t load32(const unsigned char *at) {
  return load16(at) | load16(at + 2) << 16;
}

static int damaged(const char *path, fault *why) {
  return file_fault(why, path, 0, 0, "is not a whole BMP; copy the file anew");
}

static int unusual(const char *path, const char *what, fault *why) {
  return file_fault(why, path, 0, 0, "is a BMP %s, which is not read; save it with 24 bits a pixel, or as PGM", what);
}

static bool is_known_size(uint32_t size) {
  return size == 40 || size == 56 || size == 108 || size == 124;
}

static bool has_palette(const header *head) {
  return head->bits == 1 || head->bits == 4 || head->bits == 8;
}

static uint32_t count_colours(const header *head) {
  if (!has_palette(head) || head->offset < FILE_HEAD + head->size) return 0;
  return (head->offset - FILE_HEAD - head->size) / 4;
}

/* The header's numbers, none of them judged. */
static int read_header(header *head, const char *path, const file_bytes *bytes, fault *why) {
  const unsigned char *data = bytes->data;
  if (bytes->size < FILE_HEAD + 4) return damaged(path, why);
  head->offset = load32(data + 10);
  head->size = load32(data + 14);
  if (!is_known_size(head->size)) return unusual(path, "of an old or rare kind", why);
  if (bytes->size < FILE_HEAD + (size_t)head->size + 12) return damaged(path, why);
  head->width = (int32_t)load32(data + 18);
  head->height = (int32_t)load32(data + 22);
  head->bits = load16(data + 28);
  head->compression = load32(data + 30);
  head->masks_size = head->size == 40 && head->compression == 3 ? 12 : 0;
  head->colours = count_colours(head);
  head->alpha = head->compression == 3 && head->size > 56 && load32(data + 66) == 0xFF000000u;
  return load16(data + 26) == 1 ? 0 : damaged(path, why);
}

static bool has_byte_masks(const unsigned char *masks) {
  return load32(masks) == 0xFF0000u && load32(masks + 4) == 0xFF00u && load32(masks + 8) == 0xFFu;
}

/* Colours by masks: a byte each, in the usual order, behind a header of 40 bytes or in one of 108 or 124. */
static bool has_usual_masks(const header *head, const file_bytes *bytes) {
  return head->bits == 32 && head->size != 56 && has_byte_masks(bytes->data + FILE_HEAD + 40);
}

/* What is wrong with a BMP that is whole but not read; NULL if nothing is. */
static const char *unusual_trait(const header *head, const file_bytes *bytes) {
  switch (head->compression) {
  case 0: break;
  case 1:
  case 2: return "with run-length compression";
  case 3:
    if (!has_usual_masks(head, bytes)) return "with rare colour masks";
    break;
  default: return "with compression";
  }
  if (has_palette(head)) return NULL;
  if (head->bits != 24 && head->bits != 32) return "of 16 bits a pixel or a rare kind";
  return head->offset == FILE_HEAD + head->size + head->masks_size ? NULL : "with a gap before its pixels";
}

static int check_kind(const header *head, const char *path, const file_bytes *bytes, fault *why) {
  const char *trait = unusual_trait(head, bytes);
  if (trait != NULL) return unusual(path, trait, why);
  if (has_palette(head) && (head->colours < 1 || head->colours > 256)) return damaged(path, why);
  return 0;
}

static size_t row_bytes(const header *head) {
  return ((size_t)head->width * head->bits + 31) / 32 * 4;
}

/* That every colour is one of the palette's. */
static int check_colours(const header *head, const char *path, const file_bytes *bytes, fault *why) {
  const size_t rows = (size_t)labs(head->height), mask = has_palette(head) ? (1u << head->bits) - 1 : 0;
  if (!has_palette(head) || head->colours > mask) return 0;
  for (size_t y = 0; y < rows; y++) {
    const unsigned char *row = bytes->data + head->offset + y * row_bytes(head);
    for (size_t x = 0; x < (size_t)head->width; x++) {
      const size_t bit = x * head->bits;
      if ((row[bit / 8] >> (8 - head->bits - bit % 8) & mask) >= head->colours) return damaged(path, why);
    }
  }
  return 0;
}

static int check(const header *head, const char *path, const file_bytes *bytes, fault *why) {
  const double height = head->height < 0 ? -(double)head->height : head->height;
  if (image_check_size(path, head->width, height, why) != 0 || check_kind(head, path, bytes, why) != 0) return -1;
  const size_t wanted = row_bytes(head) * (size_t)height;
  if (head->offset <= bytes->size && bytes->size - head->offset >= wanted) return check_colours(head, path, bytes, why);
  return file_fault(
      why, path, 0, 0,
      "is cut off: its header says %d x %.0f pixels, which take %zu bytes, but it holds %zu; copy the file "
      "anew",
      (int)head->width, height, wanted, head->offset <= bytes->size ? bytes->size - head->offset : 0);
}

int bmp_read(image *it, const char *path, const file_bytes *bytes, enum image_alpha how, fault *why) {
  header head = {0};
  int channels;
  if (read_header(&head, path, bytes, why) != 0 || check(&head, path, bytes, why) != 0) return -1;
  unsigned char *rgba = stbi_load_from_memory(bytes->data, (int)bytes->size, &it->width, &it->height, &channels, 4);
  if (rgba == NULL) return damaged(path, why);
  const int status = image_from_rgba(it, rgba, 8, head.alpha, how);
  stbi_image_free(rgba);
  return status == 0 ? 0 : file_fault(why, path, 0, 0, "no memory for its pixels; scale the map down");
}

#else

int bmp_read(image *it, const char *path, const file_bytes *bytes, enum image_alpha how, fault *why) {
  (void)it;
  (void)bytes;
  (void)how;
  return file_fault(
      why, path, 0, 0,
      "is a BMP, which this build cannot read; install libstb-dev and build again, or convert the image to "
      "PGM");
}

#endif

/* ROS map_server maps: a YAML and the image that it names, read as nav2_map_server reads them.
 *
 * Occupancy p of a sample v: 1 - v / maximum, with `negate` v / maximum.
 * - trinary: p > occupied_thresh is occupied, p < free_thresh is free, all else unknown: both thresholds themselves are
 *   unknown. (nav2 up to Jazzy is strict like this; its later code lets the thresholds in, at the same default values
 *   with the same result.)
 * - scale: between the thresholds p is scaled to 0..100. What rounds to 0 is free, all above counts as occupied here,
 *   and `unknown: free` must not open it; unless the mission has a grey_cost: then it is ground that takes longer the
 *   darker it is, and only what rounds to 100 is occupied.
 * - raw: v * 255 / maximum, rounded, is the occupancy: 0 free, 1..100 occupied here, above 100 unknown. No negate.
 *
 * Unknown pixels are free, or they are obstacles and grow like them. The grey that map savers write for unknown ground,
 * 205 of 255, is free by the rule above where `free_thresh` is 0.25, which they write beside it today. Where a mission
 * says nothing of unknown ground it is free then, and a note says so. Where it says `blocked`, that grey is unknown all
 * the same.
 */
#ifndef QUARTER_HOST_ROSMAP_H
#define QUARTER_HOST_ROSMAP_H

#include <stdbool.h>

#include "host/base/file.h"
#include "host/input/input.h"
#include "host/input/tree.h"

enum rosmap_class { ROSMAP_FREE, ROSMAP_OCCUPIED, ROSMAP_UNKNOWN };
enum rosmap_mode { ROSMAP_TRINARY, ROSMAP_SCALE, ROSMAP_RAW };

/* What the YAML says. */
typedef struct {
  char image[INPUT_PATH_SIZE]; /* path */
  int image_line;
  double resolution; /* metres a pixel */
  double origin[3];  /* metres: lower-left corner of the lower-left pixel; radians: the turn about it */
  bool negate;
  double occupied, free; /* thresholds */
  int mode;              /* enum rosmap_mode */
} rosmap_header;

int rosmap_read_header(rosmap_header *header, const char *path, const file_bytes *bytes, fault *why);

/* What a sample of an image with that maximum stands for. */
enum rosmap_class rosmap_classify(const rosmap_header *header, int sample, int maximum);

/* How far a grey of a map in scale mode is from free ground (0) to an obstacle (1); 0 in other modes. */
double rosmap_greyness(const rosmap_header *header, int sample, int maximum);

/* Fill the input's cells and frame, as in->ground wants them; in->map is the YAML's path. 0, or -1 with *fault set. */
int rosmap_read(input *in, const file_bytes *bytes, fault *why);

/* Whether a mapping has a ROS map's keys and not a mission's. */
bool rosmap_looks_like_one(tree *yaml);

#endif

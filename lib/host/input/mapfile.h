/* A map by itself, of which a mission is to be made: one that is there, or open ground, or a bare image, whose scale
 * the user tells. */
#ifndef QUARTER_HOST_MAPFILE_H
#define QUARTER_HOST_MAPFILE_H

#include "host/input/input.h"
#include "host/input/kind.h"

typedef struct {
  enum kind kind; /* of the map that the mission is to name: KIND_YAML is a ROS map */
  char *made;     /* what that map, in->map, is to hold, for free(); NULL: it is there */
  size_t length;
} mapfile;

/* Cells of a map of so many pixels or metres a side, at most, where nobody says how large they are to be. */
#define MAPFILE_ROOMY 65536 /* of a ROS map, by whole pixels */
#define MAPFILE_PLAIN 10000 /* of open ground, by 1, 2 or 5 times a power of ten */

/* Read the map `path` into an input that mapfile_begin() has set up: cells, frame, and what a drawing marks.
 * `resolution`, metres a pixel, is for images alone: the map is then the YAML beside that says so. 0, or -1 with *why
 * set and nothing to free. */
int mapfile_read(input *in, mapfile *map, const char *path, double resolution, fault *why);

/* Open ground, width x height metres, as a drawing at `path`. Likewise. */
int mapfile_open(input *in, mapfile *map, const char *path, double width, double height, fault *why);

/* An input that says nothing yet. `cell_size`: metres, 0: whichever suits. */
void mapfile_begin(input *in, double cell_size);

/* A name of a file as YAML has it, in quotes where need be. */
void mapfile_write_name(FILE *out, const char *name);

#endif

/* Likelihood that lies over the ground, made places: square tiles, as a sensor sees the ground, the likeliest first. */
#ifndef QUARTER_HOST_TILES_H
#define QUARTER_HOST_TILES_H

#include "host/input/input.h"
#include "host/input/tile_names.h"
#include "host/input/value.h"

typedef struct {
  const double *mass; /* of each cell */
  double off;         /* that lies on no cell */
  double side;        /* of a tile, in cells, 1 or more; tiles begin at the grid's lower left corner */
  double share;       /* 0..1: of the mass of all tiles that a robot can get to, as much is covered */
  const char *path;   /* what says all this, for faults and notes */
  int line;
  input_origin origin;     /* of the places */
  const char *file;        /* where the likelihood stands */
  const uint32_t *area_of; /* the area that each cell is of, from 1; 0: of none. NULL: there are no areas */
  tile_area *area;         /* they; how many tiles go by each is counted here */
} tiles_settings;

/* Add a place for each tile that is taken: at the cell nearest to its mass's middle, of those that a robot can get to
 * and no other place stands in if there are any, with its mass as the weight, and by a name (tile_names.h). How much is
 * covered becomes a note.
 * 0, or -1 with *fault set: there is no mass, none within reach, or more tiles than places are left. */
int tiles_add(input *in, const tiles_settings *settings, fault *why);

/* -1 with the fault set: a footprint of that side is less than a cell, and would leave cells half seen. */
int tiles_check(const input *in, double footprint, const value_site *site);

#endif

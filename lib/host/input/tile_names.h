/* What places that were tiles are called. A tile goes by its column and row, as squares of a map do: A1 is the lower
 * left one, B07 the second from the left and the seventh from below. That follows from the ground and the footprint
 * alone, so a place keeps its name whatever else is cleared, left out or found likely. */
#ifndef QUARTER_HOST_TILE_NAMES_H
#define QUARTER_HOST_TILE_NAMES_H

#include <stddef.h>

#include "host/input/input.h"

/* A polygon, as a tile is named by it. */
typedef struct {
  char name[QTR_SITE_NAME_BYTES]; /* empty: none */
  size_t tiles;                   /* that go by it */
} tile_area;

typedef struct {
  size_t column, row;    /* from 0, rows from below */
  size_t rows;           /* of tiles */
  const tile_area *area; /* NULL: it is of none */
  const char *file;      /* where its likelihood stands */
  bool plain;            /* false: another file's tiles, of another size perhaps, go by column and row alone */
} tile_naming;

/* "Orchard", of an area of one tile; "Orchard B07"; "B07"; "likelihood B07", by the file: the first that may be a name,
 * and that no place before has. Empty where none is. */
void tile_name(char name[QTR_SITE_NAME_BYTES], const tile_naming *tile, const input *in);

#endif

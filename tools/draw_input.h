/* What a picture is drawn of. */
#ifndef QUARTER_TOOLS_DRAW_INPUT_H
#define QUARTER_TOOLS_DRAW_INPUT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "quarter/config.h"
#include "quarter/names.h"

typedef struct {
  qtr_cell start;
  const qtr_cell *trail; /* cells walked, the start first; NULL: straight lines from place to place */
  size_t trail_length;
  int places;            /* that it visits */
  const uint16_t *place; /* in order */
  const qtr_steps *step; /* when it visits each */
} drawing_seeker;

/* Plain data; all pointers are the caller's. */
typedef struct {
  const char *title; /* NULL: none */
  unsigned columns, rows;
  const uint8_t *cost; /* of each cell: 0 blocked, 1 free, more: slow ground */
  double cell_size;    /* metres a cell; 0: unknown */
  double step_seconds; /* that a step takes; 0: unknown */
  qtr_steps deadline;  /* visits after it count for nothing; 0: none */
  bool turned;         /* the map against the map frame: rows and columns are no axes of that */
  double x, y;         /* of the outer corner of the bottom-left cell, metres in the map frame */
  bool reached_alone;  /* the map holds what can be reached, and nothing of the rest */
  bool dark;           /* for dark pages */
  bool grid;           /* lines from the axes' numbers over the map, to read positions from */
  int places;          /* 0..QTR_MAX_PLACES */
  const qtr_cell *place;
  const double *likelihood; /* of each place; any unit */
  const uint16_t *number;   /* of each place, as it is shown; NULL: its index */
  const qtr_names *names;   /* of places and seekers; NULL: none has one */
  int seekers;
  const drawing_seeker *seeker;
  int lines;               /* of the certificate, for the legend */
  const char *const *line; /* a tab parts what is named from its value */
  const uint16_t *region;  /* of each cell, to draw the regions' borders; NULL: none */
  uint32_t regions;
  const qtr_cell *representative; /* of each region, to mark with a dot */
  const uint16_t *spot;           /* of each place: those of a spot wear one colour and letter; NULL: none */
} drawing;

static inline bool drawing_is_late(const drawing *d, qtr_steps step) {
  return d->deadline > 0 && step > d->deadline;
}

static inline size_t drawing_cells(const drawing *d) {
  return (size_t)d->columns * d->rows;
}

#endif

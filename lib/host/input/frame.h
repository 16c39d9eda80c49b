/* Positions that the user states, as cells of the input's map. */
#ifndef QUARTER_HOST_FRAME_H
#define QUARTER_HOST_FRAME_H

#include "host/input/input.h"

/* A point of the planning grid, in cells from its lower-left corner. */
typedef struct {
  double across, up;
} frame_point;

/* 0.6 / 0.2 is a hair below 3 in binary: what is that close to a line between cells is on it. */
double frame_settle(double cells);

frame_point frame_locate(const input *in, input_position position);

/* The cell of a position; QTR_NO_CELL outside the map. */
qtr_cell frame_cell(const input *in, input_position position);

/* The middle of a cell, in metres in the map frame or as column and row. */
input_position frame_centre(const input *in, qtr_cell cell, bool metres);

/* Metres for a map of cells, where the mission says how large they are; x and y from its lower-left corner. */
void frame_of_cells(input *in);

/* The frame as a table holds it, so that a robot can tell cells from its own pose: whole micrometres. Left as it is
 * (none) where the map has no metres. */
void frame_in_um(const input_frame *frame, qtr_frame *out);

/* "x 1.5, y 2" or "column 3, row 4" into out[size]. */
void frame_name(char *out, size_t size, input_position position);

/* Where the map is, for who is outside: "spans x 0 to 5 and y 0 to 4", into out[size]. */
void frame_span(char *out, size_t size, const input *in, bool metres);

#endif

/* Positions that the user states, as cells of the input's map. */
#ifndef QUARTER_READER_FRAME_H
#define QUARTER_READER_FRAME_H

#include "input.h"

/* The cell of a point in metres in the map frame, or of a column and row counted from 0 at the top left. 0, or -1 with
 * *fault set: outside the map, or not a whole number. */
int frame_point(const input *in, double x, double y, input_origin origin, qtr_cell *cell, fault *why);
int frame_cell(const input *in, double column, double row, input_origin origin, qtr_cell *cell, fault *why);

#endif

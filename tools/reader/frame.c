#include "frame.h"

#include <math.h>

#include "file.h"
#include "sites.h"

/* Which cell along an axis. 0.6 / 0.2 is a hair below 3 in binary: a point that close to a line is on it. */
static double cells_along(double metres, double cell_size) {
  double cells = metres / cell_size, nearest = round(cells);
  return fabs(cells - nearest) < 1e-6 ? nearest : floor(cells);
}

int frame_point(const input *in, double x, double y, input_origin origin, qtr_cell *cell, fault *why) {
  const qtr_mission *mission = &in->mission;
  const input_frame *frame = &in->frame;
  double column = cells_along(x - frame->origin_x, frame->cell_size);
  double above = cells_along(y - frame->origin_y, frame->cell_size);
  if (column >= 0.0 && column < mission->columns && above >= 0.0 && above < mission->rows) {
    *cell = (qtr_cell)((mission->rows - 1u - (unsigned)above) * mission->columns + (unsigned)column);
    return 0;
  }
  return file_fault(why, sites_path(in, origin), origin.line, origin.column,
                    "x %g, y %g lies outside the map, which spans x %g to %g and y %g to %g; move it inside", x, y,
                    frame->origin_x, frame->origin_x + mission->columns * frame->cell_size, frame->origin_y,
                    frame->origin_y + mission->rows * frame->cell_size);
}

int frame_cell(const input *in, double column, double row, input_origin origin, qtr_cell *cell, fault *why) {
  const qtr_mission *mission = &in->mission;
  const char *path = sites_path(in, origin);
  if (column != floor(column) || row != floor(row)) {
    return file_fault(why, path, origin.line, origin.column, "column %g, row %g is not a cell; give whole numbers",
                      column, row);
  }
  if (column >= 0.0 && column < mission->columns && row >= 0.0 && row < mission->rows) {
    *cell = (qtr_cell)((unsigned)row * mission->columns + (unsigned)column);
    return 0;
  }
  return file_fault(
      why, path, origin.line, origin.column,
      "column %g, row %g lies outside the map, whose columns are 0 to %d and rows 0 to %d; move it inside", column, row,
      mission->columns - 1, mission->rows - 1);
}

#include "host/input/overlay.h"

#include <math.h>
#include <stdio.h>

#include "host/base/file.h"
#include "host/input/frame.h"

/* ---- where it lies ---- */

/* An image covers the map's own pixels, not the cells that its edge cuts. Its proportions are the map's if no other
 * number of rows would be nearer to them. */
static int cover_map(overlay *over, const raster *it, const input *in, const char *path, fault *why) {
  const double across = in->across > 0.0 ? in->across : in->mission.columns;
  const double upward = in->upward > 0.0 ? in->upward : in->mission.rows;
  *over = (overlay){0.0, 0.0, across / it->columns, upward / it->rows};
  if (fabs(upward / over->across - it->rows) <= 0.5 + 1e-6 || fabs(across / over->upward - it->columns) <= 0.5 + 1e-6)
    return 0;
  return file_fault(why, path, 0, 0,
                    "the image is %d x %d pixels, and the map %g x %g cells: it cannot cover the map as it should; cut "
                    "it to the map, or give an ESRI ASCII grid, which says where it lies",
                    it->columns, it->rows, across, upward);
}

static int place_grid(overlay *over, const raster *it, const input *in, const char *path, fault *why) {
  const input_frame *frame = &in->frame;
  char span[200];
  const double size = it->size / frame->cell_size;
  if (frame->yaw != 0.0)
    return file_fault(why, path, 0, 0,
                      "the map is turned by %g radians, and an ESRI ASCII grid never is; give an image that covers the "
                      "map",
                      frame->yaw);
  *over =
      (overlay){(it->x - frame->origin_x) / frame->cell_size, (it->y - frame->origin_y) / frame->cell_size, size, size};
  if (over->left < in->mission.columns && over->bottom < in->mission.rows && over->left + it->columns * size > 0.0 &&
      over->bottom + it->rows * size > 0.0)
    return 0;
  frame_span(span, sizeof span, in, true);
  return file_fault(
      why, path, 0, 0,
      "it spans x %.10g to %.10g and y %.10g to %.10g and lies beside the map, %s; mend its corner and cellsize, "
      "which are in %s of the map frame",
      it->x, it->x + it->columns * it->size, it->y, it->y + it->rows * it->size, span,
      frame->metric ? "metres" : "cells");
}

int overlay_find(overlay *over, const raster *it, const input *in, const char *path, fault *why) {
  return (it->placed ? place_grid : cover_map)(over, it, in, path, why);
}

/* ---- what lies under it ---- */

typedef struct {
  double from, to;
} range;

static double clip(double value, double most) {
  return value < 0.0 ? 0.0 : value > most ? most : value;
}

/* From the value's edge to the next, on the grid. */
static range range_of(double corner, double side, int index, double most) {
  return (range){clip(frame_settle(corner + index * side), most),
                 clip(frame_settle(corner + (index + 1) * side), most)};
}

static double length_in(range it, double cell) {
  return fmin(it.to, cell + 1.0) - fmax(it.from, cell);
}

static void visit_cells(range across, range upward, double area, double value, const qtr_mission *mission,
                        overlay_visit *visit, void *context) {
  for (double up = floor(upward.from); up < upward.to; up++) {
    const size_t first = (size_t)(mission->rows - 1u - (unsigned)up) * mission->columns;
    for (double column = floor(across.from); column < across.to; column++)
      visit(context, (qtr_cell)(first + (size_t)column), value,
            length_in(across, column) * length_in(upward, up) / area);
  }
}

void overlay_each(const overlay *over, const raster *it, const input *in, overlay_visit *visit, void *context) {
  const qtr_mission *mission = &in->mission;
  for (int row = 0; row < it->rows; row++) {
    const range upward = range_of(over->bottom, over->upward, it->rows - 1 - row, mission->rows);
    for (int column = 0; column < it->columns && upward.from < upward.to; column++) {
      const double value = it->value[(size_t)row * (size_t)it->columns + (size_t)column];
      const range across = range_of(over->left, over->across, column, mission->columns);
      if (!isnan(value)) visit_cells(across, upward, over->across * over->upward, value, mission, visit, context);
    }
  }
}

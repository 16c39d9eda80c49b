#include "host/input/frame.h"

#include <math.h>
#include <stdio.h>

double frame_settle(double cells) {
  double nearest = round(cells);
  return fabs(cells - nearest) < 1e-6 ? nearest : cells;
}

frame_point frame_locate(const input *in, input_position position) {
  const input_frame *frame = &in->frame;
  if (!position.metres) return (frame_point){position.x + 0.5, in->mission.rows - position.y - 0.5};
  double east = position.x - frame->origin_x, north = position.y - frame->origin_y;
  double cosine = cos(frame->yaw), sine = sin(frame->yaw);
  return (frame_point){frame_settle((cosine * east + sine * north) / frame->cell_size),
                       frame_settle((cosine * north - sine * east) / frame->cell_size)};
}

qtr_cell frame_cell(const input *in, input_position position) {
  const qtr_mission *mission = &in->mission;
  frame_point at = frame_locate(in, position);
  if (!(at.across >= 0.0 && at.across < mission->columns && at.up >= 0.0 && at.up < mission->rows)) return QTR_NO_CELL;
  return (qtr_cell)((mission->rows - 1u - (unsigned)at.up) * mission->columns + (unsigned)at.across);
}

void frame_of_cells(input *in) {
  if (in->ground.cell_size > 0.0) in->frame = (input_frame){.metric = true, .cell_size = in->ground.cell_size};
}

/* Back from cells to metres. */
static input_position metres_of(const input_frame *frame, frame_point at) {
  double cosine = cos(frame->yaw), sine = sin(frame->yaw);
  return (input_position){true, frame->origin_x + frame->cell_size * (cosine * at.across - sine * at.up),
                          frame->origin_y + frame->cell_size * (sine * at.across + cosine * at.up)};
}

input_position frame_centre(const input *in, qtr_cell cell, bool metres) {
  unsigned column = (unsigned)(cell % in->mission.columns), row = (unsigned)(cell / in->mission.columns);
  if (!metres) return (input_position){false, column, row};
  return metres_of(&in->frame, (frame_point){column + 0.5, in->mission.rows - row - 0.5});
}

static int64_t micrometres(double metres) {
  return (int64_t)llround(metres * 1e6);
}

void frame_in_um(const input_frame *frame, qtr_frame *out) {
  if (!frame->metric) return;
  out->cell_size_um = (uint32_t)micrometres(frame->cell_size);
  out->origin_x_um = micrometres(frame->origin_x);
  out->origin_y_um = micrometres(frame->origin_y);
  if (frame->yaw == 0.0) return;
  out->cosine = (int32_t)lround(cos(frame->yaw) * QTR_FRAME_ONE);
  out->sine = (int32_t)lround(sin(frame->yaw) * QTR_FRAME_ONE);
}

void frame_name(char *out, size_t size, input_position position) {
  snprintf(out, size, position.metres ? "x %.6g, y %.6g" : "column %.6g, row %.6g", position.x, position.y);
}

void frame_span(char *out, size_t size, const input *in, bool metres) {
  const double columns = in->mission.columns, rows = in->mission.rows;
  if (!metres) {
    snprintf(out, size, "whose columns are 0 to %.0f and rows 0 to %.0f", columns - 1, rows - 1);
    return;
  }
  const input_position first = metres_of(&in->frame, (frame_point){0, 0});
  const input_position last = metres_of(&in->frame, (frame_point){columns, rows});
  if (in->frame.yaw == 0.0) {
    snprintf(out, size, "which spans x %g to %g and y %g to %g", first.x, last.x, first.y, last.y);
    return;
  }
  const input_position right = metres_of(&in->frame, (frame_point){columns, 0});
  const input_position left = metres_of(&in->frame, (frame_point){0, rows});
  snprintf(out, size, "whose corners are (%.4g, %.4g), (%.4g, %.4g), (%.4g, %.4g) and (%.4g, %.4g)", first.x, first.y,
           right.x, right.y, last.x, last.y, left.x, left.y);
}

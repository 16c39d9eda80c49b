/* Ticks and numbers along the lower and the left edge of the map: where things are, in the terms of a mission. */
#include <math.h>

#include "draw_parts.h"

enum { SIZE = 11, APART = 56 }; /* pixels: of the numbers, and between them at least */

/* An axis: the position of the map's first edge, and how much of it a cell is, counted as the numbers are. */
typedef struct {
  const char *name;
  double first, cell;
} axis;

/* 1, 2 or 5 times a power of ten, `least` or more. */
static double round_step(double least) {
  const double power = pow(10, floor(log10(least)));
  for (int n = 0; n < 3; n++)
    if ((const double[]){1, 2, 5}[n] * power >= least * (1 - 1e-9)) return (const double[]){1, 2, 5}[n] * power;
  return 10 * power;
}

/* Numbers need more room where there are more digits; cells are counted in whole numbers. */
static double step_of(const draw_page *page, bool metric, double a_cell) {
  const double step = round_step(APART / page->cell * a_cell);
  return metric ? step : fmax(1, step);
}

static void put_tick_text(const draw_page *page, double x, double y, const char *anchor, double value) {
  fprintf(page->out, "<text x=\"%.2f\" y=\"%.2f\" text-anchor=\"%s\">%.6g</text>\n", x, y, anchor,
          fabs(value) < 1e-9 ? 0.0 : value);
}

/* A line over the map from the axis, as a path's `d`: of five, the one at a number is the darkest. */
static void draw_line(const draw_page *page, double x, double y, const char *direction, double length, bool numbered) {
  fprintf(page->out, "<path stroke=\"%s\" stroke-width=\".7\" stroke-opacity=\"%s\" d=\"M%.2f %.2f%s%.2f\"/>",
          page->theme->muted, numbered ? ".55" : ".18", x, y, direction, length);
}

/* Where there is a grid. Columns and rows have lines of their own already, between them. */
static void draw_lines(const draw_page *page, const axis *a, double step, bool across) {
  const bool down = a->cell < 0, cells = fabs(a->cell) == 1.0 && page->d->cell_size == 0.0;
  const double fine = cells ? step : step / 5, scale = page->cell / fabs(a->cell);
  const double length = across ? page->width : page->height, end = a->first + length / scale;
  if (!page->d->grid) return;
  for (double k = ceil(a->first / fine - 1e-9); k * fine <= end + 1e-9 * fine; k++) {
    const double along = (k * fine - a->first) * scale;
    const bool numbered = fabs(remainder(k * fine, step)) < 1e-6 * step;
    if (across)
      draw_line(page, page->x + along, page->y, "v", page->height, numbered);
    else
      draw_line(page, page->x, down ? page->y + along : page->y + page->height - along, "h", page->width, numbered);
  }
}

/* Along the lower edge, from the left; a number stands at `value` = first + pixels / page->cell * cell. */
static void draw_across(const draw_page *page, const axis *a, double step) {
  const double bottom = page->y + page->height, scale = page->cell / a->cell;
  const double end = a->first + page->width / scale;
  for (double k = ceil(a->first / step - 1e-9); k * step <= end + 1e-9 * step; k++) {
    const double x = page->x + (k * step - a->first) * scale;
    fprintf(page->out, "<path stroke=\"%s\" d=\"M%.2f %.2fv5\"/>", page->theme->muted, x, bottom);
    put_tick_text(page, x, bottom + 16, "middle", k * step);
  }
  fprintf(page->out, "<text x=\"%.2f\" y=\"%.2f\" text-anchor=\"middle\">%s</text>\n", page->x + page->width / 2,
          bottom + 31, a->name);
}

/* Along the left edge: upwards from the bottom, or, with a cell below 0, downwards from the top. */
static void draw_up(const draw_page *page, const axis *a, double step) {
  const bool down = a->cell < 0;
  const double scale = page->cell / fabs(a->cell), end = a->first + page->height / scale;
  for (double k = ceil(a->first / step - 1e-9); k * step <= end + 1e-9 * step; k++) {
    const double along = (k * step - a->first) * scale;
    const double y = down ? page->y + along : page->y + page->height - along;
    fprintf(page->out, "<path stroke=\"%s\" d=\"M%.2f %.2fh-5\"/>", page->theme->muted, page->x, y);
    put_tick_text(page, page->x - 8, y + 4, "end", k * step);
  }
  const double middle = page->y + page->height / 2, x = page->x - DRAW_AXIS_LEFT + SIZE - 2;
  fprintf(page->out,
          "<text x=\"%.2f\" y=\"%.2f\" text-anchor=\"middle\" transform=\"rotate(-90 %.2f %.2f)\">%s</text>\n", x,
          middle, x, middle, a->name);
}

void draw_axes(const draw_page *page) {
  const drawing *d = page->d;
  const bool metric = d->cell_size > 0 && !d->turned;
  const double side = metric ? d->cell_size : 1;
  /* A column's number stands at the middle of its cells. */
  const axis across = {metric ? "x, metres" : "column", metric ? d->x + page->left * side : page->left - 0.5, side};
  const axis up = {metric ? "y, metres" : "row",
                   metric ? d->y + (d->rows - page->top - page->rows) * side : page->top - 0.5, metric ? side : -1};
  const double step = step_of(page, metric, side);
  fprintf(page->out, "<g id=\"axes\" font-size=\"%d\" fill=\"%s\">\n", SIZE, page->theme->muted);
  draw_lines(page, &across, step, true);
  draw_lines(page, &up, step, false);
  draw_across(page, &across, step);
  draw_up(page, &up, step);
  fputs("</g>\n", page->out);
}

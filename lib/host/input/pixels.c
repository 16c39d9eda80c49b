#include "host/input/pixels.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#define OVERLAP 1e-4 /* of a pixel, below which there is none */
#define BLOCKED 255  /* worse than any slow pixel */

/* How far a pixel's middle is from a blocked pixel that many columns (or rows) away, along that axis. */
static double axis_gap(int apart) {
  return apart == 0 ? 0.0 : apart - 0.5;
}

/* reach[d]: how many columns to the left and right a blocked pixel d rows away blocks, for d = 0..rows. Touching
 * counts, and rounding must not decide it: hence the slack. */
static int *make_reach(double radius, int rows, int width) {
  int *reach = malloc(((size_t)rows + 1) * sizeof *reach);
  if (reach == NULL) return NULL;
  double square = radius * radius * (1.0 + 1e-9);
  int columns = (int)fmin(radius + 1.0, width);
  for (int d = 0; d <= rows; d++) {
    double rest = square - axis_gap(d) * axis_gap(d);
    while (columns > 0 && axis_gap(columns) * axis_gap(columns) > rest) columns--;
    reach[d] = columns;
  }
  return reach;
}

/* Rows to the nearest blocked pixel of the same column, at most limit. */
static void column_gaps(uint16_t *gaps, const pixels *map, int limit) {
  size_t width = (size_t)map->width;
  for (int y = 0; y < map->height; y++) {
    const uint8_t *blocked = map->blocked + (size_t)y * width;
    uint16_t *gap = gaps + (size_t)y * width;
    for (size_t x = 0; x < width; x++) {
      int above = y == 0 ? limit : (gap - width)[x] + 1;
      gap[x] = (uint16_t)(blocked[x] ? 0 : above < limit ? above : limit);
    }
  }
  for (int y = map->height - 2; y >= 0; y--) {
    uint16_t *gap = gaps + (size_t)y * width;
    for (size_t x = 0; x < width; x++) {
      int below = (gap + width)[x] + 1;
      if (below < gap[x]) gap[x] = (uint16_t)below;
    }
  }
}

/* Block what the gaps of one row reach, sweeping right and then left. */
static void grow_row(uint8_t *blocked, const uint16_t *gap, int width, const int *reach, int rows) {
  int until = -1;
  for (int x = 0; x < width; x++) {
    if (gap[x] <= rows && x + reach[gap[x]] > until) until = x + reach[gap[x]];
    blocked[x] = x <= until;
  }
  int from = width;
  for (int x = width - 1; x >= 0; x--) {
    if (gap[x] <= rows && x - reach[gap[x]] < from) from = x - reach[gap[x]];
    if (x >= from) blocked[x] = 1;
  }
}

int pixels_grow(pixels *map, double radius) {
  size_t width = (size_t)map->width;
  if (!(radius > 0.0)) return 0;
  int rows = (int)fmin(radius * (1.0 + 1e-9) + 0.5, map->height - 1); /* rows away that matter */
  int *reach = make_reach(radius, rows, map->width);
  uint16_t *gaps = malloc(width * (size_t)map->height * sizeof *gaps);
  if (reach != NULL && gaps != NULL) {
    column_gaps(gaps, map, rows + 1);
    for (int y = 0; y < map->height; y++) {
      grow_row(map->blocked + (size_t)y * width, gaps + (size_t)y * width, map->width, reach, rows);
    }
  }
  int result = reach != NULL && gaps != NULL ? 0 : -1;
  free(reach);
  free(gaps);
  return result;
}

static double settle(double ratio) {
  double whole = round(ratio);
  return fabs(ratio - whole) <= 1e-6 * ratio ? whole : ratio;
}

double pixels_cells(int side, double ratio) {
  return fmax(1.0, ceil(side / settle(ratio) - OVERLAP / settle(ratio)));
}

/* The pixels that a cell overlaps along an axis, counted from the map's lower-left corner. */
typedef struct {
  int first, last;
  bool over_edge;
} span;

static span cell_span(int cell, double ratio, int side) {
  double end = (cell + 1) * ratio;
  span it = {(int)fmin(floor(cell * ratio + OVERLAP), side - 1), 0, end > side + OVERLAP};
  it.last = it.over_edge ? side - 1 : (int)ceil(end - OVERLAP) - 1;
  if (it.last >= side) it.last = side - 1;
  if (it.last < it.first) it.last = it.first;
  return it;
}

static uint8_t worse(uint8_t a, uint8_t b) {
  return a > b ? a : b;
}

static uint8_t badness(const pixels *map, size_t pixel) {
  if (map->blocked[pixel]) return BLOCKED;
  return map->slow != NULL ? map->slow[pixel] : 0;
}

/* worst[x] = of the pixels of column x in the rows of the span. */
static void gather_rows(uint8_t *worst, const pixels *map, span rows) {
  size_t width = (size_t)map->width;
  memset(worst, 0, width);
  for (int y = rows.first; y <= rows.last; y++) {
    const size_t first = (size_t)(map->height - 1 - y) * width;
    for (size_t x = 0; x < width; x++) worst[x] = worse(worst[x], badness(map, first + x));
  }
}

static void fill_row(uint8_t *cost, int columns, const span *spans, const uint8_t *worst) {
  for (int c = 0; c < columns; c++) {
    uint8_t all = spans[c].over_edge ? BLOCKED : 0;
    for (int x = spans[c].first; x <= spans[c].last && all != BLOCKED; x++) all = worse(all, worst[x]);
    cost[c] = all == BLOCKED ? 0 : (uint8_t)(all + 1);
  }
}

int pixels_coarsen(uint8_t *cost, int columns, int rows, const pixels *map, double ratio) {
  uint8_t *worst = malloc((size_t)map->width);
  span *spans = malloc((size_t)columns * sizeof *spans);
  int result = worst != NULL && spans != NULL ? 0 : -1;
  ratio = settle(ratio);
  for (int c = 0; c < columns && result == 0; c++) spans[c] = cell_span(c, ratio, map->width);
  for (int r = 0; r < rows && result == 0; r++) {
    span across = cell_span(rows - 1 - r, ratio, map->height);
    uint8_t *row = cost + (size_t)r * (size_t)columns;
    if (across.over_edge) {
      memset(row, 0, (size_t)columns);
    } else {
      gather_rows(worst, map, across);
      fill_row(row, columns, spans, worst);
    }
  }
  free(worst);
  free(spans);
  return result;
}

#include "host/input/polygon.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- corners ---- */

static bool is_same(frame_point a, frame_point b) {
  return fabs(a.across - b.across) < 1e-9 && fabs(a.up - b.up) < 1e-9;
}

bool polygon_add(polygon *p, frame_point corner) {
  if (p->corners > 0 && is_same(p->corner[p->corners - 1], corner)) return true;
  if (p->corners == POLYGON_CORNERS) return false;
  p->corner[p->corners++] = corner;
  return true;
}

static frame_point end_of(const polygon *p, int edge) {
  return p->corner[(edge + 1) % p->corners];
}

/* Twice the area of the triangle: above 0 where c lies left of the way from a to b. */
static double turn(frame_point a, frame_point b, frame_point c) {
  return (b.across - a.across) * (c.up - a.up) - (b.up - a.up) * (c.across - a.across);
}

static bool is_between(frame_point a, frame_point b, frame_point c) {
  return c.across >= fmin(a.across, b.across) && c.across <= fmax(a.across, b.across) && c.up >= fmin(a.up, b.up) &&
         c.up <= fmax(a.up, b.up);
}

static int side_of(double area) {
  return (area > 0.0) - (area < 0.0);
}

/* Whether the ways from a to b and from c to d have a point in common. */
static bool do_meet(frame_point a, frame_point b, frame_point c, frame_point d) {
  const int c_side = side_of(turn(a, b, c)), d_side = side_of(turn(a, b, d));
  const int a_side = side_of(turn(c, d, a)), b_side = side_of(turn(c, d, b));
  if (c_side != d_side && a_side != b_side) return true;
  return (c_side == 0 && is_between(a, b, c)) || (d_side == 0 && is_between(a, b, d)) ||
         (a_side == 0 && is_between(c, d, a)) || (b_side == 0 && is_between(c, d, b));
}

/* The next edge goes back over this one. */
static bool does_fold(const polygon *p, int edge) {
  const frame_point a = p->corner[edge], b = end_of(p, edge), c = end_of(p, (edge + 1) % p->corners);
  const double along = (b.across - a.across) * (c.across - b.across) + (b.up - a.up) * (c.up - b.up);
  return side_of(turn(a, b, c)) == 0 && along < 0.0;
}

static bool do_cross(const polygon *p, int one, int other) {
  if (other == one + 1) return does_fold(p, one);
  if (one == 0 && other == p->corners - 1) return does_fold(p, other);
  return do_meet(p->corner[one], end_of(p, one), p->corner[other], end_of(p, other));
}

const char *polygon_check(polygon *p, char out[POLYGON_WRONG]) {
  while (p->corners > 1 && is_same(p->corner[0], p->corner[p->corners - 1])) p->corners--;
  if (p->corners < 3) {
    snprintf(out, POLYGON_WRONG, "has %d corner%s; give it 3 at least, each in a place of its own", p->corners,
             p->corners == 1 ? "" : "s");
    return out;
  }
  for (int one = 0; one < p->corners; one++)
    for (int other = one + 1; other < p->corners; other++) {
      if (!do_cross(p, one, other)) continue;
      snprintf(
          out, POLYGON_WRONG,
          "crosses itself: its edges behind corners %d and %d meet (counted from 0); list the corners in their order "
          "around it",
          one, other);
      return out;
    }
  return NULL;
}

/* ---- cells ---- */

typedef struct {
  uint8_t *mask;
  const qtr_mission *mission;
  uint8_t value; /* that cells get */
  size_t count;  /* of those that are set */
} marking;

/* The cells of a row, counted from below, from `from` to `to`; one that is merely touched is none. */
static void mark_row(marking *m, double up, double from, double to) {
  const double first = fmax(0.0, floor(from + 1e-9)), last = fmin(m->mission->columns, ceil(to - 1e-9)) - 1.0;
  const size_t row = (size_t)(m->mission->rows - 1u - (unsigned)up) * m->mission->columns;
  for (double column = first; column <= last; column++) {
    uint8_t *it = &m->mask[row + (size_t)column];
    m->count = m->count + m->value - *it;
    *it = m->value;
  }
}

/* Where an edge is, at a height. */
static double across_at(frame_point a, frame_point b, double up) {
  const double t = (up - a.up) / (b.up - a.up);
  return a.across + fmin(1.0, fmax(0.0, t)) * (b.across - a.across);
}

static void mark_edge(marking *m, frame_point a, frame_point b) {
  const double low = fmin(a.up, b.up), high = fmax(a.up, b.up);
  const double last = fmin(m->mission->rows, ceil(high - 1e-9)) - 1.0;
  for (double up = fmax(0.0, floor(low + 1e-9)); up <= last; up++) {
    const bool level = high - low < 1e-9;
    const double from = level ? a.across : across_at(a, b, up), to = level ? b.across : across_at(a, b, up + 1.0);
    mark_row(m, up, fmin(from, to), fmax(from, to));
  }
}

static int compare(const void *a, const void *b) {
  const double one = *(const double *)a, other = *(const double *)b;
  return (one > other) - (one < other);
}

/* Cells whose middles are inside: those between each two edges that a line through the middles meets. */
static void mark_middles(marking *m, const polygon *p, double up) {
  static double met[POLYGON_CORNERS];
  int count = 0;
  for (int edge = 0; edge < p->corners; edge++) {
    const frame_point a = p->corner[edge], b = end_of(p, edge);
    if ((a.up <= up + 0.5) != (b.up <= up + 0.5)) met[count++] = across_at(a, b, up + 0.5);
  }
  qsort(met, (size_t)count, sizeof *met, compare);
  for (int i = 0; i + 1 < count; i += 2) mark_row(m, up, ceil(met[i] - 0.5), floor(met[i + 1] + 0.5));
}

size_t polygon_mark(uint8_t *mask, const polygon *p, const qtr_mission *mission, enum polygon_cells which) {
  marking m = {mask, mission, 1, 0};
  for (double up = 0.0; up < mission->rows; up++) mark_middles(&m, p, up);
  m.value = which == POLYGON_CUTS;
  for (int edge = 0; edge < p->corners && which != POLYGON_MIDDLES; edge++)
    mark_edge(&m, p->corner[edge], end_of(p, edge));
  return m.count;
}

/* ---- areas ---- */

static double area_of(const frame_point *corner, int corners) {
  double twice = 0.0;
  for (int i = 0; i < corners; i++) twice += turn(corner[0], corner[i], corner[(i + 1) % corners]);
  return fabs(twice) / 2.0;
}

double polygon_area(const polygon *p) {
  return area_of(p->corner, p->corners);
}

/* A corner's way into the half of the plane that is kept: 0 or more. */
typedef struct {
  bool vertical; /* the line that bounds it */
  double at, sign;
} half_plane;

static double depth(const half_plane *h, frame_point p) {
  return h->sign * ((h->vertical ? p.across : p.up) - h->at);
}

static frame_point crossing(const half_plane *h, frame_point a, frame_point b) {
  const double t = depth(h, a) / (depth(h, a) - depth(h, b));
  return (frame_point){a.across + t * (b.across - a.across), a.up + t * (b.up - a.up)};
}

/* Sutherland and Hodgman: what of a polygon lies in a half of the plane. Where that is in parts, lines of no area join
 * them. */
static int keep_half(frame_point *out, const frame_point *in, int corners, const half_plane *h) {
  int count = 0;
  for (int i = 0; i < corners; i++) {
    const frame_point a = in[i], b = in[(i + 1) % corners];
    const bool from = depth(h, a) >= 0.0, to = depth(h, b) >= 0.0;
    if (from) out[count++] = a;
    if (from != to) out[count++] = crossing(h, a, b);
  }
  return count;
}

/* Each half adds a corner for every second one at most. */
double polygon_area_on(const polygon *p, const qtr_mission *mission) {
  static frame_point kept[2][6 * POLYGON_CORNERS];
  const half_plane sides[4] = {
      {true, 0.0, 1.0}, {true, mission->columns, -1.0}, {false, 0.0, 1.0}, {false, mission->rows, -1.0}};
  int corners = p->corners;
  memcpy(kept[0], p->corner, (size_t)corners * sizeof kept[0][0]);
  for (int i = 0; i < 4; i++) corners = keep_half(kept[(i + 1) % 2], kept[i % 2], corners, &sides[i]);
  return corners > 0 ? area_of(kept[0], corners) : 0.0;
}

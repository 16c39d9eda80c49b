/* Trajectories: rounded lines in lanes of their own, with an arrow on every leg that has room for it. */
#include <math.h>

#include "draw_parts.h"

draw_point draw_centre(const draw_page *page, qtr_cell cell) {
  const double column = (double)(cell % page->d->columns) - page->left;
  const double row = (double)(cell / page->d->columns) - page->top;
  return (draw_point){page->x + (column + 0.5) * page->cell, page->y + (row + 0.5) * page->cell};
}

static double line_width(const draw_page *page) {
  return fmin(3.2, fmax(2.4, 0.12 * page->cell));
}

/* The cells of a seeker's way: its trail, or its start and places. */
static size_t way_length(const drawing_seeker *s) {
  return s->trail != NULL ? s->trail_length : (size_t)s->places + 1;
}

static draw_point way_point(const draw_page *page, int seeker, size_t index) {
  const drawing_seeker *s = &page->d->seeker[seeker];
  const qtr_cell cell = s->trail != NULL ? s->trail[index]
                        : index == 0     ? s->start
                                         : page->d->place[s->place[index - 1]];
  const double beside = draw_lane(page, seeker, index) * fmin(5, fmax(3.4, 0.16 * page->cell));
  draw_point point = draw_centre(page, cell);
  point.x += beside;
  point.y += beside;
  return point;
}

static void put_point(FILE *out, char command, draw_point point) {
  fputc(command, out);
  draw_number(out, point.x);
  fputc(' ', out);
  draw_number(out, point.y);
}

static double distance(draw_point a, draw_point b) {
  return hypot(a.x - b.x, a.y - b.y);
}

static draw_point towards(draw_point from, draw_point to, double length) {
  const double whole = distance(from, to), part = whole > 0 ? length / whole : 0;
  return (draw_point){from.x + (to.x - from.x) * part, from.y + (to.y - from.y) * part};
}

static bool is_straight(draw_point before, draw_point middle, draw_point after) {
  const double dot = (middle.x - before.x) * (after.x - middle.x) + (middle.y - before.y) * (after.y - middle.y);
  return dot > 0.999 * distance(before, middle) * distance(middle, after);
}

/* The end of the straight line that begins at a point of the way. */
static size_t line_end(const draw_page *page, int seeker, size_t first) {
  const size_t last = way_length(&page->d->seeker[seeker]) - 1;
  size_t end = first + 1;
  while (end < last &&
         is_straight(way_point(page, seeker, end - 1), way_point(page, seeker, end), way_point(page, seeker, end + 1)))
    end++;
  return end;
}

/* A rounded corner, but a sharp one where the way turns back. */
static void draw_corner(const draw_page *page, draw_point before, draw_point corner, draw_point after) {
  const double in = distance(before, corner), out = distance(corner, after);
  const double dot = (corner.x - before.x) * (after.x - corner.x) + (corner.y - before.y) * (after.y - corner.y);
  if (dot < -0.999 * in * out) {
    put_point(page->out, 'L', corner);
    return;
  }
  const double radius = fmin(fmax(8, page->cell / 2), fmin(in, out) / 2);
  put_point(page->out, 'L', towards(corner, before, radius));
  put_point(page->out, 'Q', corner);
  put_point(page->out, ' ', towards(corner, after, radius));
}

static void draw_way(const draw_page *page, int seeker) {
  const size_t last = way_length(&page->d->seeker[seeker]) - 1;
  size_t first = 0, corner = line_end(page, seeker, first);
  put_point(page->out, 'M', way_point(page, seeker, 0));
  while (corner < last) {
    const size_t next = line_end(page, seeker, corner);
    draw_corner(page, way_point(page, seeker, first), way_point(page, seeker, corner), way_point(page, seeker, next));
    first = corner;
    corner = next;
  }
  put_point(page->out, 'L', way_point(page, seeker, last));
}

/* An arrow head in the middle of a leg, if the leg has room for one. */
static void draw_arrow(const draw_page *page, int seeker, size_t first, size_t last) {
  double length = 0;
  for (size_t i = first; i < last; i++) length += distance(way_point(page, seeker, i), way_point(page, seeker, i + 1));
  if (length < 40) return;
  double left = length / 2;
  size_t i = first;
  for (; i + 1 < last; i++) {
    const double step = distance(way_point(page, seeker, i), way_point(page, seeker, i + 1));
    if (left < step) break;
    left -= step;
  }
  const draw_point from = way_point(page, seeker, i), to = way_point(page, seeker, i + 1);
  const double step = distance(from, to), size = 1.4 + line_width(page) * 1.5;
  const double ux = (to.x - from.x) / step * size, uy = (to.y - from.y) / step * size;
  /* In the middle of a cell's side, where the rounded line runs for sure. */
  const draw_point middle = towards(from, to, page->d->seeker[seeker].trail != NULL ? step / 2 : left);
  char colour[8];
  fprintf(page->out, "<path class=\"arrow\" fill=\"%s\" stroke=\"%s\" stroke-width=\"0.8\" d=\"",
          draw_colour(page, colour, seeker), page->theme->ground);
  put_point(page->out, 'M', (draw_point){middle.x + 1.1 * ux, middle.y + 1.1 * uy});
  put_point(page->out, 'L', (draw_point){middle.x - ux - uy, middle.y - uy + ux});
  put_point(page->out, 'L', (draw_point){middle.x - 0.5 * ux, middle.y - 0.5 * uy});
  put_point(page->out, 'L', (draw_point){middle.x - ux + uy, middle.y - uy - ux});
  fputs("z\"/>\n", page->out);
}

static void draw_arrows(const draw_page *page, int seeker) {
  const drawing_seeker *s = &page->d->seeker[seeker];
  const size_t length = way_length(s);
  size_t first = 0;
  for (int v = 0; v < s->places; v++) {
    size_t last = s->trail != NULL ? first : (size_t)v + 1;
    while (s->trail != NULL && last < length && s->trail[last] != page->d->place[s->place[v]]) last++;
    if (last >= length) return;
    if (last > first) draw_arrow(page, seeker, first, last);
    first = last;
  }
}

void draw_trails(draw_page *page) {
  const double width = line_width(page);
  draw_assign_lanes(page);
  fputs("<g id=\"trajectories\" fill=\"none\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n", page->out);
  for (int seeker = 0; seeker < page->d->seekers; seeker++) {
    char colour[8];
    if (way_length(&page->d->seeker[seeker]) < 2) continue;
    fprintf(page->out, "<path class=\"casing\" stroke=\"%s\" stroke-opacity=\"0.85\" stroke-width=\"%.2f\" d=\"",
            page->theme->ground, width + 2.2);
    draw_way(page, seeker);
    fprintf(page->out, "\"/>\n<path class=\"trajectory\" stroke=\"%s\" stroke-width=\"%.2f\"%s d=\"",
            draw_colour(page, colour, seeker), width, draw_dashes(seeker));
    draw_way(page, seeker);
    fputs("\"/>\n", page->out);
  }
  for (int seeker = 0; seeker < page->d->seekers; seeker++) draw_arrows(page, seeker);
  fputs("</g>\n", page->out);
}

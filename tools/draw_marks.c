/* Starts and places. */
#include <math.h>
#include <stdlib.h>

#include "draw_parts.h"

/* ---- starts ---- */

void draw_badge(const draw_page *page, int seeker, double x, double y, double size) {
  char colour[8];
  fprintf(page->out,
          "<rect x=\"%.2f\" y=\"%.2f\" width=\"%.2f\" height=\"%.2f\" rx=\"3\" fill=\"%s\" stroke=\"%s\" "
          "stroke-width=\"1.4\"/><text x=\"%.2f\" y=\"%.2f\" font-size=\"%.1f\" fill=\"%s\">%d</text>\n",
          x - size / 2, y - size / 2, size, size, draw_colour(colour, seeker), DRAW_INK, x, y + 0.36 * 0.66 * size,
          (seeker < 100 ? 0.66 : 0.5) * size, draw_ink(seeker), seeker);
}

enum { ROW = 4 }; /* squares side by side where seekers share a start */

static int sharing(const drawing *d, int seeker, int *earlier) {
  int count = 0;
  *earlier = 0;
  for (int i = 0; i < d->seekers; i++) {
    if (d->seeker[i].start != d->seeker[seeker].start) continue;
    if (i < seeker) ++*earlier;
    count++;
  }
  return count;
}

/* Where the middle of a block of squares goes so that it stays on the map: at `middle`, if there is room. */
static double keep_on_map(double middle, double size, double map, double map_size) {
  if (size > map_size) return map + map_size / 2;
  return fmin(fmax(middle, map + size / 2), map + map_size - size / 2);
}

void draw_starts(const draw_page *page) {
  const double size = 15, pitch = size + 1;
  fputs("<g id=\"starts\" text-anchor=\"middle\" font-weight=\"bold\">\n", page->out);
  for (int seeker = 0; seeker < page->d->seekers; seeker++) {
    int earlier;
    const int count = sharing(page->d, seeker, &earlier);
    const int across = count < ROW ? count : ROW, down = (count + ROW - 1) / ROW;
    const draw_point centre = draw_centre(page, page->d->seeker[seeker].start);
    const double x = keep_on_map(centre.x, across * pitch, page->x, page->width);
    const double y = keep_on_map(centre.y, down * pitch, page->y, page->height);
    draw_badge(page, seeker, x + (earlier % ROW - (across - 1) / 2.0) * pitch,
               y + (earlier / ROW - (down - 1) / 2.0) * pitch, size);
  }
  fputs("</g>\n", page->out);
}

/* ---- places ---- */

double draw_radius(const draw_page *page, double likelihood) {
  const double largest = fmin(22, fmax(14, 0.46 * page->cell));
  return largest * sqrt(likelihood / page->largest);
}

static void draw_order(const draw_page *page, int place, draw_point at, double radius) {
  const int number = page->visit[place] + 1;
  const double size = fmin(14, fmax(10, radius * 1.05));
  const bool inside = radius >= (number < 10 ? 7 : 9);
  if (inside)
    fprintf(page->out, "<text x=\"%.2f\" y=\"%.2f\" font-size=\"%.1f\" fill=\"%s\">%d</text>", at.x, at.y + 0.36 * size,
            size, draw_ink(page->visitor[place]), number);
  else
    fprintf(page->out,
            "<text x=\"%.2f\" y=\"%.2f\" font-size=\"11\" fill=\"%s\" stroke=\"#fff\" stroke-width=\"3\" "
            "stroke-linejoin=\"round\" paint-order=\"stroke\" text-anchor=\"start\">%d</text>",
            at.x + 0.75 * radius, at.y - 0.75 * radius, DRAW_INK, number);
}

/* Whose colour a place wears: its spot's, its visitor's, or nobody's (-1). */
static int wearer(const draw_page *page, int place) {
  return page->d->spot != NULL ? page->d->spot[place] : page->visitor[place];
}

/* A, B, ... Z, then numbers. */
static void draw_spot(const draw_page *page, int place, draw_point at) {
  const int spot = page->d->spot[place];
  char mark[8];
  snprintf(mark, sizeof mark, spot < 26 ? "%c" : "%d", spot < 26 ? 'A' + spot : spot + 1);
  fprintf(page->out, "<text x=\"%.2f\" y=\"%.2f\" font-size=\"12\" fill=\"%s\">%s</text>", at.x, at.y + 4.3,
          draw_ink(spot), mark);
}

static void draw_place(const draw_page *page, int place) {
  const drawing *d = page->d;
  const int visitor = page->visitor[place];
  const draw_point at = draw_centre(page, d->place[place]);
  const double radius = fmax(draw_radius(page, d->likelihood[place]), d->spot != NULL ? 9 : 2.5);
  const int wears = wearer(page, place);
  char colour[8];
  fprintf(page->out, "<g class=\"place\"><title>place %d, likelihood %.4g", place, d->likelihood[place]);
  if (visitor >= 0)
    fprintf(page->out, ", seeker %d, visit %d, step %lu", visitor, page->visit[place] + 1,
            (unsigned long)d->seeker[visitor].step[page->visit[place]]);
  fprintf(page->out,
          "</title><circle cx=\"%.2f\" cy=\"%.2f\" r=\"%.2f\" fill=\"%s\" stroke=\"%s\" stroke-width=\"1.3\"/>", at.x,
          at.y, radius, wears < 0 ? "#fff" : draw_colour(colour, wears), DRAW_INK);
  if (d->spot != NULL)
    draw_spot(page, place, at);
  else if (visitor >= 0)
    draw_order(page, place, at, radius);
  fputs("</g>\n", page->out);
}

static const double *sort_likelihood;

static int compare_places(const void *a, const void *b) {
  const int p = *(const int *)a, q = *(const int *)b;
  if (sort_likelihood[p] != sort_likelihood[q]) return sort_likelihood[p] > sort_likelihood[q] ? -1 : 1;
  return p - q;
}

/* The smaller over the larger. */
void draw_places(const draw_page *page) {
  int order[QTR_MAX_PLACES];
  for (int p = 0; p < page->d->places; p++) order[p] = p;
  sort_likelihood = page->d->likelihood;
  qsort(order, (size_t)page->d->places, sizeof *order, compare_places);
  fputs("<g id=\"places\" text-anchor=\"middle\" font-weight=\"bold\">\n", page->out);
  for (int p = 0; p < page->d->places; p++) draw_place(page, order[p]);
  fputs("</g>\n", page->out);
}

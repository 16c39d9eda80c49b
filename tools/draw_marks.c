/* Places, starts and what is written beside them. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "draw_parts.h"
#include "figures.h"
#include "host/base/xml.h"

void draw_badge(const draw_page *page, int seeker, double x, double y, double size) {
  char colour[8];
  fprintf(page->out,
          "<rect x=\"%.2f\" y=\"%.2f\" width=\"%.2f\" height=\"%.2f\" rx=\"3\" fill=\"%s\" stroke=\"%s\" "
          "stroke-width=\"1.4\"/><text x=\"%.2f\" y=\"%.2f\" font-size=\"%.1f\" fill=\"%s\">%d</text>\n",
          x - size / 2, y - size / 2, size, size, draw_colour(page, colour, seeker), page->theme->ink, x,
          y + 0.36 * 0.66 * size, (seeker < 100 ? 0.66 : 0.5) * size, draw_ink(page, seeker), seeker);
}

/* ---- places ---- */

static draw_point place_centre(const draw_page *page, int place) {
  return draw_centre(page, page->d->place[place]);
}

double draw_fit_radius(const draw_page *page) {
  const drawing *d = page->d;
  const double most = fmin(22, fmax(14, 0.46 * page->cell));
  double share = 1;
  for (int p = 0; p < d->places; p++)
    for (int q = 0; q < p; q++) {
      const draw_point a = place_centre(page, p), b = place_centre(page, q);
      const double radii = most * (sqrt(d->likelihood[p] / page->largest) + sqrt(d->likelihood[q] / page->largest));
      share = fmin(share, (hypot(a.x - b.x, a.y - b.y) - 1) / radii);
    }
  return fmax(fmin(most, 7), share * most);
}

double draw_radius(const draw_page *page, double likelihood) {
  return page->largest_radius * sqrt(likelihood / page->largest);
}

static double place_radius(const draw_page *page, int place) {
  return fmax(draw_radius(page, page->d->likelihood[place]), page->d->spot != NULL ? 9 : 3);
}

/* Whose colour a place wears: its spot's, its visitor's, or nobody's (-1). */
static int wearer(const draw_page *page, int place) {
  return page->d->spot != NULL ? page->d->spot[place] : page->visitor[place];
}

/* A place that is searched too late wears nobody's colour. */
static bool is_late(const draw_page *page, int place) {
  const int visitor = page->visitor[place];
  return visitor >= 0 && drawing_is_late(page->d, page->d->seeker[visitor].step[page->visit[place]]);
}

/* ", seeker 0, visit 3, step 14, 7 s", once for each look. */
static void tell_visits(const draw_page *page, int place) {
  const drawing *d = page->d;
  for (int seeker = 0; seeker < d->seekers; seeker++)
    for (int v = 0; v < d->seeker[seeker].places; v++)
      if (d->seeker[seeker].place[v] == place)
        fprintf(page->out, ", seeker %d, visit %d, %s%s", seeker, v + 1,
                figures_moment(d->seeker[seeker].step[v], d->step_seconds).text,
                figures_late(drawing_is_late(d, d->seeker[seeker].step[v])));
}

static void draw_place(draw_page *page, int place) {
  const drawing *d = page->d;
  const draw_point at = place_centre(page, place);
  const double radius = place_radius(page, place);
  const int wears = wearer(page, place);
  char colour[8];
  fputs("<g class=\"place\"><title>place ", page->out);
  xml_text(page->out, draw_place_label(d, place).text, QTR_SITE_NAME_BYTES);
  fprintf(page->out, ", likelihood %.4g", d->likelihood[place]);
  tell_visits(page, place);
  fprintf(page->out,
          "</title><circle cx=\"%.2f\" cy=\"%.2f\" r=\"%.2f\" fill=\"%s\" stroke=\"%s\" stroke-width=\"1.3\"/></g>\n",
          at.x, at.y, radius,
          wears < 0 || is_late(page, place) ? page->theme->ground : draw_colour(page, colour, wears), page->theme->ink);
  draw_take(page, &(draw_box){at.x - radius, at.y - radius, 2 * radius, 2 * radius});
}

static const double *sort_likelihood;

static int compare_places(const void *a, const void *b) {
  const int p = *(const int *)a, q = *(const int *)b;
  if (sort_likelihood[p] != sort_likelihood[q]) return sort_likelihood[p] > sort_likelihood[q] ? -1 : 1;
  return p - q;
}

/* The smaller over the larger. */
static void draw_places(draw_page *page) {
  int order[QTR_MAX_PLACES];
  for (int p = 0; p < page->d->places; p++) order[p] = p;
  sort_likelihood = page->d->likelihood;
  qsort(order, (size_t)page->d->places, sizeof *order, compare_places);
  fputs("<g id=\"places\">\n", page->out);
  for (int p = 0; p < page->d->places; p++) draw_place(page, order[p]);
  fputs("</g>\n", page->out);
}

/* ---- starts ---- */

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

/* Where the squares of a start go: on its cell, or beside it where a place or other squares stand there. */
static draw_box find_block(const draw_page *page, draw_point at, double width, double height) {
  draw_box block = {at.x - width / 2, at.y - height / 2, width, height};
  if (width <= page->width) block.x = fmin(fmax(block.x, page->x), page->x + page->width - width);
  if (height <= page->height) block.y = fmin(fmax(block.y, page->y), page->y + page->height - height);
  if (!draw_is_clear(page, &block)) draw_find_room(page, at, page->largest_radius + 1, width, height, &block);
  return block;
}

/* From a start to its squares that stand beside it. */
static void draw_leader(const draw_page *page, draw_point at, const draw_box *block) {
  const double x = fmin(fmax(at.x, block->x), block->x + block->width);
  const double y = fmin(fmax(at.y, block->y), block->y + block->height);
  if (hypot(x - at.x, y - at.y) < 2) return;
  fprintf(page->out,
          "<path stroke=\"%s\" stroke-width=\"1.4\" d=\"M%.2f %.2fL%.2f %.2f\"/><circle cx=\"%.2f\" cy=\"%.2f\" "
          "r=\"2.6\" fill=\"%s\" stroke=\"%s\" stroke-width=\"0.8\"/>\n",
          page->theme->ink, at.x, at.y, x, y, at.x, at.y, page->theme->ink, page->theme->ground);
}

static void draw_start(draw_page *page, int seeker, int count) {
  const double size = 15, pitch = size + 1;
  const int across = count < ROW ? count : ROW, down = (count + ROW - 1) / ROW;
  const qtr_cell start = page->d->seeker[seeker].start;
  const draw_point at = draw_centre(page, start);
  const draw_box block = find_block(page, at, across * pitch, down * pitch);
  int drawn = 0;
  draw_take(page, &block);
  draw_leader(page, at, &block);
  for (int i = seeker; i < page->d->seekers; i++) {
    if (page->d->seeker[i].start != start) continue;
    draw_badge(page, i, block.x + (drawn % ROW + 0.5) * pitch, block.y + (drawn / ROW + 0.5) * pitch, size);
    drawn++;
  }
}

static void draw_starts(draw_page *page) {
  fputs("<g id=\"starts\" text-anchor=\"middle\" font-weight=\"bold\">\n", page->out);
  for (int seeker = 0; seeker < page->d->seekers; seeker++) {
    int earlier;
    const int count = sharing(page->d, seeker, &earlier);
    if (earlier == 0) draw_start(page, seeker, count);
  }
  fputs("</g>\n", page->out);
}

/* ---- labels: a place's number, and which of its seeker's visits it is ---- */

void draw_ordinal(char text[16], int number) {
  static const char *const ends[] = {"th", "st", "nd", "rd"};
  const int last = number % 10;
  snprintf(text, 16, "%d%s", number, ends[last < 4 && number / 10 % 10 != 1 ? last : 0]);
}

/* A, B, ... Z, then numbers. */
static void spot_mark(char text[QTR_SITE_NAME_BYTES], int spot) {
  snprintf(text, QTR_SITE_NAME_BYTES, spot < 26 ? "%c" : "%d", spot < 26 ? 'A' + spot : spot + 1);
}

#define BOLD 1.17 /* how much wider bold text is */

/* What stands inside a place: its spot's letter, or what it is called where there is room. False: nothing. */
static bool draw_inside(const draw_page *page, int place) {
  const draw_point at = place_centre(page, place);
  const double radius = place_radius(page, place), size = fmin(14, fmax(10, radius * 1.05));
  const int wears = wearer(page, place);
  naming_label label = draw_place_label(page->d, place);
  if (page->d->spot != NULL)
    spot_mark(label.text, page->d->spot[place]);
  else if (BOLD * draw_text_width(label.text, size) > 2 * radius - 3)
    return false;
  fprintf(page->out, "<text x=\"%.2f\" y=\"%.2f\" font-size=\"%.1f\" font-weight=\"bold\" fill=\"%s\">", at.x,
          at.y + 0.36 * size, size, wears < 0 ? page->theme->ink : draw_ink(page, wears));
  xml_text(page->out, label.text, QTR_SITE_NAME_BYTES);
  fputs("</text>\n", page->out);
  return page->d->spot == NULL;
}

static void write_label(draw_page *page, const draw_box *box, const char *number, const char *order) {
  draw_take(page, box);
  fprintf(page->out, "<text x=\"%.2f\" y=\"%.2f\" text-anchor=\"start\">", box->x + 1, box->y + box->height - 2.5);
  if (*number != '\0') {
    fputs("<tspan font-weight=\"bold\">", page->out);
    xml_text(page->out, number, QTR_SITE_NAME_BYTES);
    fprintf(page->out, "</tspan>%s", *order != '\0' ? " " : "");
  }
  fprintf(page->out, "%s</text>\n", order);
}

/* The number, if it is not inside, and the order. Where there is no room for both the order is left to the title. */
static void draw_label(draw_page *page, int place, bool numbered) {
  char number[sizeof(naming_label)] = "", order[32] = "";
  const draw_point at = place_centre(page, place);
  const double nearest = place_radius(page, place) + 1;
  draw_box box;
  if (!numbered) snprintf(number, sizeof number, "%s", draw_place_label(page->d, place).text);
  if (page->visitor[place] >= 0) draw_ordinal(order, page->visit[place] + 1);
  if (page->looks[place] > 1) sprintf(order + strlen(order), " x%d", page->looks[place]);
  if (*number == '\0' && *order == '\0') return;
  const double alone = BOLD * draw_text_width(number, 10.5) + 2, gap = numbered ? 0 : draw_text_width(" ", 10.5);
  if (draw_find_room(page, at, nearest, alone + gap + draw_text_width(order, 10.5), 12, &box)) {
    write_label(page, &box, number, order);
  } else if (!numbered) {
    draw_find_room(page, at, nearest, alone, 12, &box);
    write_label(page, &box, number, "");
  }
}

/* Numbers come first, for they are what a place is known by. */
static void draw_labels(draw_page *page) {
  bool numbered[QTR_MAX_PLACES];
  fputs("<g id=\"numbers\" text-anchor=\"middle\">\n", page->out);
  for (int p = 0; p < page->d->places; p++) numbered[p] = draw_inside(page, p);
  fprintf(page->out,
          "</g>\n<g id=\"labels\" font-size=\"10.5\" fill=\"%s\" stroke=\"%s\" stroke-width=\"4\" "
          "stroke-linejoin=\"round\" paint-order=\"stroke\">\n",
          page->theme->ink, page->theme->ground);
  for (int p = 0; p < page->d->places; p++)
    if (!numbered[p]) draw_label(page, p, false);
  for (int p = 0; p < page->d->places; p++)
    if (numbered[p]) draw_label(page, p, true);
  fputs("</g>\n", page->out);
}

void draw_marks(draw_page *page) {
  draw_places(page);
  draw_starts(page);
  draw_labels(page);
}

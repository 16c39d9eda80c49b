#include <math.h>
#include <string.h>

#include "draw_parts.h"
#include "figures.h"
#include "host/base/xml.h"

enum { SEEKER_ROW = 24, LINE_ROW = 19, SIZES_ROW = 52, KEY_ROW = 28, GAP = 14 };

#define SEEKER_TEXT (QTR_SITE_NAME_BYTES + 80)

/* Whether a place is searched several times. */
static bool looks_again(const drawing *d) {
  static bool seen[QTR_MAX_PLACES];
  memset(seen, 0, sizeof seen);
  for (int i = 0; i < d->seekers; i++)
    for (int v = 0; v < d->seeker[i].places; v++) {
      if (seen[d->seeker[i].place[v]]) return true;
      seen[d->seeker[i].place[v]] = true;
    }
  return false;
}

static void seeker_text(char text[SEEKER_TEXT], const drawing *d, int seeker) {
  const drawing_seeker *s = &d->seeker[seeker];
  const char *name = d->names != NULL ? d->names->seeker[seeker] : "";
  if (*name != '\0') text += sprintf(text, "%s: ", name);
  if (s->places == 0 && s->trail == NULL)
    snprintf(text, 80, "starts here");
  else if (s->places == 0)
    snprintf(text, 80, "no place: stands down");
  else
    snprintf(text, 80, "%d %s%s, last at %.60s", s->places, looks_again(d) ? "look" : "place",
             s->places == 1 ? "" : "s", figures_moment(s->step[s->places - 1], d->step_seconds).text);
}

static bool has_slow_ground(const drawing *d, int *slowest) {
  *slowest = 1;
  for (size_t cell = 0; cell < drawing_cells(d); cell++)
    if (d->cost[cell] > *slowest) *slowest = d->cost[cell];
  return *slowest > 1;
}

static bool has_visits(const drawing *d) {
  bool any = false;
  for (int i = 0; i < d->seekers; i++) any = any || d->seeker[i].places > 0;
  return any;
}

static bool has_late_visits(const drawing *d) {
  for (int i = 0; i < d->seekers; i++)
    for (int v = 0; v < d->seeker[i].places; v++)
      if (drawing_is_late(d, d->seeker[i].step[v])) return true;
  return false;
}

static int key_height(const draw_page *page) {
  const drawing *d = page->d;
  int slowest;
  return (d->places > 0 ? SIZES_ROW : 0) + (has_visits(d) ? KEY_ROW : 0) + (has_late_visits(d) ? KEY_ROW : 0) +
         (has_slow_ground(d, &slowest) ? KEY_ROW : 0) + (page->pockets ? KEY_ROW : 0) + KEY_ROW +
         (d->cell_size > 0 ? KEY_ROW : 0);
}

double draw_legend_width(const draw_page *page) {
  double width = 236;
  for (int l = 0; l < page->d->lines; l++) width = fmax(width, draw_text_width(page->d->line[l], 13) + 12);
  for (int i = 0; i < page->d->seekers; i++) {
    char text[SEEKER_TEXT];
    seeker_text(text, page->d, i);
    width = fmax(width, draw_text_width(text, 13) + 60);
  }
  return fmin(width, 420);
}

double draw_legend_height(const draw_page *page) {
  const drawing *d = page->d;
  return SEEKER_ROW * d->seekers + (d->lines > 0 ? GAP + LINE_ROW * d->lines : 0) + GAP + key_height(page);
}

static void put_text(const draw_page *page, double x, double y, const char *attributes, const char *text, int most) {
  fprintf(page->out, "<text x=\"%.2f\" y=\"%.2f\"%s>", x, y, attributes);
  xml_text(page->out, text, most);
  fputs("</text>\n", page->out);
}

/* What explains. */
static void put_muted(const draw_page *page, double x, double y, const char *text, int most) {
  char attributes[40];
  snprintf(attributes, sizeof attributes, " fill=\"%s\"", page->theme->muted);
  put_text(page, x, y, attributes, text, most);
}

static double draw_seekers(const draw_page *page, double y) {
  for (int seeker = 0; seeker < page->d->seekers; seeker++, y += SEEKER_ROW) {
    char text[SEEKER_TEXT], colour[8];
    seeker_text(text, page->d, seeker);
    const bool walks = page->d->seeker[seeker].places > 0 || page->d->seeker[seeker].trail != NULL;
    if (walks)
      fprintf(page->out, "<path stroke=\"%s\" stroke-width=\"3\" stroke-linecap=\"round\"%s d=\"M%.2f %.2fh28\"/>\n",
              draw_colour(page, colour, seeker), draw_dashes(seeker), page->legend_x + 22, y + 9);
    fputs("<g text-anchor=\"middle\" font-weight=\"bold\">", page->out);
    draw_badge(page, seeker, page->legend_x + 9, y + 9, 17);
    fputs("</g>", page->out);
    put_text(page, page->legend_x + (walks ? 60 : 28), y + 13.5, "", text, SEEKER_TEXT);
  }
  return y;
}

static void draw_rule(const draw_page *page, double y) {
  fprintf(page->out, "<path stroke=\"%s\" stroke-opacity=\"0.25\" d=\"M%.2f %.2fh%.2f\"/>\n", page->theme->ink,
          page->legend_x, y, page->legend_width);
}

/* "name<tab>value" with the value at the right edge, or a line as it is. */
static void draw_line(const draw_page *page, double y, const char *line) {
  char name[160];
  const char *tab = strchr(line, '\t');
  const int most = (int)(page->legend_width / (0.58 * 13));
  if (tab == NULL) {
    put_text(page, page->legend_x, y, "", line, most);
    return;
  }
  snprintf(name, sizeof name, "%.*s", (int)(tab - line), line);
  put_muted(page, page->legend_x, y, name, most);
  put_text(page, page->legend_x + page->legend_width, y, " text-anchor=\"end\"", tab + 1, most);
}

static double draw_lines(const draw_page *page, double y) {
  if (page->d->lines == 0) return y;
  draw_rule(page, y + GAP / 2.0 - 2);
  y += GAP;
  for (int l = 0; l < page->d->lines; l++, y += LINE_ROW) draw_line(page, y + 13, page->d->line[l]);
  return y;
}

/* ---- the key ---- */

static double likelihood_sum(const drawing *d) {
  double sum = 0;
  for (int p = 0; p < d->places; p++) sum += d->likelihood[p];
  return sum;
}

static void draw_sizes(const draw_page *page, double y) {
  double least = page->largest;
  for (int p = 0; p < page->d->places; p++) least = fmin(least, page->d->likelihood[p]);
  const double sum = likelihood_sum(page->d), middle = y + SIZES_ROW / 2.0 - 4;
  const double shown[2] = {least, page->largest};
  double x = page->legend_x;
  for (int s = least < page->largest ? 0 : 1; s < 2; s++) {
    char text[40];
    const double radius = fmax(2.5, draw_radius(page, shown[s]));
    fprintf(page->out,
            "<circle cx=\"%.2f\" cy=\"%.2f\" r=\"%.2f\" fill=\"none\" stroke=\"%s\" stroke-width=\"1.3\"/>\n",
            x + radius + 1, middle, radius, page->theme->ink);
    const double percent = 100 * shown[s] / sum;
    snprintf(text, sizeof text, percent < 9.95 ? "%.2g %%" : "%.0f %%", percent);
    put_text(page, x + 2 * radius + 8, middle + 4.5, "", text, 40);
    x += 2 * radius + 18 + draw_text_width(text, 13);
  }
  put_muted(page, x, middle + 4.5, "likelihood", 40);
}

/* What the labels beside the places say. */
static void draw_label_key(const draw_page *page, double y) {
  const bool again = looks_again(page->d);
  put_text(page, page->legend_x, y + 14.5, " font-size=\"10.5\"", again ? "2nd x3" : "2nd", 10);
  put_muted(page, page->legend_x + (again ? 44 : 32), y + 14.5,
            again ? "second look of its seeker, of three in all" : "second visit of its seeker", 60);
}

static void draw_late_key(const draw_page *page, double y) {
  fprintf(page->out, "<circle cx=\"%.2f\" cy=\"%.2f\" r=\"6\" fill=\"%s\" stroke=\"%s\" stroke-width=\"1.3\"/>\n",
          page->legend_x + 11, y + 10, page->theme->ground, page->theme->ink);
  put_muted(page, page->legend_x + 32, y + 14.5, "searched after the deadline", 40);
}

/* A square of ground, `column` squares from the left. */
static void draw_swatch(const draw_page *page, double y, int column, const char *fill) {
  fprintf(page->out,
          "<rect x=\"%.2f\" y=\"%.2f\" width=\"22\" height=\"16\" fill=\"%s\"/><rect x=\"%.2f\" y=\"%.2f\" "
          "width=\"22\" height=\"16\" fill=\"%s\" stroke=\"%s\" stroke-opacity=\"0.5\"/>\n",
          page->legend_x + 26 * column, y + 2, page->theme->ground, page->legend_x + 26 * column, y + 2, fill,
          page->theme->ink);
}

static void draw_slow(const draw_page *page, double y, int slowest) {
  char text[60];
  snprintf(text, sizeof text,
           page->d->step_seconds > 0.0 ? "slow, up to %d times as long" : "slow, up to %d steps a cell", slowest);
  draw_swatch(page, y, 0, "url(#slow-key)");
  put_muted(page, page->legend_x + 32, y + 14.5, text, 60);
}

static void draw_blocked(const draw_page *page, double y) {
  draw_swatch(page, y, 0, page->theme->wall);
  if (page->solid) draw_swatch(page, y, 1, page->theme->solid);
  put_muted(page, page->legend_x + (page->solid ? 58 : 32), y + 14.5,
            page->d->reached_alone ? "blocked, or out of reach" : "blocked", 40);
}

static void draw_pocket(const draw_page *page, double y) {
  draw_swatch(page, y, 0, "url(#pocket-key)");
  put_muted(page, page->legend_x + 32, y + 14.5, "free, but no robot gets there", 40);
}

/* 1, 2 or 5 times a power of ten, in metres: the longest that takes up to a third of the map or of the legend. */
static double scale_length(const draw_page *page) {
  static const double digits[] = {1, 2, 5};
  const double most = fmin(page->width / 3, page->legend_width / 2) / page->cell * page->d->cell_size;
  double best = 0;
  for (int power = -3; power < 7; power++)
    for (int n = 0; n < 3; n++)
      if (digits[n] * pow(10, power) <= most) best = digits[n] * pow(10, power);
  return best;
}

static void draw_scale(const draw_page *page, double y) {
  char text[40];
  const double metres = scale_length(page), pixels = metres / page->d->cell_size * page->cell;
  if (metres <= 0) return;
  fprintf(page->out,
          "<path fill=\"none\" stroke=\"%s\" stroke-width=\"1.6\" d=\"M%.2f %.2fv8M%.2f %.2fh%.2fm0 -4v8\"/>\n",
          page->theme->ink, page->legend_x + 1, y + 6, page->legend_x + 1, y + 10, pixels);
  snprintf(text, sizeof text, "%g m", metres);
  put_muted(page, page->legend_x + pixels + 10, y + 14.5, text, 40);
}

static void draw_key(const draw_page *page, double y) {
  int slowest;
  draw_rule(page, y + GAP / 2.0 - 2);
  y += GAP;
  if (page->d->places > 0) {
    draw_sizes(page, y);
    y += SIZES_ROW;
  }
  if (has_visits(page->d)) {
    draw_label_key(page, y);
    y += KEY_ROW;
  }
  if (has_late_visits(page->d)) {
    draw_late_key(page, y);
    y += KEY_ROW;
  }
  if (has_slow_ground(page->d, &slowest)) {
    draw_slow(page, y, slowest);
    y += KEY_ROW;
  }
  if (page->pockets) {
    draw_pocket(page, y);
    y += KEY_ROW;
  }
  draw_blocked(page, y);
  if (page->d->cell_size > 0) draw_scale(page, y + KEY_ROW);
}

void draw_legend(const draw_page *page) {
  fprintf(page->out, "<g id=\"legend\" font-size=\"13\" fill=\"%s\">\n", page->theme->ink);
  draw_key(page, draw_lines(page, draw_seekers(page, page->y)));
  fputs("</g>\n", page->out);
}

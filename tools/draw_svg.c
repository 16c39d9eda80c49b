#include "draw_svg.h"

#include <math.h>
#include <stdlib.h>

#include "draw_parts.h"
#include "figures.h"
#include "host/base/count.h"
#include "host/base/xml.h"

enum { PAD = 22, TITLE = 34, LONGEST_SIDE = 880 };

/* ---- what is shown, and where ---- */

typedef struct {
  unsigned left, top, right, bottom; /* the last ones included */
} extent;

static extent free_extent(const drawing *d) {
  extent e = {d->columns, d->rows, 0, 0};
  for (unsigned row = 0; row < d->rows; row++) {
    for (unsigned column = 0; column < d->columns; column++) {
      if (d->cost[(size_t)row * d->columns + column] == 0) continue;
      e.left = column < e.left ? column : e.left;
      e.right = column > e.right ? column : e.right;
      e.top = row < e.top ? row : e.top;
      e.bottom = row;
    }
  }
  return e.left <= e.right ? e : (extent){0, 0, d->columns - 1, d->rows - 1};
}

/* The free cells and what lies next to them: maps often have wide margins of nothing known. */
static void crop(draw_page *page) {
  const drawing *d = page->d;
  const extent e = free_extent(d);
  page->left = e.left > 0 ? e.left - 1 : 0;
  page->top = e.top > 0 ? e.top - 1 : 0;
  page->columns = (e.right + 1 < d->columns ? e.right + 2 : d->columns) - page->left;
  page->rows = (e.bottom + 1 < d->rows ? e.bottom + 2 : d->rows) - page->top;
}

static void lay_out(draw_page *page) {
  const unsigned longest = page->columns > page->rows ? page->columns : page->rows;
  page->cell = fmin(64, (double)LONGEST_SIDE / longest);
  if (page->cell > 4) page->cell = floor(page->cell);
  page->x = PAD + DRAW_AXIS_LEFT;
  page->y = PAD + (page->d->title != NULL ? TITLE : 0);
  page->width = page->cell * page->columns;
  page->height = page->cell * page->rows;
  page->legend_x = page->x + page->width + PAD;
  page->legend_width = draw_legend_width(page);
  page->page_width = page->legend_x + page->legend_width + PAD;
  page->page_height = page->y + fmax(page->height + DRAW_AXIS_BOTTOM, draw_legend_height(page)) + PAD;
}

static qtr_steps first_step(const draw_page *page, int place) {
  return page->d->seeker[page->visitor[place]].step[page->visit[place]];
}

/* Of the looks at a place the first one counts. */
static void find_visitors(draw_page *page) {
  const drawing *d = page->d;
  page->largest = 0;
  for (int p = 0; p < d->places; p++) {
    page->visitor[p] = -1;
    page->looks[p] = 0;
    page->largest = fmax(page->largest, d->likelihood[p]);
  }
  for (int seeker = 0; seeker < d->seekers; seeker++) {
    for (int v = 0; v < d->seeker[seeker].places; v++) {
      const int place = d->seeker[seeker].place[v];
      if (page->looks[place]++ > 0 && d->seeker[seeker].step[v] >= first_step(page, place)) continue;
      page->visitor[place] = seeker;
      page->visit[place] = v;
    }
  }
}

/* ---- checks ---- */

static bool seeker_fits(const drawing *d, const drawing_seeker *s) {
  const size_t cells = drawing_cells(d);
  if (s->start >= cells) return false;
  for (size_t i = 0; s->trail != NULL && i < s->trail_length; i++)
    if (s->trail[i] >= cells) return false;
  for (int v = 0; v < s->places; v++)
    if (s->place[v] >= d->places) return false;
  return true;
}

static bool fits(const drawing *d) {
  const size_t cells = drawing_cells(d);
  if (cells == 0 || d->places > QTR_MAX_PLACES || d->seekers > QTR_MAX_SEEKERS) return false;
  for (int p = 0; p < d->places; p++)
    if (d->place[p] >= cells || !(d->likelihood[p] > 0)) return false;
  for (int i = 0; i < d->seekers; i++)
    if (!seeker_fits(d, &d->seeker[i])) return false;
  return true;
}

/* ---- the page ---- */

static void describe_visit(const draw_page *page, const drawing_seeker *seeker, int visit) {
  fprintf(page->out, "%s place ", visit > 0 ? "," : "");
  xml_text(page->out, draw_place_label(page->d, seeker->place[visit]).text, QTR_SITE_NAME_BYTES);
  fprintf(page->out, " at %s%s", figures_moment(seeker->step[visit], page->d->step_seconds).text,
          figures_late(drawing_is_late(page->d, seeker->step[visit])));
}

static void describe(const draw_page *page) {
  const drawing *d = page->d;
  fputs("<title id=\"title\">", page->out);
  xml_text(page->out, d->title != NULL ? d->title : "Search plan", 1000);
  fprintf(page->out, "</title>\n<desc id=\"desc\">A map of %u by %u cells with %s and %s.", d->columns, d->rows,
          counted((uint64_t)d->places, "place").text, counted((uint64_t)d->seekers, "seeker").text);
  for (int i = 0; i < d->seekers; i++) {
    fprintf(page->out, " Seeker %d visits", i);
    if (d->seeker[i].places == 0) fputs(" no place", page->out);
    for (int v = 0; v < d->seeker[i].places; v++) describe_visit(page, &d->seeker[i], v);
    fputc('.', page->out);
  }
  fputs("</desc>\n", page->out);
}

/* Lines `size` apart, `angle` degrees from upright, of which a share is ink. */
static void define_hatching(const draw_page *page, const char *name, double size, int angle, const char *colour,
                            double share) {
  fprintf(page->out,
          "<pattern id=\"%s\" width=\"%.5f\" height=\"%.5f\" patternUnits=\"userSpaceOnUse\" "
          "patternTransform=\"rotate(%d)\"><path d=\"M0 0v%.5f\" stroke=\"%s\" stroke-width=\"%.5f\"/></pattern>\n",
          name, size, size, angle, size, colour, size * share);
}

/* Of the map, which is drawn in cells, and of the legend. */
static void define_hatchings(const draw_page *page) {
  const draw_theme *theme = page->theme;
  define_hatching(page, "slow", 6 / page->cell, 45, theme->slow, 0.55);
  define_hatching(page, "slow-key", 6, 45, theme->slow, 0.55);
  define_hatching(page, "pocket", 5 / page->cell, -45, theme->muted, 0.3);
  define_hatching(page, "pocket-key", 5, -45, theme->muted, 0.3);
}

static void begin_page(const draw_page *page) {
  fprintf(page->out,
          "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" aria-labelledby=\"title desc\" width=\"%.0f\" "
          "height=\"%.0f\" viewBox=\"0 0 %.0f %.0f\" font-family=\"Helvetica, Arial, 'Liberation Sans', 'DejaVu Sans', "
          "sans-serif\">\n",
          page->page_width, page->page_height, page->page_width, page->page_height);
  describe(page);
  fputs("<defs>\n", page->out);
  define_hatchings(page);
  fprintf(page->out, "</defs>\n<rect width=\"100%%\" height=\"100%%\" fill=\"%s\"/>\n", page->theme->page);
}

static void draw_title(const draw_page *page) {
  const double room = page->page_width - 2 * PAD;
  if (page->d->title == NULL) return;
  const double size = fmax(13, fmin(19, 19 * room / fmax(1, draw_text_width(page->d->title, 19))));
  fprintf(page->out, "<text x=\"%d\" y=\"%d\" font-size=\"%.1f\" font-weight=\"bold\" fill=\"%s\">", PAD, PAD + 16,
          size, page->theme->ink);
  xml_text(page->out, page->d->title, (int)(room / (0.58 * size)));
  fputs("</text>\n", page->out);
}

int draw_svg(FILE *out, const drawing *d) {
  draw_page page = {.out = out, .d = d, .theme = draw_theme_of(d)};
  const size_t cells = drawing_cells(d);
  if (!fits(d)) return -1;
  page.layer = malloc(cells * sizeof *page.layer);
  page.queue = malloc(cells * sizeof *page.queue);
  const bool ready = page.layer != NULL && page.queue != NULL;
  if (ready) {
    crop(&page);
    draw_look(&page);
    lay_out(&page);
    find_visitors(&page);
    page.largest_radius = draw_fit_radius(&page);
    begin_page(&page);
    draw_title(&page);
    draw_map(&page);
    draw_axes(&page);
    draw_trails(&page);
    draw_marks(&page);
    draw_legend(&page);
    fputs("</svg>\n", out);
  }
  free(page.layer);
  free(page.queue);
  return ready ? 0 : -1;
}

/* What the parts of a picture share. Private to draw_*.c. */
#ifndef QUARTER_TOOLS_DRAW_PARTS_H
#define QUARTER_TOOLS_DRAW_PARTS_H

#include <stdbool.h>
#include <stdio.h>

#include "draw_input.h"
#include "host/base/naming.h"

/* The colours of a picture, but for its seekers'. */
typedef struct {
  const char *page;
  const char *ground;
  const char *ink;
  const char *muted;
  const char *wall;
  const char *solid; /* blocked, away from free cells */
  const char *slow;
  double tint; /* how much of a seeker's colour its territory has */
} draw_theme;

typedef struct {
  double x, y;
} draw_point;

/* In pixels of the picture, from its upper left corner. */
typedef struct {
  double x, y, width, height;
} draw_box;

enum { DRAW_AXIS_LEFT = 46, DRAW_AXIS_BOTTOM = 34 };
enum { DRAW_BOXES = 2 * QTR_MAX_PLACES + QTR_MAX_SEEKERS };

typedef struct {
  FILE *out;
  const drawing *d;
  const draw_theme *theme;
  /* the part of the map that is shown, in cells, and where it goes, in pixels of the picture */
  unsigned left, top, columns, rows;
  double cell, x, y, width, height;
  double legend_x, legend_width, page_width, page_height;
  double largest;              /* likelihood */
  double largest_radius;       /* of a place */
  int visitor[QTR_MAX_PLACES]; /* seeker; -1: nobody */
  int visit[QTR_MAX_PLACES];   /* which of the seeker's visits, from 0 */
  int looks[QTR_MAX_PLACES];   /* all visits, by whomever */
  int lane[QTR_MAX_SEEKERS];   /* how far beside the cells' middles a trajectory runs */
  int boxes;
  draw_box box[DRAW_BOXES]; /* where places, starts and labels stand */
  bool pockets;             /* some free cells are out of reach */
  bool solid;               /* some blocked ones lie away from free cells */
  uint16_t *layer;          /* scratch: a number for each cell of the map */
  qtr_cell *queue;          /* scratch, as many */
} draw_page;

/* ---- draw_style.c ---- */

const draw_theme *draw_theme_of(const drawing *d);
/* "#rrggbb", from a palette that the colour-blind can tell apart (Okabe and Ito 2008), varied from the 8th seeker
 * on. */
const char *draw_colour(const draw_page *page, char text[8], int seeker);
/* What to write in on that colour. */
const char *draw_ink(const draw_page *page, int seeker);
/* Of the seeker's lines: empty, or a stroke-dasharray attribute where colours come again. */
const char *draw_dashes(int seeker);
/* Width in pixels of a text, roughly. */
double draw_text_width(const char *text, double size);
/* Two decimals at most, no zeros at the end. */
void draw_number(FILE *out, double number);

/* ---- the parts, from the bottom to the top ---- */

/* What a place is called: its name, or else its number. */
static inline naming_label draw_place_label(const drawing *d, int place) {
  naming_label label;
  if (d->names != NULL && d->names->place[place][0] != '\0')
    snprintf(label.text, sizeof label.text, "%s", d->names->place[place]);
  else
    snprintf(label.text, sizeof label.text, "%d", d->number != NULL ? d->number[place] : place);
  return label;
}

draw_point draw_centre(const draw_page *page, qtr_cell cell);
double draw_radius(const draw_page *page, double likelihood);
/* The largest radius of a place at which places near one another do not cover each other, within bounds. */
double draw_fit_radius(const draw_page *page);
void draw_map(draw_page *page);
/* Finds out what the legend is to explain: page->pockets and page->solid. */
void draw_look(draw_page *page);
void draw_trails(draw_page *page);
/* Places, then the starts beside those that they would hide, then the labels where there is room for them. */
void draw_marks(draw_page *page);
/* "1st", "2nd", "3rd", "4th". */
void draw_ordinal(char text[16], int number);
/* Lanes for the seekers' trajectories, so that no two run over one another. They stand in `layer` too: leave it alone
 * until the trajectories are drawn. */
void draw_assign_lanes(draw_page *page);
/* How many lanes beside the middle a point of a trail lies. */
int draw_lane(const draw_page *page, int seeker, size_t index);

/* ---- draw_axes.c ---- */

/* Along the map's lower and left edges, in DRAW_AXIS_LEFT and DRAW_AXIS_BOTTOM pixels: metres of the map frame, or
 * columns and rows where it has none, or does not run along them. */
void draw_axes(const draw_page *page);

/* ---- draw_labels.c ---- */

/* A box stands here from now on. */
void draw_take(draw_page *page, const draw_box *box);
bool draw_is_clear(const draw_page *page, const draw_box *box);
/* Room for a box around a point, `nearest` from it or a little further; false: there is none, *found stands on
 * least. */
bool draw_find_room(const draw_page *page, draw_point point, double nearest, double width, double height,
                    draw_box *found);

/* ---- draw_legend.c ---- */

/* The square with the seeker's number, its middle at a point. */
void draw_badge(const draw_page *page, int seeker, double x, double y, double size);
void draw_legend(const draw_page *page);
double draw_legend_height(const draw_page *page);
double draw_legend_width(const draw_page *page);

#endif

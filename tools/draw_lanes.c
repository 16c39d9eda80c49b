/* Lanes: where trajectories share the way between two cells they run side by side, elsewhere in the cells' middles. */
#include <string.h>

#include "draw_parts.h"

enum { EAST = 1, SOUTH = 2, SHARED = 2, VISITOR = 4 }; /* shifts: shared sides, visitor */

/* The cell to whose record a step of the trail belongs, and which of the cell's two sides it crosses; 0 for none. */
static unsigned side_of(const drawing *d, const drawing_seeker *s, size_t step, qtr_cell *cell) {
  const qtr_cell from = s->trail[step], to = s->trail[step + 1];
  *cell = from < to ? from : to;
  const size_t apart = from < to ? (size_t)to - from : (size_t)from - to;
  if (apart == 1) return EAST;
  return apart == d->columns ? SOUTH : 0;
}

static void mark(draw_page *page, const drawing_seeker *s) {
  qtr_cell cell;
  memset(page->layer, 0, drawing_cells(page->d) * sizeof *page->layer);
  for (size_t step = 0; step + 1 < s->trail_length; step++) {
    const unsigned side = side_of(page->d, s, step, &cell);
    page->layer[cell] = (uint16_t)(page->layer[cell] | side);
  }
}

static bool shares(const draw_page *page, const drawing_seeker *s) {
  qtr_cell cell;
  for (size_t step = 0; step + 1 < s->trail_length; step++) {
    const unsigned side = side_of(page->d, s, step, &cell);
    if ((page->layer[cell] & side) != 0) return true;
  }
  return false;
}

/* 0, 1, -1, 2, -2, ... */
static int lane_number(int n) {
  return n % 2 == 1 ? n / 2 + 1 : -(n / 2);
}

static void assign_lanes(draw_page *page) {
  const drawing *d = page->d;
  bool taken[QTR_MAX_SEEKERS][QTR_MAX_SEEKERS] = {{false}};
  for (int i = 0; i < d->seekers; i++) {
    int n = 0;
    while (taken[i][n]) n++;
    page->lane[i] = lane_number(n);
    if (d->seeker[i].trail == NULL) continue;
    mark(page, &d->seeker[i]);
    for (int later = i + 1; later < d->seekers; later++)
      if (d->seeker[later].trail != NULL && shares(page, &d->seeker[later])) taken[later][n] = true;
  }
}

/* In the layer: by which sides each cell is left by one seeker and by several, and who visits the place on it. */
static void mark_shared(draw_page *page) {
  const drawing *d = page->d;
  const size_t cells = drawing_cells(d);
  qtr_cell cell;
  memset(page->layer, 0, cells * sizeof *page->layer);
  memset(page->queue, 0, cells * sizeof *page->queue);
  for (int i = 0; i < d->seekers; i++) {
    const drawing_seeker *s = &d->seeker[i];
    for (size_t step = 0; s->trail != NULL && step + 1 < s->trail_length; step++) {
      const unsigned side = side_of(d, s, step, &cell);
      if ((page->queue[cell] & side) != 0) continue; /* the seeker's own way again */
      page->queue[cell] = (qtr_cell)(page->queue[cell] | side);
      page->layer[cell] = (uint16_t)(page->layer[cell] | (page->layer[cell] & side) << SHARED | side);
    }
    for (size_t step = 0; s->trail != NULL && step + 1 < s->trail_length; step++) {
      side_of(d, s, step, &cell);
      page->queue[cell] = 0;
    }
  }
  for (int p = 0; p < d->places; p++) {
    uint16_t *mark = &page->layer[d->place[p]];
    *mark = (uint16_t)(*mark | (page->visitor[p] + 1) << VISITOR);
  }
}

void draw_assign_lanes(draw_page *page) {
  assign_lanes(page);
  mark_shared(page);
}

static bool is_shared(const draw_page *page, const drawing_seeker *s, size_t step) {
  qtr_cell cell;
  const unsigned side = side_of(page->d, s, step, &cell);
  return (page->layer[cell] >> SHARED & side) != 0;
}

int draw_lane(const draw_page *page, int seeker, size_t index) {
  const drawing_seeker *s = &page->d->seeker[seeker];
  if (s->trail == NULL || index == 0 || page->layer[s->trail[index]] >> VISITOR == seeker + 1) return 0;
  const bool shared = is_shared(page, s, index - 1) || (index + 1 < s->trail_length && is_shared(page, s, index));
  return shared ? page->lane[seeker] : 0;
}

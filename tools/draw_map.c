/* The map: walls, solid parts, slow ground, territories, regions. A layer gives every cell a number; cells of the same
 * number are drawn as one path of rectangles as large as they come, so that a map of a million cells stays a small
 * file. */
#include <string.h>

#include "draw_parts.h"

static uint16_t at(const draw_page *page, unsigned row, unsigned column) {
  return page->layer[(size_t)row * page->d->columns + column];
}

/* Do the cells first..end-1 of a row have this number, and those next to them not? */
static bool is_run(const draw_page *page, unsigned row, unsigned first, unsigned end, uint16_t number) {
  if (first > page->left && at(page, row, first - 1) == number) return false;
  if (end < page->left + page->columns && at(page, row, end) == number) return false;
  for (unsigned column = first; column < end; column++)
    if (at(page, row, column) != number) return false;
  return true;
}

/* A run that goes on from the row above is part of a rectangle already. */
static void draw_run(const draw_page *page, unsigned row, unsigned first, unsigned end, uint16_t number) {
  unsigned height = 1;
  if (row > page->top && is_run(page, row - 1, first, end, number)) return;
  while (row + height < page->top + page->rows && is_run(page, row + height, first, end, number)) height++;
  fprintf(page->out, "M%u %uh%uv%uh-%uz", first - page->left, row - page->top, end - first, height, end - first);
}

/* The path's data, in cells; false (and nothing written) if no cell has the number. */
static bool draw_cells(const draw_page *page, uint16_t number, const char *attributes) {
  const unsigned right = page->left + page->columns;
  bool any = false;
  for (unsigned row = page->top; row < page->top + page->rows; row++) {
    for (unsigned first = page->left, end; first < right; first = end) {
      end = first + 1;
      if (at(page, row, first) != number) continue;
      while (end < right && at(page, row, end) == number) end++;
      if (!any) fprintf(page->out, "<path %s d=\"", attributes);
      any = true;
      draw_run(page, row, first, end, number);
    }
  }
  if (any) fputs("\"/>\n", page->out);
  return any;
}

/* ---- ground ---- */

enum { GROUND_FREE, GROUND_WALL, GROUND_SOLID };

static void fill_cells(const draw_page *page, uint16_t number, const char *fill) {
  char attributes[80];
  snprintf(attributes, sizeof attributes, "fill=\"%s\"", fill);
  draw_cells(page, number, attributes);
}

static bool touches_free(const drawing *d, unsigned row, unsigned column) {
  for (unsigned r = row > 0 ? row - 1 : 0; r <= row + 1 && r < d->rows; r++)
    for (unsigned c = column > 0 ? column - 1 : 0; c <= column + 1 && c < d->columns; c++)
      if (d->cost[(size_t)r * d->columns + c] != 0) return true;
  return false;
}

static void draw_ground(draw_page *page) {
  const drawing *d = page->d;
  for (unsigned row = 0; row < d->rows; row++) {
    for (unsigned column = 0; column < d->columns; column++) {
      const size_t cell = (size_t)row * d->columns + column;
      page->layer[cell] = GROUND_FREE;
      if (d->cost[cell] == 0) page->layer[cell] = touches_free(d, row, column) ? GROUND_WALL : GROUND_SOLID;
    }
  }
  fill_cells(page, GROUND_SOLID, page->theme->solid);
  fill_cells(page, GROUND_WALL, page->theme->wall);
}

/* The cell next to another in direction 0..3; the cell itself at the map's edge. */
static size_t beside(const drawing *d, size_t cell, int direction) {
  const size_t column = cell % d->columns;
  switch (direction) {
  case 0: return cell >= d->columns ? cell - d->columns : cell;
  case 1: return column + 1 < d->columns ? cell + 1 : cell;
  case 2: return cell + d->columns < drawing_cells(d) ? cell + d->columns : cell;
  default: return column > 0 ? cell - 1 : cell;
  }
}

/* ---- what no robot gets to ---- */

/* Free cells that lie apart from every start, and from every place where there is none: a layer of 1 on those that do
 * not. */
static void flood_reach(draw_page *page) {
  const drawing *d = page->d;
  size_t head = 0, tail = 0;
  memset(page->layer, 0, drawing_cells(d) * sizeof *page->layer);
  for (int i = 0; i < (d->seekers > 0 ? d->seekers : d->places); i++) {
    const qtr_cell from = d->seekers > 0 ? d->seeker[i].start : d->place[i];
    if (page->layer[from] == 0) page->queue[tail++] = from;
    page->layer[from] = 1;
  }
  while (head < tail) {
    const size_t cell = page->queue[head++];
    for (int direction = 0; direction < 4; direction++) {
      const size_t next = beside(d, cell, direction);
      if (page->layer[next] != 0 || d->cost[next] == 0) continue;
      page->layer[next] = 1;
      page->queue[tail++] = (qtr_cell)next;
    }
  }
}

enum { REACHED = 1, POCKET = 2 };

static void mark_pockets(draw_page *page) {
  const drawing *d = page->d;
  page->pockets = false;
  if (d->seekers == 0 && d->places == 0) return;
  flood_reach(page);
  for (size_t cell = 0; cell < drawing_cells(d); cell++) {
    if (d->cost[cell] == 0 || page->layer[cell] == REACHED) continue;
    page->layer[cell] = POCKET;
    page->pockets = true;
  }
}

static void draw_pockets(draw_page *page) {
  mark_pockets(page);
  if (page->pockets) draw_cells(page, POCKET, "class=\"pocket\" fill=\"url(#pocket)\"");
}

void draw_look(draw_page *page) {
  const drawing *d = page->d;
  mark_pockets(page);
  page->solid = false;
  for (unsigned row = page->top; row < page->top + page->rows; row++)
    for (unsigned column = page->left; column < page->left + page->columns; column++)
      if (d->cost[(size_t)row * d->columns + column] == 0 && !touches_free(d, row, column)) page->solid = true;
}

static void draw_slow_ground(draw_page *page) {
  const drawing *d = page->d;
  bool met[256] = {false};
  int slowest = 2;
  for (size_t cell = 0; cell < drawing_cells(d); cell++) {
    page->layer[cell] = d->cost[cell];
    met[d->cost[cell]] = true;
    if (d->cost[cell] > slowest) slowest = d->cost[cell];
  }
  for (int cost = 2; cost < 256; cost++) {
    char attributes[80];
    if (!met[cost]) continue;
    snprintf(attributes, sizeof attributes, "fill=\"url(#slow)\" opacity=\"%.2f\"", 0.35 + 0.65 * cost / slowest);
    draw_cells(page, (uint16_t)cost, attributes);
  }
}

/* ---- territories ---- */

/* Every free cell belongs to the seeker that visits the place nearest to it by steps: a flood from all places at
 * once. */
static void flood_territories(draw_page *page) {
  const drawing *d = page->d;
  size_t head = 0, tail = 0;
  memset(page->layer, 0, drawing_cells(d) * sizeof *page->layer);
  for (int p = 0; p < d->places; p++) {
    if (page->visitor[p] < 0 || page->layer[d->place[p]] != 0) continue;
    page->layer[d->place[p]] = (uint16_t)(page->visitor[p] + 1);
    page->queue[tail++] = d->place[p];
  }
  while (head < tail) {
    const size_t cell = page->queue[head++];
    for (int direction = 0; direction < 4; direction++) {
      const size_t next = beside(d, cell, direction);
      if (page->layer[next] != 0 || d->cost[next] == 0) continue;
      page->layer[next] = page->layer[cell];
      page->queue[tail++] = (qtr_cell)next;
    }
  }
}

/* Blocked cells are painted over later: as part of a territory they make for fewer rectangles. */
static void fill_blocked_cells(draw_page *page) {
  const drawing *d = page->d;
  for (size_t cell = 1; cell < drawing_cells(d); cell++)
    if (d->cost[cell] == 0) page->layer[cell] = page->layer[cell - 1];
}

static void draw_territories(draw_page *page) {
  flood_territories(page);
  fill_blocked_cells(page);
  for (int seeker = 0; seeker < page->d->seekers; seeker++) {
    char colour[8], attributes[80];
    snprintf(attributes, sizeof attributes, "class=\"territory\" fill=\"%s\" opacity=\"%.2f\"",
             draw_colour(page, colour, seeker), page->theme->tint);
    draw_cells(page, (uint16_t)(seeker + 1), attributes);
  }
}

/* ---- lines ---- */

static void draw_grid_lines(const draw_page *page) {
  if (page->cell < 12) return;
  fprintf(page->out, "<path stroke=\"%s\" stroke-opacity=\"0.13\" stroke-width=\"%.4f\" d=\"", page->theme->ink,
          1 / page->cell);
  for (unsigned column = 1; column < page->columns; column++) fprintf(page->out, "M%u 0v%u", column, page->rows);
  for (unsigned row = 1; row < page->rows; row++) fprintf(page->out, "M0 %uh%u", row, page->columns);
  fputs("\"/>\n", page->out);
}

static bool is_border(const drawing *d, size_t cell, size_t other) {
  return d->cost[cell] != 0 && d->cost[other] != 0 && d->region[cell] != d->region[other];
}

static void draw_region_borders(const draw_page *page) {
  const drawing *d = page->d;
  if (d->region == NULL) return;
  fprintf(page->out,
          "<path class=\"regions\" fill=\"none\" stroke=\"%s\" stroke-opacity=\"0.6\" stroke-width=\"%.4f\" d=\"",
          page->theme->ink, 1.2 / page->cell);
  for (unsigned row = 0; row < page->rows; row++) {
    for (unsigned column = 0; column < page->columns; column++) {
      const size_t cell = (size_t)(row + page->top) * d->columns + column + page->left;
      if (column > 0 && is_border(d, cell, cell - 1)) fprintf(page->out, "M%u %uv1", column, row);
      if (row > 0 && is_border(d, cell, cell - d->columns)) fprintf(page->out, "M%u %uh1", column, row);
    }
  }
  fputs("\"/>\n", page->out);
}

static void draw_representatives(const draw_page *page) {
  const drawing *d = page->d;
  if (d->region == NULL || d->representative == NULL) return;
  fprintf(page->out, "<g class=\"representatives\" fill=\"%s\" shape-rendering=\"auto\">\n", page->theme->muted);
  for (uint32_t region = 0; region < d->regions; region++)
    fprintf(page->out, "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"0.16\"/>\n",
            d->representative[region] % d->columns - page->left + 0.5,
            d->representative[region] / d->columns - page->top + 0.5);
  fputs("</g>\n", page->out);
}

void draw_map(draw_page *page) {
  fprintf(page->out, "<g id=\"map\" transform=\"translate(%.2f %.2f)\">\n", page->x, page->y);
  fprintf(page->out, "<rect width=\"%.2f\" height=\"%.2f\" fill=\"%s\"/>\n", page->width, page->height,
          page->theme->ground);
  fprintf(page->out, "<g transform=\"scale(%.6f)\" shape-rendering=\"crispEdges\">\n", page->cell);
  draw_territories(page);
  draw_slow_ground(page);
  draw_pockets(page);
  draw_grid_lines(page);
  draw_ground(page);
  draw_region_borders(page);
  draw_representatives(page);
  fprintf(page->out,
          "</g>\n<rect width=\"%.2f\" height=\"%.2f\" fill=\"none\" stroke=\"%s\" stroke-width=\"1.5\"/>\n</g>\n",
          page->width, page->height, page->theme->wall);
}

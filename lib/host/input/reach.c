#include "host/input/reach.h"

#include <stdlib.h>

/* Mark the free cells around `cell` and put them on the stack. */
static size_t spread(uint8_t *ground, const qtr_mission *mission, qtr_cell cell, qtr_cell *stack, size_t top) {
  const unsigned columns = mission->columns, column = (unsigned)(cell % columns), row = (unsigned)(cell / columns);
  const struct {
    bool inside;
    qtr_cell cell;
  } next[4] = {{row > 0, (qtr_cell)(cell - columns)},
               {row + 1u < mission->rows, (qtr_cell)(cell + columns)},
               {column > 0, (qtr_cell)(cell - 1)},
               {column + 1 < columns, (qtr_cell)(cell + 1)}};
  for (int i = 0; i < 4; i++) {
    if (!next[i].inside || mission->cost[next[i].cell] == 0 || ground[next[i].cell] != 0) continue;
    ground[next[i].cell] = 1;
    stack[top++] = next[i].cell;
  }
  return top;
}

/* The robots' own cells; how many. */
static size_t mark_starts(uint8_t *ground, const qtr_mission *mission, qtr_cell *stack) {
  size_t top = 0;
  for (int i = 0; i < mission->seekers; i++) {
    const qtr_cell start = mission->start[i];
    if (start == QTR_NO_CELL || mission->cost[start] == 0 || ground[start] != 0) continue;
    ground[start] = 1;
    stack[top++] = start;
  }
  return top;
}

static void mark(uint8_t *ground, const qtr_mission *mission, qtr_cell *stack) {
  const size_t cells = qtr_mission_cells(mission);
  size_t top = mark_starts(ground, mission, stack);
  const bool any = top > 0;
  while (top > 0) {
    const qtr_cell cell = stack[--top];
    top = spread(ground, mission, cell, stack, top);
  }
  for (size_t cell = 0; !any && cell < cells; cell++) ground[cell] = mission->cost[cell] != 0;
}

uint8_t *reach_mark(const input *in) {
  const size_t cells = qtr_mission_cells(&in->mission);
  qtr_cell *stack = malloc(cells * sizeof *stack);
  uint8_t *ground = stack != NULL ? calloc(cells, 1) : NULL;
  if (ground != NULL) mark(ground, &in->mission, stack);
  free(stack);
  return ground;
}

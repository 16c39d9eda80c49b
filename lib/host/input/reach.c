#include "host/input/reach.h"

#include <stdlib.h>

/* One class's part of the work. */
typedef struct {
  const qtr_mission *mission;
  int of;
  reach *marked;
  qtr_cell *stack;
} flood;

static bool may_enter(const flood *f, qtr_cell cell) {
  const uint8_t cost = f->mission->cost[cell];
  return cost == 1 || (cost > 1 && !f->mission->robot_class[f->of].smooth_only);
}

static bool take(const flood *f, qtr_cell cell) {
  const reach bit = (reach)1 << f->of;
  if (!may_enter(f, cell) || (f->marked[cell] & bit) != 0) return false;
  f->marked[cell] |= bit;
  return true;
}

/* Mark the cells around `cell` and put them on the stack. */
static size_t spread(const flood *f, qtr_cell cell, size_t top) {
  const qtr_mission *mission = f->mission;
  const unsigned columns = mission->columns, column = (unsigned)(cell % columns), row = (unsigned)(cell / columns);
  const struct {
    bool inside;
    qtr_cell cell;
  } next[4] = {{row > 0, (qtr_cell)(cell - columns)},
               {row + 1u < mission->rows, (qtr_cell)(cell + columns)},
               {column > 0, (qtr_cell)(cell - 1)},
               {column + 1 < columns, (qtr_cell)(cell + 1)}};
  for (int i = 0; i < 4; i++)
    if (next[i].inside && take(f, next[i].cell)) f->stack[top++] = next[i].cell;
  return top;
}

/* The class's robots' own cells; how many. */
static size_t mark_starts(const flood *f) {
  const qtr_mission *mission = f->mission;
  size_t top = 0;
  for (int i = 0; i < mission->seekers; i++) {
    const qtr_cell start = mission->start[i];
    if (mission->class_of[i] == f->of && start != QTR_NO_CELL && take(f, start)) f->stack[top++] = start;
  }
  return top;
}

static void mark(const qtr_mission *mission, reach *marked, qtr_cell *stack) {
  const size_t cells = qtr_mission_cells(mission);
  bool any = false;
  for (int of = 0; of < mission->classes; of++) {
    const flood f = {mission, of, marked, stack};
    size_t top = mark_starts(&f);
    any = any || top > 0;
    while (top > 0) {
      const qtr_cell cell = stack[--top];
      top = spread(&f, cell, top);
    }
  }
  for (size_t cell = 0; !any && cell < cells; cell++) marked[cell] = mission->cost[cell] != 0 ? ~(reach)0 : 0;
}

reach *reach_mark(const input *in) {
  const size_t cells = qtr_mission_cells(&in->mission);
  qtr_cell *stack = malloc(cells * sizeof *stack);
  reach *marked = stack != NULL ? calloc(cells, sizeof *marked) : NULL;
  if (marked != NULL) mark(&in->mission, marked, stack);
  free(stack);
  return marked;
}

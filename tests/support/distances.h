/* Small maps, drawn or at random, and how far apart their cells are, by Floyd and Warshall. */
#ifndef QUARTER_TESTS_DISTANCES_H
#define QUARTER_TESTS_DISTANCES_H

#include <stdio.h>
#include <string.h>

#include "quarter/grid.h"
#include "random.h"

enum { CELLS = 930, FAR = 100000000 }; /* cells of the maps whose distances are worked out */

static uint8_t cost[QTR_MAX_CELLS];
static qtr_grid grid;
static int apart[CELLS][CELLS]; /* by cell: the longer of the two ways, FAR if there is none */
static int free_cell[CELLS], free_count;

/* No rows. */
static inline void begin_map(void) {
  grid = (qtr_grid){0, 0, QTR_GRID_BYTES, cost};
}

static inline void add_row(const char *row, int columns) {
  for (int c = 0; c < columns; c++) cost[grid.rows * columns + c] = row[c] == '#' ? 0 : row[c] == '~' ? 3 : 1;
  grid.columns = (uint16_t)columns;
  grid.rows++;
}

/* Rows separated by '/'. */
static inline void draw(const char *rows) {
  const int columns = (int)strcspn(rows, "/");
  for (const char *at = rows;; at += columns + 1) {
    add_row(at, columns);
    if (at[columns] == '\0') return;
  }
}

/* No rows if it cannot be read. */
static inline void draw_file(const char *path) {
  char line[200];
  FILE *file = fopen(path, "r");
  if (file == NULL) return;
  while (fgets(line, sizeof line, file) != NULL)
    if (line[0] != ';') add_row(line, (int)strcspn(line, "\r\n"));
  fclose(file);
}

static inline void scatter(test_random *random, unsigned columns, unsigned rows, unsigned walls, unsigned dearest) {
  grid.columns = (uint16_t)columns;
  grid.rows = (uint16_t)rows;
  for (unsigned cell = 0; cell < columns * rows; cell++)
    cost[cell] = random_chance(random, walls) ? 0 : (uint8_t)random_in(random, 1, dearest);
}

/* ---- distances by Floyd and Warshall, over the free cells ---- */

static inline bool are_beside(int a, int b) {
  const int columns = grid.columns;
  if (a / columns == b / columns) return a - b == 1 || b - a == 1;
  return a - b == columns || b - a == columns;
}

static inline void shorten_by(int via) {
  for (int i = 0; i < free_count; i++) {
    int *way = apart[free_cell[i]];
    if (way[via] == FAR) continue;
    for (int k = 0; k < free_count; k++) {
      const int by_via = way[via] + apart[via][free_cell[k]];
      if (by_via < way[free_cell[k]]) way[free_cell[k]] = by_via;
    }
  }
}

/* The steps into a cell from the one beside it. */
static inline void set_out(int a) {
  for (int i = 0; i < free_count; i++) {
    const int b = free_cell[i];
    apart[a][b] = a == b ? 0 : are_beside(a, b) ? cost[b] : FAR;
  }
}

static inline void take_the_longer(int a, int b) {
  if (apart[a][b] < apart[b][a]) apart[a][b] = apart[b][a];
  apart[b][a] = apart[a][b];
}

static inline void work_out_distances(void) {
  free_count = 0;
  for (int cell = 0; cell < grid.columns * grid.rows; cell++)
    if (cost[cell] > 0) free_cell[free_count++] = cell;
  for (int i = 0; i < free_count; i++) set_out(free_cell[i]);
  for (int i = 0; i < free_count; i++) shorten_by(free_cell[i]);
  for (int i = 0; i < free_count; i++)
    for (int k = 0; k < i; k++) take_the_longer(free_cell[i], free_cell[k]);
}

#endif

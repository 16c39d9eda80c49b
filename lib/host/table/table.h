/* A policy table from a file, and what it says. */
#ifndef QUARTER_HOST_TABLE_H
#define QUARTER_HOST_TABLE_H

#include <stdbool.h>

#include "host/base/fault.h"
#include "host/base/file.h"
#include "quarter/policy.h"
#include "quarter/travel.h"

typedef struct {
  file_bytes bytes;
  qtr_policy policy; /* views into `bytes` */
} table;

/* One seeker's part of the nominal game. */
typedef struct {
  int places;
  uint16_t place[QTR_MAX_PLACES];
  qtr_steps step[QTR_MAX_PLACES];
} table_route;

/* Read and open a table, and hold it against its own map (table_check.h). 0, or -1 with *why set and nothing to free. */
int table_read(table *t, const char *path, fault *why);

void table_free(table *t);

/* A place's likelihood, as exactly as the table holds it. */
double table_probability(const table *t, unsigned place);

/* The nominal routes of all seekers, `routes` one for each. Returns how many choices were made off the table. */
uint32_t table_routes(const table *t, table_route *routes);

/* A row of the map as text, '#' blocked, '.' free, 2 to 9 the steps that slow ground takes (9 or more), into `text`, which
 * holds a character more than columns. Returns it. */
const char *table_map_row(char *text, const qtr_grid *grid, unsigned row);

/* Whether the bytes are those of a table rather than of an input. */
bool table_is_one(const char *path);

#endif

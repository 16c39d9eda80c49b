/* A policy table from a file, and what it says. */
#ifndef QUARTER_HOST_TABLE_H
#define QUARTER_HOST_TABLE_H

#include <stdbool.h>

#include "host/base/fault.h"
#include "host/base/file.h"
#include "host/base/naming.h"
#include "quarter/claim.h"
#include "quarter/names.h"
#include "quarter/policy.h"

typedef struct {
  file_bytes bytes;
  qtr_policy policy;               /* views into `bytes` */
  qtr_claim claim;                 /* as well */
  qtr_names names;                 /* of the mission, its places and robots */
  qtr_geo geo;                     /* where its map lies on the globe, if the mission said */
  uint16_t number[QTR_MAX_PLACES]; /* of each place, in the input */
} table;

/* One seeker's part of the nominal game. */
typedef struct {
  int places;
  uint16_t place[QTR_MAX_PLACES];
  qtr_steps step[QTR_MAX_PLACES];
} table_route;

/* Read and open a table, and hold it against its own map (table_check.h). 0, or -1 with *why set and nothing to
 * free. */
int table_read(table *t, const char *path, fault *why);

/* Open `t->bytes`, which the caller has filled, without a look at the map: for who has just made them. QTR_OK, or an
 * error of qtr_policy_open(), qtr_policy_check() or qtr_names_read(). */
int table_open_bytes(table *t);

void table_free(table *t);

/* Put behind a robot's table, which is all of the bytes, what people want to know. 0, or -1 with *why set. */
int table_add_names(file_bytes *bytes, const qtr_names *names, const qtr_geo *geo, fault *why);

/* What places and seekers are called. */
naming table_naming(const table *t);

/* What a place and a robot are called where nothing around says what they are: "Bay 3", or "place 5"; and a later look
 * at a place, "Bay 3 (look 2)". */
typedef struct {
  char text[QTR_SITE_NAME_BYTES + 16];
} table_name;

table_name table_place_name(const table *t, unsigned place);
table_name table_look_name(const table *t, unsigned place);
table_name table_robot_name(const table *t, int robot);

/* Column and row of one of the table's cells on the map that it was learnt on, of which it holds a part; and the cell
 * of those, QTR_NO_CELL outside that part. */
unsigned table_column(const table *t, qtr_cell cell);
unsigned table_row(const table *t, qtr_cell cell);
qtr_cell table_cell(const table *t, int column, int row);

/* Seconds that a step takes; 0: the table does not say. */
double table_step_seconds(const table *t);

/* Whether a visit at a step comes after the mission's deadline, where it has one, and counts for nothing. */
bool table_is_late(const table *t, qtr_steps step);

/* A place's likelihood, as exactly as the table holds it. */
double table_probability(const table *t, unsigned place);

/* The nominal routes of all seekers, `routes` one for each. Returns how many choices were made off the table. */
uint32_t table_routes(const table *t, table_route *routes);

/* A row of the table's grid as text, '#' blocked, '.' free, 2 to 9 the steps that slow ground takes (9 or more), into
 * `text`, which holds a character more than columns. Returns it. */
const char *table_grid_row(char *text, const qtr_grid *grid, unsigned row);

/* The same of the map that it was learnt on, '#' also where the table holds nothing. */
const char *table_map_row(char *text, const table *t, unsigned row);

/* The outer corner of that map's bottom-left cell, in metres of the map frame. */
void table_map_origin(const table *t, double *x, double *y);

/* Whether the bytes are those of a table rather than of an input. */
bool table_is_one(const char *path);

#endif

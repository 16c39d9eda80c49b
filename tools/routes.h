/* The robots' routes of a report: taken of a game, told in the mission's places, in looks, seconds and metres. */
#ifndef QUARTER_TOOLS_ROUTES_H
#define QUARTER_TOOLS_ROUTES_H

#include <stdbool.h>
#include <stdint.h>

#include "host/plan/problem.h"
#include "host/table/table.h"
#include "quarter/play.h"

/* What is told of routes beside places and steps. */
typedef struct {
  bool seconds; /* people are told of seconds, too */
  double seconds_per_step;
  qtr_steps deadline;                            /* visits after it count for nothing; 0: there is none */
  bool looks;                                    /* places may be on them several times, */
  uint8_t look[QTR_MAX_SEEKERS][QTR_MAX_PLACES]; /* and this is the how many-th look, from 1 */
  bool metric;
  double metres[QTR_MAX_SEEKERS][QTR_MAX_PLACES]; /* from the start to each place, where the map has metres */
} route_units;

/* The game's places made the mission's, of which they are looks. */
void routes_to_mission(table_route *routes, const qtr_game *game);

/* All that is told of routes whose places are the mission's. The problem's travel times are scratch. */
void routes_measure(route_units *units, const table_route *routes, problem *p);

/* The same of a table's routes. 0, or -1 with *why set. */
int routes_measure_table(route_units *units, const table_route *routes, const table *t, fault *why);

/* Whether a visit counts for nothing. */
bool routes_is_late(const route_units *units, qtr_steps step);

/* The mission's places that nobody searches, by its deadline where it has one. Their number. */
int routes_left_out(uint16_t *places, const table_route *routes, const qtr_mission *mission);

/* Steps until the find, where it comes by the deadline: the mean over the looks that count. */
double routes_time_by_deadline(const route_units *units, const table_route *routes, const qtr_mission *mission);

#endif

#include "routes.h"

#include <math.h>

#include "host/table/way.h"
#include "quarter/travel.h"

void routes_to_mission(table_route *routes, const qtr_game *game) {
  for (int seeker = 0; seeker < game->board.seekers; seeker++)
    for (int i = 0; i < routes[seeker].places; i++)
      routes[seeker].place[i] = (uint16_t)qtr_game_place(game, routes[seeker].place[i]);
}

/* ---- looks ---- */

/* Looks that are made before one, those of one moment in the order of the seekers. */
static unsigned count_looks(const table_route *routes, int seekers, int seeker, int at) {
  const uint16_t place = routes[seeker].place[at];
  const qtr_steps when = routes[seeker].step[at];
  unsigned before = 0;
  for (int other = 0; other < seekers; other++)
    for (int i = 0; i < routes[other].places; i++)
      if (routes[other].place[i] == place)
        before += routes[other].step[i] < when ||
                  (routes[other].step[i] == when && (other < seeker || (other == seeker && i < at)));
  return before;
}

/* ---- metres ---- */

static qtr_grid ground_of(const qtr_mission *mission, int seeker) {
  qtr_grid grid = qtr_mission_grid(mission);
  if (mission->robot_class[mission->class_of[seeker]].smooth_only) grid.encoding = QTR_GRID_SMOOTH;
  return grid;
}

static double cells_between(problem *p, int seeker, qtr_cell from, qtr_cell to) {
  const qtr_grid grid = ground_of(&p->in.mission, seeker);
  double cells = 0.0;
  if (from == to || qtr_travel_fill(p->travel, &grid, to) != QTR_OK) return 0.0;
  for (qtr_cell at = from; at != to && at != QTR_NO_CELL; at = qtr_travel_next(p->travel, &grid, at)) cells++;
  return cells;
}

static void measure_metres(route_units *units, const table_route *route, problem *p, int seeker) {
  const qtr_mission *mission = &p->in.mission;
  qtr_cell at = mission->start[seeker];
  double cells = 0.0;
  for (int i = 0; i < route->places; i++) {
    const qtr_cell to = mission->place[route->place[i]];
    cells += cells_between(p, seeker, at, to);
    units->metres[seeker][i] = cells * p->in.frame.cell_size;
    at = to;
  }
}

void routes_measure(route_units *units, const table_route *routes, problem *p) {
  const qtr_mission *mission = &p->in.mission;
  units->seconds = p->pace.stated;
  units->deadline = mission->aim.kind == QTR_DEADLINE ? mission->aim.deadline : 0;
  units->seconds_per_step = p->pace.seconds_per_step;
  units->metric = p->in.frame.metric;
  units->looks = false;
  for (int place = 0; place < mission->places; place++) units->looks = units->looks || mission->looks[place] > 1;
  for (int seeker = 0; seeker < mission->seekers; seeker++) {
    for (int i = 0; i < routes[seeker].places; i++)
      units->look[seeker][i] = (uint8_t)(count_looks(routes, mission->seekers, seeker, i) + 1u);
    if (units->metric) measure_metres(units, &routes[seeker], p, seeker);
  }
}

/* A way from one place to the next is a shortest one: it enters the next one's cell once, at its end. */
static int measure_way(route_units *units, const table_route *route, const table *t, int seeker, fault *why) {
  const double side = qtr_policy_frame(&t->policy).cell_size_um / 1e6;
  way walked;
  size_t at = 0, cells = 0;
  if (way_walk(&walked, t, seeker, route, why) != 0) return -1;
  for (int i = 0; i < route->places; i++) {
    const qtr_cell goal = qtr_policy_cell(&t->policy, route->place[i]);
    for (; walked.at[at].cell != goal; at++) cells += walked.at[at + 1].cell != walked.at[at].cell;
    units->metres[seeker][i] = (double)cells * side;
  }
  way_free(&walked);
  return 0;
}

static void measure_looks(route_units *units, const table_route *routes, const table *t) {
  static table_route own[QTR_MAX_SEEKERS]; /* with the place in place of a look at it */
  const int seekers = t->policy.board.seekers;
  units->looks = false;
  for (int seeker = 0; seeker < seekers; seeker++) {
    own[seeker] = routes[seeker];
    for (int i = 0; i < own[seeker].places; i++)
      own[seeker].place[i] = (uint16_t)qtr_policy_place(&t->policy, routes[seeker].place[i]);
  }
  for (unsigned place = 0; place < t->policy.board.places; place++)
    units->looks = units->looks || qtr_policy_place(&t->policy, place) != place;
  for (int seeker = 0; seeker < seekers; seeker++)
    for (int i = 0; i < own[seeker].places; i++)
      units->look[seeker][i] = (uint8_t)(count_looks(own, seekers, seeker, i) + 1u);
}

int routes_measure_table(route_units *units, const table_route *routes, const table *t, fault *why) {
  units->seconds_per_step = table_step_seconds(t);
  units->seconds = units->seconds_per_step > 0.0;
  units->deadline = t->claim.deadline;
  units->metric = qtr_policy_frame(&t->policy).cell_size_um > 0;
  measure_looks(units, routes, t);
  for (int seeker = 0; seeker < t->policy.board.seekers; seeker++)
    if (units->metric && measure_way(units, &routes[seeker], t, seeker, why) != 0) return -1;
  return 0;
}

bool routes_is_late(const route_units *units, qtr_steps step) {
  return units->deadline > 0 && step > units->deadline;
}

int routes_left_out(uint16_t *places, const table_route *routes, const qtr_mission *mission) {
  const route_units units = {.deadline = mission->aim.deadline};
  bool searched[QTR_MAX_PLACES] = {false};
  int count = 0;
  for (int seeker = 0; seeker < mission->seekers; seeker++)
    for (int i = 0; i < routes[seeker].places; i++)
      if (!routes_is_late(&units, routes[seeker].step[i])) searched[routes[seeker].place[i]] = true;
  for (int place = 0; place < mission->places; place++)
    if (!searched[place]) places[count++] = (uint16_t)place;
  return count;
}

/* What a look finds: P q (1-q)^(m-1), in the weights' unit. */
static double find_by_look(const qtr_mission *mission, unsigned place, unsigned look) {
  const double miss = 1.0 - mission->detection[place];
  return mission->weight[place] * mission->detection[place] * pow(miss, look - 1.0);
}

double routes_time_by_deadline(const route_units *units, const table_route *routes, const qtr_mission *mission) {
  double found = 0.0, sum = 0.0;
  for (int seeker = 0; seeker < mission->seekers; seeker++)
    for (int i = 0; i < routes[seeker].places; i++) {
      if (routes_is_late(units, routes[seeker].step[i])) continue;
      const double finds = find_by_look(mission, routes[seeker].place[i], units->look[seeker][i]);
      found += finds;
      sum += finds * routes[seeker].step[i];
    }
  return found > 0.0 ? sum / found : 0.0;
}

#include "quarter/environment.h"

#include <stddef.h>
#include <string.h>

#include "core/bytes.h"
#include "quarter/status.h"

static unsigned places_of(const qtr_environment *e) {
  return e->game->board.places;
}

static unsigned nodes_of(const qtr_environment *e) {
  return (unsigned)e->game->board.places + e->game->board.starts;
}

static qtr_steps tour_length(const qtr_tour *tour) {
  return tour->step[tour->places - 1];
}

static uint16_t tour_exit(const qtr_tour *tour) {
  return tour->place[tour->places - 1];
}

/* The first place of a target's tour from a node; QTR_STAND_DOWN if there is no way, node or target. */
static uint16_t first_place(const qtr_environment *e, unsigned node, unsigned target) {
  if (node >= nodes_of(e) || target >= e->targets) return QTR_STAND_DOWN;
  return e->first[(size_t)node * e->targets + target];
}

/* ---- targets and tours ---- */

static void make_single_spots(qtr_environment *e) {
  e->spots.count = e->game->board.places;
  for (uint16_t place = 0; place < e->spots.count; place++) {
    e->spots.spot_of[place] = place;
    e->spots.size[place] = 1;
    e->spots.place[place][0] = place;
  }
}

static qtr_spot_ground ground_of(const qtr_game *game) {
  const qtr_spot_ground ground = {game->board.places, game->steps, game->probability, &game->objective};
  return ground;
}

/* The tour of a target from a node; what follows its first place is kept by that place. */
static bool plan_tour(qtr_environment *e, unsigned node, uint16_t target, uint8_t order) {
  const qtr_spot_ground ground = ground_of(e->game);
  const uint16_t *place = e->spots.place[target];
  const unsigned count = e->spots.size[target];
  qtr_spot_tour planned;
  const bool found = order == QTR_SPOT_NEAREST ? qtr_spot_tour_nearest(&planned, &ground, node, place, count)
                                               : qtr_spot_tour_best(&planned, &ground, node, place, count,
                                                                    QTR_SPOT_ANY_EXIT, 0.0, &e->tour_scratch);
  if (!found) return false;
  qtr_tour *tour = &e->tour[planned.place[0]];
  tour->target = target;
  tour->places = planned.places;
  for (unsigned i = 0; i < planned.places; i++) {
    tour->place[i] = planned.place[i];
    tour->step[i] = planned.step[i] - planned.step[0];
  }
  e->first[(size_t)node * e->targets + target] = planned.place[0];
  return true;
}

/* False: stopped. Places alone take no time. */
static bool plan_tours(qtr_environment *e, uint8_t order) {
  for (unsigned place = 0; place < places_of(e); place++) e->tour[place].places = 0;
  for (unsigned node = 0; node < nodes_of(e); node++) {
    if (e->targets < places_of(e) && !qtr_watch_go_on(&e->game->mission->watch)) return false;
    for (uint16_t target = 0; target < e->targets; target++) {
      e->first[(size_t)node * e->targets + target] = QTR_STAND_DOWN;
      if (node < places_of(e) && e->spots.spot_of[node] == target) continue;
      plan_tour(e, node, target, order);
    }
  }
  return true;
}

static qtr_steps duration(const qtr_environment *e, unsigned node, unsigned target) {
  const uint16_t first = first_place(e, node, target);
  if (first == QTR_STAND_DOWN) return QTR_NEVER;
  return qtr_board_steps(&e->game->board, QTR_ANY_SEEKER, node, first) + tour_length(&e->tour[first]);
}

/* From anywhere in one target to the end of another: the longest, so that keys have room for it. */
static qtr_steps longest_between(const qtr_environment *e, unsigned from, unsigned to) {
  qtr_steps longest = QTR_NEVER;
  for (unsigned i = 0; i < e->spots.size[from]; i++) {
    const qtr_steps steps = duration(e, e->spots.place[from][i], to);
    if (steps != QTR_NEVER && (longest == QTR_NEVER || steps > longest)) longest = steps;
  }
  return longest;
}

static int make_board(qtr_environment *e, uint8_t rule) {
  e->board = e->game->board;
  e->board.places = e->targets;
  e->board.rule = rule;
  e->board.steps = e->reach;
  for (unsigned to = 0; to < e->targets; to++) {
    for (unsigned from = 0; from < e->targets; from++)
      store32_le(e->reach + 4 * ((size_t)from * e->targets + to), from == to ? 0 : longest_between(e, from, to));
    for (unsigned start = 0; start < e->board.starts; start++)
      store32_le(e->reach + 4 * ((size_t)(e->targets + start) * e->targets + to),
                 duration(e, places_of(e) + start, to));
  }
  return qtr_board_init(&e->board);
}

/* ---- regions ---- */

static qtr_region region_at(const qtr_environment *e, qtr_cell cell) {
  return e->regions->of[cell];
}

static void note_way(qtr_environment *e, const qtr_grid *grid, const qtr_field *field, unsigned place) {
  const uint32_t cells = (uint32_t)grid->columns * grid->rows;
  uint8_t *way = e->way + (size_t)place * ((QTR_MAX_CELLS + 3) / 4);
  memset(way, 0, (cells + 3) / 4);
  for (uint32_t cell = 0; cell < cells; cell++) {
    const qtr_cell next = qtr_field_next(field, grid, (qtr_cell)cell);
    if (qtr_grid_cost(grid, (qtr_cell)cell) == 0 || next == QTR_NO_CELL) continue;
    for (unsigned direction = QTR_NORTH; direction <= QTR_WEST; direction++)
      if (qtr_grid_neighbour(grid, (qtr_cell)cell, (enum qtr_direction)direction) == next)
        way[cell / 4] = (uint8_t)(way[cell / 4] | direction << 2 * (cell % 4));
  }
}

/* False: stopped. */
static bool measure_regions(qtr_environment *e, qtr_field *field) {
  const qtr_grid grid = qtr_mission_grid(e->game->mission);
  const unsigned places = places_of(e);
  for (unsigned place = 0; place < places; place++) {
    if (!qtr_watch_go_on(&e->game->mission->watch)) return false;
    qtr_field_fill(field, &grid, e->game->mission->place[place]);
    note_way(e, &grid, field, place);
    for (uint32_t region = 0; region < e->regions->count; region++)
      e->estimate[(size_t)region * places + place] = field->to_go[e->regions->representative[region]];
  }
  return true;
}

/* Steps to the end of a tour as seen from the region, of whose places `stage` are passed: 1 at the least. */
static qtr_steps estimate_left(const qtr_environment *e, qtr_cell cell, const qtr_tour *tour, unsigned stage) {
  const size_t row = (size_t)region_at(e, cell) * places_of(e);
  const qtr_steps left = e->estimate[row + tour->place[stage]] + tour_length(tour) - tour->step[stage];
  return left > 0 ? left : 1;
}

static qtr_cell next_cell(const qtr_environment *e, const qtr_grid *grid, qtr_cell cell, unsigned place) {
  const uint8_t *way = e->way + (size_t)place * ((QTR_MAX_CELLS + 3) / 4);
  return qtr_grid_neighbour(grid, cell, (enum qtr_direction)((unsigned)way[cell / 4] >> 2 * (cell % 4) & 3u));
}

/* Move a seeker on along its true way for some steps. */
static void walk_on(const qtr_environment *e, qtr_situation *s, unsigned seeker, qtr_steps steps) {
  const qtr_mission *mission = e->game->mission;
  const qtr_grid grid = qtr_mission_grid(mission);
  const qtr_tour *tour = &e->tour[s->at[seeker]];
  qtr_steps left = steps + s->carried[seeker];
  for (;;) {
    const uint16_t goal = tour->place[s->stage[seeker]];
    if (s->cell[seeker] == mission->place[goal]) {
      if (s->stage[seeker] + 1u == tour->places) left = 0;
      if (left == 0) break;
      s->stage[seeker]++;
      continue;
    }
    const qtr_cell next = next_cell(e, &grid, s->cell[seeker], goal);
    if (left < mission->cost[next]) break;
    left -= mission->cost[next];
    s->cell[seeker] = next;
  }
  s->carried[seeker] = left;
}

/* ---- keys ---- */

/* Node digits are the places, the starts, and one for standing down, whatever the targets are. With regions, `remaining`
 * is the region and how much of the tour is done. */
static void shape_keys(qtr_environment *e) {
  e->keys = e->board.keys;
  e->keys.nodes = (uint16_t)nodes_of(e);
  if (e->regions != NULL) e->keys.longest = e->regions->count * QTR_MAX_SPOT_SIZE - 1;
  qtr_key_measure(&e->keys);
}

static qtr_steps region_digit(const qtr_environment *e, const qtr_situation *s, unsigned seeker) {
  const bool idle = s->joint.remaining[seeker] == 0;
  return (qtr_steps)region_at(e, s->cell[seeker]) * QTR_MAX_SPOT_SIZE + (idle ? 0u : s->stage[seeker]);
}

void qtr_environment_key(const qtr_environment *e, const qtr_situation *s, qtr_key *key) {
  qtr_joint seen = s->joint;
  for (unsigned i = 0; i < e->board.seekers; i++) {
    if (seen.node[i] == QTR_STAND_DOWN) continue;
    seen.node[i] = s->at[i];
    if (e->regions == NULL) continue;
    if (seen.remaining[i] == 0) seen.node[i] = (uint16_t)places_of(e);
    seen.remaining[i] = region_digit(e, s, i);
  }
  qtr_key_make(key, &e->keys, &seen.visited, seen.node, seen.remaining);
}

/* ---- set-up ---- */

static int make_targets(qtr_environment *e, const qtr_aggregation *how) {
  if (how != NULL && how->by_spots) {
    const qtr_spot_ground ground = ground_of(e->game);
    const int status = qtr_spots_build(&e->spots, &ground, &how->spots, &e->spots_scratch);
    if (status != QTR_OK) return status;
  } else {
    make_single_spots(e);
  }
  e->targets = e->spots.count;
  return plan_tours(e, how != NULL ? how->spot_order : QTR_SPOT_BEST) ? QTR_OK : QTR_ERR_STOPPED;
}

int qtr_environment_init_built(qtr_environment *e, const qtr_game *game, const qtr_aggregation *how, qtr_field *field,
                               uint32_t config_id) {
  if (config_id != QTR_CONFIG_ID) return QTR_ERR_CONFIG;
  e->game = game;
  e->regions = how != NULL ? how->regions : NULL;
  e->estimating = e->regions != NULL && how->region_times == QTR_TIMES_STANDING;
  int status = make_targets(e, how);
  if (status == QTR_OK) status = make_board(e, how != NULL ? how->rule : game->board.rule);
  if (status != QTR_OK) return status;
  if (e->regions != NULL && !measure_regions(e, field)) return QTR_ERR_STOPPED;
  shape_keys(e);
  return QTR_OK;
}

void qtr_environment_start(const qtr_environment *e, qtr_situation *s) {
  qtr_joint_start(&s->joint, &e->board, NULL, NULL);
  s->now = 0;
  s->unvisited = 1.0;
  for (unsigned i = 0; i < e->board.seekers; i++) {
    s->at[i] = (uint16_t)(places_of(e) + e->board.start_of[i]);
    s->stage[i] = 0;
    s->cell[i] = e->game->mission->start[i];
    s->carried[i] = 0;
  }
}

/* ---- play ---- */

unsigned qtr_environment_exit(const qtr_environment *e, const qtr_situation *s, unsigned seeker) {
  if (seeker >= e->board.seekers) return QTR_STAND_DOWN;
  return s->joint.remaining[seeker] == 0 ? s->at[seeker] : tour_exit(&e->tour[s->at[seeker]]);
}

qtr_steps qtr_environment_visit(const qtr_environment *e, const qtr_situation *s, unsigned seeker, unsigned i) {
  if (seeker >= e->board.seekers || s->at[seeker] >= places_of(e)) return 0;
  const qtr_tour *tour = &e->tour[s->at[seeker]];
  if (i >= tour->places) return 0;
  const qtr_steps after_it = tour_length(tour) - tour->step[i];
  return s->joint.remaining[seeker] > after_it ? s->joint.remaining[seeker] - after_it : 0;
}

double qtr_environment_choose(const qtr_environment *e, qtr_situation *s, int seeker, uint16_t choice) {
  if (seeker < 0 || seeker >= e->board.seekers) return 0.0;
  if (choice == QTR_STAND_DOWN) {
    qtr_joint_choose(&s->joint, &e->board, seeker, choice);
    return 0.0;
  }
  const uint16_t first = first_place(e, s->at[seeker], choice);
  if (first == QTR_STAND_DOWN) return 0.0;
  const qtr_steps exact = duration(e, s->at[seeker], choice);
  const bool here = qtr_board_steps(&e->game->board, (unsigned)seeker, s->at[seeker], first) == 0;
  const bool done = qtr_joint_choose(&s->joint, &e->board, seeker, choice);
  s->at[seeker] = first;
  s->stage[seeker] = 0;
  if (!done) s->joint.remaining[seeker] = e->estimating ? estimate_left(e, s->cell[seeker], &e->tour[first], 0) : exact;
  /* With regions a spot counts when it is done. */
  if (!here || (e->regions != NULL && !done)) return 0.0;
  s->unvisited -= e->game->probability[first];
  return qtr_game_worth(e->game, first, 0);
}

/* A visit `offset` steps into a stretch of `passed` steps, under way since before it. */
static void collect(const qtr_environment *e, qtr_situation *s, qtr_outcome *outcome, double probability,
                    qtr_steps offset, qtr_steps passed) {
  s->unvisited -= probability;
  qtr_objective_collect(&e->game->objective, outcome, probability, offset, passed);
}

/* Exact times: each place counts when it is visited. `before` is what remained to the seeker. */
static void collect_tour(const qtr_environment *e, qtr_situation *s, qtr_outcome *outcome, unsigned seeker,
                         qtr_steps before, qtr_steps passed) {
  const qtr_tour *tour = &e->tour[s->at[seeker]];
  for (unsigned i = 0; i < tour->places; i++) {
    const qtr_steps after_it = tour_length(tour) - tour->step[i];
    if (before <= after_it || before - after_it > passed) continue;
    collect(e, s, outcome, e->game->probability[tour->place[i]], before - after_it, passed);
  }
}

static double target_probability(const qtr_environment *e, unsigned target) {
  double probability = 0.0;
  for (unsigned i = 0; i < e->spots.size[target]; i++) probability += e->game->probability[e->spots.place[target][i]];
  return probability;
}

double qtr_environment_rate(const qtr_environment *e, unsigned node, unsigned target) {
  const qtr_steps steps = duration(e, node, target);
  if (steps == QTR_NEVER) return 0.0;
  return target_probability(e, target) / (steps > 0 ? (double)steps : 0.5);
}

static void settle_seeker(const qtr_environment *e, qtr_situation *s, unsigned seeker, qtr_steps passed) {
  if (s->joint.remaining[seeker] == 0) {
    s->at[seeker] = tour_exit(&e->tour[s->at[seeker]]);
    s->cell[seeker] = e->game->mission->place[s->at[seeker]];
    s->carried[seeker] = 0;
  } else if (e->regions != NULL) {
    walk_on(e, s, seeker, passed);
    if (e->estimating)
      s->joint.remaining[seeker] = estimate_left(e, s->cell[seeker], &e->tour[s->at[seeker]], s->stage[seeker]);
  }
}

/* Whether a seeker's tour still counts: under the paper's rule another may have visited its target before it. */
static bool still_counts(const qtr_situation *s, const qtr_environment *e, unsigned seeker,
                         const qtr_places *visited_before) {
  return !qtr_places_has(visited_before, e->tour[s->at[seeker]].target);
}

static void collect_all(const qtr_environment *e, qtr_situation *s, qtr_outcome *outcome, const qtr_joint *before,
                        const qtr_places *arrived, qtr_steps passed) {
  qtr_places counted = before->visited;
  if (e->regions != NULL) {
    for (unsigned target = 0; target < e->targets; target++)
      if (qtr_places_has(arrived, target)) collect(e, s, outcome, target_probability(e, target), passed, passed);
    return;
  }
  for (unsigned i = 0; i < e->board.seekers; i++) {
    if (before->remaining[i] == 0 || !still_counts(s, e, i, &counted)) continue;
    collect_tour(e, s, outcome, i, before->remaining[i], passed);
    if (before->remaining[i] == passed) qtr_places_add(&counted, e->tour[s->at[i]].target);
  }
}

static bool pass_once(const qtr_environment *e, qtr_situation *s, qtr_outcome *outcome) {
  const qtr_joint before = s->joint;
  qtr_places arrived;
  qtr_places_clear(&arrived);
  const qtr_steps passed = qtr_joint_advance(&s->joint, &e->board, &arrived);
  if (passed == 0) return false;
  qtr_objective_wait(&e->game->objective, outcome, s->unvisited, passed);
  collect_all(e, s, outcome, &before, &arrived, passed);
  for (unsigned i = 0; i < e->board.seekers; i++)
    if (before.remaining[i] > 0) settle_seeker(e, s, i, passed);
  qtr_objective_pass(&e->game->objective, outcome, passed);
  s->now += passed;
  return true;
}

void qtr_environment_pass(const qtr_environment *e, qtr_situation *s, qtr_outcome *outcome) {
  outcome->reward = 0.0;
  outcome->discount = 1.0;
  while (qtr_joint_chooser(&s->joint, &e->board) == QTR_NOBODY)
    if (!pass_once(e, s, outcome)) return;
}

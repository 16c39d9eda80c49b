#include "field/families.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "field/ground.h"
#include "host/base/memory.h"
#include "quarter/random.h"
#include "quarter/status.h"

#define TRIES 100 /* of a seed, until there is room for all places */

const char *const family_names[FAMILIES + 1] = {"scatter", "rooms", "corridors", "floor", NULL};

/* ---- places and robots ---- */

static bool is_taken(const qtr_mission *mission, qtr_cell cell) {
  for (unsigned i = 0; i < mission->seekers; i++)
    if (mission->start[i] == cell) return true;
  for (unsigned place = 0; place < mission->places; place++)
    if (mission->place[place] == cell) return true;
  return false;
}

/* A cell that can be reached; QTR_NO_CELL if none was met. */
static qtr_cell draw_cell(const qtr_mission *mission, const qtr_travel *reach, uint64_t *state) {
  for (unsigned i = 0; i < 64u * QTR_MAX_PLACES; i++) {
    const qtr_cell cell = (qtr_cell)qtr_lcg_below(state, qtr_mission_cells(mission));
    if (reach->to_go[cell] != QTR_NEVER && !is_taken(mission, cell)) return cell;
  }
  return QTR_NO_CELL;
}

/* The cell from which the others must be reached. */
static qtr_cell first_cell(const qtr_mission *mission, int family, uint64_t *state) {
  qtr_cell cell = 0;
  while (mission->cost[cell] == 0 || (family != FAMILY_SCATTER && qtr_lcg_below(state, 50) > 0))
    cell = (qtr_cell)((cell + 1) % qtr_mission_cells(mission));
  return cell;
}

static bool put_robots(qtr_mission *mission, const family_wish *wish, const qtr_travel *reach, qtr_cell first,
                       uint64_t *state) {
  for (unsigned i = 0; i < wish->robots; i++) {
    const qtr_cell cell = i == 0 || wish->family != FAMILY_CORRIDORS ? first : draw_cell(mission, reach, state);
    if (cell == QTR_NO_CELL) return false;
    mission->start[i] = cell;
    mission->class_of[i] = (uint8_t)(i % wish->classes);
    mission->seekers = (uint8_t)(i + 1);
  }
  return true;
}

static bool put_places(qtr_mission *mission, const family_wish *wish, const qtr_travel *reach, uint64_t *state) {
  while (mission->places < wish->places) {
    const qtr_cell cell = draw_cell(mission, reach, state);
    if (cell == QTR_NO_CELL) return false;
    mission->place[mission->places] = cell;
    mission->looks[mission->places] = (uint8_t)wish->looks;
    mission->detection[mission->places] = wish->looks > 1 ? 0.8 : 1.0;
    mission->weight[mission->places++] = qtr_lcg_below(state, 3) == 0 ? 3.0 : 1.0;
  }
  return true;
}

static void set_classes(qtr_mission *mission, const family_wish *wish) {
  mission->classes = (uint8_t)wish->classes;
  for (unsigned c = 0; c < wish->classes; c++) {
    qtr_robot_class_default(&mission->robot_class[c]);
    mission->robot_class[c].cell_steps = wish->stretch * (c + 1);
    for (unsigned place = 0; place < wish->places && wish->looks > 1; place++)
      mission->robot_class[c].scan[place] = 2 * wish->stretch;
  }
}

/* False: the ground that this seed makes has no room for all. */
static bool people(study *s, const family_wish *wish, uint64_t *state) {
  qtr_mission *mission = &s->p.in.mission;
  const qtr_grid grid = qtr_mission_grid(mission);
  const qtr_cell first = first_cell(mission, wish->family, state);
  qtr_travel_fill(s->p.travel, &grid, first);
  return put_robots(mission, wish, s->p.travel, first, state) && put_places(mission, wish, s->p.travel, state);
}

/* ---- problems ---- */

static int check(const family_wish *wish, fault *why) {
  if ((uint64_t)wish->places * wish->looks > QTR_MAX_PLACES)
    return fault_set(why, "%u looks are more than this build holds, %d", wish->places * wish->looks, QTR_MAX_PLACES);
  if (wish->robots > QTR_MAX_SEEKERS || wish->classes > QTR_MAX_CLASSES)
    return fault_set(why, "%u robots are more than this build holds, %d", wish->robots, QTR_MAX_SEEKERS);
  return 0;
}

static void begin(qtr_mission *mission, const family_wish *wish) {
  qtr_mission_default(mission);
  mission->aim.kind = (uint8_t)wish->objective;
  mission->aim.gamma = wish->gamma;
  set_classes(mission, wish);
}

static int draw(study *s, const family_wish *wish, fault *why) {
  uint64_t state = (wish->seed + 1) * 0x9E3779B97F4A7C15u;
  for (unsigned i = 0; i < TRIES; i++) {
    begin(&s->p.in.mission, wish);
    if (ground_draw(&s->p.in.mission, wish->family, wish->side, &state, why) != 0) return -1;
    if (problem_need_game(&s->p, why) != 0) return -1;
    if (people(s, wish, &state)) return 0;
  }
  return fault_set(why, "no room for %u places on ground of that size", wish->places);
}

int problem_of_family(problem_case *made, const family_wish *wish, fault *why) {
  *made = (problem_case){0};
  snprintf(made->name, sizeof made->name, "%s %u", family_names[wish->family], wish->seed);
  if (check(wish, why) != 0) return -1;
  made->s = study_take(why);
  if (made->s == NULL || draw(made->s, wish, why) != 0) return -1;
  snprintf(made->s->p.in.path, sizeof made->s->p.in.path, "%s", made->name);
  if (problem_need_game(&made->s->p, why) != 0) return -1;
  const int status = qtr_game_init(made->s->p.game, &made->s->p.in.mission, made->s->p.travel, NULL);
  if (status != QTR_OK) return fault_set(why, "%s: %s", made->name, qtr_strerror(status));
  return problem_tell(made, why);
}

#include "field/problem.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "host/base/file.h"
#include "host/base/memory.h"

/* ---- plain numbers ---- */

static int take_all(plain_problem *p, bool comes_home, fault *why) {
  const size_t nodes = (size_t)p->looks + p->starts;
  p->place_of = memory_take(p->looks * sizeof *p->place_of, why);
  p->weight = memory_take(p->places * sizeof *p->weight, why);
  p->detection = memory_take(p->places * sizeof *p->detection, why);
  p->class_of = memory_take(p->robots * sizeof *p->class_of, why);
  p->start_of = memory_take(p->robots * sizeof *p->start_of, why);
  p->steps = memory_take(p->classes * nodes * p->looks * sizeof *p->steps, why);
  p->home = comes_home ? memory_take((size_t)p->robots * p->looks * sizeof *p->home, why) : NULL;
  return p->place_of == NULL || p->weight == NULL || p->detection == NULL || p->class_of == NULL ||
                 p->start_of == NULL || p->steps == NULL || (comes_home && p->home == NULL)
             ? -1
             : 0;
}

static void tell_places(plain_problem *p, const qtr_game *game) {
  for (unsigned look = 0; look < p->looks; look++) p->place_of[look] = qtr_game_place(game, look);
  for (unsigned place = 0; place < p->places; place++) {
    p->weight[place] = game->mission->weight[place];
    p->detection[place] = game->mission->detection[place];
  }
}

static void tell_robots(plain_problem *p, const qtr_game *game) {
  for (unsigned i = 0; i < p->robots; i++) {
    p->class_of[i] = game->mission->class_of[i];
    p->start_of[i] = game->board.start_of[i];
    for (unsigned look = 0; p->home != NULL && look < p->looks; look++)
      p->home[(size_t)i * p->looks + look] = qtr_game_way_home(game, i, look);
  }
}

static void tell_steps(plain_problem *p, const qtr_game *game) {
  uint32_t *at = p->steps;
  for (unsigned of_class = 0; of_class < p->classes; of_class++)
    for (unsigned node = 0; node < p->looks + p->starts; node++)
      for (unsigned look = 0; look < p->looks; look++)
        *at++ = qtr_board_class_steps(&game->board, of_class, node, look);
}

int problem_tell(problem_case *made, fault *why) {
  const qtr_game *game = made->s->p.game;
  plain_problem *p = &made->plain;
  p->looks = game->board.places;
  p->places = game->mission->places;
  p->starts = game->board.starts;
  p->robots = game->board.seekers;
  p->classes = game->mission->classes;
  p->by_time = game->objective.kind == QTR_TIME;
  p->gamma = game->mission->aim.gamma;
  p->home_weight = game->mission->aim.home_weight;
  if (take_all(p, p->home_weight > 0.0, why) != 0) return -1;
  tell_places(p, game);
  tell_robots(p, game);
  tell_steps(p, game);
  return 0;
}

void problem_drop(problem_case *made) {
  plain_problem *p = &made->plain;
  study_drop(made->s);
  free(p->place_of);
  free(p->weight);
  free(p->detection);
  free(p->class_of);
  free(p->start_of);
  free(p->steps);
  free(p->home);
  *made = (problem_case){0};
}

/* ---- of the literature ---- */

static int check_size(const tsplib *instance, const char *path, const problem_wish *wish, fault *why) {
  if (instance->towns - 1 > QTR_MAX_PLACES)
    return file_fault(why, path, instance->line, 0, "%u towns are more than this build holds, 1 and %d places",
                      instance->towns, QTR_MAX_PLACES);
  if (wish->robots < 1 || wish->robots > QTR_MAX_SEEKERS)
    return fault_set(why, "%u robots are more than this build holds, %d, or none", wish->robots, QTR_MAX_SEEKERS);
  return 0;
}

static void fill_mission(qtr_mission *mission, const tsplib *instance, const problem_wish *wish) {
  qtr_mission_default(mission);
  mission->columns = mission->rows = 0;
  mission->places = (uint16_t)(instance->towns - 1);
  mission->seekers = (uint8_t)wish->robots;
  mission->aim.kind = (uint8_t)wish->objective;
  mission->aim.gamma = wish->gamma;
  mission->aim.home_weight = wish->comes_home ? 1.0 : 0.0;
  for (unsigned place = 0; place < mission->places; place++) mission->weight[place] = 1.0;
  for (unsigned i = 0; i < wish->robots; i++) mission->start[i] = 0;
}

/* Town 1 is the start, town p + 2 place p. */
static void fill_legs(qtr_steps *steps, qtr_steps *home, const tsplib *instance) {
  const unsigned towns = instance->towns;
  const unsigned places = towns - 1;
  for (unsigned from = 0; from < towns; from++) {
    qtr_steps *row = steps + (size_t)(from == 0 ? places : from - 1) * places;
    for (unsigned to = 1; to < towns; to++) row[to - 1] = instance->distance[(size_t)from * towns + to];
    if (from > 0) home[from - 1] = instance->distance[(size_t)from * towns];
  }
}

/* Two towns in one spot would be one place, and no route could tell them apart. */
static int check_apart(const tsplib *instance, const char *path, fault *why) {
  for (unsigned from = 1; from < instance->towns; from++)
    for (unsigned to = 1; to < instance->towns; to++)
      if (from != to && instance->distance[(size_t)from * instance->towns + to] == 0)
        return file_fault(why, path, instance->line, 0, "towns %u and %u are 0 apart: make them one", from + 1, to + 1);
  return 0;
}

static int make_game(problem_case *made, const tsplib *instance, const char *path, fault *why) {
  const size_t places = instance->towns - 1;
  qtr_steps *steps = memory_take((places + 1) * places * sizeof *steps, why);
  qtr_steps *home = steps != NULL ? memory_take(places * sizeof *home, why) : NULL;
  int status = home != NULL ? problem_need_game(&made->s->p, why) : -1;
  if (status == 0) {
    const qtr_legs legs = {1, steps, home};
    fill_legs(steps, home, instance);
    status = qtr_game_init_legs(made->s->p.game, &made->s->p.in.mission, &legs, NULL);
    if (status != QTR_OK) file_fault(why, path, instance->line, 0, "%s", qtr_strerror(status));
  }
  free(home);
  free(steps);
  return status == 0 ? 0 : -1;
}

int problem_of_instance(problem_case *made, const tsplib *instance, const char *path, const problem_wish *wish,
                        fault *why) {
  *made = (problem_case){0};
  snprintf(made->name, sizeof made->name, "%s", instance->name);
  if (check_size(instance, path, wish, why) != 0 || check_apart(instance, path, why) != 0) return -1;
  made->s = study_take(why);
  if (made->s == NULL) return -1;
  snprintf(made->s->p.in.path, sizeof made->s->p.in.path, "%s", path);
  fill_mission(&made->s->p.in.mission, instance, wish);
  if (make_game(made, instance, path, why) != 0) return -1;
  return problem_tell(made, why);
}

#include "host/plan/problem.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "host/base/stop.h"
#include "host/input/read.h"
#include "host/plan/terms.h"
#include "host/plan/unfit.h"
#include "quarter/status.h"

#define NAMES_SIZE 700

static void override(input *in, const plan_config *config) {
  qtr_mission *mission = &in->mission;
  if (config->aim.gamma > 0.0) mission->aim.gamma = config->aim.gamma;
  if (config->aim.kind != PLAN_AS_STATED) mission->aim.kind = config->aim.kind;
  if (config->rule != PLAN_AS_STATED) mission->rule = (uint8_t)config->rule;
  if (config->deadline_seconds > 0.0) {
    mission->aim.kind = QTR_DEADLINE;
    in->terms.deadline_seconds = config->deadline_seconds;
    in->terms.stated = true;
  }
  if (mission->aim.kind == QTR_TIME || mission->aim.home_weight == 0.0) return;
  notes_add(&in->note, "%s: home_weight counts under --objective time alone, and is left aside", in->path);
  mission->aim.home_weight = 0.0;
}

/* What a mission's terms leave no room for. */
static int check_terms(const input *in, const plan_config *config, fault *why) {
  const qtr_mission *mission = &in->mission;
  if (config->any_cleared && terms_depend_on_progress(mission))
    return fault_set(why,
                     "%s: --cleared any takes no classes, looks, ready times, endurance, deadline or home_weight yet; "
                     "leave them out",
                     in->path);
  if (config->any_starts && terms_end(mission))
    return fault_set(
        why,
        "%s: --starts any takes no endurance: which robot is home in time depends on where it starts, and starts share "
        "what is learnt; where the starts are known learn for them or leave "
        "endurance_seconds out",
        in->path);
  if (config->aggregate.way == AGGREGATE_NONE) return 0;
  if (aggregate_by_regions(config->aggregate.way) ? terms_any(mission) : terms_leave_no_spots(mission))
    return fault_set(why,
                     "%s: --aggregate: regions take none of the field's terms, and spots no classes, looks, ready "
                     "times, endurance or home_weight; leave it out",
                     in->path);
  return 0;
}

/* "place 3 (file:line), place 5 (file:line), ...", cut off when the room is used up. */
static void name_unreachable(const problem *p, char *names) {
  size_t length = 0;
  names[0] = '\0';
  for (int place = 0; place < p->in.mission.places; place++) {
    char name[300];
    if (qtr_game_reachable(p->game, (unsigned)place)) continue;
    input_place_name(&p->in, place, name, sizeof name);
    if (length + strlen(name) + 8 > NAMES_SIZE) {
      snprintf(names + length, NAMES_SIZE - length, ", ...");
      return;
    }
    length += (size_t)snprintf(names + length, NAMES_SIZE - length, "%s%s", length > 0 ? ", " : "", name);
  }
}

static void drop_unreachable(problem *p) {
  qtr_mission *mission = &p->in.mission;
  uint16_t kept = 0;
  for (uint16_t place = 0; place < mission->places; place++) {
    if (!qtr_game_reachable(p->game, place)) continue;
    input_keep_place(&p->in, kept++, place);
  }
  mission->places = kept;
}

/* A class that some places or ground are barred to. */
static bool has_choosy_class(const qtr_mission *mission) {
  for (int of = 0; of < mission->classes; of++) {
    if (mission->robot_class[of].smooth_only) return true;
    for (unsigned place = 0; place < mission->places; place++)
      if (qtr_places_has(&mission->robot_class[of].avoided, place)) return true;
  }
  return false;
}

/* A cell that any obstacle touches is blocked: what shuts doors, where it may be that. */
static void name_what_shuts(const problem *p, char *out, size_t size) {
  const input *in = &p->in;
  const bool coarse = in->resolution > 0.0 && in->frame.cell_size > 1.5 * in->resolution;
  out[0] = '\0';
  if (coarse)
    snprintf(out, size,
             "; cells of %.6g m may shut doors that a smaller cell_size leaves open (the map's pixels are %.6g m)",
             in->frame.cell_size, in->resolution);
  else if (in->ground.robot_radius > 0.0)
    snprintf(out, size, "; the robot_radius of %.6g m may shut doors", in->ground.robot_radius);
}

static int handle_unreachable(problem *p, const plan_config *config, fault *why) {
  char names[NAMES_SIZE], shuts[160];
  name_unreachable(p, names);
  name_what_shuts(p, shuts, sizeof shuts);
  if (!config->reading.skip)
    return fault_set(
        why, "%s: no seeker can reach %s; move or remove them%s, or leave them out with --skip-unreachable%s",
        p->in.path, names,
        has_choosy_class(&p->in.mission) ? ", let a class go there (its avoid, or its \"rough: false\")" : "", shuts);
  drop_unreachable(p);
  if (p->in.mission.places == 0)
    return fault_set(why, "%s: no seeker can reach any place; move the starts or the places", p->in.path);
  notes_add(&p->in.note, "%s: left out, for no seeker can reach them: %s", p->in.path, names);
  return 0;
}

/* The gamma that leaves a share of e^-10 after so many steps, rounded up to the digits that tell it from 1. */
static double mild_gamma(qtr_steps steps) {
  const double unit = pow(10.0, floor(log10(10.0 / (double)steps)));
  return steps > 20 ? 1.0 - floor(10.0 / (double)steps / unit) * unit : 0.6;
}

static int fault_discount(const problem *p, int place, fault *why) {
  const qtr_board *board = &p->game->board;
  qtr_steps nearest = QTR_NEVER;
  char name[300];
  for (unsigned i = 0; i < board->seekers; i++) {
    const qtr_steps steps = unfit_way(p->game, i, (unsigned)place);
    if (steps < nearest) nearest = steps;
  }
  input_place_name(&p->in, place, name, sizeof name);
  return fault_set(why,
                   "%s: gamma %g leaves nothing to tell plans apart by: even the nearest place, %s, is %" PRIu32
                   " steps away; take a gamma nearer 1, such as %g, or --objective time",
                   p->in.path, p->pace.gamma, name, nearest,
                   mild_gamma((qtr_steps)(nearest * p->pace.seconds_per_step)));
}

int problem_load(problem *p, const char *path, const plan_config *config, fault *why) {
  if (plan_config_check(config, why) != 0 || input_read(&p->in, path, &config->reading, why) != 0) return -1;
  override(&p->in, config);
  if (terms_apply(&p->in, &p->pace, why) != 0 || check_terms(&p->in, config, why) != 0) return -1;
  p->in.mission.watch = stop_watch();
  return 0;
}

int problem_need_game(problem *p, fault *why) {
  int status = memory_need(&p->game_block, qtr_game_bytes(&p->in.mission), why);
  if (status == 0) status = memory_need(&p->travel_block, qtr_travel_bytes(qtr_mission_cells(&p->in.mission)), why);
  p->game = p->game_block.at;
  p->travel = p->travel_block.at;
  return status;
}

void problem_give_back(problem *p) {
  memory_drop(&p->game_block);
  memory_drop(&p->travel_block);
  p->game = NULL;
  p->travel = NULL;
}

int problem_measure(problem *p, const plan_config *config, fault *why) {
  const double begin = stop_seconds();
  int culprit;
  int status = qtr_mission_check(&p->in.mission, &culprit);
  if (problem_need_game(p, why) != 0) return -1;
  if (status == QTR_OK) status = qtr_game_init(p->game, &p->in.mission, p->travel, &culprit);
  if (status == QTR_ERR_UNREACHABLE) {
    if (handle_unreachable(p, config, why) != 0) return -1;
    status = qtr_game_init(p->game, &p->in.mission, p->travel, &culprit);
  }
  const bool some_left_out = p->in.places_stated != p->in.mission.places;
  p->in.mission.number = some_left_out ? p->in.place_number : NULL;
  p->travel_seconds = stop_seconds() - begin;
  if (status == QTR_OK) unfit_note(&p->in, p->game, &p->pace);
  notes_print(&p->in.note, 0);
  if (status == QTR_ERR_DISCOUNT) return fault_discount(p, culprit, why);
  /* All places take as long as those that were measured; what comes after them until the first plan takes no time. */
  if (status == QTR_ERR_STOPPED)
    return stop_fault(why, p->in.path, "a first plan",
                      begin + p->travel_seconds * p->in.mission.places / p->game->measured);
  return status == QTR_OK ? 0 : unfit_fault(&p->in, p->game, &p->pace, status, culprit, why);
}

uint32_t problem_free_cells(const problem *p) {
  const uint32_t cells = qtr_mission_cells(&p->in.mission);
  uint32_t count = 0;
  for (uint32_t cell = 0; cell < cells; cell++) count += p->in.mission.cost[cell] > 0;
  return count;
}

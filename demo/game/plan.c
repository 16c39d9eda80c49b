#include "plan.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "host/base/clock.h"
#include "host/base/outfile.h"
#include "host/base/stop.h"
#include "host/plan/study.h"
#include "host/table/certificate.h"
#include "quarter/export.h"
#include "quarter/objective.h"
#include "quarter/status.h"

_Static_assert(DEMO_NAME_SIZE >= QTR_NAME_BYTES, "a name that an input may have is shown whole");

static study *learnt;
static plan_config asked;

/* ---- learning ---- */

int plan_read(const char *mission, int robots, fault *why) {
  plan_config_default(&asked);
  asked.reading.robots = robots;
  study_drop(learnt);
  learnt = study_take(why);
  if (learnt == NULL || problem_load(&learnt->p, mission, &asked, why) != 0) return -1;
  return problem_measure(&learnt->p, &asked, why);
}

static void learn(double seconds) {
  const double begin = clock_seconds();
  while (!stop_asked() && study_step(learnt) == QTR_LEARNING && clock_seconds() - begin < seconds) continue;
}

static int not_learnt(int status, fault *why) {
  if (!stop_asked())
    return fault_set(why, "%s: no policy table can be made: %s", learnt->p.in.path, qtr_strerror(status));
  fault_set(why, "%s: ended (%s) while it was learnt; nothing was written", learnt->p.in.path, stop_reason());
  why->status = EXIT_STOPPED;
  return -1;
}

static int learn_table(table *t, double seconds, fault *why) {
  if (study_begin(learnt, &asked, why) != 0) return -1;
  learn(seconds);
  if (stop_asked()) return not_learnt(QTR_ERR_STOPPED, why);
  const uint32_t size = qtr_export_size(learnt->learner);
  t->bytes.data = malloc(size);
  t->bytes.size = size;
  int32_t status = t->bytes.data != NULL ? qtr_export(learnt->learner, t->bytes.data, size) : QTR_ERR_SPACE;
  if (status > 0 && table_add_names(&t->bytes, &learnt->p.in.names, &learnt->p.in.geo, why) != 0) {
    table_free(t);
    return -1;
  }
  if (status > 0) status = table_open_bytes(t);
  if (status == QTR_OK) return 0;
  table_free(t);
  return not_learnt(status, why);
}

/* ---- a table from elsewhere ---- */

/* Where the table's cell is on the mission's map. */
static qtr_cell on_map(const table *t, const qtr_mission *mission, qtr_cell cell) {
  return (qtr_cell)(table_row(t, cell) * mission->columns + table_column(t, cell));
}

static bool same_map(const table *t, const qtr_mission *mission) {
  const qtr_grid *grid = &t->policy.grid;
  if (t->claim.map_columns != mission->columns || t->claim.map_rows != mission->rows) return false;
  for (uint32_t cell = 0; cell < qtr_grid_cells(grid); cell++)
    if (qtr_grid_cost(grid, (qtr_cell)cell) != mission->cost[on_map(t, mission, (qtr_cell)cell)]) return false;
  return true;
}

/* Travel times, scans included, ready times and ends: what robots of the mission can do. */
static bool same_times(const qtr_board *one, const qtr_board *other) {
  for (unsigned i = 0; i < one->seekers; i++) {
    if (qtr_board_ready(one, i) != qtr_board_ready(other, i) || qtr_board_end(one, i) != qtr_board_end(other, i))
      return false;
    for (unsigned from = 0; from <= one->places; from++)
      for (unsigned to = 0; to < one->places; to++)
        if (qtr_board_steps(one, i, from < one->places ? from : from + one->start_of[i], to) !=
            qtr_board_steps(other, i, from < one->places ? from : from + other->start_of[i], to))
          return false;
  }
  return true;
}

static bool same_likelihoods(const table *t, const qtr_game *game) {
  for (unsigned place = 0; place < game->board.places; place++)
    if (fabs(table_probability(t, place) - game->probability[place]) > 1e-6) return false;
  return true;
}

/* Places are the game's: several looks at one of the mission's are so many. */
static const char *difference(const table *t, const qtr_game *game) {
  const qtr_mission *mission = game->mission;
  const qtr_policy *policy = &t->policy;
  if (!same_map(t, mission)) return "its map is another one";
  if (policy->board.places != game->board.places) return "it has other places";
  for (unsigned place = 0; place < game->board.places; place++)
    if (on_map(t, mission, qtr_policy_cell(policy, place)) != mission->place[qtr_game_place(game, place)])
      return "its places lie elsewhere";
  if (policy->board.seekers != mission->seekers) return "it is for another number of robots";
  for (unsigned i = 0; i < mission->seekers; i++)
    if (on_map(t, mission, qtr_policy_cell(policy, (unsigned)game->board.places + policy->board.start_of[i])) !=
        mission->start[i])
      return "its robots start elsewhere";
  if (!same_times(&policy->board, &game->board)) return "its robots are others, or their times";
  return same_likelihoods(t, game) ? NULL : "its likelihoods are others";
}

static int read_table(table *t, const char *path, fault *why) {
  if (table_read(t, path, why) != 0) return -1;
  const char *other = difference(t, learnt->p.game);
  if (other == NULL) return 0;
  table_free(t);
  return fault_set(why, "%s: this table is not of %s: %s; learn it again with 'quarter learn %s -o %s'", path,
                   learnt->p.in.path, other, learnt->p.in.path, path);
}

/* ---- what it says ---- */

int plan_look(const plan *p, int place, int n) {
  for (unsigned look = 0; look < p->t.policy.board.places; look++)
    if ((int)qtr_policy_place(&p->t.policy, look) == place && --n == 0) return (int)look;
  return -1;
}

qtr_steps plan_look_step(const plan *p, int place, int n) {
  const int look = place >= 0 ? plan_look(p, place, n) : -1;
  return look >= 0 ? p->step[look] : QTR_NEVER;
}

/* Of looks at one place the likelier ones are those that come first, whatever numbers they were given. */
static void sort_looks(plan *p, int place) {
  for (int n = 1; plan_look(p, place, n + 1) >= 0; n++) {
    for (int m = n; m >= 1; m--) {
      const int earlier = plan_look(p, place, m), later = plan_look(p, place, m + 1);
      if (p->step[earlier] <= p->step[later]) break;
      const qtr_steps step = p->step[earlier];
      const int territory = p->territory[earlier];
      p->step[earlier] = p->step[later];
      p->territory[earlier] = p->territory[later];
      p->step[later] = step;
      p->territory[later] = territory;
    }
  }
}

static void find_last_step(plan *p) {
  const qtr_board *board = &p->t.policy.board;
  p->last_step = -1.0;
  for (unsigned i = 0; i < board->seekers; i++)
    if (qtr_board_end(board, i) != QTR_NEVER && qtr_board_end(board, i) > p->last_step)
      p->last_step = qtr_board_end(board, i);
}

static void survey(plan *p) {
  const qtr_board *board = &p->t.policy.board;
  const table_certificate c = table_certificate_of(&p->t.policy);
  table_routes(&p->t, p->routes);
  p->places = p->t.claim.own_places;
  p->expected_step = 0.0;
  for (unsigned place = 0; place < board->places; place++) {
    p->likelihood[place] = c.findable * table_probability(&p->t, place);
    p->territory[place] = -1;
    p->step[place] = QTR_NEVER;
  }
  for (int i = 0; i < board->seekers; i++) {
    for (int j = 0; j < p->routes[i].places; j++) {
      p->territory[p->routes[i].place[j]] = i;
      p->step[p->routes[i].place[j]] = p->routes[i].step[j];
    }
  }
  for (int place = 0; place < p->places; place++) sort_looks(p, place);
  find_last_step(p);
  if (board->places > p->places || p->last_step >= 0.0) {
    p->expected_step = c.expected_time;
    return;
  }
  for (unsigned place = 0; place < board->places; place++)
    if (p->step[place] != QTR_NEVER) p->expected_step += table_probability(&p->t, place) * p->step[place];
}

/* Likelihoods as a table has them, where nothing is missed: what games draw from is then the same for a table made
 * anew and for one read. */
static void find_truth(plan *p) {
  double sum = 0.0;
  bool misses = false;
  for (int place = 0; place < p->places; place++) {
    const double q = learnt->p.in.mission.detection[place];
    p->truth.detection[place] = q;
    p->truth.likelihood[place] = table_probability(&p->t, (unsigned)place) / q;
    sum += p->truth.likelihood[place];
    misses = misses || q < 1.0;
  }
  for (int place = 0; misses && place < p->places; place++) p->truth.likelihood[place] /= sum;
}

/* As the learner counts them when it has made a plan: a table does not hold it. */
static void count_negligible(plan *p) {
  static qtr_objective objective;
  const table_certificate c = table_certificate_of(&p->t.policy);
  const qtr_aim aim = {.kind = c.objective, .gamma = c.gamma};
  qtr_objective_init(&objective, &aim, NULL);
  p->negligible = 0;
  for (unsigned place = 0; place < p->t.policy.board.places; place++)
    if (p->step[place] != QTR_NEVER)
      p->negligible += qtr_objective_neglects(&objective, p->likelihood[place], p->step[place], c.figure);
}

static int save_table(const table *t, const char *path, fault *why) {
  outfile out;
  if (path == NULL) return 0;
  if (outfile_open(&out, path, why) != 0) return -1;
  fwrite(t->bytes.data, 1, t->bytes.size, out.file);
  return outfile_commit(&out, why);
}

static void name_mission(plan *p) {
  const char *mission = learnt->p.in.path;
  const char *slash = strrchr(mission, '/');
  const char *name = learnt->p.in.names.mission[0] != '\0' ? learnt->p.in.names.mission
                     : slash != NULL                       ? slash + 1
                                                           : mission;
  snprintf(p->name, sizeof p->name, "%.*s", (int)sizeof p->name - 1, name);
}

int plan_make(plan *p, const char *table_path, double seconds, const char *save, fault *why) {
  name_mission(p);
  const int status = table_path != NULL ? read_table(&p->t, table_path, why) : learn_table(&p->t, seconds, why);
  if (status != 0) return -1;
  survey(p);
  find_truth(p);
  count_negligible(p);
  if (save_table(&p->t, save, why) == 0) return 0;
  plan_free(p);
  return -1;
}

/* ---- without the field's terms ---- */

/* All robots of one class, as fast as they are on the average, so that steps stay as long as they were. */
static void make_plain(qtr_mission *mission) {
  uint32_t steps = 0;
  for (int i = 0; i < mission->seekers; i++) {
    steps += mission->robot_class[mission->class_of[i]].cell_steps;
    mission->class_of[i] = 0;
    mission->ready[i] = 0;
  }
  qtr_robot_class_default(&mission->robot_class[0]);
  mission->robot_class[0].cell_steps = (steps + mission->seekers / 2u) / mission->seekers;
  mission->classes = 1;
  mission->aim.home_weight = 0.0;
  for (int place = 0; place < mission->places; place++) {
    mission->detection[place] = 1.0;
    mission->looks[place] = 1;
  }
}

int plan_make_plain(table *t, const plan *p, int robots, double seconds, fault *why) {
  static char mission[INPUT_PATH_SIZE];
  snprintf(mission, sizeof mission, "%s", learnt->p.in.path);
  study_drop(learnt);
  learnt = study_take(why);
  asked.reading.robots = robots;
  if (learnt == NULL || problem_load(&learnt->p, mission, &asked, why) != 0) return -1;
  make_plain(&learnt->p.in.mission);
  if (problem_measure(&learnt->p, &asked, why) != 0 || learn_table(t, seconds, why) != 0) return -1;
  if (t->policy.board.places == p->places && t->policy.grid.columns == p->t.policy.grid.columns &&
      t->policy.grid.rows == p->t.policy.grid.rows)
    return 0;
  table_free(t);
  return fault_set(why, "%s: without its terms it has other places or another map; no games can be compared", mission);
}

void plan_free(plan *p) {
  table_free(&p->t);
}

double plan_found_by(const plan *p, double step) {
  double probability = 0.0;
  for (unsigned place = 0; place < p->t.policy.board.places; place++)
    if (p->step[place] != QTR_NEVER && p->step[place] <= step) probability += p->likelihood[place];
  return probability;
}

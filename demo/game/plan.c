#include "plan.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "host/base/clock.h"
#include "host/base/outfile.h"
#include "host/base/stop.h"
#include "host/plan/study.h"
#include "host/plan/terms.h"
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
  if (terms_check_demo(&learnt->p.in, why) != 0) return -1;
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
  return same_likelihoods(t, game) ? NULL : "its likelihoods are others";
}

static int read_table(table *t, const char *path, fault *why) {
  if (table_read(t, path, why) != 0) return -1;
  const char *other = difference(t, &learnt->p.game);
  if (other == NULL) return 0;
  table_free(t);
  return fault_set(why, "%s: this table is not of %s: %s; learn it again with 'quarter learn %s -o %s'", path,
                   learnt->p.in.path, other, learnt->p.in.path, path);
}

/* ---- what it says ---- */

static void survey(plan *p) {
  const qtr_board *board = &p->t.policy.board;
  table_routes(&p->t, p->routes);
  p->expected_step = 0.0;
  for (unsigned place = 0; place < board->places; place++) {
    p->likelihood[place] = table_probability(&p->t, place);
    p->territory[place] = -1;
    p->step[place] = QTR_NEVER;
  }
  for (int i = 0; i < board->seekers; i++) {
    for (int j = 0; j < p->routes[i].places; j++) {
      const unsigned place = p->routes[i].place[j];
      p->territory[place] = i;
      p->step[place] = p->routes[i].step[j];
      p->expected_step += p->likelihood[place] * p->routes[i].step[j];
    }
  }
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
  count_negligible(p);
  if (save_table(&p->t, save, why) == 0) return 0;
  plan_free(p);
  return -1;
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

#include "relearn.h"

#include <math.h>
#include <string.h>

#include "figures.h"
#include "host/base/stop.h"
#include "host/plan/study.h"
#include "host/table/certificate.h"
#include "quarter/claim.h"
#include "quarter/rest.h"
#include "quarter/status.h"

/* The table's mission without what is cleared, and which of the table's places each of its places is. */
typedef struct {
  const table *t;
  const qtr_deployment *deployment;
  table_certificate claimed;
  uint16_t of[QTR_MAX_PLACES];
} source;

/* ---- the mission ---- */

static void take_ground(qtr_mission *m, const table *t) {
  const qtr_grid *grid = &t->policy.grid;
  m->columns = grid->columns;
  m->rows = grid->rows;
  for (uint32_t cell = 0; cell < qtr_grid_cells(grid); cell++)
    m->cost[cell] = (uint8_t)qtr_grid_cost(grid, (qtr_cell)cell);
}

/* Of a place's looks, the worth of the second is that of the first times 1 - q. Where there is one look alone, what it
 * finds is all that counts, and it is taken to find as much as looks do on the whole. */
static void take_looks(qtr_mission *m, unsigned place, const source *s) {
  const qtr_policy *policy = &s->t->policy;
  double worth[2] = {0.0, 0.0};
  unsigned looks = 0;
  for (unsigned look = 0; look < policy->board.places; look++)
    if (qtr_policy_place(policy, look) == s->of[place]) {
      if (looks < 2) worth[looks] = s->claimed.findable * table_probability(s->t, look);
      looks++;
    }
  m->detection[place] = looks > 1 ? 1.0 - worth[1] / worth[0] : s->claimed.findable;
  m->weight[place] = worth[0] / m->detection[place];
  m->looks[place] = (uint8_t)looks;
}

static void take_class(qtr_mission *m, unsigned of_class, const source *s) {
  const qtr_policy *policy = &s->t->policy;
  qtr_robot_class *of = &m->robot_class[of_class];
  qtr_robot_class_default(of);
  of->cell_steps = qtr_claim_cell_steps(policy, of_class);
  for (unsigned place = 0; place < m->places; place++) {
    const qtr_steps scan = qtr_board_class_steps(&policy->board, of_class, s->of[place], s->of[place]);
    of->scan[place] = scan != QTR_NEVER ? scan : 0;
    if (scan == QTR_NEVER) qtr_places_add(&of->avoided, place);
  }
}

static void take_robots(qtr_mission *m, const source *s, const simulation_config *config) {
  const qtr_policy *policy = &s->t->policy;
  const qtr_board *board = &policy->board;
  m->seekers = board->seekers;
  m->classes = board->classes > 0 ? board->classes : 1;
  for (unsigned of = 0; of < m->classes; of++) take_class(m, of, s);
  for (unsigned i = 0; i < m->seekers; i++) {
    qtr_robot_class *of = &m->robot_class[board->class_of[i]];
    const qtr_steps end = qtr_board_end(board, i);
    m->class_of[i] = board->class_of[i];
    m->ready[i] = qtr_board_ready(board, i);
    m->start[i] = config->froms > 0 ? table_cell(s->t, config->from[i].column, config->from[i].row)
                                    : qtr_policy_cell(policy, (unsigned)board->places + s->deployment->start_of[i]);
    of->endurance = end != QTR_NEVER ? end - m->ready[i] : QTR_NEVER;
    of->smooth_only = qtr_policy_ground(policy, i).encoding == QTR_GRID_SMOOTH;
  }
}

static void make_mission(qtr_mission *m, source *s, const simulation_config *config) {
  const qtr_policy *policy = &s->t->policy;
  qtr_mission_default(m);
  take_ground(m, s->t);
  for (unsigned place = 0; place < policy->board.places; place++)
    if (qtr_policy_place(policy, place) == place && !qtr_places_has(&s->deployment->cleared, place)) {
      m->place[m->places] = qtr_policy_cell(policy, place);
      s->of[m->places++] = (uint16_t)place;
    }
  for (unsigned place = 0; place < m->places; place++) take_looks(m, place, s);
  take_robots(m, s, config);
  m->rule = policy->board.rule;
  m->aim = (qtr_aim){s->claimed.objective, s->claimed.gamma, s->claimed.deadline,
                     s->claimed.home_weight * s->claimed.findable};
}

/* ---- the game by their rule ---- */

/* One of the game's places that is the same look as the table's. */
static unsigned game_place(const qtr_game *game, const source *s, unsigned place) {
  const naming n = table_naming(s->t);
  unsigned before = naming_look(&n, place);
  for (unsigned p = 0; p < game->board.places; p++)
    if (s->of[qtr_game_place(game, p)] == qtr_policy_place(&s->t->policy, place) && --before == 0) return p;
  return QTR_MAX_PLACES;
}

static int play_by_rule(relearnt *r, const qtr_game *game, const source *s, const simulation_config *asked,
                        fault *why) {
  static simulation played;
  simulation_config config = *asked;
  qtr_steps visit[QTR_MAX_PLACES], last[QTR_MAX_SEEKERS] = {0};
  uint64_t home = 0;
  config.lates = config.losts = 0;
  config.target = SIMULATION_NO_TARGET;
  if (simulation_run(&played, s->t, s->deployment, &config, why) != 0) return -1;
  for (unsigned place = 0; place < game->board.places; place++) visit[place] = QTR_NEVER;
  for (int i = 0; i < played.visits; i++) {
    const unsigned place = game_place(game, s, played.visit[i].place), seeker = played.visit[i].seeker;
    if (place == QTR_MAX_PLACES) continue;
    visit[place] = played.visit[i].step;
    last[seeker] = played.visit[i].step + qtr_game_way_home(game, seeker, place);
  }
  for (unsigned i = 0; i < game->board.seekers; i++) home += last[i];
  qtr_game_score(game, visit, game->objective.terms.home_weight > 0.0 ? home : 0, &r->by_rule);
  r->objective = game->objective.kind;
  r->figure_by_rule = qtr_objective_figure(r->objective, qtr_objective_of_score(r->objective, &r->by_rule));
  return 0;
}

/* ---- learning ---- */

static int learn_rest(relearnt *r, study *anew, fault *why) {
  static plan_config config;
  enum qtr_learning learning = QTR_LEARNING;
  plan_config_default(&config);
  if (study_begin(anew, &config, why) != 0) return -1;
  do {
    learning = study_step(anew);
    qtr_learner_certificate(anew->learner, &r->certificate);
  } while (learning == QTR_LEARNING && !stop_asked());
  return 0;
}

int relearn(relearnt *r, const table *t, const qtr_deployment *deployment, const simulation_config *config,
            fault *why) {
  static source s;
  study *anew = study_take(why);
  if (anew == NULL) return -1;
  s = (source){.t = t, .deployment = deployment, .claimed = table_certificate_of(&t->policy)};
  *r = (relearnt){.step_seconds = table_step_seconds(t)};
  make_mission(&anew->p.in.mission, &s, config);
  stop_begin();
  stop_after(RELEARN_SECONDS);
  anew->p.in.mission.watch = stop_watch();
  int status = anew->p.in.mission.places > 0 ? qtr_mission_check(&anew->p.in.mission, NULL) : QTR_ERR_NO_PLACE;
  if (status == QTR_OK && problem_need_game(&anew->p, why) != 0) status = QTR_ERR_SPACE;
  if (status == QTR_OK) status = qtr_rest_game(anew->p.game, &anew->p.in.mission, anew->p.travel);
  if (status != QTR_OK) fault_set(why, "the rest: %s", qtr_strerror(status));
  if (status == QTR_OK) status = play_by_rule(r, anew->p.game, &s, config, why);
  if (status == QTR_OK) status = learn_rest(r, anew, why);
  study_drop(anew);
  return status == QTR_OK ? 0 : -1;
}

/* ---- what is told ---- */

/* "expected time 24.3 s by their rule, 21.1 s learnt anew, 13.2 % less" */
static void write_pair(FILE *out, uint8_t objective, double rule, double anew, double step_seconds) {
  const double change = 100.0 * (anew - rule) / rule;
  fprintf(out, "%s %s by their rule, %s learnt anew", qtr_objective_in_words(objective)->figure,
          figures_told(objective, rule, step_seconds).text, figures_told(objective, anew, step_seconds).text);
  if (fabs(change) >= 0.005) fprintf(out, ", %.3g %% %s", fabs(change), change < 0.0 ? "less" : "more");
}

void relearn_write(FILE *out, const relearnt *r) {
  const qtr_certificate *c = &r->certificate;
  write_pair(out, r->objective, r->figure_by_rule, c->objective, r->step_seconds);
  fputs(" (", out);
  certificate_tell(out, c->certified, c->gap, c->negligible_places);
  fputs(")\n", out);
  if (!qtr_objective_in_words(r->objective)->fades) return;
  write_pair(out, QTR_TIME, r->by_rule.expected_time, c->expected_time, r->step_seconds);
  fputc('\n', out);
}

static void write_one(json *j, const char *key, const relearnt *r, double figure, double expected_time) {
  json_object(j, key);
  json_number(j, "objective_value", figures_unit(r->objective, r->step_seconds) * figure);
  json_number(j, "expected_time", expected_time);
  figures_json_seconds(j, "expected_time_seconds", expected_time, r->step_seconds);
  json_end_object(j);
}

void relearn_json(json *j, const relearnt *r) {
  const qtr_certificate *c = &r->certificate;
  json_object(j, "off_table_loss");
  json_string(j, "objective", qtr_objective_names[r->objective]);
  write_one(j, "by_rule", r, r->figure_by_rule, r->by_rule.expected_time);
  write_one(j, "learnt_anew", r, c->objective, c->expected_time);
  json_number(j, "objective_bound", figures_unit(r->objective, r->step_seconds) * c->bound);
  json_number(j, "gap", c->gap);
  json_bool(j, "certified", c->certified);
  json_end_object(j);
}

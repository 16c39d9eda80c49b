#include "host/plan/simulation.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "host/table/certificate.h"
#include "quarter/claim.h"
#include "quarter/objective.h"

/* One robot and its body: what the executor does not know of. */
typedef struct {
  qtr_seeker seeker;
  qtr_cell *way;     /* the cells to enter, in order, as far as its heading */
  uint32_t entered;  /* of them, by now */
  uint32_t cells;    /* on the way */
  uint16_t heading;  /* the place that the way leads to */
  qtr_cell cell;     /* where it stands */
  qtr_cell entering; /* the cell that it is moving to */
  double ready;      /* when it will be there */
  double factor;     /* how much longer its moves take */
  qtr_steps lost;    /* from when on it does nothing more */
  bool moving;
  bool scanning; /* its target, until it is ready */
} robot;

typedef struct {
  robot *robots;
  int count;
  const table *t;
  const simulation_config *config;
  qtr_places seen; /* places visited by any robot: for the record alone, no robot reads it */
  qtr_field *
      field; /* travel times for whoever looks for its way: every robot has its own, but one at a time is enough here */
} world;

void simulation_config_default(simulation_config *config) {
  memset(config, 0, sizeof *config);
  config->target = SIMULATION_NO_TARGET;
}

/* ---- set-up ---- */

static int check_seeker(int seeker, const char *name, const table *t, fault *why) {
  if (seeker < t->policy.board.seekers) return 0;
  return fault_set(why, "--%s: there is no seeker %d; the table has seekers 0 to %d", name, seeker,
                   t->policy.board.seekers - 1);
}

static int check_place(unsigned place, const char *name, const table *t, fault *why) {
  if (place < t->policy.board.places) return 0;
  return fault_set(why, "--%s: there is no place %u; the table has places 0 to %d", name, place,
                   t->policy.board.places - 1);
}

static int check_config(const table *t, const simulation_config *config, fault *why) {
  for (int i = 0; i < config->lates; i++)
    if (check_seeker(config->late[i].seeker, "late", t, why) != 0) return -1;
  for (int i = 0; i < config->losts; i++)
    if (check_seeker(config->lost[i].seeker, "lost", t, why) != 0) return -1;
  if (config->target != SIMULATION_NO_TARGET && check_place((unsigned)config->target, "target", t, why) != 0) return -1;
  for (unsigned place = 0; place < QTR_MAX_PLACES; place++)
    if (qtr_places_has(&config->clear, place) && check_place(place, "clear", t, why) != 0) return -1;
  return 0;
}

static void set_faults(world *w) {
  for (int i = 0; i < w->config->lates; i++) {
    robot *late = &w->robots[w->config->late[i].seeker];
    late->ready += w->config->late[i].wait;
    late->factor *= w->config->late[i].factor;
  }
  for (int i = 0; i < w->config->losts; i++) {
    robot *lost = &w->robots[w->config->lost[i].seeker];
    if (w->config->lost[i].step < lost->lost) lost->lost = w->config->lost[i].step;
  }
}

static void free_world(world *w) {
  for (int i = 0; w->robots != NULL && i < w->count; i++) free(w->robots[i].way);
  free(w->field);
  free(w->robots);
}

static int make_world(world *w, const table *t, const qtr_deployment *deployment, const simulation_config *config,
                      fault *why) {
  const qtr_board *board = &t->policy.board;
  *w = (world){
      calloc(board->seekers, sizeof(robot)), board->seekers, t, config, config->clear, malloc(sizeof(qtr_field))};
  for (int i = 0; w->robots != NULL && i < w->count; i++) {
    robot *r = &w->robots[i];
    r->way = malloc(qtr_grid_cells(&t->policy.grid) * sizeof *r->way);
    r->heading = QTR_STAND_DOWN;
    r->cell = config->froms > 0 ? table_cell(t, config->from[i].column, config->from[i].row)
                                : qtr_policy_cell(&t->policy, (unsigned)board->places + board->start_of[i]);
    r->factor = 1.0;
    r->ready = qtr_board_ready(board, (unsigned)i);
    r->lost = QTR_NEVER;
    qtr_seeker_init(&r->seeker, &t->policy, (unsigned)i, deployment, 0);
  }
  bool whole = w->robots != NULL && w->field != NULL;
  for (int i = 0; whole && i < w->count; i++) whole = w->robots[i].way != NULL;
  if (whole) {
    set_faults(w);
    return 0;
  }
  free_world(w);
  return fault_set(why, "no memory for %d robots on this map", board->seekers);
}

/* ---- what happens at a step ---- */

static void tell_others(world *w, int from, const qtr_signal *signal, qtr_steps now) {
  for (int i = 0; i < w->count; i++)
    if (i != from && now < w->robots[i].lost) qtr_seeker_hear(&w->robots[i].seeker, signal);
}

static void record_visit(simulation *s, world *w, int i, uint16_t place, qtr_steps now) {
  if (qtr_places_has(&w->seen, place)) {
    s->duplicates++;
    return;
  }
  qtr_places_add(&w->seen, place);
  s->visit[s->visits++] = (simulation_visit){place, (uint8_t)i, now};
}

/* Steps that a robot takes to scan a place where it stands. */
static qtr_steps scan_steps(const world *w, int i, unsigned place) {
  return qtr_board_steps(&w->t->policy.board, (unsigned)i, place, place);
}

/* Begin to scan the target; true if that takes a while from now. */
static bool begin_scan(const world *w, robot *r, int i, unsigned place, qtr_steps now) {
  const double takes = r->factor * scan_steps(w, i, place);
  const double from = now - r->ready < 1.0 ? r->ready : (double)now;
  r->scanning = true;
  if (takes > 0.0) r->ready = from + takes;
  return r->ready > now;
}

/* A robot scans the places it stands on, and learns where to go next. */
static bool scan(simulation *s, world *w, int i, qtr_steps now) {
  robot *r = &w->robots[i];
  if (now >= r->lost) return false;
  const uint16_t place = qtr_seeker_target(&r->seeker);
  if (place == QTR_STAND_DOWN || r->moving || qtr_policy_cell(&w->t->policy, place) != r->cell) return false;
  if (!r->scanning && begin_scan(w, r, i, place, now)) return false;
  r->scanning = false;
  record_visit(s, w, i, place, now);
  if ((int)qtr_policy_place(&w->t->policy, place) == w->config->target && s->found_step == QTR_NEVER) {
    s->found_step = now;
    if (!w->config->clear_all) {
      qtr_seeker_found(&r->seeker);
      return false;
    }
  }
  qtr_seeker_visited(&r->seeker, place);
  return true;
}

static void announce(simulation *s, world *w, int i, qtr_steps now) {
  qtr_signal signal;
  if (now >= w->robots[i].lost) return;
  while (qtr_seeker_announce(&w->robots[i].seeker, &signal)) {
    if (signal.kind == QTR_SIGNAL_FOUND)
      s->found_signals++;
    else
      s->done_signals++;
    tell_others(w, i, &signal, now);
  }
}

/* The cells to the robot's target, or to another one where that is out of reach. False: it has none left. */
static bool find_way(world *w, robot *r) {
  const qtr_grid ground = qtr_policy_ground(&w->t->policy, r->seeker.self);
  const qtr_grid *grid = &ground;
  if (!qtr_seeker_field(&r->seeker, w->field, r->cell)) return false;
  r->heading = qtr_seeker_target(&r->seeker);
  r->entered = r->cells = 0;
  for (qtr_cell at = r->cell, next; (next = qtr_field_next(w->field, grid, at)) != at; at = next)
    r->way[r->cells++] = next;
  return true;
}

/* Set out for the next cell on the way to the target. */
static void set_out(world *w, int i, qtr_steps now) {
  robot *r = &w->robots[i];
  if (now >= r->lost) return;
  const uint16_t target = qtr_seeker_target(&r->seeker);
  if (target == QTR_STAND_DOWN || r->moving || r->scanning || r->ready > now) return;
  if (r->heading != target && !find_way(w, r)) return;
  r->entering = r->entered < r->cells ? r->way[r->entered++] : r->cell;
  /* A slow robot that moves on at once keeps the fraction of a step that it was early. */
  const double from = now - r->ready < 1.0 ? r->ready : (double)now;
  const uint32_t cell_steps = qtr_claim_cell_steps(&w->t->policy, w->t->policy.board.class_of[i]);
  r->ready = from + r->factor * cell_steps * qtr_grid_cost(&w->t->policy.grid, r->entering);
  r->moving = true;
}

static void arrive(robot *r, qtr_steps now) {
  if (!r->moving || r->ready > now) return;
  r->cell = r->entering;
  r->moving = false;
}

/* One step of the world. Everything that happens at a step is seen before anyone moves on. Returns whether any robot
 * still has something to do. */
static bool step_world(simulation *s, world *w, qtr_steps now) {
  bool busy = false;
  for (int i = 0; i < w->count; i++) {
    arrive(&w->robots[i], now);
    while (w->robots[i].ready <= now && scan(s, w, i, now)) {}
  }
  for (int i = 0; i < w->count; i++) announce(s, w, i, now);
  for (int i = 0; i < w->count; i++) {
    set_out(w, i, now);
    busy = busy || (now < w->robots[i].lost && qtr_seeker_target(&w->robots[i].seeker) != QTR_STAND_DOWN);
  }
  return busy;
}

/* ---- the account ---- */

static int left_over(const world *w) {
  int left = 0;
  for (unsigned place = 0; place < w->t->policy.board.places; place++) left += !qtr_places_has(&w->seen, place);
  return left;
}

/* The likelihood that a look counts, which goes by how many were made at its place before. */
static double likelihood_of(const simulation *s, const world *w, int visit) {
  const qtr_policy *policy = &w->t->policy;
  const unsigned place = qtr_policy_place(policy, s->visit[visit].place);
  unsigned before = 0;
  for (int i = 0; i < visit; i++) before += qtr_policy_place(policy, s->visit[i].place) == place;
  for (unsigned look = 0; look < policy->board.places; look++)
    if (qtr_policy_place(policy, look) == place && before-- == 0) return table_probability(w->t, look);
  return 0.0;
}

/* When the last robot must be home; 0: some need never be. */
static qtr_steps last_end(const world *w) {
  qtr_steps last = 0;
  for (int i = 0; i < w->count; i++) {
    const qtr_steps end = qtr_board_end(&w->t->policy.board, (unsigned)i);
    if (end == QTR_NEVER) return 0;
    last = end > last ? end : last;
  }
  return last;
}

/* The likelihood of what was not cleared beforehand. */
static double findable_left(const world *w) {
  double sum = 0.0;
  for (unsigned place = 0; place < w->t->policy.board.places; place++)
    if (!qtr_places_has(&w->config->clear, place)) sum += table_probability(w->t, place);
  return sum;
}

/* Over the visits: of what was not cleared beforehand all is found in the end, if looks never miss. */
static void add_up(simulation *s, const world *w) {
  const table_certificate c = table_certificate_of(&w->t->policy);
  const double all = findable_left(w);
  const qtr_steps end = last_end(w);
  double visited = 0.0, sum = 0.0;
  for (int i = 0; i < s->visits; i++) {
    const double probability = likelihood_of(s, w, i) / all;
    const qtr_steps step = s->visit[i].step;
    s->value += QTR_REWARD_SCALE * c.findable * probability * pow(c.gamma, step > 0 ? step - 1.0 : 0.0);
    visited += probability;
    if (!table_is_late(w->t, step)) s->found += c.findable * probability;
    sum += probability * step;
  }
  if (left_over(w) == 0)
    s->expected_time = visited > 0.0 ? sum / visited : 0.0;
  else
    s->expected_time = end > 0 ? sum + (1.0 - visited) * end : NAN;
  for (int i = 0; i < w->count; i++) s->off_table += w->robots[i].seeker.division.off_table;
}

int simulation_run(simulation *s, const table *t, const qtr_deployment *deployment, const simulation_config *config,
                   fault *why) {
  world w;
  if (check_config(t, config, why) != 0 || make_world(&w, t, deployment, config, why) != 0) return -1;
  *s = (simulation){.found_step = QTR_NEVER};
  while (step_world(s, &w, s->end)) s->end++;
  add_up(s, &w);
  free_world(&w);
  return 0;
}

#include "aggregate/environment.h"

#include <stddef.h>

#include "core/block.h"
#include "core/bytes.h"
#include "model/rounding.h"
#include "model/settings.h"
#include "quarter/status.h"

#define ROUNDING 1e-9 /* more than adding up the likelihoods of all places is wrong by */

static unsigned places_of(const qtr_environment *e) {
  return e->game->board.places;
}

static unsigned nodes_of(const qtr_environment *e) {
  return (unsigned)e->game->board.places + e->game->board.starts;
}

/* The first place of a target's tour from a node; QTR_STAND_DOWN if there is no way, node or target. */
static uint16_t first_place(const qtr_environment *e, unsigned node, unsigned target) {
  if (node >= nodes_of(e) || target >= e->targets.count) return QTR_STAND_DOWN;
  return qtr_targets_first(&e->targets, node, target);
}

/* ---- the board of targets ---- */

/* From anywhere in one target to the end of another: the longest, so that keys have room for it. */
static qtr_steps longest_between(const qtr_environment *e, unsigned from, unsigned to) {
  qtr_steps longest = QTR_NEVER;
  for (unsigned i = 0; i < qtr_targets_size(&e->targets, from); i++) {
    const qtr_steps steps = qtr_targets_duration(&e->targets, 0, qtr_targets_place(&e->targets, from, i), to);
    if (steps != QTR_NEVER && (longest == QTR_NEVER || steps > longest)) longest = steps;
  }
  return longest;
}

/* Times between targets are for reach alone, and for how long keys must be: a tour depends on where it begins, so
 * choosing sets the time that remains (qtr_environment_choose()). */
static void fill_reach(qtr_environment *e) {
  const unsigned targets = e->targets.count;
  for (unsigned to = 0; to < targets; to++) {
    for (unsigned from = 0; from < targets; from++)
      qtr_store32(e->reach + 4 * ((size_t)from * targets + to), from == to ? 0 : longest_between(e, from, to));
    for (unsigned start = 0; start < e->board.starts; start++)
      qtr_store32(e->reach + 4 * ((size_t)(targets + start) * targets + to),
                  qtr_targets_duration(&e->targets, 0, places_of(e) + start, to));
  }
}

/* The joint game's rules hold among targets as among places; where these are the same, on one board. */
static int make_board(qtr_environment *e, uint8_t rule) {
  e->board = e->game->board;
  e->board.rule = rule;
  if (!e->aggregated) return QTR_OK;
  e->board.places = e->targets.count;
  e->board.step_bytes = 4;
  e->board.steps = e->reach;
  fill_reach(e);
  return qtr_board_init(&e->board);
}

/* ---- keys ---- */

/* Node digits are the places, the starts, and one for standing down, whatever the targets are. With regions,
 * `remaining` is what is seen of the walk. */
static void shape_keys(qtr_environment *e) {
  e->keys = e->board.keys;
  e->keys.nodes = (uint16_t)nodes_of(e);
  if (!qtr_sight_is_exact(&e->sight)) e->keys.longest = qtr_sight_last_digit(&e->sight);
  qtr_key_measure(&e->keys);
}

/* A seeker on its way is known by the first place of its tour, which tells target, order and exit. With regions one
 * that is idle is so by its region alone: its node says that it is idle. */
static void key_of_seen(const qtr_environment *e, const qtr_situation *s, qtr_key *key) {
  qtr_joint seen = s->joint;
  for (unsigned i = 0; i < e->board.seekers; i++) {
    if (seen.node[i] == QTR_STAND_DOWN) continue;
    seen.node[i] = s->at[i];
    if (qtr_sight_is_exact(&e->sight)) continue;
    const bool is_idle = seen.remaining[i] == 0;
    if (is_idle) seen.node[i] = (uint16_t)places_of(e);
    seen.remaining[i] = qtr_sight_digit(&e->sight, &s->walk[i], is_idle);
  }
  qtr_joint_key(key, &seen, &e->keys);
}

/* Without aggregation all of the joint game is seen as it is. */
void qtr_environment_key(const qtr_environment *e, const qtr_situation *s, qtr_key *key) {
  if (e->aggregated)
    key_of_seen(e, s, key);
  else
    qtr_joint_key(key, &s->joint, &e->keys);
}

/* ---- settings ---- */

void qtr_aggregation_default(qtr_aggregation *how) {
  *how = (qtr_aggregation){
      .made = SETTINGS_MADE, .rule = QTR_RULE_FREE, .spot_order = QTR_SPOT_BEST, .region_times = QTR_TIMES_STANDING};
  qtr_spots_default(&how->spots);
}

int qtr_aggregation_check(const qtr_aggregation *how) {
  if (how->made != SETTINGS_MADE || how->rule > QTR_RULE_PAPER) return QTR_ERR_ARGUMENT;
  if (how->spot_order > QTR_SPOT_NEAREST || how->region_times > QTR_TIMES_TRUE) return QTR_ERR_ARGUMENT;
  return how->by_spots ? qtr_spots_check(&how->spots) : QTR_OK;
}

/* ---- set-up ---- */

static int make_targets(qtr_environment *e, const qtr_aggregation *how) {
  if (how != NULL && how->by_spots) return qtr_targets_spots(&e->targets, e->game, &how->spots, how->spot_order);
  qtr_targets_places(&e->targets, e->game);
  return QTR_OK;
}

/* What an aggregate leaves out of sight: who may go where until when. */
static bool is_for_spots(const qtr_game *game) {
  const qtr_terms *terms = &game->board.terms;
  return qtr_board_classes(&game->board) == 1 && terms->look_of == NULL && terms->ready == NULL && terms->end == NULL &&
         game->objective.terms.home_weight == 0.0;
}

/* Regions walk cell by cell, a step at a time. */
static bool is_for_regions(const qtr_game *game) {
  const qtr_robot_class *all = &game->mission->robot_class[0];
  for (unsigned place = 0; place < game->mission->places; place++)
    if (all->scan[place] > 0) return false;
  return all->cell_steps == 1 && !all->smooth_only && game->board.terms.clock == 0;
}

static int check_terms(const qtr_environment *e, const qtr_aggregation *how) {
  if (e->game->by_legs && how != NULL && (e->aggregated || how->rule != QTR_RULE_FREE)) return QTR_ERR_ARGUMENT;
  if (!e->aggregated) return QTR_OK;
  return is_for_spots(e->game) && (how->regions == NULL || is_for_regions(e->game)) ? QTR_OK : QTR_ERR_ARGUMENT;
}

/* What sight by regions needs stands behind the environment itself. */
static int make_sight(qtr_environment *e, const qtr_aggregation *how, qtr_travel *travel) {
  if (how != NULL && how->regions != NULL)
    return qtr_sight_by_regions(&e->sight, e + 1, e->game, how->regions, how->region_times, travel);
  qtr_sight_exact(&e->sight, e->game);
  return QTR_OK;
}

/* The public header's sizes hold what stands here. */
typedef char environment_fits[sizeof(qtr_environment) <= QTR_ENVIRONMENT_GROUND_BYTES ? 1 : -1];

static bool is_aggregated(const qtr_aggregation *how) {
  return how != NULL && (how->by_spots || how->regions != NULL);
}

static size_t sight_bytes(const qtr_game *game, const qtr_aggregation *how) {
  return how != NULL && how->regions != NULL ? qtr_sight_bytes(game, how->regions->count) : 0;
}

size_t qtr_environment_bytes(const qtr_game *game, const qtr_aggregation *how) {
  const size_t times = 4 * ((size_t)game->board.places + game->board.starts) * game->board.places;
  return sizeof(qtr_environment) + sight_bytes(game, how) + (is_aggregated(how) ? times : 0);
}

static int set_up(qtr_environment *e, const qtr_game *game, const qtr_aggregation *how, qtr_travel *travel) {
  e->game = game;
  e->aggregated = is_aggregated(how);
  e->reach = (uint8_t *)(e + 1) + sight_bytes(game, how);
  int status = check_terms(e, how);
  if (status == QTR_OK) status = make_targets(e, how);
  if (status == QTR_OK) status = make_board(e, how != NULL ? how->rule : game->board.rule);
  if (status == QTR_OK) status = make_sight(e, how, travel);
  if (status == QTR_OK) shape_keys(e);
  return status;
}

int qtr_environment_init_built(qtr_environment **environment, void *block, size_t bytes, const qtr_game *game,
                               const qtr_aggregation *how, qtr_travel *travel, uint32_t config_id) {
  if (config_id != QTR_CONFIG_ID) return QTR_ERR_CONFIG;
  int status = how != NULL ? qtr_aggregation_check(how) : QTR_OK;
  if (status == QTR_OK) status = block_check(block, bytes, qtr_environment_bytes(game, how));
  if (status == QTR_OK) status = set_up(block, game, how, travel);
  if (status == QTR_OK) *environment = block;
  return status;
}

unsigned qtr_environment_targets(const qtr_environment *e) {
  return e->targets.count;
}

void qtr_environment_start(const qtr_environment *e, qtr_situation *s) {
  qtr_joint_start(&s->joint, &e->board, NULL, NULL);
  s->unvisited = 1.0;
  for (unsigned i = 0; i < e->board.seekers; i++) {
    s->at[i] = (uint16_t)(places_of(e) + e->board.start_of[i]);
    s->walk[i] = qtr_walk_at(e->game->mission->start[i]);
  }
}

/* ---- play ---- */

unsigned qtr_environment_exit(const qtr_environment *e, const qtr_situation *s, unsigned seeker) {
  if (seeker >= e->board.seekers) return QTR_STAND_DOWN;
  if (s->joint.remaining[seeker] == 0 || s->at[seeker] >= places_of(e)) return s->at[seeker];
  return qtr_tour_exit(qtr_targets_tour(&e->targets, s->at[seeker]));
}

/* A tour of length l with `remaining` steps left visits its place i, which lies l - s_i before its end, after
 * remaining - (l - s_i). */
static qtr_steps steps_to_visit(const qtr_tour *tour, qtr_steps remaining, unsigned i) {
  const qtr_steps after_it = qtr_tour_length(tour) - tour->step[i];
  return remaining > after_it ? remaining - after_it : 0;
}

static bool is_on_tour(const qtr_environment *e, const qtr_situation *s, const qtr_steps *remaining, unsigned seeker) {
  return remaining[seeker] > 0 && s->at[seeker] < places_of(e);
}

/* Steps after which a seeker on its way comes by a place of a target; QTR_NEVER where it is bound for another one. */
static qtr_steps steps_to_place(const qtr_environment *e, const qtr_situation *s, const qtr_steps *remaining,
                                unsigned seeker, unsigned place) {
  const qtr_tour *tour = qtr_targets_tour(&e->targets, s->at[seeker]);
  for (unsigned i = 0; i < tour->places; i++)
    if (tour->place[i] == place) return steps_to_visit(tour, remaining[seeker], i);
  return QTR_NEVER;
}

/* Steps after which the first of those on their way, `remaining` steps from their tours' ends, comes by a place, and
 * who that is. */
static qtr_steps first_visit(const qtr_environment *e, const qtr_situation *s, const qtr_steps *remaining,
                             unsigned place, unsigned *seeker) {
  qtr_steps least = QTR_NEVER;
  for (unsigned i = 0; i < e->board.seekers; i++) {
    if (!is_on_tour(e, s, remaining, i)) continue;
    const qtr_steps steps = steps_to_place(e, s, remaining, i, place);
    if (steps >= least) continue;
    least = steps;
    *seeker = i;
  }
  return least;
}

qtr_steps qtr_environment_visit(const qtr_environment *e, const qtr_situation *s, unsigned seeker, unsigned i) {
  if (seeker >= e->board.seekers || !is_on_tour(e, s, s->joint.remaining, seeker)) return 0;
  const qtr_tour *tour = qtr_targets_tour(&e->targets, s->at[seeker]);
  if (i >= tour->places) return 0;
  if (e->board.rule == QTR_RULE_PAPER) return first_visit(e, s, s->joint.remaining, tour->place[i], &seeker);
  return steps_to_visit(tour, s->joint.remaining[seeker], i);
}

/* Whether a place of a target that others are bound for has been visited by one of them. */
static bool was_visited_on_tour(const qtr_environment *e, const qtr_situation *s, unsigned place) {
  unsigned seeker;
  return e->board.rule == QTR_RULE_PAPER && first_visit(e, s, s->joint.remaining, place, &seeker) == 0;
}

/* A place where the seeker already stands counts at once, before time passes: its reward is apart from the entry's (Q
 * is stored under the state after the choice). */
static double visit_at_once(const qtr_environment *e, qtr_situation *s, uint16_t place) {
  s->unvisited -= e->game->probability[place];
  return qtr_objective_at_once(&e->game->objective, e->game->probability[place], s->joint.now);
}

/* Without aggregation the board is the game's own. */
static double go_to_place(const qtr_environment *e, qtr_situation *s, int seeker, uint16_t place) {
  const bool visited = qtr_joint_choose(&s->joint, &e->board, seeker, place);
  s->at[seeker] = place;
  return visited ? visit_at_once(e, s, place) : 0.0;
}

static double go_to(const qtr_environment *e, qtr_situation *s, int seeker, uint16_t choice) {
  const uint16_t first = first_place(e, s->at[seeker], choice);
  if (first == QTR_STAND_DOWN) return 0.0;
  if (!e->aggregated) return go_to_place(e, s, seeker, choice);
  const qtr_steps exact = qtr_targets_duration(&e->targets, (unsigned)seeker, s->at[seeker], choice);
  if (exact == QTR_NEVER) return 0.0;
  const bool here = qtr_board_steps(&e->game->board, (unsigned)seeker, s->at[seeker], first) == 0 &&
                    !was_visited_on_tour(e, s, first);
  const bool done = qtr_joint_choose(&s->joint, &e->board, seeker, choice);
  s->at[seeker] = first;
  s->walk[seeker].stage = 0;
  if (!done)
    s->joint.remaining[seeker] =
        qtr_sight_left(&e->sight, &s->walk[seeker], qtr_targets_tour(&e->targets, first), exact);
  /* With regions a spot counts when it is done. */
  return here && (done || qtr_sight_is_exact(&e->sight)) ? visit_at_once(e, s, first) : 0.0;
}

static double make_choice(const qtr_environment *e, qtr_situation *s, int seeker, uint16_t choice) {
  if (choice != QTR_STAND_DOWN) return go_to(e, s, seeker, choice);
  qtr_joint_choose(&s->joint, &e->board, seeker, choice);
  return 0.0;
}

/* Where coming home counts. */
static double choose_and_leave(const qtr_environment *e, qtr_situation *s, int seeker, uint16_t choice) {
  const qtr_joint before = s->joint;
  const double reward = make_choice(e, s, seeker, choice);
  return reward + qtr_game_leave(e->game, &before, &s->joint, 0);
}

double qtr_environment_choose(const qtr_environment *e, qtr_situation *s, int seeker, uint16_t choice) {
  if (seeker < 0 || seeker >= e->board.seekers) return 0.0;
  if (e->game->objective.terms.home_weight != 0.0) return choose_and_leave(e, s, seeker, choice);
  return make_choice(e, s, seeker, choice);
}

/* Only the chooser's own state changes, the bits of one place, and who has stood down since. */
void qtr_environment_undo(const qtr_environment *e, qtr_situation *s, const qtr_situation *before, int seeker,
                          uint16_t choice) {
  const unsigned word = choice != QTR_STAND_DOWN ? QTR_PLACE_WORD(choice) : 0;
  for (unsigned i = 0; i < e->board.seekers; i++) s->joint.node[i] = before->joint.node[i];
  s->joint.remaining[seeker] = before->joint.remaining[seeker];
  s->joint.visited.word[word] = before->joint.visited.word[word];
  s->joint.bound.word[word] = before->joint.bound.word[word];
  s->joint.unvisited = before->joint.unvisited;
  s->unvisited = before->unvisited;
  s->at[seeker] = before->at[seeker];
  s->walk[seeker] = before->walk[seeker];
}

/* A visit `offset` steps into a stretch of `passed` steps, under way since before it. */
static void collect(const qtr_environment *e, qtr_situation *s, qtr_outcome *outcome, double probability,
                    qtr_steps offset, qtr_steps passed) {
  s->unvisited -= probability;
  /* Each place counts once, under either rule and in any tour: nothing is left of more than there was. */
  QTR_ASSERT(s->unvisited > -ROUNDING);
  qtr_objective_collect(&e->game->objective, outcome, probability, offset, passed);
}

/* Under the paper's rule several may be bound for one target, and come to its places in different orders: each counts
 * for whoever is there first, and of those who come in one moment for the lowest. */
static bool is_first_there(const qtr_environment *e, const qtr_situation *s, const qtr_joint *before, unsigned seeker,
                           unsigned place) {
  unsigned first = seeker;
  if (e->board.rule == QTR_RULE_PAPER) first_visit(e, s, before->remaining, place, &first);
  return first == seeker;
}

/* Exact times: each place counts when it is visited. `before` is the joint state where the stretch began. */
static void collect_tour(const qtr_environment *e, qtr_situation *s, qtr_outcome *outcome, unsigned seeker,
                         const qtr_joint *before, qtr_steps passed) {
  const qtr_tour *tour = qtr_targets_tour(&e->targets, s->at[seeker]);
  for (unsigned i = 0; i < tour->places; i++) {
    const qtr_steps steps = steps_to_visit(tour, before->remaining[seeker], i);
    if (steps == 0 || steps > passed || !is_first_there(e, s, before, seeker, tour->place[i])) continue;
    collect(e, s, outcome, e->game->probability[tour->place[i]], steps, passed);
  }
}

/* P / d: half a step for what is here, so that it goes before all else and the rate stays a number. */
double qtr_environment_rate(const qtr_environment *e, unsigned seeker, unsigned node, unsigned target) {
  if (first_place(e, node, target) == QTR_STAND_DOWN) return 0.0;
  const qtr_steps steps = qtr_targets_duration(&e->targets, seeker, node, target);
  if (steps == QTR_NEVER) return 0.0;
  return qtr_targets_probability(&e->targets, target) / (steps > 0 ? (double)steps : 0.5);
}

/* What is exact needs no cell: place and steps left say all that is to come. By regions the cell decides what is
 * seen next, so it goes on along the true way. */
static void settle_seeker(const qtr_environment *e, qtr_situation *s, unsigned seeker, qtr_steps passed) {
  if (s->at[seeker] >= places_of(e)) return; /* was not ready, at its start */
  const qtr_tour *tour = qtr_targets_tour(&e->targets, s->at[seeker]);
  qtr_steps *remaining = &s->joint.remaining[seeker];
  if (*remaining == 0) {
    s->at[seeker] = qtr_tour_exit(tour);
    s->walk[seeker] = qtr_walk_at(e->game->mission->place[qtr_game_place(e->game, s->at[seeker])]);
  } else if (!qtr_sight_is_exact(&e->sight)) {
    qtr_sight_walk(&e->sight, &s->walk[seeker], tour, passed);
    *remaining = qtr_sight_left(&e->sight, &s->walk[seeker], tour, *remaining);
  }
}

/* By regions all of a target counts when it is seen to be done: what is seen within a tour is no time of a visit. */
static void collect_all(const qtr_environment *e, qtr_situation *s, qtr_outcome *outcome, const qtr_joint *before,
                        const qtr_places *arrived, qtr_steps passed) {
  if (!qtr_sight_is_exact(&e->sight)) {
    for (unsigned target = 0; target < e->targets.count; target++)
      if (qtr_places_has(arrived, target))
        collect(e, s, outcome, qtr_targets_probability(&e->targets, target), passed, passed);
    return;
  }
  for (unsigned i = 0; i < e->board.seekers; i++) {
    if (!is_on_tour(e, s, before->remaining, i)) continue;
    /* Of a target visited nothing is left: under the paper's rule one may still be on its way to it. */
    if (qtr_places_has(&before->visited, qtr_targets_tour(&e->targets, s->at[i])->target)) continue;
    collect_tour(e, s, outcome, i, before, passed);
  }
}

/* One stretch: all that is unvisited waits for it, what is visited in it is given back, what comes after is discounted
 * by it. */
static bool pass_once(const qtr_environment *e, qtr_situation *s, qtr_outcome *outcome) {
  const qtr_joint before = s->joint;
  qtr_places arrived;
  qtr_places_clear(&arrived);
  const qtr_steps passed = qtr_joint_advance(&s->joint, &e->board, &arrived);
  if (passed == 0) {
    qtr_objective_end(&e->game->objective, outcome, s->unvisited);
    return false;
  }
  qtr_objective_wait(&e->game->objective, outcome, s->unvisited, qtr_game_seekers_out(e->game, &before), passed);
  collect_all(e, s, outcome, &before, &arrived, passed);
  for (unsigned i = 0; i < e->board.seekers; i++)
    if (before.remaining[i] > 0) settle_seeker(e, s, i, passed);
  outcome->reward += qtr_game_leave(e->game, &before, &s->joint, passed);
  qtr_objective_pass(&e->game->objective, outcome, passed);
  return true;
}

void qtr_environment_pass(const qtr_environment *e, qtr_situation *s, qtr_outcome *outcome) {
  qtr_objective_begin(outcome, s->joint.now);
  while (qtr_joint_chooser(&s->joint, &e->board) == QTR_NOBODY)
    if (!pass_once(e, s, outcome)) return;
}

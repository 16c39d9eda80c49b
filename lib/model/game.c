#include "quarter/game.h"

#include <math.h>
#include <stddef.h>

#include "core/bytes.h"
#include "model/matrix.h"
#include "model/rounding.h"
#include "quarter/status.h"
#include "robot/board.h"

#define ROUNDING 1e-9 /* more than adding up the likelihoods of all places is wrong by */

/* ---- set-up ---- */

/* Seekers who set out from one cell share a node, so that the key cannot tell them apart. */
static void find_starts(qtr_game *game) {
  qtr_board *board = &game->board;
  board->starts = 0;
  for (unsigned i = 0; i < board->seekers; i++) {
    uint16_t start = 0;
    while (start < board->starts && game->mission->start[game->first_at[start]] != game->mission->start[i]) start++;
    if (start == board->starts) game->first_at[board->starts++] = (uint16_t)i;
    board->start_of[i] = start;
  }
}

/* The mission's places come first, in their order; then the second looks, and so on, each as long as it can still find
 * something. Returns false if they are more than the build holds. */
static bool list_looks(qtr_game *game) {
  const qtr_mission *mission = game->mission;
  unsigned places = mission->places;
  game->board.terms.look_of = NULL;
#if QTR_TERMS
  for (unsigned place = 0; place < places; place++) qtr_store16(game->look_of + 2 * place, place);
  for (unsigned look = 1; look < UINT8_MAX; look++) {
    for (unsigned place = 0; place < mission->places; place++) {
      if (look >= mission->looks[place] || mission->detection[place] == 1.0) continue;
      if (places == QTR_MAX_PLACES) return false;
      qtr_store16(game->look_of + 2 * places++, place);
    }
  }
  if (places > mission->places) game->board.terms.look_of = game->look_of;
#endif
  game->board.places = (uint16_t)places;
  return true;
}

unsigned qtr_game_place(const qtr_game *game, unsigned place) {
  return game->board.terms.look_of == NULL ? place : qtr_load16(game->board.terms.look_of + 2 * (size_t)place);
}

static qtr_matrix_nodes nodes_of(const qtr_game *game, const qtr_cell *start) {
  const qtr_matrix_nodes nodes = {game->mission, game->board.places, game->board.terms.look_of, start,
                                  game->board.starts};
  return nodes;
}

static bool comes_home(const qtr_game *game) {
  return game->board.terms.end != NULL || game->objective.terms.home_weight > 0.0;
}

/* The ways home, a search a seeker. False: stopped. */
static bool measure_home(qtr_game *game, const qtr_matrix_nodes *nodes, qtr_travel *travel) {
#if QTR_TERMS
  const qtr_mission *mission = game->mission;
  for (unsigned i = 0; comes_home(game) && i < mission->seekers; i++) {
    if (!qtr_watch_go_on(&mission->watch)) return false;
    qtr_matrix_fill_home(game->home + 4 * (size_t)i * game->board.places, nodes, mission->class_of[i],
                         mission->start[i], travel);
  }
#else
  (void)game;
  (void)nodes;
  (void)travel;
#endif
  return true;
}

/* The elemental tasks (section 4.1): the composite task, which is what is learnt, sees of the map these times alone.
 * False: stopped. */
static bool measure_travel(qtr_game *game, qtr_travel *travel) {
  qtr_cell start[QTR_MAX_SEEKERS];
  for (unsigned i = 0; i < game->board.starts; i++) start[i] = qtr_game_start_cell(game, i);
  const qtr_matrix_nodes nodes = nodes_of(game, start);
  game->used = (qtr_box){0, 0, 0, 0};
  game->measured = qtr_matrix_fill(game->steps, &nodes, travel, &game->used);
  return game->measured == game->mission->places && measure_home(game, &nodes, travel);
}

/* The same out of a board that has measured them. Later looks at a place take as long as the first. */
static void copy_travel(qtr_game *game, const qtr_board *known, const uint16_t *place, const uint16_t *start_of) {
  const unsigned places = game->board.places;
  uint8_t *at = game->steps;
  for (unsigned of_class = 0; of_class < game->mission->classes; of_class++) {
    for (unsigned node = 0; node < places + game->board.starts; node++) {
      const unsigned from =
          node < places ? place[qtr_game_place(game, node)] : known->places + start_of[game->first_at[node - places]];
      for (unsigned to = 0; to < places; to++, at += 4)
        qtr_store32(at, qtr_board_class_steps(known, of_class, from, place[qtr_game_place(game, to)]));
    }
  }
  game->used = (qtr_box){0, 0, 0, 0};
  game->measured = game->mission->places;
}

#if QTR_TERMS
/* A way costs the cells that it enters: back it enters its first one, and not its last. */
static void copy_home(qtr_game *game, const qtr_board *known, const uint16_t *place, const uint16_t *start_of) {
  const qtr_mission *mission = game->mission;
  for (unsigned i = 0; i < mission->seekers; i++) {
    const qtr_robot_class *of = &mission->robot_class[mission->class_of[i]];
    const qtr_steps at_start = of->cell_steps * mission->cost[mission->start[i]];
    for (unsigned p = 0; p < game->board.places; p++) {
      const unsigned to = qtr_game_place(game, p);
      const qtr_steps out =
          qtr_board_class_steps(known, mission->class_of[i], (unsigned)known->places + start_of[i], place[to]);
      const qtr_steps at_place = of->scan[to] + of->cell_steps * mission->cost[mission->place[to]];
      qtr_store32(game->home + 4 * ((size_t)i * game->board.places + p),
                  out == QTR_NEVER ? QTR_NEVER : out + at_start - at_place);
    }
  }
}
#endif

/* Once more, over what was rounded: for the assertion alone. */
static double sum_of_probabilities(const qtr_game *game) {
  double sum = 0.0;
  for (unsigned place = 0; place < game->board.places; place++) sum += game->probability[place];
  return sum;
}

/* What a look finds that comes after `before` others: P q (1-q)^m. */
static double find_by_look(const qtr_mission *mission, unsigned place, unsigned before) {
  double probability = mission->weight[place] * mission->detection[place];
  for (unsigned i = 0; i < before; i++) probability *= 1.0 - mission->detection[place];
  return probability;
}

static unsigned looks_before(const qtr_game *game, unsigned look) {
  unsigned before = 0;
  for (unsigned other = 0; other < look; other++) before += qtr_game_place(game, other) == qtr_game_place(game, look);
  return before;
}

static double sum_of_weights(const qtr_mission *mission) {
  double sum = 0.0;
  for (unsigned place = 0; place < mission->places; place++) sum += mission->weight[place];
  return sum;
}

/* P = weight / sum of weights: what was told in any unit is a distribution (section 4.1). Of the looks' shares the sum
 * is W, what can be found at all. Returns it. */
static double set_probabilities(qtr_game *game) {
  const qtr_mission *mission = game->mission;
  double sum = 0.0;
  for (unsigned place = 0; place < game->board.places; place++) {
    const unsigned before = place < mission->places ? 0 : looks_before(game, place);
    game->probability[place] = find_by_look(mission, qtr_game_place(game, place), before);
    sum += game->probability[place];
  }
  for (unsigned place = 0; place < game->board.places; place++) game->probability[place] /= sum;
  /* P is a distribution (section 4.1): what is unvisited begins at 1 and ends at 0. */
  QTR_ASSERT(fabs(sum_of_probabilities(game) - 1.0) < ROUNDING);
  return sum / sum_of_weights(mission);
}

/* ---- the field's terms ---- */

/* The latest end of a seeker's endurance; 0 if none has one. */
static qtr_steps set_ends(qtr_game *game) {
  const qtr_mission *mission = game->mission;
  qtr_steps latest = 0;
  game->board.terms.end = NULL;
  game->board.terms.ready = NULL;
  (void)mission;
#if QTR_TERMS
  for (unsigned i = 0; i < mission->seekers; i++) {
    const qtr_steps endurance = mission->robot_class[mission->class_of[i]].endurance;
    qtr_steps end = QTR_NEVER;
    if (endurance != QTR_NEVER) {
      end = endurance < QTR_NEVER - 1 - mission->ready[i] ? mission->ready[i] + endurance : QTR_NEVER - 1;
      game->board.terms.end = game->end;
      if (end > latest) latest = end;
    }
    qtr_store32(game->end + 4 * i, end);
    qtr_store32(game->ready + 4 * i, mission->ready[i]);
    if (mission->ready[i] > 0) game->board.terms.ready = game->ready;
  }
#endif
  return latest;
}

/* What the board and the objective make of the mission's terms, before there are any travel times. */
static void set_terms(qtr_game *game) {
  const qtr_mission *mission = game->mission;
  qtr_terms *terms = &game->board.terms;
  qtr_objective_terms worth = {.findable = 1.0};
  worth.end = set_ends(game);
  const double findable = set_probabilities(game);
  for (unsigned place = 0; place < mission->places; place++)
    if (mission->detection[place] < 1.0) worth.findable = findable;
  if (mission->aim.home_weight > 0.0)
    worth.home_weight = mission->aim.home_weight / sum_of_weights(mission) / worth.findable;
  qtr_objective_init(&game->objective, &mission->aim, &worth);
  game->board.classes = mission->classes;
  for (unsigned i = 0; i < mission->seekers; i++) game->board.class_of[i] = mission->class_of[i];
  terms->rules = comes_home(game) ? QTR_BY_HOME : 0;
  /* With an end a place may be worth less than the longer way home. Without one all must be visited, and who alone can
   * visit what is left has to go in any play. */
  if (worth.home_weight > 0.0 && terms->end != NULL) terms->rules |= QTR_ANYONE_MAY_LEAVE;
  terms->clock = qtr_objective_last_clock(&game->objective);
  terms->home = NULL;
#if QTR_TERMS
  if (terms->end != NULL) terms->home = game->home;
#endif
}

qtr_steps qtr_game_way_home(const qtr_game *game, unsigned seeker, unsigned node) {
#if QTR_TERMS
  if (comes_home(game) && node < game->board.places)
    return qtr_load32(game->home + 4 * ((size_t)seeker * game->board.places + node));
#endif
  (void)game;
  (void)seeker;
  (void)node;
  return 0;
}

unsigned qtr_game_seekers_out(const qtr_game *game, const qtr_joint *joint) {
  unsigned out = 0;
  if (game->objective.terms.home_weight == 0.0) return 0;
  for (unsigned i = 0; i < game->board.seekers; i++) out += joint->node[i] != QTR_STAND_DOWN;
  return out;
}

/* Nobody goes home on the way, so the nodes are still those of before; who was not ready is at home when it is. */
double qtr_game_leave(const qtr_game *game, const qtr_joint *before, const qtr_joint *after, qtr_steps passed) {
  double worth = 0.0;
  if (game->objective.terms.home_weight == 0.0) return 0.0;
  for (unsigned i = 0; i < game->board.seekers; i++) {
    if (before->node[i] == QTR_STAND_DOWN || after->node[i] != QTR_STAND_DOWN) continue;
    const qtr_steps left = before->remaining[i] > passed ? before->remaining[i] - passed : 0;
    worth += qtr_objective_leave(&game->objective, left + qtr_game_way_home(game, i, before->node[i]));
  }
  return worth;
}

static qtr_steps steps_at_first(const qtr_game *game, unsigned seeker, unsigned place) {
  return qtr_board_steps(&game->board, seeker, (unsigned)game->board.places + game->board.start_of[seeker], place);
}

bool qtr_game_reachable(const qtr_game *game, unsigned place) {
  for (unsigned i = 0; i < game->board.seekers; i++)
    if (steps_at_first(game, i, place) != QTR_NEVER) return true;
  return false;
}

/* Step at which a seeker can have searched a place if it goes there first; QTR_NEVER if it cannot, or not be home in
 * time. */
static qtr_steps searched_at_first(const qtr_game *game, unsigned seeker, unsigned place) {
  const qtr_steps way = steps_at_first(game, seeker, place);
  if (way == QTR_NEVER) return QTR_NEVER;
  const qtr_steps when = qtr_board_ready(&game->board, seeker) + way;
  if (game->board.terms.end == NULL) return when;
  const qtr_steps home = qtr_game_way_home(game, seeker, place);
  return home != QTR_NEVER && when + home <= qtr_board_end(&game->board, seeker) ? when : QTR_NEVER;
}

/* The place that a seeker can have searched first. */
static unsigned nearest_place(const qtr_game *game, qtr_steps *steps) {
  unsigned nearest = 0;
  *steps = QTR_NEVER;
  for (unsigned i = 0; i < game->board.seekers; i++) {
    for (unsigned place = 0; place < game->board.places; place++) {
      const qtr_steps way = searched_at_first(game, i, place);
      if (way >= *steps) continue;
      *steps = way;
      nearest = place;
    }
  }
  return nearest;
}

/* Whether there is anything in reach that counts: in the time that there is, and to be told from nothing, for
 * gamma^(t-1) of the nearest place is the most that any game keeps of its rewards. */
static int check_worth(const qtr_game *game, int *culprit) {
  qtr_steps steps;
  const unsigned nearest = nearest_place(game, &steps);
  if (culprit != NULL) *culprit = (int)nearest;
  if (steps == QTR_NEVER) return QTR_ERR_HORIZON;
  if (game->objective.kind == QTR_DEADLINE && steps > game->objective.deadline) return QTR_ERR_HORIZON;
  return qtr_objective_tells(&game->objective, steps) ? QTR_OK : QTR_ERR_DISCOUNT;
}

/* On ground that its class may not enter a seeker would have no way back. */
static int check_starts(const qtr_mission *mission, int *culprit) {
  for (unsigned i = 0; i < mission->seekers; i++) {
    const qtr_grid grid = qtr_matrix_grid(mission, mission->class_of[i]);
    if (culprit != NULL) *culprit = (int)i;
    if (qtr_grid_cost(&grid, mission->start[i]) == 0) return QTR_ERR_START;
  }
  return QTR_OK;
}

/* Everything but travel times. False if the looks are more than the build holds. */
static bool set_up(qtr_game *game, const qtr_mission *mission) {
  game->mission = mission;
  game->by_legs = false;
  game->board.seekers = mission->seekers;
  game->board.rule = mission->rule;
  game->board.step_bytes = 4;
  game->board.steps = game->steps;
  find_starts(game);
  if (!list_looks(game)) return false;
  set_terms(game);
  return true;
}

/* The same on a map. */
static int begin(qtr_game *game, const qtr_mission *mission, int *culprit) {
  const int status = check_starts(mission, culprit);
  if (status != QTR_OK) return status;
  return set_up(game, mission) ? QTR_OK : QTR_ERR_LIMIT;
}

/* Once there are travel times. */
static int finish(qtr_game *game, int *culprit) {
  for (unsigned place = 0; place < game->mission->places; place++) {
    if (qtr_game_reachable(game, place)) continue;
    if (culprit != NULL) *culprit = (int)place;
    return QTR_ERR_UNREACHABLE;
  }
  const int status = check_worth(game, culprit);
  return status == QTR_OK ? qtr_board_init(&game->board) : status;
}

int qtr_game_init_built(qtr_game *game, const qtr_mission *mission, qtr_travel *travel, int *culprit,
                        uint32_t config_id) {
  if (config_id != QTR_CONFIG_ID) return QTR_ERR_CONFIG;
  const int status = begin(game, mission, culprit);
  if (status != QTR_OK) return status;
  return measure_travel(game, travel) ? finish(game, culprit) : QTR_ERR_STOPPED;
}

int qtr_game_init_known_built(qtr_game *game, const qtr_mission *mission, const qtr_board *known, const uint16_t *place,
                              const uint16_t *start_of, uint32_t config_id) {
  if (config_id != QTR_CONFIG_ID) return QTR_ERR_CONFIG;
  const int status = begin(game, mission, NULL);
  if (status != QTR_OK) return status;
  copy_travel(game, known, place, start_of);
#if QTR_TERMS
  if (comes_home(game)) copy_home(game, known, place, start_of);
#endif
  return finish(game, NULL);
}

/* ---- legs ---- */

/* A place to which legs are no more than steps: no scans there, no second looks, nobody keeps out. */
static bool is_for_legs(const qtr_mission *mission, unsigned place) {
  const qtr_robot_class *all = &mission->robot_class[0];
  const bool looked_at_again = mission->looks[place] > 1 && mission->detection[place] < 1.0;
  return all->scan[place] == 0 && !qtr_places_has(&all->avoided, place) && !looked_at_again;
}

static bool is_apart(const qtr_mission *mission, const qtr_legs *legs, unsigned place) {
  for (unsigned from = 0; from < mission->places; from++)
    if (from != place && legs->steps[(size_t)from * mission->places + place] == 0) return false;
  return true;
}

static bool seekers_are_for_legs(const qtr_mission *mission, const qtr_legs *legs) {
  const bool come_home = mission->aim.home_weight > 0.0 || mission->robot_class[0].endurance != QTR_NEVER;
  for (unsigned i = 0; i < mission->seekers; i++)
    if (mission->start[i] >= legs->starts) return false;
  return mission->classes == 1 && (!come_home || legs->home != NULL);
}

/* Of the terms those alone that need no map and leave one matrix for all. */
static int check_legs(const qtr_mission *mission, const qtr_legs *legs, int *culprit) {
  if (mission->places > QTR_MAX_PLACES || mission->seekers > QTR_MAX_SEEKERS) return QTR_ERR_LIMIT;
  if (qtr_mission_cells(mission) != 0 || mission->rule != QTR_RULE_FREE) return QTR_ERR_ARGUMENT;
  if (!seekers_are_for_legs(mission, legs)) return QTR_ERR_ARGUMENT;
  for (unsigned place = 0; place < mission->places; place++) {
    if (culprit != NULL) *culprit = (int)place;
    if (!is_for_legs(mission, place) || !is_apart(mission, legs, place)) return QTR_ERR_ARGUMENT;
  }
  return QTR_OK;
}

/* A seeker's start among the legs'. */
static const qtr_steps *start_row(const qtr_game *game, const qtr_steps *rows, unsigned seeker) {
  return rows + (size_t)game->mission->start[seeker] * game->board.places;
}

static void copy_legs(qtr_game *game, const qtr_legs *legs) {
  const unsigned places = game->board.places;
  const qtr_steps *starts = legs->steps + (size_t)places * places;
  uint8_t *at = game->steps;
  for (unsigned node = 0; node < places + game->board.starts; node++) {
    const qtr_steps *row =
        node < places ? legs->steps + (size_t)node * places : start_row(game, starts, game->first_at[node - places]);
    for (unsigned to = 0; to < places; to++, at += 4) qtr_store32(at, node == to ? 0 : row[to]);
  }
#if QTR_TERMS
  for (unsigned i = 0; comes_home(game) && i < game->board.seekers; i++)
    for (unsigned place = 0; place < places; place++)
      qtr_store32(game->home + 4 * ((size_t)i * places + place), start_row(game, legs->home, i)[place]);
#endif
}

int qtr_game_init_legs_built(qtr_game *game, const qtr_mission *mission, const qtr_legs *legs, int *culprit,
                             uint32_t config_id) {
  if (config_id != QTR_CONFIG_ID) return QTR_ERR_CONFIG;
  const int status = check_legs(mission, legs, culprit);
  if (status != QTR_OK) return status;
  if (!set_up(game, mission)) return QTR_ERR_LIMIT;
  copy_legs(game, legs);
  game->by_legs = true;
  game->used = (qtr_box){0, 0, 0, 0};
  game->measured = mission->places;
  return finish(game, culprit);
}

/* ---- rewards ---- */

/* Looks at a place count in the order in which they are made, whichever was meant to come first. */
static void sort_looks(const qtr_game *game, qtr_steps *visit) {
  const unsigned places = game->board.places;
  for (unsigned place = game->mission->places; place < places; place++) {
    for (unsigned before = 0; before < place; before++) {
      if (qtr_game_place(game, before) != qtr_game_place(game, place) || visit[before] <= visit[place]) continue;
      const qtr_steps sooner = visit[place];
      visit[place] = visit[before];
      visit[before] = sooner;
    }
  }
}

/* From visits alone and not from the course of play, so that games and routes are scored by one sum, in one order. */
void qtr_game_score(const qtr_game *game, const qtr_steps *visit, uint64_t home, qtr_score *score) {
  qtr_steps when[QTR_MAX_PLACES];
  for (unsigned place = 0; place < game->board.places; place++) when[place] = visit[place];
  sort_looks(game, when);
  qtr_objective_score(&game->objective, score, game->probability, when, game->board.places, home);
}

/* ---- play ---- */

/* A place on a start cell is unvisited until somebody chooses it: that takes no time, and is still a choice. */
void qtr_game_start(const qtr_game *game, qtr_state *state) {
  qtr_joint_start(&state->joint, &game->board, NULL, NULL);
  state->unvisited = 1.0;
}

/* Let `passed` steps, one or more, go by in an outcome; at their end the places in `arrived` are visited. */
static void collect(const qtr_game *game, qtr_state *state, qtr_outcome *outcome, qtr_steps passed,
                    const qtr_places *arrived, const qtr_joint *before) {
  double probability = 0.0;
  for (unsigned place = 0; place < game->board.places; place++)
    if (qtr_places_has(arrived, place)) probability += game->probability[place];
  qtr_objective_wait(&game->objective, outcome, state->unvisited, qtr_game_seekers_out(game, before), passed);
  qtr_objective_collect(&game->objective, outcome, probability, passed, passed);
  outcome->reward += qtr_game_leave(game, before, &state->joint, passed);
  qtr_objective_pass(&game->objective, outcome, passed);
  state->unvisited -= probability;
  /* No place is taken off twice: a likelihood below 0 would earn by waiting. */
  QTR_ASSERT(state->unvisited > -ROUNDING);
}

/* Q(s,a) = max Q(s',a') where no time passes: a choice earns nothing by itself, but for a place that is reached in 0
 * steps; and it costs the way home of those who have nothing left to choose. */
double qtr_game_choose(const qtr_game *game, qtr_state *state, int seeker, uint16_t choice) {
  const qtr_joint before = state->joint;
  const bool visited = qtr_joint_choose(&state->joint, &game->board, seeker, choice);
  const double home = qtr_game_leave(game, &before, &state->joint, 0);
  if (!visited) return home;
  state->unvisited -= game->probability[choice];
  return home + qtr_objective_at_once(&game->objective, game->probability[choice], state->joint.now);
}

/* Stretch by stretch, each as long as the least travel time left, until a seeker is idle that has a choice: for the
 * backup they are one transition, tau their sum. */
void qtr_game_pass(const qtr_game *game, qtr_state *state, qtr_outcome *outcome) {
  qtr_objective_begin(outcome, state->joint.now);
  while (qtr_joint_chooser(&state->joint, &game->board) == QTR_NOBODY) {
    const qtr_joint before = state->joint;
    qtr_places arrived;
    qtr_places_clear(&arrived);
    const qtr_steps passed = qtr_joint_advance(&state->joint, &game->board, &arrived);
    if (passed == 0) {
      qtr_objective_end(&game->objective, outcome, state->unvisited);
      break;
    }
    collect(game, state, outcome, passed, &arrived, &before);
  }
}

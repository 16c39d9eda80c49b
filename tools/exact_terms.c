/* A plan is a list of places for each seeker: it goes from one to the next without waiting, takes a look at each when
 * it gets there, and is out of the game after the last. Which of a place's looks a look is depends on all that the
 * others do, so the joint game is searched, in the order of time: a recursion over its states, each solved once.
 *
 * - A state has the looks made at each place and, of each seeker, the node that it is bound for and the step at which
 *   its look there ends. The earliest of these is next (the lower seeker on a tie): its look is the next one at its
 *   place, which tells what it counts, and the seeker chooses where to go on to, or to leave the game.
 * - Not more seekers are bound for a place than it has looks left.
 * - Time is counted from the mission's start throughout, so that endurance and a deadline need nothing of their own. */
#include "exact_terms.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "exact_ways.h"

enum { SEEKERS = EXACT_TERMS_SEEKERS, LOOKS = EXACT_TERMS_LOOKS, OUT = 0xFF, NOBODY = -1 };
static const size_t state_limit = 6000000; /* some seconds, some 300 MB */

/* Without padding: it is its own key. */
typedef struct {
  qtr_steps free_at[SEEKERS]; /* 0 for who is out of the game */
  uint8_t node[SEEKERS];      /* a place, `places` for the start, OUT */
  uint8_t made[LOOKS];        /* looks at each place; 0 beyond the places */
  uint16_t is_one;            /* 0: a slot without a state */
} look_state;
_Static_assert(sizeof(look_state) == SEEKERS * (sizeof(qtr_steps) + 1) + LOOKS + 2, "padding in a key");

typedef struct {
  look_state state;
  double value;
} state_slot;

typedef struct {
  const qtr_mission *mission;
  int places, seekers;
  exact_ways ways;
  double worth[LOOKS][LOOKS]; /* what the m-th look at a place counts: P q (1-q)^m, from 0 */
  double findable;            /* all of them */
  double home_weight;         /* beside shares of 1 */
  bool all_looks;             /* leaving a look out is no play */
  uint64_t end[SEEKERS];      /* when each must be home; UINT64_MAX: never */
  double last_end;            /* expected time with endurance: the latest of them, when what is left is counted */
  exact_solution *solution;   /* NULL but when the solution is played back */
  state_slot *table;
  size_t slots, used;
  bool full;
} look_game;

/* ---- which missions ---- */

/* That can find something: where the first finds what is there, there is no second. */
static int looks_of(const qtr_mission *mission, int place) {
  return mission->detection[place] < 1 ? mission->looks[place] : 1;
}

static bool has_looks(const qtr_mission *mission) {
  for (int p = 0; p < mission->places; p++)
    if (mission->detection[p] < 1) return true;
  return false;
}

static bool is_of_note(const qtr_robot_class *kind, int places) {
  if (kind->cell_steps != 1 || kind->smooth_only || kind->endurance != QTR_NEVER) return true;
  for (int p = 0; p < places; p++)
    if (kind->scan[p] > 0 || qtr_places_has(&kind->avoided, (unsigned)p)) return true;
  return false;
}

bool exact_has_terms(const qtr_mission *mission) {
  if (mission->aim.kind == QTR_DEADLINE || mission->aim.home_weight > 0 || has_looks(mission)) return true;
  for (int i = 0; i < mission->seekers; i++)
    if (mission->ready[i] > 0 || is_of_note(&mission->robot_class[mission->class_of[i]], mission->places)) return true;
  return false;
}

int exact_check_terms(const qtr_mission *mission, fault *why) {
  int looks = 0;
  for (int p = 0; p < mission->places; p++) looks += looks_of(mission, p);
  if (mission->rule != QTR_RULE_FREE)
    return fault_set(why,
                     "exact: the paper's rule knows none of the mission's terms (classes, scan times, looks, ready "
                     "times, endurance, deadline, coming home); use --rule free");
  if (mission->seekers <= SEEKERS && looks <= LOOKS) return 0;
  return fault_set(
      why,
      "exact: %d looks by %d seekers are too many where robots or places differ: it takes %d looks in all, "
      "a place one or more, and %d seekers; use `quarter learn`, which certifies its result too",
      looks, mission->seekers, LOOKS, SEEKERS);
}

/* ---- the table of solved states ---- */

static state_slot *find_slot(const look_game *game, const look_state *state) {
  uint64_t word[sizeof *state / sizeof(uint64_t)], hash = 0;
  memcpy(word, state, sizeof word);
  for (size_t w = 0; w < sizeof word / sizeof *word; w++) {
    hash = (hash ^ word[w]) * 0x9E3779B97F4A7C15u;
    hash ^= hash >> 29;
  }
  for (size_t at = hash & (game->slots - 1);; at = (at + 1) & (game->slots - 1)) {
    state_slot *slot = &game->table[at];
    if (!slot->state.is_one || memcmp(&slot->state, state, sizeof *state) == 0) return slot;
  }
}

static bool grow(look_game *game) {
  state_slot *old = game->table, *larger = calloc(game->slots * 2, sizeof *larger);
  const size_t before = game->slots;
  if (larger == NULL) return false;
  game->table = larger;
  game->slots *= 2;
  for (size_t s = 0; s < before; s++)
    if (old[s].state.is_one) *find_slot(game, &old[s].state) = old[s];
  free(old);
  return true;
}

static void store(look_game *game, const look_state *state, double value) {
  if (game->used >= state_limit || (game->used * 4 >= game->slots * 3 && !grow(game))) game->full = true;
  if (game->full) return;
  *find_slot(game, state) = (state_slot){*state, value};
  game->used++;
}

/* ---- what counts ---- */

static double discounted(const look_game *game, double worth, qtr_steps when) {
  return QTR_REWARD_SCALE * worth * pow(game->mission->aim.gamma, when > 0 ? when - 1.0 : 0);
}

/* To be maximised: what a look earns that counts `worth` and ends at `when`. */
static double look_value(const look_game *game, double worth, qtr_steps when) {
  if (game->mission->aim.kind == QTR_DISCOUNTED) return discounted(game, worth, when);
  if (game->mission->aim.kind == QTR_DEADLINE) return when <= game->mission->aim.deadline ? worth : 0;
  return worth * (game->last_end - when);
}

static double leaving_value(const look_game *game, int seeker, int node, qtr_steps now) {
  return -game->home_weight * ((double)now + game->ways.home[seeker][node]);
}

/* ---- the game ---- */

static int next_seeker(const look_game *game, const look_state *state) {
  int next = NOBODY;
  for (int i = 0; i < game->seekers; i++) {
    if (state->node[i] == OUT) continue;
    if (next == NOBODY || state->free_at[i] < state->free_at[next]) next = i;
  }
  return next;
}

/* Whether a look at the place is left for the seeker: neither made nor under way. */
static bool is_left(const look_game *game, const look_state *state, int seeker, int place) {
  int looks = state->made[place];
  for (int i = 0; i < game->seekers; i++) looks += i != seeker && state->node[i] == place;
  return looks < looks_of(game->mission, place);
}

/* When a seeker's look would end that goes on to a place; QTR_NEVER: it may not. */
static qtr_steps arrival(const look_game *game, const look_state *state, int seeker, int place) {
  const qtr_steps leg = game->ways.leg[seeker][state->node[seeker]][place];
  if (leg == QTR_NEVER) return QTR_NEVER;
  const qtr_steps when = state->free_at[seeker] + leg;
  if (game->mission->aim.kind == QTR_DEADLINE && when > game->mission->aim.deadline) return QTR_NEVER;
  if (game->end[seeker] != UINT64_MAX && (uint64_t)when + game->ways.home[seeker][place] > game->end[seeker])
    return QTR_NEVER;
  return when;
}

/* The seeker's look is made. Returns what it earns. */
static double make_look(look_game *game, look_state *state, int seeker) {
  const int place = state->node[seeker];
  if (place == game->places) return 0;
  const int look = state->made[place]++;
  if (game->solution != NULL) {
    const int count = game->solution->length[seeker]++;
    game->solution->route[seeker][count] = (uint16_t)place;
    game->solution->step[seeker][count] = state->free_at[seeker];
    game->solution->look[seeker][count] = (uint8_t)(look + 1);
  }
  return look_value(game, game->worth[place][look], state->free_at[seeker]);
}

/* ---- the most that can come, so that what is worth less than another choice need not be looked into ---- */

/* When a look at the place can end at the earliest, by whoever gets there soonest; QTR_NEVER: nobody does. */
static qtr_steps soonest(const look_game *game, const look_state *state, int place) {
  qtr_steps least = QTR_NEVER;
  for (int i = 0; i < game->seekers; i++) {
    if (state->node[i] == OUT) continue;
    const qtr_steps leg = state->node[i] == place ? 0 : game->ways.leg[i][state->node[i]][place];
    if (leg != QTR_NEVER && state->free_at[i] + leg < least) least = state->free_at[i] + leg;
  }
  return least;
}

/* All looks that are left, each when the first can be, or left out where that earns more. */
static double most_to_come(const look_game *game, const look_state *state) {
  double most = 0;
  for (int p = 0; p < game->places; p++) {
    const qtr_steps when = soonest(game, state, p);
    const int looks = when == QTR_NEVER ? 0 : looks_of(game->mission, p);
    for (int m = state->made[p]; m < looks; m++) {
      const double value = look_value(game, game->worth[p][m], when);
      most += game->all_looks ? value : fmax(value, 0);
    }
  }
  for (int i = 0; i < game->seekers; i++) most -= game->home_weight * state->free_at[i];
  return most;
}

/* ---- the search ---- */

typedef struct {
  look_state next;
  double at_once, most; /* what it earns itself, and that with all that can come after it */
} look_choice;

/* Into a list whose best promise stands first. */
static void add_choice(look_choice *list, int *count, look_choice added) {
  int at = (*count)++;
  for (; at > 0 && list[at - 1].most < added.most; at--) list[at] = list[at - 1];
  list[at] = added;
}

/* All that a seeker can do whose look is made: go on, or leave the game. Returns how many. */
static int list_choices(const look_game *game, const look_state *from, int seeker, look_choice *list) {
  int count = 0;
  look_choice choice = {.next = *from};
  for (int p = 0; p < game->places; p++) {
    const qtr_steps when = is_left(game, from, seeker, p) ? arrival(game, from, seeker, p) : QTR_NEVER;
    if (when == QTR_NEVER) continue;
    choice.next.node[seeker] = (uint8_t)p;
    choice.next.free_at[seeker] = when;
    choice.most = most_to_come(game, &choice.next);
    add_choice(list, &count, choice);
  }
  choice.next.node[seeker] = OUT;
  choice.next.free_at[seeker] = 0;
  choice.at_once = leaving_value(game, seeker, from->node[seeker], from->free_at[seeker]);
  choice.most = choice.at_once + most_to_come(game, &choice.next);
  add_choice(list, &count, choice);
  return count;
}

static double solve(look_game *game, const look_state *state);

/* What is still to come at best, and the state once the seeker has chosen. Of equals the first: of two promises alike
 * it goes on rather than to leave. */
static double best_choice(look_game *game, const look_state *from, int seeker, look_state *chosen) {
  look_choice list[LOOKS + 1];
  const int count = list_choices(game, from, seeker, list);
  double best = -INFINITY;
  *chosen = list[0].next;
  for (int c = 0; c < count && list[c].most >= best; c++) {
    const double value = list[c].at_once + solve(game, &list[c].next);
    if (value <= best) continue;
    best = value;
    *chosen = list[c].next;
  }
  return best;
}

static double end_value(const look_game *game, const look_state *state) {
  for (int p = 0; p < game->places; p++)
    if (game->all_looks && state->made[p] < looks_of(game->mission, p)) return -INFINITY;
  return 0;
}

static double solve(look_game *game, const look_state *state) {
  const int seeker = next_seeker(game, state);
  if (game->full) return 0;
  if (seeker == NOBODY) return end_value(game, state);
  const state_slot *slot = find_slot(game, state);
  if (slot->state.is_one) return slot->value;
  look_state after = *state, chosen;
  double value = make_look(game, &after, seeker);
  value += best_choice(game, &after, seeker, &chosen);
  store(game, state, value);
  return value;
}

static void play(look_game *game, look_state state, exact_solution *solution) {
  for (int seeker; (seeker = next_seeker(game, &state)) != NOBODY;) {
    look_state chosen;
    game->solution = solution;
    make_look(game, &state, seeker);
    game->solution = NULL;
    best_choice(game, &state, seeker, &chosen);
    state = chosen;
  }
}

/* ---- a mission made ready ---- */

static void set_worths(look_game *game) {
  const qtr_mission *mission = game->mission;
  double largest = 0, sum = 0;
  for (int p = 0; p < game->places; p++) largest = fmax(largest, mission->weight[p]);
  for (int p = 0; p < game->places; p++) sum += mission->weight[p] / largest;
  for (int p = 0; p < game->places; p++) {
    double left = mission->weight[p] / largest / sum;
    for (int m = 0; m < looks_of(mission, p); m++) {
      game->worth[p][m] = left * mission->detection[p];
      game->findable += game->worth[p][m];
      left -= game->worth[p][m];
    }
  }
  game->home_weight = mission->aim.kind == QTR_TIME ? mission->aim.home_weight / largest / sum : 0;
}

/* Robots with endurance and robots without are not played for one expected time. */
static int set_ends(look_game *game, fault *why) {
  const qtr_mission *mission = game->mission;
  int tiring = 0;
  for (int i = 0; i < game->seekers; i++) {
    const qtr_steps endurance = mission->robot_class[mission->class_of[i]].endurance;
    game->end[i] = endurance == QTR_NEVER ? UINT64_MAX : (uint64_t)mission->ready[i] + endurance;
    if (endurance == QTR_NEVER) continue;
    tiring++;
    game->last_end = fmax(game->last_end, (double)game->end[i]);
  }
  game->all_looks = mission->aim.kind == QTR_TIME && tiring == 0;
  if (mission->aim.kind != QTR_TIME || tiring == 0 || tiring == game->seekers) return 0;
  return fault_set(why, "exact: under expected time either all robots have endurance or none");
}

static int check_places(const look_game *game, fault *why) {
  for (int p = 0; p < game->places; p++) {
    bool reached = false;
    for (int i = 0; i < game->seekers; i++) reached |= game->ways.leg[i][game->places][p] != QTR_NEVER;
    if (!reached)
      return fault_set(why, "exact: no seeker can reach place %d; move it, remove it, or give --skip-unreachable", p);
  }
  return 0;
}

static int check_horizon(const look_game *game, const look_state *first, fault *why) {
  for (int i = 0; i < game->seekers; i++)
    for (int p = 0; p < game->places; p++)
      if (arrival(game, first, i, p) != QTR_NEVER) return 0;
  return fault_set(why, "exact: no seeker can search any place by the deadline, or within its endurance");
}

static void set_up_state(const look_game *game, look_state *first) {
  memset(first, 0, sizeof *first);
  first->is_one = 1;
  for (int i = 0; i < SEEKERS; i++) {
    first->node[i] = i < game->seekers ? (uint8_t)game->places : OUT;
    first->free_at[i] = i < game->seekers ? game->mission->ready[i] : 0;
  }
}

/* ---- the answer ---- */

static double time_of(const look_game *game, const exact_solution *solution) {
  double sum = 0;
  for (int i = 0; i < game->seekers; i++) {
    const int last = solution->length[i] - 1;
    for (int v = 0; v <= last; v++)
      sum += game->worth[solution->route[i][v]][solution->look[i][v] - 1] * solution->step[i][v];
    const int node = last < 0 ? game->places : solution->route[i][last];
    sum -= leaving_value(game, i, node, last < 0 ? game->mission->ready[i] : solution->step[i][last]);
  }
  return sum;
}

/* From the routes alone, so that all figures are exact whatever was optimised. */
static void evaluate(exact_solution *solution, const look_game *game) {
  const uint8_t kind = game->mission->aim.kind;
  for (int i = 0; i < game->seekers; i++) {
    for (int v = 0; v < solution->length[i]; v++) {
      const double worth = game->worth[solution->route[i][v]][solution->look[i][v] - 1];
      solution->value += discounted(game, worth, solution->step[i][v]);
      solution->found_probability += worth;
    }
  }
  const double found = solution->found_probability;
  const double left = game->all_looks ? 0 : game->findable - found;
  const double time = time_of(game, solution);
  solution->expected_time = kind == QTR_TIME ? (time + left * game->last_end) / game->findable : time / found;
  solution->objective = kind == QTR_TIME ? solution->expected_time : kind == QTR_DEADLINE ? found : solution->value;
}

static void count_negligible(exact_solution *solution, const look_game *game) {
  for (int i = 0; i < game->seekers; i++) {
    for (int v = 0; v < solution->length[i]; v++) {
      const double worth = game->worth[solution->route[i][v]][solution->look[i][v] - 1];
      const double steps = fmax(1, solution->step[i][v]);
      const double part = game->mission->aim.kind == QTR_DISCOUNTED ? discounted(game, worth, solution->step[i][v])
                          : game->mission->aim.kind == QTR_DEADLINE ? worth
                                                                    : worth * steps / game->findable;
      solution->negligible += part < QTR_NEGLIGIBLE * solution->objective;
    }
  }
}

static int search(look_game *game, exact_solution *solution, qtr_travel *travel, fault *why) {
  look_state first;
  set_worths(game);
  set_up_state(game, &first);
  if (set_ends(game, why) != 0 || exact_measure_ways(&game->ways, game->mission, travel, why) != 0) return -1;
  if (check_places(game, why) != 0 || check_horizon(game, &first, why) != 0) return -1;
  solve(game, &first);
  if (game->full)
    return fault_set(why, "exact: this mission has more than %lu joint states, which is its limit; use `quarter learn`",
                     (unsigned long)game->used);
  play(game, first, solution);
  evaluate(solution, game);
  count_negligible(solution, game);
  return 0;
}

int exact_solve_terms(exact_solution *solution, const qtr_mission *mission, qtr_travel *travel, fault *why) {
  if (exact_check_terms(mission, why) != 0) return -1;
  look_game *game = calloc(1, sizeof *game);
  int status = -1;
  if (game != NULL) {
    game->mission = mission;
    game->places = mission->places;
    game->seekers = mission->seekers;
    game->slots = 1024;
    game->table = calloc(game->slots, sizeof *game->table);
  }
  if (game == NULL || game->table == NULL)
    fault_set(why, "exact: out of memory; use `quarter learn`");
  else
    status = search(game, solution, travel, why);
  if (game != NULL) free(game->table);
  free(game);
  return status;
}

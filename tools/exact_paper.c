/* The paper's rule (section 4.2.2, Table 1): nobody stands down while there is a place to choose, so seekers hinder one
 * another by what they are bound for, and the whole joint game has to be searched: a recursion over its states, each
 * solved once.
 *
 * - An idle seeker chooses an unvisited place that no other seeker is bound for; when fewer places than seekers are
 *   left unvisited, any unvisited place. An idle seeker that has nothing to choose is out of the game.
 * - Whoever is bound for a place goes there, even if another gets there first. Then it earns nothing.
 * - Idle seekers choose one after another with no time passing: the one at the lowest node first, the starts counting
 *   as nodes after the places, the lower seeker on a tie.
 */
#include "exact_paper.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { PAPER_PLACES = EXACT_PAPER_PLACES, KEY_WORDS = 1 + QTR_MAX_SEEKERS, OUT = 0xFFFF };
static const size_t state_limit = 6000000; /* some 20 s, some 300 MB */

typedef struct {
  uint16_t node;  /* at it if nothing remains, else bound for it; OUT */
  uint16_t owner; /* which seeker this is; seekers with the same node and time are alike otherwise */
  qtr_steps remaining;
} seating;

typedef struct {
  uint32_t visited;
  seating seat[QTR_MAX_SEEKERS]; /* sorted by node, remaining time and owner */
} joint_state;

typedef struct {
  const exact_problem *problem;
  qtr_steps steps[PAPER_PLACES + QTR_MAX_SEEKERS][PAPER_PLACES]; /* from a node to a place */
  uint32_t reach[PAPER_PLACES + QTR_MAX_SEEKERS];                /* the places to which there is a way from a node */
  exact_solution *solution;                                      /* NULL but when the solution is played back */
  qtr_steps now;                                                 /* of the playback */
  uint64_t *table; /* slots of a key and the bits of a value; a key's first word is never 0 */
  size_t slots, used;
  bool full;
} joint_game;

/* ---- the table of solved states ---- */

static size_t slot_words(const joint_game *game) {
  return (size_t)game->problem->seekers + 2;
}

static void make_key(uint64_t key[KEY_WORDS], const joint_game *game, const joint_state *state) {
  key[0] = (uint64_t)1 << 63 | state->visited;
  for (int i = 0; i < game->problem->seekers; i++)
    key[i + 1] = (uint64_t)state->seat[i].node << 32 | state->seat[i].remaining;
}

static uint64_t *find_slot(const joint_game *game, const uint64_t *key) {
  const size_t words = slot_words(game), key_bytes = (words - 1) * sizeof *key;
  uint64_t hash = 0;
  for (size_t w = 0; w + 1 < words; w++) {
    hash = (hash ^ key[w]) * 0x9E3779B97F4A7C15u;
    hash ^= hash >> 29;
  }
  for (size_t at = hash & (game->slots - 1);; at = (at + 1) & (game->slots - 1)) {
    uint64_t *slot = game->table + at * words;
    if (slot[0] == 0 || memcmp(slot, key, key_bytes) == 0) return slot;
  }
}

static bool grow(joint_game *game) {
  const size_t words = slot_words(game), before = game->slots;
  uint64_t *old = game->table;
  uint64_t *larger = calloc(before * 2 * words, sizeof *old);
  if (larger == NULL) return false;
  game->table = larger;
  game->slots = before * 2;
  for (size_t s = 0; s < before; s++)
    if (old[s * words] != 0) memcpy(find_slot(game, old + s * words), old + s * words, words * sizeof *old);
  free(old);
  return true;
}

static void store(joint_game *game, const uint64_t *key, double value) {
  if (game->used >= state_limit || (game->used * 4 >= game->slots * 3 && !grow(game))) game->full = true;
  if (game->full) return;
  uint64_t *slot = find_slot(game, key);
  memcpy(slot, key, (slot_words(game) - 1) * sizeof *key);
  memcpy(slot + slot_words(game) - 1, &value, sizeof value);
  game->used++;
}

/* ---- the game ---- */

static uint32_t unvisited(const joint_game *game, const joint_state *state) {
  return (((uint32_t)1 << game->problem->places) - 1) & ~state->visited;
}

static double unvisited_share(const joint_game *game, const joint_state *state) {
  const uint32_t set = unvisited(game, state);
  double sum = 0;
  for (int p = 0; p < game->problem->places; p++)
    if (((set >> p) & 1) != 0) sum += game->problem->share[p];
  return sum;
}

/* The places, as bits, that a seeker at `node` may choose. */
static uint32_t choices(const joint_game *game, const joint_state *state, int node) {
  uint32_t set = unvisited(game, state);
  if (__builtin_popcount(set) >= game->problem->seekers)
    for (int i = 0; i < game->problem->seekers; i++)
      if (state->seat[i].remaining > 0) set &= ~((uint32_t)1 << state->seat[i].node);
  return set & game->reach[node];
}

static bool comes_before(const seating *a, const seating *b) {
  if (a->node != b->node) return a->node < b->node;
  if (a->remaining != b->remaining) return a->remaining < b->remaining;
  return a->owner < b->owner;
}

static void settle(const joint_game *game, joint_state *state) {
  for (int i = 0; i < game->problem->seekers; i++) {
    seating *seat = &state->seat[i];
    if (seat->node != OUT && seat->remaining == 0 && choices(game, state, seat->node) == 0) seat->node = OUT;
  }
  for (int i = 1; i < game->problem->seekers; i++) {
    const seating moved = state->seat[i];
    int at = i;
    for (; at > 0 && comes_before(&moved, &state->seat[at - 1]); at--) state->seat[at] = state->seat[at - 1];
    state->seat[at] = moved;
  }
}

static void visit(joint_game *game, joint_state *state, const seating *seat) {
  state->visited |= (uint32_t)1 << seat->node;
  if (game->solution == NULL) return;
  const int count = game->solution->length[seat->owner]++;
  game->solution->route[seat->owner][count] = seat->node;
  game->solution->step[seat->owner][count] = game->now;
}

/* The seat whose turn it is to choose, or -1. */
static int find_chooser(const joint_game *game, const joint_state *state) {
  for (int i = 0; i < game->problem->seekers; i++)
    if (state->seat[i].node != OUT && state->seat[i].remaining == 0) return i;
  return -1;
}

/* Returns what a visit on the spot earns. */
static double choose(joint_game *game, joint_state *state, int chooser, int place) {
  seating *seat = &state->seat[chooser];
  double earned = 0;
  seat->remaining = game->steps[seat->node][place];
  seat->node = (uint16_t)place;
  if (seat->remaining == 0) {
    visit(game, state, seat);
    if (game->problem->discounted) earned = exact_reward(game->problem, place, 0);
  }
  settle(game, state);
  return earned;
}

/* Time until the next arrival; 0 if nobody is under way. */
static qtr_steps time_to_arrival(const joint_game *game, const joint_state *state) {
  qtr_steps least = 0;
  for (int i = 0; i < game->problem->seekers; i++) {
    const qtr_steps remaining = state->seat[i].remaining;
    if (remaining > 0 && (least == 0 || remaining < least)) least = remaining;
  }
  return least;
}

/* Returns what the arrivals earn, discounted over the time that passes. */
static double advance(joint_game *game, joint_state *state, qtr_steps tau) {
  double earned = game->problem->discounted ? 0 : -(double)tau * unvisited_share(game, state);
  if (game->solution != NULL) game->now += tau;
  for (int i = 0; i < game->problem->seekers; i++) {
    seating *seat = &state->seat[i];
    if (seat->remaining == 0) continue;
    seat->remaining -= tau;
    if (seat->remaining > 0 || ((state->visited >> seat->node) & 1) != 0) continue;
    visit(game, state, seat);
    if (game->problem->discounted) earned += exact_reward(game->problem, seat->node, tau);
  }
  settle(game, state);
  return earned;
}

static double solve(joint_game *game, const joint_state *state);

static double best_choice(joint_game *game, const joint_state *from, int chooser, int *choice) {
  const uint32_t set = choices(game, from, from->seat[chooser].node);
  double best = -INFINITY;
  *choice = -1;
  for (int p = 0; p < game->problem->places; p++) {
    if (((set >> p) & 1) == 0) continue;
    joint_state next = *from;
    double value = choose(game, &next, chooser, p);
    value += solve(game, &next);
    if (value > best || *choice < 0) {
      best = value;
      *choice = p;
    }
  }
  return best;
}

static double pass_time(joint_game *game, const joint_state *from) {
  const qtr_steps tau = time_to_arrival(game, from);
  if (tau == 0) return -INFINITY; /* places are left over and nobody can visit them */
  joint_state next = *from;
  const double earned = advance(game, &next, tau);
  const double keep = game->problem->discounted ? exact_discount(game->problem, tau) : 1;
  return earned + keep * solve(game, &next);
}

/* The value from this state on. Only states with a choice are stored: the others have one successor each, and there are
 * many more of them. */
static double solve(joint_game *game, const joint_state *state) {
  uint64_t key[KEY_WORDS];
  double value;
  if (game->full || unvisited(game, state) == 0) return 0;
  const int chooser = find_chooser(game, state);
  if (chooser < 0) return pass_time(game, state);
  make_key(key, game, state);
  const uint64_t *slot = find_slot(game, key);
  if (slot[0] != 0) {
    memcpy(&value, slot + slot_words(game) - 1, sizeof value);
    return value;
  }
  int choice;
  value = best_choice(game, state, chooser, &choice);
  store(game, key, value);
  return value;
}

static void play(joint_game *game, joint_state *state, exact_solution *solution) {
  game->now = 0;
  while (unvisited(game, state) != 0) {
    const int chooser = find_chooser(game, state);
    int choice = -1;
    game->solution = NULL;
    if (chooser >= 0) best_choice(game, state, chooser, &choice);
    game->solution = solution;
    if (chooser >= 0)
      choose(game, state, chooser, choice);
    else
      advance(game, state, time_to_arrival(game, state));
  }
}

static void measure_ways(joint_game *game) {
  const int nodes = game->problem->places + game->problem->starts;
  for (int n = 0; n < nodes; n++) {
    for (int p = 0; p < game->problem->places; p++) {
      game->steps[n][p] = exact_steps(game->problem, n, p);
      if (game->steps[n][p] != QTR_NEVER) game->reach[n] |= (uint32_t)1 << p;
    }
  }
}

static int search(joint_game *game, exact_solution *solution, fault *why) {
  joint_state first = {.visited = 0};
  measure_ways(game);
  for (int i = 0; i < game->problem->seekers; i++)
    first.seat[i] =
        (seating){.node = (uint16_t)(game->problem->places + game->problem->start_of[i]), .owner = (uint16_t)i};
  settle(game, &first);
  const double value = solve(game, &first);
  if (game->full)
    return fault_set(why,
                     "exact: under the paper's rule this mission has more than %lu joint states, which "
                     "is its limit; use `quarter learn`, or --rule free",
                     (unsigned long)game->used);
  if (value == -INFINITY) return fault_set(why, "exact: no routes reach every place; remove the places cut off");
  play(game, &first, solution);
  return 0;
}

int exact_solve_paper(exact_solution *solution, const exact_problem *problem, fault *why) {
  joint_game game = {.problem = problem, .slots = 1024};
  game.table = calloc(game.slots * slot_words(&game), sizeof *game.table);
  if (game.table == NULL) return fault_set(why, "exact: out of memory; use `quarter learn`");
  const int status = search(&game, solution, why);
  free(game.table);
  return status;
}

/* The joint game once more, from the paper's rules alone, and its optimum by going through all plays: no keys, no
 * memory of states, no bounds, nothing of the core but the mission. For small games. */
#ifndef QUARTER_TESTS_BRUTE_H
#define QUARTER_TESTS_BRUTE_H

#include <math.h>

#include "missions.h"

enum { BRUTE_PLACES = 9, BRUTE_SEEKERS = 4, BRUTE_GONE = -1 };

typedef struct {
  unsigned visited; /* a bit a place */
  long now;
  int node[BRUTE_SEEKERS];  /* place, or places + number of the start; BRUTE_GONE: stood down */
  long left[BRUTE_SEEKERS]; /* steps to go */
} brute_state;

typedef struct brute_game {
  int places, seekers;
  bool paper, time;
  double gamma;
  double probability[BRUTE_PLACES];
  long way[BRUTE_PLACES + BRUTE_SEEKERS][BRUTE_PLACES]; /* -1: none */
  int start[BRUTE_SEEKERS];
  /* told, where set, of each state just after a choice and of what the visits to come are worth at best */
  void (*look)(const struct brute_game *game, const brute_state *after, double best);
} brute_game;

static inline void brute_measure(brute_game *game, int node, const qtr_mission *mission, qtr_cell cell) {
  static long steps[QTR_MAX_CELLS];
  flood(steps, mission, cell);
  for (int p = 0; p < game->places; p++) game->way[node][p] = steps[mission->place[p]];
}

static inline void brute_set_up(brute_game *game, const qtr_mission *mission) {
  double sum = 0.0;
  int starts = 0;
  memset(game, 0, sizeof *game);
  game->places = mission->places;
  game->seekers = mission->seekers;
  game->paper = mission->rule == QTR_RULE_PAPER;
  game->time = mission->aim.kind == QTR_TIME;
  game->gamma = mission->aim.gamma;
  for (int p = 0; p < game->places; p++) sum += mission->weight[p];
  for (int p = 0; p < game->places; p++) {
    game->probability[p] = mission->weight[p] / sum;
    brute_measure(game, p, mission, mission->place[p]);
  }
  for (int i = 0; i < game->seekers; i++) {
    int same = 0;
    while (mission->start[same] != mission->start[i]) same++;
    game->start[i] = same < i ? game->start[same] : game->places + starts++;
    brute_measure(game, game->start[i], mission, mission->start[i]);
  }
}

static inline double brute_worth(const brute_game *game, int place, long when) {
  if (game->time) return -game->probability[place] * (double)when;
  return 10.0 * game->probability[place] * pow(game->gamma, when > 0 ? (double)(when - 1) : 0.0);
}

static inline int brute_unvisited(const brute_game *game, const brute_state *state) {
  int count = 0;
  for (int p = 0; p < game->places; p++) count += !(state->visited >> p & 1u);
  return count;
}

/* Places that a seeker is on its way to. */
static inline unsigned brute_bound(const brute_game *game, const brute_state *state) {
  unsigned bound = 0;
  for (int i = 0; i < game->seekers; i++)
    if (state->left[i] > 0) bound |= 1u << state->node[i];
  return bound & ~state->visited;
}

static inline unsigned brute_reach(const brute_game *game, int node, unsigned places) {
  for (int p = 0; p < game->places; p++)
    if (game->way[node][p] < 0) places &= ~(1u << p);
  return places;
}

/* The places that a seeker at `node` may choose (Table 1). */
static inline unsigned brute_choices(const brute_game *game, const brute_state *state, int node) {
  const unsigned unvisited = ((1u << game->places) - 1) & ~state->visited;
  const unsigned any = brute_reach(game, node, unvisited);
  const unsigned own = any & ~brute_bound(game, state);
  if (!game->paper) return own;
  return brute_unvisited(game, state) < game->seekers || own == 0 ? any : own;
}

/* Who has nothing left to choose is out of the game. */
static inline void brute_settle(const brute_game *game, brute_state *state) {
  for (int i = 0; i < game->seekers; i++)
    if (state->node[i] != BRUTE_GONE && state->left[i] == 0 && brute_choices(game, state, state->node[i]) == 0)
      state->node[i] = BRUTE_GONE;
}

static inline void brute_begin(const brute_game *game, brute_state *state) {
  memset(state, 0, sizeof *state);
  for (int i = 0; i < game->seekers; i++) state->node[i] = game->start[i];
  brute_settle(game, state);
}

/* The idle seeker at the lowest node; -1 if none is idle. */
static inline int brute_chooser(const brute_game *game, const brute_state *state) {
  int chooser = -1;
  for (int i = 0; i < game->seekers; i++) {
    if (state->node[i] == BRUTE_GONE || state->left[i] > 0) continue;
    if (chooser < 0 || state->node[i] < state->node[chooser]) chooser = i;
  }
  return chooser;
}

/* Free rule: may stand down if the others can reach all that this one leaves. */
static inline bool brute_may_stand_down(const brute_game *game, const brute_state *state, int seeker) {
  unsigned left = brute_choices(game, state, state->node[seeker]);
  for (int i = 0; i < game->seekers; i++)
    if (i != seeker && state->node[i] != BRUTE_GONE) left &= ~brute_reach(game, state->node[i], left);
  return !game->paper && left == 0;
}

/* Choose a place or BRUTE_GONE; returns what is visited at once. */
static inline double brute_choose(const brute_game *game, brute_state *state, int seeker, int choice) {
  double worth = 0.0;
  if (choice == BRUTE_GONE) {
    state->node[seeker] = BRUTE_GONE;
  } else {
    state->left[seeker] = game->way[state->node[seeker]][choice];
    state->node[seeker] = choice;
    if (state->left[seeker] == 0) {
      state->visited |= 1u << choice;
      worth = brute_worth(game, choice, state->now);
    }
  }
  brute_settle(game, state);
  return worth;
}

static inline long brute_least_left(const brute_game *game, const brute_state *state) {
  long least = 0;
  for (int i = 0; i < game->seekers; i++)
    if (state->left[i] > 0 && (least == 0 || state->left[i] < least)) least = state->left[i];
  return least;
}

/* Let time pass until the next arrival; returns what is visited then. False in `*on`: nothing moves any more. */
static inline double brute_pass(const brute_game *game, brute_state *state, bool *on) {
  const long least = brute_least_left(game, state);
  double worth = 0.0;
  *on = least > 0 && brute_unvisited(game, state) > 0;
  if (!*on) return 0.0;
  state->now += least;
  for (int i = 0; i < game->seekers; i++) {
    if (state->left[i] == 0) continue;
    state->left[i] -= least;
    if (state->left[i] > 0 || (state->visited >> state->node[i] & 1u)) continue;
    state->visited |= 1u << state->node[i];
    worth += brute_worth(game, state->node[i], state->now);
  }
  brute_settle(game, state);
  return worth;
}

static inline double brute_best(const brute_game *game, const brute_state *state);

static inline double brute_after(const brute_game *game, const brute_state *state, int seeker, int choice) {
  brute_state after = *state;
  const double at_once = brute_choose(game, &after, seeker, choice);
  const double best = brute_best(game, &after);
  if (game->look != NULL) game->look(game, &after, best);
  return at_once + best;
}

/* What the visits still to come are worth at best, each by its step since the start of the game. */
static inline double brute_best(const brute_game *game, const brute_state *state) {
  const int seeker = brute_chooser(game, state);
  double best = -HUGE_VAL;
  if (seeker < 0) {
    bool on;
    brute_state later = *state;
    const double worth = brute_pass(game, &later, &on);
    if (on) return worth + brute_best(game, &later);
    return game->time && brute_unvisited(game, state) > 0 ? -HUGE_VAL : 0.0;
  }
  const unsigned choices = brute_choices(game, state, state->node[seeker]);
  for (int p = 0; p < game->places; p++)
    if (choices >> p & 1u) best = fmax(best, brute_after(game, state, seeker, p));
  if (brute_may_stand_down(game, state, seeker)) best = fmax(best, brute_after(game, state, seeker, BRUTE_GONE));
  return best;
}

/* The optimum of the whole game, to be maximised: value, or -expected time. */
static inline double brute_optimum(const brute_game *game) {
  brute_state start;
  brute_begin(game, &start);
  return brute_best(game, &start);
}

#endif

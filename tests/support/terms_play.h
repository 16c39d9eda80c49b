/* The joint game under the field's terms, played by the rules: looks as copies of their place that are fixed when they
 * are chosen, idle seekers that choose one after another, and who may stand down. Its optimum by going through all
 * plays: no keys, no memory of states, no bounds. Small games alone (support/terms_games.h). */
#ifndef QUARTER_TESTS_TERMS_PLAY_H
#define QUARTER_TESTS_TERMS_PLAY_H

#include "terms_brute.h"

enum { TERMS_GONE = -1 };

typedef struct {
  unsigned visited; /* a bit a node */
  long now;
  int node[TERMS_MOST_SEEKERS];     /* a copy, or copies + number of the start; TERMS_GONE: stood down */
  long free_at[TERMS_MOST_SEEKERS]; /* when it is there, its scan over; ready, before it is */
} terms_state;

typedef struct terms_game {
  terms_ways ways;
  int copies; /* the first looks are 0..places-1, then the second and third ones of each place in turn */
  int place_of[TERMS_MOST_LOOKS];
  double worth_of[TERMS_MOST_LOOKS];
  double all;              /* of the worths */
  bool needs_all, by_home; /* expected time without endurance; seekers of other homes are of other kinds */
  bool anyone_may_leave;   /* home weight beside endurance or forbidden places */
  bool always_leave;       /* the rule left out, for comparison */
  int start[TERMS_MOST_SEEKERS], kind[TERMS_MOST_SEEKERS];
  /* told, where set, of each state just after a choice and of what is still to come at best, as terms_gain() counts */
  void (*look)(const struct terms_game *game, const terms_state *after, double best);
} terms_game;

/* ---- a mission as a game ---- */

static inline void terms_add_copies(terms_game *game, int place, int first) {
  const qtr_mission *mission = game->ways.mission;
  for (int m = first; m < (first == 0 ? 1 : terms_looks_of_use(mission, place)); m++) {
    const double q = mission->detection[place];
    game->place_of[game->copies] = place;
    game->worth_of[game->copies] = mission->weight[place] / game->ways.total * q * pow(1.0 - q, m);
    game->all += game->worth_of[game->copies++];
  }
}

static inline bool terms_are_alike(const terms_game *game, int a, int b) {
  const qtr_mission *mission = game->ways.mission;
  if (mission->class_of[a] != mission->class_of[b]) return false;
  return !game->by_home || (mission->start[a] == mission->start[b] && mission->ready[a] == mission->ready[b]);
}

static inline void terms_name_seekers(terms_game *game) {
  const qtr_mission *mission = game->ways.mission;
  int starts = 0;
  for (int i = 0; i < mission->seekers; i++) {
    int same = 0;
    while (mission->start[same] != mission->start[i]) same++;
    game->start[i] = same < i ? game->start[same] : game->copies + starts++;
    game->kind[i] = 0;
    while (!terms_are_alike(game, game->kind[i], i)) game->kind[i]++;
  }
}

static inline void terms_set_up(terms_game *game, const qtr_mission *mission) {
  bool tires = false, forbidden = false;
  memset(game, 0, sizeof *game);
  terms_measure(&game->ways, mission);
  for (int p = 0; p < mission->places; p++) terms_add_copies(game, p, 0);
  for (int p = 0; p < mission->places; p++) terms_add_copies(game, p, 1);
  for (int i = 0; i < mission->seekers; i++) {
    tires |= terms_class(mission, i)->endurance != QTR_NEVER;
    for (int p = 0; p < mission->places; p++) forbidden |= game->ways.leg[i][mission->places][p] < 0;
  }
  game->needs_all = mission->aim.kind == QTR_TIME && !tires;
  game->by_home = tires || mission->aim.home_weight > 0.0;
  game->anyone_may_leave = mission->aim.home_weight > 0.0 && (tires || forbidden);
  terms_name_seekers(game);
}

/* ---- rules ---- */

/* A node of the game as one of the ways'. */
static inline int terms_spot(const terms_game *game, int node) {
  return node < game->copies ? game->place_of[node] : game->ways.mission->places;
}

static inline bool terms_is_idle(const terms_state *state, int seeker) {
  return state->node[seeker] != TERMS_GONE && state->free_at[seeker] <= state->now;
}

static inline unsigned terms_bound(const terms_game *game, const terms_state *state) {
  unsigned bound = 0;
  for (int i = 0; i < game->ways.mission->seekers; i++)
    if (state->node[i] != TERMS_GONE && state->node[i] < game->copies && state->free_at[i] > state->now)
      bound |= 1u << state->node[i];
  return bound;
}

/* When the look at a copy would end of a seeker that goes there next; -1: it is not feasible. */
static inline long terms_end_of(const terms_game *game, const terms_state *state, int seeker, int copy) {
  const long from = state->free_at[seeker] > state->now ? state->free_at[seeker] : state->now;
  return terms_arrival(&game->ways, seeker, terms_spot(game, state->node[seeker]), from, game->place_of[copy]);
}

static inline bool terms_is_alone(const terms_game *game, const terms_state *state, int seeker) {
  for (int i = 0; i < game->ways.mission->seekers; i++)
    if (i != seeker && state->node[i] != TERMS_GONE) return false;
  return true;
}

/* A seeker alone in the game takes of a place's copies the lowest. */
static inline unsigned terms_choices(const terms_game *game, const terms_state *state, int seeker) {
  const unsigned taken = state->visited | terms_bound(game, state);
  const bool alone = terms_is_alone(game, state, seeker);
  unsigned choices = 0, places = 0;
  for (int copy = 0; copy < game->copies; copy++) {
    if ((taken >> copy & 1u) || terms_end_of(game, state, seeker, copy) < 0) continue;
    if (!alone || !(places >> game->place_of[copy] & 1u)) choices |= 1u << copy;
    places |= 1u << game->place_of[copy];
  }
  return choices;
}

/* Not while some place among its choices is feasible for no other seeker in the game. */
static inline bool terms_may_leave(const terms_game *game, const terms_state *state, int seeker) {
  unsigned left = terms_choices(game, state, seeker);
  if (game->anyone_may_leave || game->always_leave) return true;
  for (int copy = 0; copy < game->copies; copy++)
    for (int i = 0; i < game->ways.mission->seekers; i++)
      if (i != seeker && state->node[i] != TERMS_GONE && terms_end_of(game, state, i, copy) >= 0) left &= ~(1u << copy);
  return left == 0;
}

/* The idle seeker lowest by node, kind and number; -1: none is. */
static inline int terms_chooser(const terms_game *game, const terms_state *state) {
  int chooser = -1;
  for (int i = 0; i < game->ways.mission->seekers; i++) {
    if (!terms_is_idle(state, i)) continue;
    const bool lower = chooser < 0 || state->node[i] < state->node[chooser] ||
                       (state->node[i] == state->node[chooser] && game->kind[i] < game->kind[chooser]);
    if (lower) chooser = i;
  }
  return chooser;
}

/* ---- what it earns, to be maximised ---- */

static inline double terms_gain(const terms_game *game, int copy, long when) {
  const qtr_mission *mission = game->ways.mission;
  const double worth = game->worth_of[copy];
  if (mission->aim.kind == QTR_DEADLINE) return when <= (long)mission->aim.deadline ? worth : 0.0;
  if (mission->aim.kind == QTR_DISCOUNTED) return 10.0 * worth * pow(mission->aim.gamma, fmax((double)when - 1.0, 0.0));
  return worth * (double)((game->needs_all ? 0 : terms_last_end(mission)) - when);
}

static inline double terms_leave(const terms_game *game, terms_state *state, int seeker) {
  const double weight = game->ways.mission->aim.home_weight / game->ways.total;
  const long home = game->ways.home[seeker][terms_spot(game, state->node[seeker])];
  state->node[seeker] = TERMS_GONE;
  return weight > 0.0 ? -weight * (double)(state->now + home) : 0.0;
}

/* ---- all plays ---- */

static inline double terms_play(const terms_game *game, const terms_state *state);

static inline double terms_choose(const terms_game *game, const terms_state *state, int seeker, int copy) {
  terms_state after = *state;
  double gain = 0.0;
  if (copy == TERMS_GONE) {
    gain = terms_leave(game, &after, seeker);
  } else {
    after.free_at[seeker] = terms_end_of(game, state, seeker, copy);
    after.node[seeker] = copy;
    if (after.free_at[seeker] == after.now) {
      after.visited |= 1u << copy;
      gain = terms_gain(game, copy, after.now);
    }
  }
  const double best = terms_play(game, &after);
  if (game->look != NULL) game->look(game, &after, best);
  return gain + best;
}

/* The step at which the next seeker is free; -1: all have stood down. */
static inline long terms_next_step(const terms_game *game, const terms_state *state) {
  long next = -1;
  for (int i = 0; i < game->ways.mission->seekers; i++)
    if (state->node[i] != TERMS_GONE && (next < 0 || state->free_at[i] < next)) next = state->free_at[i];
  return next;
}

/* Nobody is to choose: time passes until somebody is, or the game is over. */
static inline double terms_pass(const terms_game *game, const terms_state *state) {
  terms_state later = *state;
  double gain = 0.0;
  later.now = terms_next_step(game, state);
  if (later.now < 0) return game->needs_all && state->visited != (1u << game->copies) - 1u ? -HUGE_VAL : 0.0;
  for (int i = 0; i < game->ways.mission->seekers; i++) {
    const int copy = state->node[i];
    if (copy == TERMS_GONE || copy >= game->copies || state->free_at[i] != later.now) continue;
    later.visited |= 1u << copy;
    gain += terms_gain(game, copy, later.now);
  }
  return gain + terms_play(game, &later);
}

static inline double terms_play(const terms_game *game, const terms_state *state) {
  const int seeker = terms_chooser(game, state);
  if (seeker < 0) return terms_pass(game, state);
  const unsigned choices = terms_choices(game, state, seeker);
  double best = -HUGE_VAL;
  for (int copy = 0; copy < game->copies; copy++)
    if (choices >> copy & 1u) best = fmax(best, terms_choose(game, state, seeker, copy));
  if (choices == 0 || terms_may_leave(game, state, seeker))
    best = fmax(best, terms_choose(game, state, seeker, TERMS_GONE));
  return best;
}

/* The optimum of the whole game in the objective's own unit, as brute_force_value(). */
static inline double terms_play_value(const terms_game *game) {
  const qtr_mission *mission = game->ways.mission;
  terms_state start = {0};
  for (int i = 0; i < mission->seekers; i++) {
    start.node[i] = game->start[i];
    start.free_at[i] = (long)mission->ready[i];
  }
  const double best = terms_play(game, &start);
  if (mission->aim.kind != QTR_TIME) return best;
  return (game->needs_all ? 0.0 : (double)terms_last_end(mission)) - best / game->all;
}

#endif

#include "search/play.h"

#include <stddef.h>

#include "model/rounding.h"
#include "quarter/status.h"
#include "robot/board.h"

void qtr_play_begin(qtr_play *play) {
  play->choices = 0;
  for (unsigned place = 0; place < QTR_MAX_PLACES; place++) play->visit[place] = QTR_NEVER;
}

/* More choices than any game has, or numbers that are none, are not noted: a play never leads outside its arrays. */
void qtr_play_add(qtr_play *play, int seeker, uint16_t choice) {
  if (seeker < 0 || seeker >= QTR_MAX_SEEKERS || play->choices >= QTR_MAX_CHOICES) return;
  if (choice >= QTR_MAX_PLACES && choice != QTR_STAND_DOWN) return;
  play->seeker[play->choices] = (uint8_t)seeker;
  play->choice[play->choices++] = choice;
}

/* A place counts at its first visit: under the paper's rule two seekers may be bound for it, and the later choice may
 * come sooner. */
void qtr_play_score(qtr_play *play, const qtr_game *game) {
  qtr_state state;
  qtr_outcome outcome;
  qtr_steps home[QTR_MAX_SEEKERS];
  uint64_t all_home = 0;
  qtr_game_start(game, &state);
  qtr_game_pass(game, &state, &outcome);
  for (unsigned i = 0; i < game->board.seekers; i++) home[i] = qtr_board_ready(&game->board, i);
  for (unsigned i = 0; i < play->choices; i++) {
    const uint16_t choice = play->choice[i];
    /* A play is the choices of whose turn it was, so that playing them again is the same game. */
    QTR_ASSERT(qtr_joint_chooser(&state.joint, &game->board) == play->seeker[i]);
    if (choice != QTR_STAND_DOWN) {
      const qtr_steps when =
          state.joint.now + qtr_board_steps(&game->board, play->seeker[i], state.joint.node[play->seeker[i]], choice);
      if (when < play->visit[choice]) play->visit[choice] = when;
      home[play->seeker[i]] = when + qtr_game_way_home(game, play->seeker[i], choice);
    }
    qtr_game_choose(game, &state, play->seeker[i], choice);
    qtr_game_pass(game, &state, &outcome);
  }
  for (unsigned i = 0; i < game->board.seekers; i++) all_home += home[i];
  qtr_game_score(game, play->visit, all_home, &play->score);
}

/* Among the places that a seeker may choose, the most likely one for the way to it: P / d, the greedy rule of search
 * theory, as robots have it off their table. At no distance d counts for half a step. */
static uint16_t best_rate(const qtr_game *game, const qtr_state *state, int seeker, const qtr_places *choices) {
  uint16_t choice = QTR_STAND_DOWN;
  double best = -1.0;
  for (uint16_t place = 0; place < game->board.places; place++) {
    if (!qtr_places_has(choices, place)) continue;
    const qtr_steps steps = qtr_board_steps(&game->board, (unsigned)seeker, state->joint.node[seeker], place);
    const double rate = game->probability[place] / (steps > 0 ? (double)steps : 0.5);
    if (rate <= best) continue;
    best = rate;
    choice = place;
  }
  return choice;
}

/* A look at the same place as `place`, itself above all, that may be chosen; QTR_STAND_DOWN if there is none. */
static uint16_t look_like(const qtr_game *game, uint16_t place, const qtr_places *choices) {
  if (qtr_places_has(choices, place)) return place;
  for (uint16_t other = 0; other < game->board.places; other++)
    if (qtr_places_has(choices, other) && qtr_game_place(game, other) == qtr_game_place(game, place)) return other;
  return QTR_STAND_DOWN;
}

/* The next place of a route that may be visited; QTR_STAND_DOWN at its end. */
static uint16_t next_of_route(const qtr_game *game, const qtr_routes *routes, int seeker, uint16_t *next,
                              const qtr_places *choices) {
  uint16_t choice = QTR_STAND_DOWN;
  while (choice == QTR_STAND_DOWN && *next < routes->length[seeker])
    choice = look_like(game, routes->place[seeker][(*next)++], choices);
  return choice;
}

/* Play a game to its end: each seeker by its route, or by rate if there are none. Routes divide the places, so
 * under the free rule each place is still free when its turn comes. */
static void play_out(qtr_play *play, const qtr_game *game, const qtr_routes *routes) {
  uint16_t next[QTR_MAX_SEEKERS] = {0};
  qtr_state state;
  qtr_outcome outcome;
  int seeker;
  qtr_play_begin(play);
  qtr_game_start(game, &state);
  qtr_game_pass(game, &state, &outcome);
  while ((seeker = qtr_joint_chooser(&state.joint, &game->board)) != QTR_NOBODY) {
    qtr_places choices;
    uint16_t choice = QTR_STAND_DOWN;
    const bool may_stand_down = qtr_joint_choices(&state.joint, &game->board, seeker, &choices);
    if (routes != NULL) choice = next_of_route(game, routes, seeker, &next[seeker], &choices);
    if (choice == QTR_STAND_DOWN && (routes == NULL || !may_stand_down))
      choice = best_rate(game, &state, seeker, &choices);
    qtr_game_choose(game, &state, seeker, choice);
    qtr_game_pass(game, &state, &outcome);
    qtr_play_add(play, seeker, choice);
  }
  qtr_play_score(play, game);
}

void qtr_play_by_rate(qtr_play *play, const qtr_game *game) {
  play_out(play, game, NULL);
}

/* Where there is an end nobody may come to some places in time. */
unsigned qtr_routes_count(const qtr_game *game) {
  return (unsigned)game->board.seekers + (game->board.terms.end != NULL ? 1u : 0u);
}

/* Only that no place is in two routes: places may be left out, for what is in nobody's reach. */
bool qtr_routes_are_division(const qtr_routes *routes, unsigned seekers) {
  qtr_places taken;
  qtr_places_clear(&taken);
  for (unsigned seeker = 0; seeker < seekers; seeker++) {
    for (unsigned i = 0; i < routes->length[seeker]; i++) {
      if (qtr_places_has(&taken, routes->place[seeker][i])) return false;
      qtr_places_add(&taken, routes->place[seeker][i]);
    }
  }
  return true;
}

void qtr_play_routes(qtr_play *play, const qtr_game *game, const qtr_routes *routes) {
  /* Who visits what is a division: nobody's route holds what another one's does. */
  QTR_ASSERT(qtr_routes_are_division(routes, game->board.seekers));
  play_out(play, game, routes);
}

/* Under the paper's rule followers choose a place that another one is bound for: then it is on both their routes. */
void qtr_play_to_routes(const qtr_play *play, const qtr_game *game, qtr_routes *routes) {
  const unsigned count = qtr_routes_count(game);
  for (unsigned route = 0; route < count; route++) routes->length[route] = 0;
  for (unsigned i = 0; i < play->choices; i++) {
    const unsigned seeker = play->seeker[i];
    if (play->choice[i] == QTR_STAND_DOWN) continue;
    routes->place[seeker][routes->length[seeker]++] = play->choice[i];
  }
  for (uint16_t place = 0; count > game->board.seekers && place < game->board.places; place++)
    if (play->visit[place] == QTR_NEVER) routes->place[count - 1][routes->length[count - 1]++] = place;
}

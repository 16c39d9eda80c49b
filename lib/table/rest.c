#include "quarter/rest.h"

#include <stddef.h>
#include <string.h>

#include "quarter/status.h"

/* What a place is like for each class, under its number of now. */
static void take_place(qtr_mission *rest, unsigned to, const qtr_mission *whole, unsigned from) {
  rest->place[to] = whole->place[from];
  rest->weight[to] = whole->weight[from];
  rest->detection[to] = whole->detection[from];
  rest->looks[to] = whole->looks[from];
  for (unsigned i = 0; i < whole->classes; i++) {
    qtr_robot_class *of = &rest->robot_class[i];
    of->scan[to] = whole->robot_class[i].scan[from];
    qtr_places_remove(&of->avoided, to);
    if (qtr_places_has(&whole->robot_class[i].avoided, from)) qtr_places_add(&of->avoided, to);
  }
}

/* Weights stay as they were: likelihoods are worked out of them anew, over what is left, as Bayes' rule has it for
 * places known to be empty. Places close up, for a game has no gaps; `number` leads back. */
void qtr_rest_make(qtr_mission *rest, uint16_t *number, const qtr_mission *whole, const qtr_cell *start,
                   const qtr_places *cleared) {
  rest->places = 0;
  rest->aim = whole->aim;
  for (uint16_t place = 0; place < whole->places; place++) {
    if (cleared != NULL && qtr_places_has(cleared, place)) continue;
    number[rest->places] = place;
    take_place(rest, rest->places++, whole, place);
  }
  QTR_ASSERT(rest->places > 0); /* a mission has something to search */
  memcpy(rest->start, start, whole->seekers * sizeof *start);
}

/* One game that cannot be told by its objective must not end the making of a table for all others. The least expected
 * time is what a discount tends to as it comes near 1, and what comes soonest after a deadline. */
static bool gives_way(int status, qtr_mission *rest) {
  if (status != QTR_ERR_DISCOUNT && (status != QTR_ERR_HORIZON || rest->aim.kind != QTR_DEADLINE)) return false;
  qtr_aim_undiscount(&rest->aim);
  return true;
}

int qtr_rest_game(qtr_game *game, qtr_mission *rest, qtr_travel *travel) {
  const int status = qtr_game_init(game, rest, travel, NULL);
  return gives_way(status, rest) ? qtr_game_init(game, rest, travel, NULL) : status;
}

int qtr_rest_game_known(qtr_game *game, qtr_mission *rest, const qtr_board *known, const uint16_t *place,
                        const uint16_t *start_of) {
  const int status = qtr_game_init_known(game, rest, known, place, start_of);
  return gives_way(status, rest) ? qtr_game_init_known(game, rest, known, place, start_of) : status;
}

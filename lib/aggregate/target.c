#include "aggregate/target.h"

#include "model/rounding.h"
#include "quarter/status.h"

static unsigned places_of(const qtr_targets *t) {
  return t->game->board.places;
}

static unsigned nodes_of(const qtr_targets *t) {
  return (unsigned)t->game->board.places + t->game->board.starts;
}

static qtr_spot_ground ground_of(const qtr_game *game) {
  const qtr_spot_ground ground = {game->board.places, game->steps, game->probability, &game->objective};
  return ground;
}

/* No place has a tour yet: it gets one when it is the first of some. */
static void begin(qtr_targets *t, const qtr_game *game) {
  t->game = game;
  for (unsigned place = 0; place < places_of(t); place++) t->tour[place].places = 0;
}

/* ---- tours ---- */

/* The tour of a target from a node; what follows its first place is kept by that place. From there on the best order
 * maximises what is counted from its visit, whoever comes and when (objectives fall apart at any moment), and the
 * nearest-first order looks at the place alone: so whichever node is planned last writes the same tour. */
static bool plan_tour(qtr_targets *t, unsigned node, uint16_t target, uint8_t order) {
  const qtr_spot_ground ground = ground_of(t->game);
  const uint16_t *place = t->spots.place[target];
  const unsigned count = t->spots.size[target];
  qtr_spot_tour planned;
  const bool found = order == QTR_SPOT_NEAREST ? qtr_spot_tour_nearest(&planned, &ground, node, place, count)
                                               : qtr_spot_tour_best(&planned, &ground, node, place, count,
                                                                    QTR_SPOT_ANY_EXIT, 0.0, &t->tour_scratch);
  if (!found) return false;
  qtr_tour *tour = &t->tour[planned.place[0]];
  tour->target = target;
  tour->places = planned.places;
  for (unsigned i = 0; i < planned.places; i++) {
    tour->place[i] = planned.place[i];
    tour->step[i] = planned.step[i] - planned.step[0];
  }
  t->first[(size_t)node * t->count + target] = planned.place[0];
  return true;
}

/* Nobody goes from a spot to itself: all of it has been visited. */
static void plan_tours_from(qtr_targets *t, unsigned node, uint8_t order) {
  for (uint16_t target = 0; target < t->count; target++) {
    t->first[(size_t)node * t->count + target] = QTR_STAND_DOWN;
    if (node < places_of(t) && t->spots.spot_of[node] == target) continue;
    plan_tour(t, node, target, order);
  }
}

/* ---- targets ---- */

/* Spots of one place each: their tours are a visit long, and the game is the ground's own. Whether there is a way
 * depends on who goes, and only travel times tell. */
void qtr_targets_places(qtr_targets *t, const qtr_game *game) {
  begin(t, game);
  t->count = t->spots.count = game->board.places;
  for (uint16_t place = 0; place < t->count; place++) {
    t->spots.spot_of[place] = place;
    t->spots.size[place] = 1;
    t->spots.place[place][0] = place;
    t->tour[place] = (qtr_tour){.target = place, .places = 1, .place = {place}};
    for (unsigned node = 0; node < nodes_of(t); node++)
      t->first[(size_t)node * t->count + place] = node == place ? QTR_STAND_DOWN : place;
  }
}

int qtr_targets_spots(qtr_targets *t, const qtr_game *game, const qtr_spots_config *config, uint8_t order) {
  const qtr_spot_ground ground = ground_of(game);
  begin(t, game);
  const int status = qtr_spots_build(&t->spots, &ground, config, &t->spots_scratch);
  if (status != QTR_OK) return status;
  t->count = t->spots.count;
  for (unsigned node = 0; node < nodes_of(t); node++) {
    /* Places alone take no time. */
    if (t->count < places_of(t) && !qtr_watch_go_on(&game->mission->watch)) return QTR_ERR_STOPPED;
    plan_tours_from(t, node, order);
  }
  return QTR_OK;
}

/* The target is found in a spot as often as in one of its places. */
double qtr_targets_probability(const qtr_targets *t, unsigned target) {
  double probability = 0.0;
  for (unsigned i = 0; i < t->spots.size[target]; i++) probability += t->game->probability[t->spots.place[target][i]];
  return probability;
}

/* The way to the first place, and the tour from there: what a choice of this target takes. */
qtr_steps qtr_targets_duration(const qtr_targets *t, unsigned seeker, unsigned node, unsigned target) {
  const uint16_t first = qtr_targets_first(t, node, target);
  if (first == QTR_STAND_DOWN) return QTR_NEVER;
  /* A tour is known by its first place, which is one of the target's own. */
  QTR_ASSERT(t->tour[first].places > 0 && t->tour[first].target == target);
  const qtr_steps way = qtr_board_steps(&t->game->board, seeker, node, first);
  return way == QTR_NEVER ? QTR_NEVER : way + qtr_tour_length(&t->tour[first]);
}

/* A game being played: choices added, routes followed, and all of it scored on the true map. */
#ifndef QUARTER_SEARCH_PLAY_H
#define QUARTER_SEARCH_PLAY_H

#include <stdbool.h>

#include "quarter/play.h"

/* Begin an empty play. */
void qtr_play_begin(qtr_play *play);

/* Add a choice. One of no seeker's or no place's, and one more than QTR_MAX_CHOICES, is left out. */
void qtr_play_add(qtr_play *play, int seeker, uint16_t choice);

/* A game to have something to improve on: always the most likely place for the way. Scored. */
void qtr_play_by_rate(qtr_play *play, const qtr_game *game);

/* How many routes a game has, the one of what nobody visits included. */
unsigned qtr_routes_count(const qtr_game *game);

/* Whether no place is on two routes, or on one twice. */
bool qtr_routes_are_division(const qtr_routes *routes, unsigned seekers);

/* The game in which each seeker follows its route and stands down at its end, as far as it may: what is not allowed it
 * leaves out, and where it may not stand down it goes on by rate. Free rule alone. Scored. */
void qtr_play_routes(qtr_play *play, const qtr_game *game, const qtr_routes *routes);

#endif

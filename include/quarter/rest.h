/* What is left of a mission once some of its places are cleared, from whatever cells the seekers then set out. */
#ifndef QUARTER_REST_H
#define QUARTER_REST_H

#include <stdint.h>

#include "quarter/game.h"
#include "quarter/mission.h"
#include "quarter/places.h"

QTR_C_BEGIN

/* Make `rest`, a copy of the whole mission or an earlier rest of it, the mission without the places in `cleared` (NULL
 * for none; never all), its seekers at `start`. `number` tells what numbers its places have in the whole one. */
void qtr_rest_make(qtr_mission *rest, uint16_t *number, const qtr_mission *whole, const qtr_cell *start,
                   const qtr_places *cleared);

/* Set its game up. From cells, or with places left, that are so far apart that discounting tells nothing any more, or a
 * deadline is past before any of them is reached, it is played for expected time instead, and the rest says so. As
 * qtr_game_init() otherwise. */
int qtr_rest_game(qtr_game *game, qtr_mission *rest, qtr_travel *travel);

/* The same by travel times that are known, as qtr_game_init_known(). */
int qtr_rest_game_known(qtr_game *game, qtr_mission *rest, const qtr_board *known, const uint16_t *place,
                        const uint16_t *start_of);

QTR_C_END

#endif

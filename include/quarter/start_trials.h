/* What a table for any start loses: its routes from random cells, played on the ground, against the best found for
 * those very cells.
 *
 *   qtr_start_trials_begin(&trials, seed);
 *   while (qtr_start_trials_next(&trials, &policy, &mission, &rest)) {
 *     // learn `rest` in a game of its own
 *     qtr_start_trials_add(&trials, &policy, &game, best);
 *   }
 */
#ifndef QUARTER_START_TRIALS_H
#define QUARTER_START_TRIALS_H

#include <stdbool.h>
#include <stdint.h>

#include "quarter/deployment.h"
#include "quarter/game.h"
#include "quarter/policy.h"

QTR_C_BEGIN

#define QTR_START_TRIALS 100       /* that are made, */
#define QTR_START_TRIES_MOST 10000 /* of so many draws: not all cells will do */

typedef struct {
  uint64_t random;
  uint32_t tries;
  qtr_deployment deployment;     /* of the trial under way */
  uint16_t count;                /* trials made */
  double loss[QTR_START_TRIALS]; /* of the objective, relative, 0.01 is one per cent; the least first */
} qtr_start_trials;

/* QTR_OK, or QTR_ERR_CONFIG if the caller was built under other sizes. */
#define qtr_start_trials_begin(trials, seed) qtr_start_trials_begin_built(trials, seed, QTR_CONFIG_ID)
int qtr_start_trials_begin_built(qtr_start_trials *trials, uint64_t seed, uint32_t config_id);

/* Draw cells for the next trial, and make `rest`, a copy of the mission, the mission from there. False: enough. A trial
 * that is not added is one that was not made. */
bool qtr_start_trials_next(qtr_start_trials *trials, const qtr_policy *policy, const qtr_mission *mission,
                           qtr_mission *rest);

/* The best play that was found in the rest's game is worth `best`. */
void qtr_start_trials_add(qtr_start_trials *trials, const qtr_policy *policy, const qtr_game *game, double best);

QTR_C_END

#endif

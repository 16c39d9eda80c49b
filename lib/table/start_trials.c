#include "quarter/start_trials.h"

#include <math.h>
#include <stddef.h>

#include "model/rounding.h"
#include "quarter/nominal.h"
#include "quarter/random.h"
#include "quarter/rest.h"
#include "quarter/status.h"

int qtr_start_trials_begin_built(qtr_start_trials *trials, uint64_t seed, uint32_t config_id) {
  if (config_id != QTR_CONFIG_ID) return QTR_ERR_CONFIG;
  trials->random = seed;
  trials->tries = 0;
  trials->count = 0;
  return QTR_OK;
}

/* Free cells, each as likely as any: others are drawn again. There are some, for the mission has a start. */
static qtr_cell draw_cell(qtr_start_trials *trials, const qtr_mission *mission) {
  qtr_cell cell;
  do cell = (qtr_cell)qtr_lcg_below(&trials->random, qtr_mission_cells(mission));
  while (mission->cost[cell] == 0);
  return cell;
}

/* Cells that no region stands for are no start of the table, and no trial. The draws have an end of their own, or a map
 * made mostly of such cells would keep this going. */
bool qtr_start_trials_next(qtr_start_trials *trials, const qtr_policy *policy, const qtr_mission *mission,
                           qtr_mission *rest) {
  uint16_t number[QTR_MAX_PLACES];
  qtr_cell start[QTR_MAX_SEEKERS];
  while (trials->count < QTR_START_TRIALS && trials->tries++ < QTR_START_TRIES_MOST) {
    for (unsigned i = 0; i < mission->seekers; i++) start[i] = draw_cell(trials, mission);
    if (qtr_deployment_init(&trials->deployment, policy, start, NULL) != QTR_OK) continue;
    qtr_rest_make(rest, number, mission, start, NULL);
    return true;
  }
  return false;
}

/* What the table's routes earn when the seekers set out from these very cells. */
static double earn_on_ground(const qtr_policy *policy, const qtr_deployment *deployment, const qtr_game *game) {
  qtr_steps visit[QTR_MAX_PLACES];
  qtr_score score;
  uint64_t home = 0;
  for (unsigned place = 0; place < policy->board.places; place++) visit[place] = QTR_NEVER;
  for (unsigned i = 0; i < policy->board.seekers; i++) {
    unsigned node = (unsigned)policy->board.places + game->board.start_of[i];
    qtr_steps now = qtr_board_ready(&game->board, i);
    qtr_joint joint;
    uint16_t place;
    qtr_joint_start(&joint, &policy->board, deployment->start_of, NULL);
    /* The nominal game tells the order alone; the time is that of the seeker's own way, which begins in the cell drawn
     * and not in the representative. */
    while ((place = qtr_policy_play(policy, &joint, (int)i, NULL, NULL)) != QTR_STAND_DOWN) {
      now += qtr_board_steps(&game->board, i, node, place);
      node = place;
      visit[node] = now;
    }
    home += (uint64_t)now + qtr_game_way_home(game, i, node);
  }
  qtr_game_score(game, visit, home, &score);
  return score.worth;
}

/* Kept sorted: quantiles are read off by index. */
void qtr_start_trials_add(qtr_start_trials *trials, const qtr_policy *policy, const qtr_game *game, double best) {
  const double loss = (best - earn_on_ground(policy, &trials->deployment, game)) / fabs(best);
  QTR_ASSERT(trials->count < QTR_START_TRIALS && trials->tries > 0); /* qtr_start_trials_next() said so */
  unsigned at = trials->count++;
  for (; at > 0 && trials->loss[at - 1] > loss; at--) trials->loss[at] = trials->loss[at - 1];
  trials->loss[at] = loss;
}

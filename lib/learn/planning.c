#include "learn/planning.h"

#include "learn/role.h"
#include "model/rounding.h"

#if QTR_RECREATES

#define FIRST_RUN 4096u /* rounds; each run is twice as long as the one before it */
#define LONGEST_RUN (1u << 24)
#define WORK_MOST (1u << 19) /* rounds times places of one step */

/* A share of what a step takes itself: prices take their slots times the square of the places, episodes the cube, and a
 * round takes the places. Much of it comes first, for prices are tuned towards the best game. Games of few places are
 * mostly over before they need it. */
static uint32_t rounds_of_step(const qtr_learner *learner) {
  const uint32_t places = learner->game->board.places;
  const bool prices = learner->phase != QTR_PHASE_EPISODES;
  const uint32_t few = prices ? 24 : 12;
  const uint32_t most = WORK_MOST / places;
  if (places <= few) return 0;
  const uint32_t more = places - few;
  const uint32_t rounds =
      prices ? 2 * places * more / (1 + learner->planned_steps) + learner->bound.gains.slots * more / 32
             : places * more / 100;
  return rounds < most ? rounds : most;
}

/* Every better game that is found elsewhere goes in. */
static void take_over(qtr_learner *learner) {
  qtr_recreation *r = &learner->recreation;
  const bool over = qtr_recreation_is_over(r);
  if (!over && learner->best.score.worth <= learner->planned) return;
  qtr_play_to_routes(&learner->best, learner->game, &learner->routes);
  if (over) {
    const uint32_t rounds = r->rounds == 0 ? FIRST_RUN : r->rounds < LONGEST_RUN ? 2 * r->rounds : r->rounds;
    qtr_recreation_begin(r, learner->game, &learner->routes, rounds, learner->config.seed + rounds);
  } else {
    qtr_recreation_adopt(r, &learner->routes);
  }
}

static void hand_over(qtr_learner *learner) {
  qtr_recreation *r = &learner->recreation;
  if (qtr_recreation_is_over(r))
    qtr_refine(&learner->refinery, &r->best, learner->game, 0, learner->config.seed);
  else if (!r->found)
    return;
  r->found = false;
  qtr_play_routes(&learner->play, learner->game, &r->best);
  if (qtr_score_is_better(&learner->play.score, &learner->best.score)) learner->best = learner->play;
}

void qtr_planning_init(qtr_learner *learner) {
  learner->recreation.round = learner->recreation.rounds = 0;
  learner->planned_steps = 0;
}

void qtr_planning_step(qtr_learner *learner) {
  const uint32_t rounds = rounds_of_step(learner);
  if (rounds == 0 || learner_learns_alone(learner) || learner->game->board.rule != QTR_RULE_FREE) return;
  take_over(learner);
  qtr_recreation_go_on(&learner->recreation, rounds);
  hand_over(learner);
  learner->planned_steps++;
  learner->planned = learner->best.score.worth;
}

#else

void qtr_planning_init(qtr_learner *learner) {
  (void)learner;
}

void qtr_planning_step(qtr_learner *learner) {
  (void)learner;
}

#endif

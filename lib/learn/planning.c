#include "learn/planning.h"

#include "learn/role.h"
#include "model/rounding.h"

#if QTR_RECREATES

#define FIRST_RUN 4096u /* rounds; each run is twice as long as the one before it */
#define LONGEST_RUN (1u << 24)
#define WORK_MOST (1u << 21) /* rounds times places of one step */

#define FEW_BESIDE_PRICES 24u /* places: no rounds beside the prices */
#define FEW_BESIDE_EPISODES 12u
#define LABELS_A_ROUND 8u /* routes begun, which take twice as long */

/* Of games that are searched by vicinity: rounds of the first run for each place, and of a step for each slot and place
 * that its prices fill; they take as long as these then. */
#define LARGE_RUN 32u
#define LARGE_SHARE 64u

static bool is_large(const qtr_learner *learner) {
  return qtr_vicinity_in_use(&learner->vicinity);
}

bool qtr_planning_follows(const qtr_learner *learner) {
  return learner->game->board.places > FEW_BESIDE_PRICES;
}

/* Fewer of the prices' steps go to one of the learner, or it would last minutes. */
uint32_t qtr_planning_price_steps(const qtr_learner *learner, uint32_t most) {
  const uint32_t places = learner->game->board.places;
  return is_large(learner) ? 1 + most * QTR_SEARCHED_WHOLE / places * QTR_SEARCHED_WHOLE / places : most;
}

/* How many times as long a filling of C takes as where walks remember one neighbour of each place, two gains a slot:
 * about twice, where they remember more. */
static uint64_t length_of_filling(const qtr_learner *learner) {
  return learner->bound.gains.row < 4u * learner->game->board.places ? 1 : 2;
}

/* Much of it comes first, for prices are tuned towards the best game; then a share of what the prices' step takes
 * that grows with the places, for of many the plan is what there is for long. */
static uint32_t rounds_beside_prices(const qtr_learner *learner, uint32_t more) {
  const uint64_t places = learner->game->board.places;
  const uint64_t filled = learner->bound.gains.slots * length_of_filling(learner);
  return (uint32_t)(places * places * more / 32 / (1 + learner->planned_steps) +
                    (filled * more * places * places >> 15));
}

/* A share of what a step takes itself: prices take their slots times the square of the places, episodes the cube, and a
 * round takes the places. */
static uint32_t rounds_of_step(const qtr_learner *learner) {
  const uint32_t places = learner->game->board.places;
  const bool prices = learner->phase != QTR_PHASE_EPISODES;
  const uint32_t few = prices ? FEW_BESIDE_PRICES : FEW_BESIDE_EPISODES;
  const uint32_t most = WORK_MOST / places;
  if (places <= few) return 0;
  if (is_large(learner) && prices)
    return qtr_planning_price_steps(learner, QTR_PRICE_STEPS) * learner->bound.gains.slots * places / LARGE_SHARE;
  const uint32_t more = places - few;
  const uint32_t rounds = prices ? rounds_beside_prices(learner, more) : places * more / 100;
  return rounds < most ? rounds : most;
}

static uint32_t first_run(const qtr_learner *learner) {
  return is_large(learner) ? LARGE_RUN * learner->game->board.places : FIRST_RUN;
}

/* Every better game that is found elsewhere goes in. */
static void take_over(qtr_learner *learner) {
  qtr_recreation *r = &learner->recreation;
  const bool over = qtr_recreation_is_over(r);
  if (!over && learner->best.score.worth <= learner->planned) return;
  qtr_play_to_routes(&learner->best, learner->game, &learner->routes);
  if (over) {
    const uint32_t rounds = r->rounds == 0 ? first_run(learner) : r->rounds < LONGEST_RUN ? 2 * r->rounds : r->rounds;
    qtr_recreation_begin(r, learner->game, &learner->vicinity, &learner->routes, rounds, learner->config.seed + rounds);
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
  qtr_vicinity_init(&learner->vicinity, learner->game);
  qtr_refine_begin(&learner->refinery, &learner->vicinity);
}

static bool may_plan(const qtr_learner *learner) {
  return !learner_learns_alone(learner) && learner->game->board.rule == QTR_RULE_FREE;
}

static void plan(qtr_learner *learner, uint32_t rounds) {
  take_over(learner);
  qtr_recreation_go_on(&learner->recreation, rounds);
  hand_over(learner);
  learner->planned_steps++;
  learner->planned = learner->best.score.worth;
}

void qtr_planning_first(qtr_learner *learner) {
  if (is_large(learner) && may_plan(learner)) plan(learner, first_run(learner));
}

void qtr_planning_step(qtr_learner *learner) {
  const uint32_t rounds = rounds_of_step(learner);
  if (rounds > 0 && may_plan(learner)) plan(learner, rounds);
}

void qtr_planning_beside(qtr_learner *learner, uint32_t labels) {
  if (may_plan(learner)) plan(learner, labels / LABELS_A_ROUND);
}

#else

bool qtr_planning_follows(const qtr_learner *learner) {
  (void)learner;
  return false;
}

void qtr_planning_beside(qtr_learner *learner, uint32_t labels) {
  (void)learner;
  (void)labels;
}

uint32_t qtr_planning_price_steps(const qtr_learner *learner, uint32_t most) {
  (void)learner;
  return most;
}

void qtr_planning_first(qtr_learner *learner) {
  (void)learner;
}

void qtr_planning_init(qtr_learner *learner) {
  (void)learner;
}

void qtr_planning_step(qtr_learner *learner) {
  (void)learner;
}

#endif

#include "learn/tail.h"

#include <math.h>

#include "learn/certificate.h"
#include "learn/role.h"
#include "model/rounding.h"
#include "search/pool.h"
#include "search/selection.h"

#define FIRST_LABELS (1u << 17) /* of the first try; each one that fails is followed by one with four times as many, */
#define FIRST_EPISODES 64u      /* and four times as many episodes */
#define LABELS_A_STEP 4096u
#define PLACES_MOST 256u /* of more of them pairs and triples take too long */
#define LEAST_GAP 1e-8   /* what a linear programme can tell */

enum phase { TAIL_WAITS = 0, TAIL_LISTS = 1, TAIL_SELECTS = 2, TAIL_IS_OVER = 3 };

struct qtr_tail {
  uint8_t phase;
  uint32_t labels_most;
  uint64_t episodes, wait; /* that there are to be before the next try; and after it, if it fails */
  qtr_pool pool;
  qtr_selection selection;
  size_t bytes;
  uint64_t block[];
};

void qtr_tail_init(qtr_learner *learner, void *block, size_t bytes) {
  learner->tail = NULL;
  if (block == NULL || bytes <= sizeof(qtr_tail) || (uintptr_t)block % sizeof(uint64_t) != 0) return;
  learner->tail = block;
  learner->tail->phase = TAIL_WAITS;
  learner->tail->labels_most = FIRST_LABELS;
  learner->tail->episodes = 0;
  learner->tail->wait = FIRST_EPISODES;
  learner->tail->bytes = bytes - sizeof(qtr_tail);
}

/* All of the gap is closed but for what rounding may add, and never less than half of the gap asked for. */
static double target_of(const qtr_learner *learner) {
  const double half = qtr_certificate_within(learner, 0.5);
  const double least = learner->best.score.worth + LEAST_GAP * fabs(learner->best.score.worth);
  return half < least ? half : least;
}

static void begin_list(qtr_learner *learner) {
  qtr_tail *tail = learner->tail;
  if (learner->episodes < tail->episodes) return;
  qtr_pool_begin(&tail->pool, tail->block, tail->bytes, &learner->bound, target_of(learner));
  if (tail->pool.labels_most > tail->labels_most) tail->pool.labels_most = tail->labels_most;
  tail->phase = TAIL_LISTS;
}

/* Once more, with more room, or when the best game is better. */
static void wait_for_next(qtr_learner *learner) {
  qtr_tail *tail = learner->tail;
  tail->phase = TAIL_WAITS;
  tail->labels_most = tail->labels_most < UINT32_MAX / 4 ? tail->labels_most * 4 : UINT32_MAX;
  tail->episodes = learner->episodes + tail->wait;
  tail->wait *= 4;
}

static void begin_selection(qtr_learner *learner) {
  qtr_tail *tail = learner->tail;
  const size_t used = qtr_pool_bytes(&tail->pool);
  const bool begun = qtr_selection_begin(&tail->selection, &tail->pool, (uint8_t *)tail->block + used,
                                         tail->bytes - used, target_of(learner));
  if (begun)
    tail->phase = TAIL_SELECTS;
  else
    wait_for_next(learner);
}

static void list(qtr_learner *learner) {
  switch (qtr_pool_go_on(&learner->tail->pool, LABELS_A_STEP)) {
  case QTR_LISTING: return;
  case QTR_LISTED: begin_selection(learner); return;
  default: wait_for_next(learner);
  }
}

static void take_game(qtr_learner *learner) {
  qtr_selection_routes(&learner->tail->selection, &learner->routes);
  qtr_play_routes(&learner->play, learner->game, &learner->routes);
  if (qtr_score_is_better(&learner->play.score, &learner->best.score)) learner->best = learner->play;
  qtr_selection_raise(&learner->tail->selection, target_of(learner));
}

static void select(qtr_learner *learner) {
  qtr_tail *tail = learner->tail;
  const enum qtr_selecting status = qtr_selection_go_on(&tail->selection);
  if (status == QTR_SELECTION_GAME) take_game(learner);
  if (status == QTR_SELECTED || status == QTR_SELECTION_STUCK) tail->phase = TAIL_IS_OVER;
  if (tail->selection.upper < learner->upper) learner->upper = learner->ground_upper = tail->selection.upper;
}

static bool is_of_use(const qtr_learner *learner) {
  return learner->tail != NULL && !learner_is_aggregate(learner) && learner->game->board.rule == QTR_RULE_FREE &&
         learner->game->board.places <= PLACES_MOST;
}

bool qtr_tail_step(qtr_learner *learner) {
  if (!is_of_use(learner)) return false;
  if (learner->tail->phase == TAIL_WAITS) begin_list(learner);
  switch (learner->tail->phase) {
  case TAIL_LISTS: list(learner); return true;
  case TAIL_SELECTS: select(learner); return true;
  default: return false;
  }
}

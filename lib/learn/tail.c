#include "learn/tail.h"

#include <math.h>

#include "core/block.h"
#include "learn/certificate.h"
#include "learn/planning.h"
#include "learn/role.h"
#include "model/rounding.h"
#include "search/columns.h"
#include "search/deal.h"
#include "search/pool.h"
#include "search/selection.h"

#define FIRST_LABELS (1u << 17) /* of the first list of all routes; each that fails is followed by a longer one */
#define LONGER 4u
#define EARLY_LABELS 8u   /* a list while prices are tuned: of what a fill of C takes, so many times fewer; */
#define SMALL_LAYERS 100u /* that fit in it, */
#define SHORT_LISTS 24u   /* and of how many places it takes no time */
#define LEAST_EARLY_LABELS (1u << 14) /* where all routes of a few places are listed at once */
#define EARLY_SHARE 0.7          /* and not before the gap is that much of what it was when the last one was too long */
#define LABELS_TO_TRY (1u << 19) /* of a list of some, out of which a better game is looked for, */
#define STEPS_TO_TRY 2000u       /* so long at most */
#define ROOM_TO_PRICE 0.75       /* of the room, for labels while routes are priced */
#define NARROWER 0.5             /* of the gap: some of the routes where all are too many */
#define LEAST_SHARE 0.2          /* of it: of fewer routes hardly any game is made */
#define LESS 0.8                 /* of the gap of the last list of all routes, before the next one, */
#define LEAST_ROUNDS 2u          /* and rounds of triples */
#define FIRST_EPISODES 64u       /* before all is tried anew; after each failure four times as many */
#define LABELS_A_STEP 4096u
#define FEW_PLACES 9u    /* and one for each seeker: all routes are listed sooner than prices are tuned */
#define PLACES_MOST 256u /* of more of them pairs and triples take too long */
#define LEAST_GAP 1e-8   /* what a linear programme can tell */
#define ROUNDING 1e-14   /* what sums of prices lose of them */

enum phase {
  TAIL_WAITS = 0,
  TAIL_LISTS = 1,  /* all routes within the gap; where they are too many, some */
  TAIL_TRIES = 2,  /* the best game out of some */
  TAIL_PRICES = 3, /* routes, until fewer are within the gap */
  TAIL_FILLS = 4,  /* C, for the next list */
  TAIL_SELECTS = 5,
  TAIL_SETTLES = 6, /* the bound is put back for the episodes */
  TAIL_IS_OVER = 7
};

struct qtr_tail {
  uint8_t phase, then;     /* what follows when the bound is settled */
  bool is_early;           /* prices are still being tuned, */
  double early_gap;        /* and routes are listed from this gap on */
  bool is_priced;          /* as far as it goes */
  uint32_t rounds;         /* of triples, since the last list of all */
  uint32_t labels;         /* of the next list of all */
  double gap;              /* of the last one */
  double share;            /* of the gap, being listed */
  uint32_t steps;          /* of a try */
  uint64_t episodes, wait; /* that there are to be before the next time; and after it, if it fails */
  qtr_pool pool;
  qtr_columns columns;
  qtr_selection selection;
  double *charge;  /* for each pair of places */
  uint8_t *listed; /* the rest of the block: labels, and behind them what is worked out from them */
  size_t bytes;    /* of that */
  uint64_t block[];
};

void qtr_tail_init(qtr_learner *learner, void *block, size_t bytes) {
  const size_t places = learner->game->board.places;
  const size_t needed = sizeof(qtr_tail) + places * places * sizeof(double);
  learner->tail = NULL;
  if (block == NULL || bytes <= needed || (uintptr_t)block % sizeof(uint64_t) != 0) return;
  qtr_tail *tail = learner->tail = block;
  tail->phase = TAIL_WAITS;
  tail->labels = FIRST_LABELS;
  tail->episodes = 0;
  tail->wait = FIRST_EPISODES;
  tail->early_gap = HUGE_VAL;
  tail->listed = (uint8_t *)tail->block;
  tail->charge = block_cut(&tail->listed, places * places * sizeof(double));
  tail->bytes = bytes - needed;
}

/* Few enough places to deal them to the seekers. */
static bool is_dealt(const qtr_learner *learner) {
  return learner->game->board.places <= QTR_DEALT_MOST;
}

/* All of the gap is closed but for what rounding may add, and never less than half of the gap asked for. */
static double target_of(const qtr_learner *learner) {
  const double half = qtr_certificate_within(learner, 0.5);
  const double least_gap = is_dealt(learner) ? QTR_LEAST_GAP : LEAST_GAP;
  const double least = learner->best.score.worth + least_gap * fabs(learner->best.score.worth);
  return half < least ? half : least;
}

static void lower(qtr_learner *learner, double upper) {
  if (upper < learner->upper) learner->upper = learner->ground_upper = upper;
}

static double gap_of(const qtr_learner *learner) {
  return learner->tail->columns.upper - target_of(learner);
}

static void settle(qtr_learner *learner, enum phase then) {
  learner->tail->phase = TAIL_SETTLES;
  learner->tail->then = (uint8_t)then;
}

/* Once more behind some episodes, when the best game is better. */
static void wait_for_next(qtr_learner *learner) {
  qtr_tail *tail = learner->tail;
  tail->episodes = learner->episodes + tail->wait;
  tail->wait *= 4;
  settle(learner, TAIL_WAITS);
}

/* ---- lists of routes within the gap ---- */

static void begin_list(qtr_learner *learner, double share, uint32_t labels) {
  qtr_tail *tail = learner->tail;
  tail->phase = TAIL_LISTS;
  tail->share = share;
  tail->pool.labels_most = labels < tail->pool.labels_room ? labels : tail->pool.labels_room;
  qtr_columns_list(&tail->columns, share * gap_of(learner));
}

static void list_all(qtr_learner *learner) {
  qtr_tail *tail = learner->tail;
  tail->gap = gap_of(learner);
  tail->rounds = 0;
  begin_list(learner, 1.0, tail->labels);
  if (tail->labels < UINT32_MAX / LONGER) tail->labels *= LONGER;
}

/* From the bound's own prices, C filled with them. */
static void begin_prices(qtr_learner *learner) {
  qtr_tail *tail = learner->tail;
  qtr_pool_init(&tail->pool, tail->listed, tail->bytes, &learner->bound);
  const uint32_t labels = (uint32_t)(ROOM_TO_PRICE * tail->pool.labels_room);
  const size_t used = qtr_pool_bytes(&tail->pool, labels);
  const qtr_columns_room room = {tail->charge, tail->listed + used, tail->bytes - used, labels};
  qtr_columns_begin(&tail->columns, &learner->bound, &tail->pool, &room, target_of(learner));
}

/* Where prices are far above what any game is worth, no sum of them tells games apart. */
static bool can_tell(const qtr_learner *learner) {
  double prices = 0.0;
  for (unsigned place = 0; place < learner->game->board.places; place++) prices += fabs(learner->bound.price[place]);
  return target_of(learner) - learner->best.score.worth >= ROUNDING * prices;
}

static void begin(qtr_learner *learner) {
  qtr_tail *tail = learner->tail;
  if (learner->episodes < tail->episodes || !can_tell(learner)) return;
  begin_prices(learner);
  tail->is_early = tail->is_priced = false;
  list_all(learner);
}

/* Play the routes at hand, and keep the game if it is better. */
static void take_routes(qtr_learner *learner) {
  qtr_play_routes(&learner->play, learner->game, &learner->routes);
  if (qtr_score_is_better(&learner->play.score, &learner->best.score)) learner->best = learner->play;
}

/* The best game out of the routes listed, which all games that are worth more than the target are made of. */
static bool deal(qtr_learner *learner) {
  qtr_tail *tail = learner->tail;
  const size_t used = qtr_pool_bytes(&tail->pool, tail->pool.labels);
  if (!is_dealt(learner) || tail->bytes - used < qtr_deal_bytes(&tail->pool)) return false;
  if (qtr_deal(&tail->pool, tail->listed + used, &learner->routes)) take_routes(learner);
  lower(learner, target_of(learner));
  settle(learner, TAIL_IS_OVER);
  return true;
}

/* From the labels on what is left of the block is free. */
static bool begin_selection(qtr_learner *learner) {
  qtr_tail *tail = learner->tail;
  const size_t used = qtr_pool_bytes(&tail->pool, tail->pool.labels);
  return qtr_selection_begin(&tail->selection, &tail->pool, tail->listed + used, tail->bytes - used,
                             &tail->columns.center, &tail->columns.basis, target_of(learner));
}

/* Out of all routes within the gap. */
static bool begin_choice(qtr_learner *learner) {
  if (deal(learner)) return true;
  if (!begin_selection(learner)) return false;
  learner->tail->phase = TAIL_SELECTS;
  return true;
}

static void price_on(qtr_learner *learner) {
  learner->tail->phase = TAIL_PRICES;
  if (learner->tail->is_priced) wait_for_next(learner);
}

static void begin_try(qtr_learner *learner) {
  learner->tail->steps = 0;
  learner->tail->phase = TAIL_TRIES;
  if (!begin_selection(learner)) price_on(learner);
}

/* Of one seeker alone each route is a game: prices bring nothing that episodes do not. */
static void list_some(qtr_learner *learner) {
  qtr_tail *tail = learner->tail;
  if (learner->game->board.seekers == 1) {
    wait_for_next(learner);
  } else if (NARROWER * tail->share > LEAST_SHARE) {
    begin_list(learner, NARROWER * tail->share, LABELS_TO_TRY);
  } else {
    qtr_pool_forget_listed(&tail->pool);
    price_on(learner);
  }
}

static void list(qtr_learner *learner) {
  if (learner->tail->pool.labels > FIRST_LABELS) qtr_planning_beside(learner, LABELS_A_STEP);
  switch (qtr_pool_go_on(&learner->tail->pool, LABELS_A_STEP)) {
  case QTR_LISTING: return;
  case QTR_POOL_FULL: list_some(learner); return;
  default: break;
  }
  if (learner->tail->share != 1.0)
    begin_try(learner);
  else if (!begin_choice(learner))
    wait_for_next(learner);
}

/* ---- prices of routes, until fewer are within the gap ---- */

static bool may_list_all(const qtr_learner *learner) {
  const qtr_tail *tail = learner->tail;
  return tail->is_priced || (tail->rounds >= LEAST_ROUNDS && gap_of(learner) < LESS * tail->gap);
}

static void price(qtr_learner *learner) {
  qtr_tail *tail = learner->tail;
  qtr_planning_step(learner);
  const enum qtr_pricing status = qtr_columns_go_on(&tail->columns);
  lower(learner, tail->columns.upper);
  if (status == QTR_PRICING) return;
  tail->rounds++;
  tail->is_priced = status == QTR_PRICING_STUCK;
  if (may_list_all(learner)) tail->phase = TAIL_FILLS;
}

static void fill(qtr_learner *learner) {
  if (qtr_columns_settle(&learner->tail->columns)) list_all(learner);
}

/* ---- the best game ---- */

static void take_game(qtr_learner *learner) {
  qtr_selection_routes(&learner->tail->selection, &learner->routes);
  take_routes(learner);
  qtr_selection_raise(&learner->tail->selection, target_of(learner));
}

/* Out of the routes at hand: what that proves is of them alone. */
static void try(qtr_learner *learner) {
  qtr_tail *tail = learner->tail;
  const enum qtr_selecting status = qtr_selection_go_on(&tail->selection);
  if (status == QTR_SELECTION_GAME) take_game(learner);
  if (status == QTR_SELECTED || status == QTR_SELECTION_STUCK || ++tail->steps == STEPS_TO_TRY) price_on(learner);
}

/* It is tried again when the gap is less. */
static void tune_on(qtr_learner *learner) {
  learner->tail->phase = TAIL_WAITS;
  learner->phase = QTR_PHASE_GROUND_PRICES;
}

static void select(qtr_learner *learner) {
  qtr_tail *tail = learner->tail;
  const enum qtr_selecting status = qtr_selection_go_on(&tail->selection);
  if (status == QTR_SELECTION_GAME) take_game(learner);
  if (status == QTR_SELECTION_STUCK && tail->is_early)
    tune_on(learner);
  else if (status == QTR_SELECTED || status == QTR_SELECTION_STUCK)
    settle(learner, TAIL_IS_OVER);
  lower(learner, tail->selection.upper);
}

static bool is_of_use(const qtr_learner *learner) {
  return learner->tail != NULL && !learner_is_aggregate(learner) && learner->game->board.rule == QTR_RULE_FREE &&
         learner->game->board.places <= PLACES_MOST;
}

/* ---- while prices are being tuned ---- */

bool qtr_tail_comes_first(const qtr_learner *learner) {
  const qtr_board *board = &learner->game->board;
  return is_of_use(learner) && board->places <= FEW_PLACES + board->seekers;
}

/* It is to take less than the prices' steps do from one to the next. */
static uint32_t early_labels(const qtr_learner *learner) {
  const uint32_t places = learner->game->board.places;
  const uint64_t labels = (uint64_t)places * places * learner->bound.gains.slots / EARLY_LABELS;
  if (labels < LEAST_EARLY_LABELS && qtr_tail_comes_first(learner)) return LEAST_EARLY_LABELS;
  return labels < FIRST_LABELS ? (uint32_t)labels : FIRST_LABELS;
}

/* A layer of routes of `length` places, half of what a seeker visits or less, is not small any more and more than
 * twice as large as the one before it: those to come do not fit. Lists of few places take no time; and where endurance
 * ends routes, nobody knows what half of one is. */
static bool is_hopeless(const qtr_learner *learner, uint32_t length, uint32_t before) {
  const qtr_board *board = &learner->game->board;
  const qtr_pool *pool = &learner->tail->pool;
  const uint32_t layer = pool->layer_end - pool->layer_begin;
  return board->places > SHORT_LISTS && board->terms.end == NULL && length * board->seekers * 2 <= board->places &&
         layer > pool->labels_most / SMALL_LAYERS && layer / 2 > before;
}

static bool list_early(qtr_learner *learner) {
  qtr_pool *pool = &learner->tail->pool;
  enum qtr_listing status = QTR_LISTING;
  uint32_t length = 0;
  begin_prices(learner);
  begin_list(learner, 1.0, early_labels(learner));
  while (status == QTR_LISTING) {
    const uint32_t first = pool->layer_begin;
    const uint32_t before = pool->layer_end - first;
    status = qtr_pool_go_on(pool, LABELS_A_STEP);
    if (pool->layer_begin != first && is_hopeless(learner, ++length, before)) return false;
  }
  return status == QTR_LISTED && begin_choice(learner);
}

bool qtr_tail_try_early(qtr_learner *learner) {
  qtr_tail *tail = learner->tail;
  if (!is_of_use(learner) || !can_tell(learner)) return false;
  const double gap = learner->bound.upper - target_of(learner);
  if (gap > tail->early_gap || !qtr_bound_settle(&learner->bound)) return false;
  tail->early_gap = EARLY_SHARE * gap;
  tail->is_early = list_early(learner);
  if (tail->is_early)
    learner->phase = QTR_PHASE_EPISODES;
  else
    tail->phase = TAIL_WAITS;
  return tail->is_early;
}

/* ---- steps ---- */

/* Episodes need C as the bound's own prices have it. */
static void put_back(qtr_learner *learner) {
  qtr_gains_charge(&learner->bound.gains, NULL);
  if (qtr_bound_settle(&learner->bound)) learner->tail->phase = learner->tail->then;
}

bool qtr_tail_step(qtr_learner *learner) {
  if (!is_of_use(learner)) return false;
  switch (learner->tail->phase) {
  case TAIL_WAITS: begin(learner); return learner->tail->phase != TAIL_WAITS;
  case TAIL_LISTS: list(learner); return true;
  case TAIL_TRIES: try(learner); return true;
  case TAIL_PRICES: price(learner); return true;
  case TAIL_FILLS: fill(learner); return true;
  case TAIL_SELECTS: select(learner); return true;
  case TAIL_SETTLES: put_back(learner); return true;
  default: return false;
  }
}

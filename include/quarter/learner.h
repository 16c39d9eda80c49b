/* The learner: the Q-learning unit and its action strategy (paper, Fig. 3.1, 5.1).
 *
 * Certified setting: Q starts at an upper bound, the seekers act greedily on it, and each episode is backed up from its
 * end to its start, Q(s,a) <- min(Q(s,a), backup). Q then never falls below the optimal Q*, so the largest Q of the
 * first state bounds every policy from above, and the best game played so far is a policy that earns what it earns. When
 * the two meet, that policy is optimal; stopped earlier, the gap between them is known.
 *
 *   qtr_learner_init(&learner, &game, &config);
 *   while (qtr_learner_step(&learner) == QTR_LEARNING) { qtr_learner_certificate(&learner, &certificate); ... }
 */
#ifndef QUARTER_LEARNER_H
#define QUARTER_LEARNER_H

#include <stdbool.h>
#include <stdint.h>

#include "quarter/bound.h"
#include "quarter/config.h"
#include "quarter/game.h"
#include "quarter/joint.h"
#include "quarter/qtable.h"
#include "quarter/refine.h"

/* A game has no more choices than this: a place each, and each seeker stands down once. Under the paper's rule a seeker
 * may follow others, at most once for every place that they visit. */
#define QTR_MAX_CHOICES (QTR_MAX_PLACES * 2 + QTR_MAX_SEEKERS)

typedef struct {
  double gap;    /* relative, 0 or more: stop when bound and objective differ by no more than gap * |objective|. Smaller
                    takes longer; below 1e-6 the floats of the Q-table may keep it from closing (QTR_CONVERGED). */
  uint64_t seed; /* of the random choices; stored in the table. The certified setting makes none. */
} qtr_learner_config;

/* Gap 1e-5, seed 1. */
void qtr_learner_config_default(qtr_learner_config *config);

enum qtr_learning {
  QTR_LEARNING = 0,  /* the gap is open and further steps can close it */
  QTR_CERTIFIED = 1, /* the gap is closed */
  QTR_CONVERGED = 2  /* nothing more can be learnt: Q is at its fixed point, or the table is full */
};

/* The state of knowledge after a step. */
typedef struct {
  double value;          /* of the best game played: discounted */
  double expected_time;  /* of the same game, steps */
  double objective;      /* whichever of the two the mission asks for */
  double bound;          /* no policy does better than this in the mission's objective */
  double gap;            /* |objective - bound| / |objective| */
  bool certified;        /* gap is within the config's */
  uint64_t episodes;     /* games played, those given up early included */
  uint64_t updates;      /* Q entries set or lowered */
  uint32_t price_steps;  /* subgradient steps of the bound */
} qtr_certificate;

/* A game as it was played: who chose what, in order. */
typedef struct {
  uint16_t choices;
  uint8_t seeker[QTR_MAX_CHOICES];
  uint16_t choice[QTR_MAX_CHOICES];
  qtr_steps visit[QTR_MAX_PLACES]; /* each place's step of first visit */
  qtr_score score;
} qtr_play;

/* One choice of the episode under way, as the backup needs it. */
typedef struct {
  qtr_key key;       /* of the joint state after the choice */
  double q;          /* largest Q: of the choice made */
  double runner_up;  /* largest Q of the other choices */
  double at_once;    /* reward without time passing, part of Q and not of the entry */
  qtr_outcome outcome;
} qtr_trace;

/* Large: keep it in static storage. */
typedef struct {
  const qtr_game *game;
  qtr_learner_config config;
  qtr_play best;
  double upper; /* largest Q of the first state */
  bool pricing; /* the bound is still being tuned */
  uint64_t episodes, updates;
  qtr_play play;
  qtr_routes routes;
  qtr_refinery refinery;
  qtr_trace trace[QTR_MAX_CHOICES];
  qtr_bound bound;
  qtr_qtable table;
} qtr_learner;

/* Begin. The game must outlive the learner. QTR_OK, QTR_ERR_ARGUMENT for a config out of range, or QTR_ERR_CONFIG if
 * the caller was built under other array sizes. */
#define qtr_learner_init(learner, game, config) qtr_learner_init_built(learner, game, config, QTR_CONFIG_ID)
int qtr_learner_init_built(qtr_learner *learner, const qtr_game *game, const qtr_learner_config *config,
                           uint32_t config_id);

/* Learn a little more: some steps of the bound's prices, or one episode. May be stopped after any step; calling it again
 * after the end does nothing. */
enum qtr_learning qtr_learner_step(qtr_learner *learner);

/* What is known now. Bound and value never grow worse from step to step. */
void qtr_learner_certificate(const qtr_learner *learner, qtr_certificate *certificate);

/* The best game played so far; lives as long as the learner and changes with its steps. */
const qtr_play *qtr_learner_best(const qtr_learner *learner);

#endif

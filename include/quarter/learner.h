/* The learner: the Q-learning unit and its action strategies (paper, Fig. 3.1, 5.1), in two settings. They share
 * the game, the keys and the Q-table, and differ in the value that Q starts from, the action strategy, the backup with its
 * order, and in when they end; the certified one also searches for its first game.
 *
 * Certified setting: Q starts at an upper bound, the seekers act greedily on it, and each episode is backed up from its
 * end to its start, Q(s,a) <- min(Q(s,a), backup). Q then never falls below the optimal Q*, so the largest Q of the
 * first state bounds every policy from above, and the best game played so far is a policy that earns what it earns. When
 * the two meet, that policy is optimal; stopped earlier, the gap between them is known.
 *
 * Paper setting: Q starts at 0, the seekers explore, and each step is backed up as it comes, Q(s,a) <- (1 - alpha) Q(s,a)
 * + alpha backup (Eq. 4.7). After each episode the greedy policy is played; the best one played is the result, and the
 * prices alone bound it.
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
#include "quarter/environment.h"
#include "quarter/explore.h"
#include "quarter/game.h"
#include "quarter/joint.h"
#include "quarter/play.h"
#include "quarter/policy.h"
#include "quarter/qtable.h"
#include "quarter/refine.h"

#define QTR_LEAST_GAP 1e-12 /* a smaller gap is taken for this one: two sums that are equal may differ by as much */
#define QTR_FLOAT_GAP 1e-6  /* below, the Q-table holds doubles, at 4 bytes more an entry: floats would keep it open */

enum qtr_setting { QTR_SETTING_CERTIFIED = 0, QTR_SETTING_PAPER = 1 };

typedef struct {
  uint32_t made; /* by qtr_learner_config_default() */
  double gap;    /* relative, 0 or more: stop when bound and objective differ by no more than gap * |objective|. Smaller
                    takes longer; below QTR_FLOAT_GAP it takes more memory, and QTR_LEAST_GAP is the least that can be
                    told. The paper setting, with 0, goes on learning whatever is proven. */
  uint64_t seed; /* of the random choices: how the local search shakes, how the paper setting explores */
  uint8_t setting; /* enum qtr_setting */
  double alpha;    /* paper setting: learning rate, above 0 up to 1; 1 is right where the model is deterministic */
  qtr_exploration_plan exploration; /* paper setting */
  bool ground_search; /* certified, on an aggregate: local search goes on from its plays on the ground, so that the best
                         game is often better than any that the aggregate allows. False: the aggregate's own best */
} qtr_learner_config;

/* Gap 1e-5, seed 1, certified, with search on the ground; alpha 1 and epsilon-greedy for the paper setting. */
void qtr_learner_config_default(qtr_learner_config *config);

/* QTR_OK, or QTR_ERR_ARGUMENT for settings out of their ranges, or not from their default. */
int qtr_learner_config_check(const qtr_learner_config *config);

enum qtr_learning {
  QTR_LEARNING = 0,  /* the gap is open and further steps can close it */
  QTR_CERTIFIED = 1, /* the gap is closed */
  QTR_CONVERGED = 2 /* nothing more can be learnt: Q is at its fixed point (on an aggregate: it has the best policy that
                        the aggregate allows, and what a gap is left is the aggregate's), or the table is full */
};

/* The state of knowledge after a step. */
typedef struct {
  double value;         /* of the best game played: discounted */
  double expected_time; /* of the same game, steps */
  double objective;     /* whichever of the two the mission asks for */
  double bound;         /* no policy does better than this in the mission's objective */
  double gap;           /* |objective - bound| / |objective| */
  bool certified;       /* gap is within the config's */
  /* Places that make up less than QTR_NEGLIGIBLE of the best game's objective each. The certificate says nothing of their
   * order, which goes by expected time where worths are equal. */
  uint16_t negligible_places;
  uint64_t episodes;    /* games played, those given up early included */
  uint64_t updates;     /* of Q entries that changed them */
  double max_q;         /* largest Q of the first state, in units of reward (MaxQ of Fig. 4.5); certified: its least
                            so far, a bound on every policy of what is learnt on */
  uint32_t price_steps; /* subgradient steps of the bound */
} qtr_certificate;

/* The choices of a state, each with its Q and the entry that it is stored under. */
typedef struct {
  unsigned count;
  uint16_t choice[QTR_MAX_PLACES + 1];
  double q[QTR_MAX_PLACES + 1];
  double at_once[QTR_MAX_PLACES + 1]; /* reward without time passing, part of Q and not of the entry */
  qtr_key key[QTR_MAX_PLACES + 1];    /* of the joint state after the choice */
} qtr_candidates;

/* One choice of the episode under way, as the backup needs it. */
typedef struct {
  qtr_key key;      /* of its entry */
  double q;         /* of the choice made */
  double runner_up; /* largest Q of the other choices */
  double at_once;   /* as in the candidates */
  uint16_t first;   /* place that the choice leads to first */
  qtr_outcome outcome;
} qtr_trace;

/* What a learner is at. The paper setting has no use for an aggregate's prices. */
enum qtr_phase { QTR_PHASE_GROUND_PRICES = 0, QTR_PHASE_AGGREGATE_PRICES = 1, QTR_PHASE_EPISODES = 2 };

/* Large: keep it in static storage. */
typedef struct {
  const qtr_game *game;
  const qtr_environment *ground;      /* the game itself */
  const qtr_environment *environment; /* what is learnt on: the ground, or an aggregate of it */
  qtr_learner_config config;
  qtr_play best;
  double upper;        /* certified: the largest Q of the first state; paper: the prices' bound */
  double ground_upper; /* the bound on the game itself, from its prices */
  double max_q;        /* paper: the largest Q of the first state after the last episode */
  uint8_t phase;       /* enum qtr_phase */
  uint64_t episodes, updates;
  qtr_play play;
  qtr_routes routes;
  qtr_refinery refinery;
  qtr_explorer explorer;
  qtr_candidates candidates;
  qtr_trace trace[QTR_MAX_CHOICES];
  uint8_t records[QTR_MAX_CHOICES * QTR_RECORD_BYTES]; /* for the export */
  qtr_bound bound;
  qtr_qtable table;
} qtr_learner;

/* Begin, on the ground (an environment without aggregation) or on an aggregate of the same game (NULL: none). Then the
 * game must have the free rule: what was learnt on the aggregate is played on the ground as routes. Both environments
 * must outlive the learner. QTR_OK, QTR_ERR_ARGUMENT for a config that fails its check or the certified setting on regions, whose
 * times are no bound, or QTR_ERR_CONFIG if the caller was built under other array sizes. There is a first game in any case:
 * a stop by the mission's watch leaves it as it is, with a bound that is not tight. */
#define qtr_learner_init(learner, ground, aggregate, config)                                                           \
  qtr_learner_init_built(learner, ground, aggregate, config, QTR_CONFIG_ID)
int qtr_learner_init_built(qtr_learner *learner, const qtr_environment *ground, const qtr_environment *aggregate,
                           const qtr_learner_config *config, uint32_t config_id);

/* Learn a little more: some steps of the bound's prices, or one episode. May be stopped after any step, or within
 * one by the mission's watch: what is known stays so, and learning can go on. Calling it again after the end does nothing. */
enum qtr_learning qtr_learner_step(qtr_learner *learner);

/* What is known now. Bound and value never grow worse from step to step. */
void qtr_learner_certificate(const qtr_learner *learner, qtr_certificate *certificate);

/* The best game played so far; lives as long as the learner and changes with its steps. */
const qtr_play *qtr_learner_best(const qtr_learner *learner);

#endif

/* The learner: the Q-learning unit and its action strategies (paper, Fig. 3.1, 5.1), in two settings. They share the
 * game, the keys and the Q-table, and differ in the value that Q starts from, the action strategy, the backup with its
 * order, and in when they end; the certified one also searches for its first game.
 *
 * Certified setting: Q starts at an upper bound, the seekers act greedily on it, and each episode is backed up from its
 * end to its start, Q(s,a) <- min(Q(s,a), backup). Q then never falls below the optimal Q*, so the largest Q of the
 * first state bounds every policy from above, and the best game played so far is a policy that earns what it earns.
 * When the two meet, that policy is optimal; stopped earlier, the gap between them is known. On the ground, what
 * prices leave open is first closed by choosing among all routes within the gap, where the caller's block holds them.
 *
 * Paper setting: Q starts at 0, the seekers explore, and each step is backed up as it comes, Q(s,a) <- (1 - alpha)
 * Q(s,a) + alpha backup (Eq. 4.7). After each episode the greedy policy is played; the best one played is the result,
 * and the prices alone bound it.
 *
 * All memory is the caller's, in blocks. With those of any mission of a robot's build, in static storage, as firmware
 * has them:
 *
 *   static qtr_learner_memory memory;
 *   qtr_environment *ground;
 *   qtr_learner *learner;
 *   qtr_environment_init(&ground, memory.ground, sizeof memory.ground, &game, NULL, &field);
 *   const qtr_learner_blocks blocks = QTR_LEARNER_BLOCKS(memory);
 *   qtr_learner_init(&learner, &blocks, ground, NULL, &config);
 *   while (qtr_learner_step(learner) == QTR_LEARNING) { qtr_learner_certificate(learner, &certificate); ... }
 */
#ifndef QUARTER_LEARNER_H
#define QUARTER_LEARNER_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "quarter/config.h"
#include "quarter/environment.h"
#include "quarter/explore.h"
#include "quarter/game.h"
#include "quarter/play.h"
#include "quarter/policy.h"

QTR_C_BEGIN

#define QTR_LEAST_GAP 1e-12 /* a smaller gap is taken for this one: two sums that are equal may differ by as much */
#define QTR_FLOAT_GAP 1e-6  /* below, the Q-table holds doubles, at 4 bytes more an entry: floats would keep it open */

enum qtr_setting { QTR_SETTING_CERTIFIED = 0, QTR_SETTING_PAPER = 1 };

typedef struct {
  uint32_t made; /* by qtr_learner_config_default() */
  double gap;    /* relative, 0 or more: stop when bound and objective differ by no more than gap * |objective|. Smaller
                    takes longer; below QTR_FLOAT_GAP it takes more memory, and QTR_LEAST_GAP is the least that can be
                    told. The paper setting, with 0, goes on learning whatever is proven. */
  uint64_t seed; /* of the random choices: how the local search shakes, how the paper setting explores */
  uint32_t
      price_steps; /* of the bound at most before games are learnt from; 0: as long as they gain. Small missions are
                           certified sooner by some games more than by prices at their best */
  uint8_t setting; /* enum qtr_setting */
  double alpha;    /* paper setting: learning rate, above 0 up to 1; 1 is right where the model is deterministic */
  qtr_exploration_plan exploration; /* paper setting */
  bool ground_search; /* certified, on an aggregate: local search goes on from its plays on the ground, so that the best
                         game is often better than any that the aggregate allows. False: the aggregate's own best */
} qtr_learner_config;

/* Gap 1e-5, seed 1, prices at their best, certified, with search on the ground; alpha 1 and epsilon-greedy for the
 * paper setting. */
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
  double found;         /* probability that the same game finds at all; under a deadline, by then */
  double objective;     /* whichever of the three the mission asks for */
  double bound;         /* no policy does better than this in the mission's objective */
  double gap;           /* |objective - bound| / |objective| */
  bool certified;       /* gap is within the config's */
  /* Places that make up less than QTR_NEGLIGIBLE of the best game's objective each. The certificate says nothing of
   * their order, which goes by expected time where worths are equal. */
  uint16_t negligible_places;
  uint64_t episodes;    /* games played, those given up early included */
  uint64_t updates;     /* of Q entries that changed them */
  double max_q;         /* largest Q of the first state, in units of reward (MaxQ of Fig. 4.5); certified: its least
                            so far, a bound on every policy of what is learnt on */
  uint32_t price_steps; /* steps of the bound's prices */
} qtr_certificate;

/* ---- memory ---- */

/* Stands in the workspace, and lives as long as that. */
typedef struct qtr_learner qtr_learner;

/* The caller's memory for a learner. It must outlive the learner, and is nobody else's. */
typedef struct {
  void *work;         /* the workspace, aligned as for a uint64_t */
  size_t work_bytes;  /* qtr_learner_bytes() at the least */
  uint32_t *table;    /* the Q-table */
  size_t table_words; /* QTR_QTABLE_LEAST_WORDS at the least; more than QTR_QTABLE_WORDS are not used */
  void *routes;       /* for routes within the gap, aligned as for a uint64_t; NULL: none are listed */
  size_t route_bytes; /* the larger, the wider the gaps that are closed at once; qtr_learner_route_bytes() */
} qtr_learner_blocks;

/* Bytes of the workspace that learning a game takes, on whatever aggregate of it. */
size_t qtr_learner_bytes(const qtr_game *game);

/* Bytes for its routes, as far as they are likely to be of use; never more than QTR_ROUTE_BYTES. */
size_t qtr_learner_route_bytes(const qtr_game *game);

/* What ruin and recreate takes of it. */
#define QTR_RECREATION_BYTES                                                                                           \
  ((QTR_RECREATES ? 3 * sizeof(qtr_routes) + (size_t)QTR_MAX_PLACES * 56 + 256 : 0) +                                  \
   (size_t)QTR_VICINITY_PLACES * (2 * QTR_VICINITY + QTR_VICINITY_PLACES / 8))

/* At most, for missions of QTR_STATIC_PLACES whose seekers are of no more than QTR_MAX_CLASSES kinds (quarter/terms.h):
 * what the bound's prices, the game under way and the search on it take, then the bound's gains. */
#define QTR_LEARNER_BYTES                                                                                              \
  (2 * sizeof(qtr_play) + 2 * sizeof(qtr_routes) + QTR_RECREATION_BYTES +                                              \
   QTR_MAX_CHOICES * (sizeof(qtr_key) + QTR_RECORD_BYTES + 64) +                                                       \
   (size_t)QTR_MAX_PLACES * (sizeof(qtr_key) + 88 + 6 * QTR_MAX_CUTS) +                                                \
   (size_t)QTR_STATIC_PLACES * (QTR_STATIC_PLACES + QTR_MAX_CLASSES * (4 * QTR_STATIC_NODES + 12 * QTR_STATIC_PLACES + \
                                                                       24 * QTR_BOUND_SLOTS)) +                        \
   16 * QTR_MAX_CUTS + 1024)

/* All blocks for any mission of the build, or of QTR_STATIC_PLACES; large, keep it in static storage. Who never learns
 * on an aggregate, or on none with regions, declares smaller ones by the same sizes. */
typedef struct {
  uint64_t ground[(QTR_ENVIRONMENT_GROUND_BYTES + 7) / 8];
  uint64_t aggregate[(QTR_ENVIRONMENT_REGIONS_BYTES + 7) / 8];
  uint64_t work[(QTR_LEARNER_BYTES + 7) / 8];
  uint32_t table[QTR_QTABLE_WORDS];
  uint64_t routes[(QTR_ROUTE_BYTES + 15) / 8];
} qtr_learner_memory;

/* A learner's own, as the initialiser of a qtr_learner_blocks. */
#define QTR_LEARNER_BLOCKS(memory)                                                                                     \
  {(memory).work, sizeof(memory).work, (memory).table, QTR_QTABLE_WORDS, (memory).routes, QTR_ROUTE_BYTES}

/* ---- learning ---- */

/* Begin, on the ground (an environment without aggregation) or on an aggregate of the same game (NULL: none). Then the
 * game must have the free rule: what was learnt on the aggregate is played on the ground as routes. Both environments
 * must outlive the learner. QTR_OK, and then alone `*learner` is set; QTR_ERR_SPACE for a block that is smaller than it
 * says above; QTR_ERR_ARGUMENT for one that is not aligned, a config that fails its check, or the certified setting on
 * regions, whose times are no bound; QTR_ERR_CONFIG if the caller was built under other array sizes. There is a first
 * game in any case: a stop by the mission's watch leaves it as it is, with a bound that is not tight. */
#define qtr_learner_init(learner, blocks, ground, aggregate, config)                                                   \
  qtr_learner_init_built(learner, blocks, ground, aggregate, config, QTR_CONFIG_ID)
int qtr_learner_init_built(qtr_learner **learner, const qtr_learner_blocks *blocks, const qtr_environment *ground,
                           const qtr_environment *aggregate, const qtr_learner_config *config, uint32_t config_id);

/* Learn a little more: some steps of the bound's prices, or one episode. May be stopped after any step, or within one
 * by the mission's watch: what is known stays so, and learning can go on. Calling it again after the end does
 * nothing. */
enum qtr_learning qtr_learner_step(qtr_learner *learner);

/* What is known now. Bound and value never grow worse from step to step. */
void qtr_learner_certificate(const qtr_learner *learner, qtr_certificate *certificate);

/* The best game played so far; lives as long as the learner and changes with its steps. */
const qtr_play *qtr_learner_best(const qtr_learner *learner);

/* ---- the Q-table ---- */

/* Entries in it, and bytes that each takes, key and value. */
uint32_t qtr_learner_entries(const qtr_learner *learner);
uint32_t qtr_learner_entry_bytes(const qtr_learner *learner);

/* For a table that grows as it is learnt: words that it needs to stand in so that the next step finds room for all that
 * it learns, as it would in QTR_QTABLE_WORDS. Never more than those. */
size_t qtr_learner_table_needs(const qtr_learner *learner);

/* The table stands in another block now, no smaller, whose start holds what the old one held (as realloc() leaves it).
 * Between steps alone. QTR_OK, or QTR_ERR_SPACE with nothing changed if it is smaller. */
int qtr_learner_move_table(qtr_learner *learner, uint32_t *table, size_t words);

QTR_C_END

#endif

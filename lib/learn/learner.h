/* A learner from inside: what it is at, and its workspace. The bound's gains stand behind it in the block. */
#ifndef QUARTER_LEARN_LEARNER_H
#define QUARTER_LEARN_LEARNER_H

#include "aggregate/environment.h"
#include "quarter/learner.h"
#include "search/bound.h"
#include "search/explore.h"
#include "search/qtable.h"
#include "search/recreate.h"
#include "search/refine.h"
#include "search/vicinity.h"

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

#define QTR_READ_BITS (128 * QTR_MAX_PLACES)

/* What a learner is at. The paper setting has no use for an aggregate's prices. */
enum qtr_phase { QTR_PHASE_GROUND_PRICES = 0, QTR_PHASE_AGGREGATE_PRICES = 1, QTR_PHASE_EPISODES = 2 };

typedef struct qtr_tail qtr_tail; /* learn/tail.h */

struct qtr_learner {
  const qtr_game *game;
  const qtr_environment *ground;      /* the game itself */
  const qtr_environment *environment; /* what is learnt on: the ground, or an aggregate of it */
  qtr_learner_config config;
  qtr_play best;
  double upper;        /* certified: the largest Q of the first state; paper: the prices' bound */
  double ground_upper; /* the bound on the game itself, from its prices */
  double max_q;        /* paper: the largest Q of the first state after the last episode */
  uint8_t phase;       /* enum qtr_phase */
  bool replayed;       /* paper: the greedy game is known, for nothing that it read has changed since */
  uint64_t episodes, updates;
  qtr_play play;
  qtr_routes routes;
  qtr_refinery refinery;
#if QTR_RECREATES
  qtr_vicinity vicinity;
  qtr_recreation recreation;
  double planned;         /* worth of the best game that it knows of */
  uint32_t planned_steps; /* that it has gone on beside */
#endif
  qtr_explorer explorer;
  qtr_candidates candidates;
  qtr_trace trace[QTR_MAX_CHOICES];
  uint8_t records[QTR_MAX_CHOICES * QTR_RECORD_BYTES]; /* for the export */
  uint32_t read[QTR_READ_BITS / 32]; /* paper: a bit for each entry that the greedy game read; some share theirs */
  qtr_bound bound;
  qtr_qtable table;
  qtr_tail *tail; /* NULL: there is no block for it */
};

#endif

/* An environment from inside: what a moment of it is, and how it goes on. */
#ifndef QUARTER_AGGREGATE_ENVIRONMENT_H
#define QUARTER_AGGREGATE_ENVIRONMENT_H

#include "aggregate/sight.h"
#include "aggregate/target.h"
#include "quarter/config.h"
#include "quarter/environment.h"
#include "quarter/game.h"
#include "quarter/joint.h"

struct qtr_environment {
  const qtr_game *game;
  bool aggregated;
  qtr_targets targets;
  qtr_sight sight;
  qtr_board board;    /* the joint game over the targets */
  qtr_key_shape keys; /* of what is seen of it */
  uint8_t *reach; /* aggregated: the board's travel times, the longest between targets; behind all else in the block */
};

/* A moment. */
typedef struct {
  qtr_joint joint;                /* over the targets */
  double unvisited;               /* probability of the places left */
  uint16_t at[QTR_MAX_SEEKERS];   /* idle: the node where it is; on its way: the first place of its tour */
  qtr_walk walk[QTR_MAX_SEEKERS]; /* with regions: where it truly is */
} qtr_situation;

/* The first situation. Time passes in it, by qtr_environment_pass(), where nobody is ready from the start. */
void qtr_environment_start(const qtr_environment *environment, qtr_situation *situation);

/* `seeker`, whose turn it is, makes an allowed choice: a target, or to stand down. Returns the reward of a place at no
 * distance, less the ways home of those who have nothing left to choose. Nothing happens, and 0, for a seeker or target
 * that is none or has no way. */
double qtr_environment_choose(const qtr_environment *environment, qtr_situation *situation, int seeker,
                              uint16_t choice);

/* Take the choice just made back: what it changed is again as it was before. The other parts of both are the same. */
void qtr_environment_undo(const qtr_environment *environment, qtr_situation *situation, const qtr_situation *before,
                          int seeker, uint16_t choice);

/* Let time pass until somebody is to choose or the game is over (Eq. 4.7). */
void qtr_environment_pass(const qtr_environment *environment, qtr_situation *situation, qtr_outcome *outcome);

/* The key of a situation in the Q-table. */
void qtr_environment_key(const qtr_environment *environment, const qtr_situation *situation, qtr_key *key);

/* Likelihood for a step of the way: a target's, for a seeker at a node, by exact times; 0 if there is no way, seeker,
 * node or target. */
double qtr_environment_rate(const qtr_environment *environment, unsigned seeker, unsigned node, unsigned target);

/* The place at which the seeker on its way, or idle, will next be free; a node. QTR_STAND_DOWN for a seeker that is
 * none. */
unsigned qtr_environment_exit(const qtr_environment *environment, const qtr_situation *situation, unsigned seeker);

/* Steps from now until place `i` of the tour of a seeker on its way is visited, by it or, under the paper's rule, by
 * another one that is bound for its target and comes there sooner. 0: visited already, or there is no such seeker or
 * place. */
qtr_steps qtr_environment_visit(const qtr_environment *environment, const qtr_situation *situation, unsigned seeker,
                                unsigned i);

#endif

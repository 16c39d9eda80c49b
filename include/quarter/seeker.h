/* The executor: what one robot does, from the table and its own sensors alone.
 *
 * Every robot plays the whole joint game forward in nominal time from what all know: the table and the deployment (starts,
 * places cleared beforehand). Its own choices in that game are its route, so nothing that it does depends on another's real
 * progress. When its territory is finished and no termination was heard, it goes on with its neighbour's (seeker i + 1,
 * then i + 2, ... mod k), in that one's order: any survivor thus scans every place that it can reach.
 *
 * The only words between robots are the two signals below.
 */
#ifndef QUARTER_SEEKER_H
#define QUARTER_SEEKER_H

#include <stdbool.h>
#include <stdint.h>

#include "quarter/config.h"
#include "quarter/deployment.h"
#include "quarter/joint.h"
#include "quarter/places.h"
#include "quarter/policy.h"
#include "quarter/travel.h"

enum qtr_signal {
  QTR_SIGNAL_FOUND = 1,         /* the target is found: everyone stops */
  QTR_SIGNAL_TERRITORY_DONE = 2 /* every place of a territory has been scanned: nobody need go there any more */
};

/* One bit for each seeker. */
typedef struct {
  uint32_t word[(QTR_MAX_SEEKERS + 31) / 32];
} qtr_seeker_set;

typedef struct {
  const qtr_policy *policy;
  qtr_deployment deployment;
  qtr_places visited;      /* where this robot has been itself */
  qtr_joint joint;         /* the nominal game, as far as the territory's seeker has chosen */
  qtr_seeker_set done;     /* territories known to be finished */
  qtr_seeker_set announce; /* finished here and not yet announced */
  uint32_t off_table;      /* choices of the nominal game that the table had no record of */
  uint16_t target;         /* place bound for; QTR_STAND_DOWN: nothing left to do */
  uint8_t self;
  uint8_t territory; /* the seeker whose route is being walked */
  uint8_t pass;      /* territories left behind */
  bool missed;       /* a place of this territory is out of this robot's reach */
} qtr_seeker;

/* Robot `self` (0..seekers-1) at its start. `deployment` (copied) is the same on every robot; NULL: the mission's own
 * starts, nothing cleared. The open policy must outlive the seeker. QTR_OK; with nothing written QTR_ERR_ARGUMENT for a
 * robot that is none, QTR_ERR_CONFIG if the caller was built under other sizes. */
#define qtr_seeker_init(seeker, policy, self, deployment)                                                              \
  qtr_seeker_init_built(seeker, policy, self, deployment, QTR_CONFIG_ID)
int qtr_seeker_init_built(qtr_seeker *seeker, const qtr_policy *policy, unsigned self, const qtr_deployment *deployment,
                          uint32_t config_id);

/* The place to go to now; QTR_STAND_DOWN: stay, there is nothing left to do. */
uint16_t qtr_seeker_target(const qtr_seeker *seeker);

/* The robot stands on `place` and has scanned it without a find. If that is its target, it goes on to the next; a target that
 * a signal has changed meanwhile stays. Where the scan finds the target of the search, hear FOUND instead. A place out of
 * range is ignored. */
void qtr_seeker_visited(qtr_seeker *seeker, unsigned place);

/* A signal was heard, or, for FOUND, the robot found the target itself. It may change the target. Not from an interrupt while
 * another function of this module runs: keep the signal and hear it between two moves. `territory` counts for
 * TERRITORY_DONE alone; a number out of range or an unknown signal is ignored. */
void qtr_seeker_hear(qtr_seeker *seeker, int signal, unsigned territory);

/* Take a territory that this robot has finished and must announce as TERRITORY_DONE. False if there is none: call until
 * then after init and after each visit. */
bool qtr_seeker_announce(qtr_seeker *seeker, uint8_t *territory);

/* Fill `field` with the way to the current target, for qtr_field_next(). False if there is no target. */
bool qtr_seeker_field(const qtr_seeker *seeker, qtr_field *field);

#endif

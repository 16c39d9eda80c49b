/* From where the robots set out, and what is scanned before they do, where that is not what the mission says. Every
 * robot must be told the same, or they divide the ground differently. */
#ifndef QUARTER_DEPLOYMENT_H
#define QUARTER_DEPLOYMENT_H

#include "quarter/config.h"
#include "quarter/places.h"
#include "quarter/policy.h"

QTR_C_BEGIN

typedef struct {
  uint16_t start_of[QTR_MAX_SEEKERS]; /* start of the policy's board that each seeker plays from */
  qtr_places cleared;                 /* known to all before the start */
} qtr_deployment;

/* As the mission itself says. */
void qtr_deployment_home(qtr_deployment *deployment, const qtr_policy *policy);

/* Seeker i at cell `starts[i]` (NULL: where the mission says), the places in `cleared` (NULL: what the mission says)
 * already scanned. On a table for any start the cells may be any free ones from which the seeker can get to a place,
 * and stand for their regions; on others they must be start cells of the table. QTR_OK; with nothing written
 * QTR_ERR_START for a cell that is none of them, QTR_ERR_CONFIG if the caller was built under other sizes. */
#define qtr_deployment_init(deployment, policy, starts, cleared)                                                       \
  qtr_deployment_init_built(deployment, policy, starts, cleared, QTR_CONFIG_ID)
int qtr_deployment_init_built(qtr_deployment *deployment, const qtr_policy *policy, const qtr_cell *starts,
                              const qtr_places *cleared, uint32_t config_id);

/* What tells this division of the ground from every other: the CRC-32 of the table, then of the start nodes (2 bytes
 * each) and the places cleared (a bit each). Signals carry it, so that robots which play other divisions do not believe
 * one another. */
uint32_t qtr_deployment_identity(const qtr_deployment *deployment, const qtr_policy *policy);

QTR_C_END

#endif

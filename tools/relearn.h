/* What a table's mission would come to if what is left of it were learnt anew: the figure beside a game that its robots
 * play by their rule, where the table has no answers. */
#ifndef QUARTER_TOOLS_RELEARN_H
#define QUARTER_TOOLS_RELEARN_H

#include <stdbool.h>
#include <stdio.h>

#include "host/base/fault.h"
#include "host/base/json.h"
#include "host/plan/simulation.h"
#include "quarter/deployment.h"
#include "quarter/learner.h"

#define RELEARN_SECONDS 2.0 /* at most */

typedef struct {
  uint8_t objective; /* enum qtr_objective_kind */
  double step_seconds;
  qtr_score by_rule;           /* of the robots as they would go, all of them and on time */
  double figure_by_rule;       /* of it, in steps where it is a time */
  qtr_certificate certificate; /* of what is learnt anew */
} relearnt;

/* Learn what the deployment leaves of the table's mission, from its starts, for RELEARN_SECONDS at most. 0, or -1 with
 * *why set. */
int relearn(relearnt *r, const table *t, const qtr_deployment *deployment, const simulation_config *config, fault *why);

/* "expected time 24.3 s by their rule, 21.1 s learnt anew, 13.2 % less (certified optimal)", in lines of its own. */
void relearn_write(FILE *out, const relearnt *r);

/* The member "off_table_loss". */
void relearn_json(json *j, const relearnt *r);

#endif

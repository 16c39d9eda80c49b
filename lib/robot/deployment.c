#include "quarter/deployment.h"

#include <stdbool.h>
#include <stddef.h>

#include "quarter/status.h"

/* The start that stands for a cell: its region's, or on a table without regions the start at that cell; `starts` or more
 * if there is none. */
static unsigned start_at(const qtr_policy *policy, qtr_cell cell) {
  unsigned start = 0;
  if (qtr_grid_cost(&policy->grid, cell) == 0) return policy->board.starts;
  if (policy->regions != NULL) return qtr_policy_region(policy, cell);
  while (start < policy->board.starts && qtr_policy_cell(policy, policy->board.places + start) != cell) start++;
  return start;
}

static qtr_cell home_of(const qtr_policy *policy, unsigned seeker) {
  return qtr_policy_cell(policy, (unsigned)policy->board.places + policy->board.start_of[seeker]);
}

/* All where the mission says: then they play from those very cells and not from their regions, so that what they earn is
 * what the table's certificate says. */
static bool are_home(const qtr_policy *policy, const qtr_cell *starts) {
  for (unsigned i = 0; starts != NULL && i < policy->board.seekers; i++)
    if (starts[i] != home_of(policy, i)) return false;
  return true;
}

int qtr_deployment_init_built(qtr_deployment *deployment, const qtr_policy *policy, const qtr_cell *starts,
                              const qtr_places *cleared, uint32_t config_id) {
  if (config_id != QTR_CONFIG_ID) return QTR_ERR_CONFIG;
  const bool home = are_home(policy, starts);
  for (unsigned i = 0; !home && i < policy->board.seekers; i++)
    if (start_at(policy, starts[i]) >= policy->board.starts) return QTR_ERR_START;
  for (unsigned i = 0; i < policy->board.seekers; i++)
    deployment->start_of[i] = home ? policy->board.start_of[i] : (uint16_t)start_at(policy, starts[i]);
  qtr_places_clear(&deployment->cleared);
  if (cleared != NULL) deployment->cleared = *cleared;
  return QTR_OK;
}

#include "quarter/regions.h"

#include <float.h>

#include "model/rounding.h"
#include "model/settings.h"

/* The paper's limits (Fig. 5.3): they are of its map, and `quarter tune` finds those of another one. */
void qtr_regions_default(qtr_regions_config *config) {
  *config = (qtr_regions_config){.made = SETTINGS_MADE, .max_size = 25, .diameter = 15};
}

/* Of a size that is none, and of one that this build has no lists for. A negation, so that a likelihood that is no
 * number is refused, too. */
int qtr_regions_check(const qtr_regions_config *config) {
  if (config->made != SETTINGS_MADE || config->max_size == 0 || config->diameter == 0) return QTR_ERR_ARGUMENT;
  if (config->max_size > QTR_MAX_REGION_SIZE || config->diameter > QTR_MAX_REGION_DIAMETER) return QTR_ERR_LIMIT;
  if (!(config->likelihood >= 0.0 && config->likelihood <= DBL_MAX)) return QTR_ERR_ARGUMENT;
  return config->likelihood > 0.0 && config->places > QTR_MAX_PLACES ? QTR_ERR_LIMIT : QTR_OK;
}

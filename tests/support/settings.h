/* Settings in one expression, made from their defaults. */
#ifndef QUARTER_TESTS_SETTINGS_H
#define QUARTER_TESTS_SETTINGS_H

#include "quarter/environment.h"

static inline qtr_spots_config spot_limits(unsigned size, qtr_steps diameter, double likelihood) {
  qtr_spots_config config;
  qtr_spots_default(&config);
  config.size = (uint8_t)size;
  config.diameter = diameter;
  config.likelihood = likelihood;
  return config;
}

static inline qtr_regions_config region_limits(uint32_t max_size, uint32_t diameter) {
  qtr_regions_config config;
  qtr_regions_default(&config);
  config.max_size = max_size;
  config.diameter = diameter;
  return config;
}

/* Under the free rule; NULL: without spots, without regions. */
static inline qtr_aggregation aggregation_of(const qtr_spots_config *spots, const qtr_regions *regions) {
  qtr_aggregation how;
  qtr_aggregation_default(&how);
  how.by_spots = spots != NULL;
  if (spots != NULL) how.spots = *spots;
  how.regions = regions;
  return how;
}

#endif

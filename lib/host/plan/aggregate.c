#include "host/plan/aggregate.h"

#include <stddef.h>
#include <string.h>

static int divide_by_limits(qtr_regions *regions, const aggregate_config *config, const qtr_mission *mission,
                            const memory_block *scratch) {
  const qtr_grid grid = qtr_mission_grid(mission);
  qtr_regions_config limits = config->regions;
  limits.places = mission->places;
  limits.place = mission->place;
  limits.weight = mission->weight;
  limits.watch = mission->watch;
  return qtr_regions_build(regions, &grid, &limits, scratch->at, scratch->bytes);
}

const char *const aggregate_names[] = {[AGGREGATE_NONE] = "none",
                                       [AGGREGATE_REGIONS] = "regions",
                                       [AGGREGATE_SPOTS] = "spots",
                                       [AGGREGATE_BOTH] = "both",
                                       NULL};

const char aggregate_help[] =
    "none (the default), spots, and in the paper setting regions or both: learn on an aggregate;\n"
    "what is reported is what the policy earns on the true map";

/* In the order of the names. */
static const struct {
  int (*divide)(qtr_regions *regions, const aggregate_config *config, const qtr_mission *mission,
                const memory_block *scratch);
  bool by_regions, by_spots;
} ways[] = {[AGGREGATE_NONE] = {divide_by_limits, false, false},
            [AGGREGATE_REGIONS] = {divide_by_limits, true, false},
            [AGGREGATE_SPOTS] = {divide_by_limits, false, true},
            [AGGREGATE_BOTH] = {divide_by_limits, true, true}};

void aggregate_default(aggregate_config *config) {
  memset(config, 0, sizeof *config);
  config->way = AGGREGATE_NONE;
  qtr_regions_default(&config->regions);
  qtr_aggregation_default(&config->units);
}

bool aggregate_by_regions(int way) {
  return ways[way].by_regions;
}

bool aggregate_by_spots(int way) {
  return ways[way].by_spots;
}

int aggregate_divide(qtr_regions *regions, const aggregate_config *config, const qtr_mission *mission,
                     const memory_block *scratch) {
  return ways[config->way].divide(regions, config, mission, scratch);
}

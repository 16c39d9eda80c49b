/* What a plan can be learnt on beside its true map: each way to aggregate by its name, with the units that it takes. */
#ifndef QUARTER_HOST_AGGREGATE_H
#define QUARTER_HOST_AGGREGATE_H

#include <stdbool.h>

#include "host/base/memory.h"
#include "quarter/environment.h"
#include "quarter/mission.h"
#include "quarter/regions.h"

/* The first ways; there may be more of them than anybody asks for by number. */
enum { AGGREGATE_NONE = 0, AGGREGATE_REGIONS = 1, AGGREGATE_SPOTS = 2, AGGREGATE_BOTH = 3 };

/* What users call the ways, ended by NULL; and what help says of them. */
extern const char *const aggregate_names[];
extern const char aggregate_help[];

typedef struct {
  int way;                    /* a number of aggregate_names */
  qtr_regions_config regions; /* limits; places, weights and the watch are the mission's */
  qtr_aggregation units; /* spots and orders; its rule is the mission's, by_spots and regions follow from the way */
} aggregate_config;

/* None; limits as the units have them by default. */
void aggregate_default(aggregate_config *config);

/* Whether a way sees seekers in regions; whether it takes places together to spots. */
bool aggregate_by_regions(int way);
bool aggregate_by_spots(int way);

/* Divide a mission's map as the way does, or by regions where it does not, in qtr_regions_scratch_bytes() of scratch.
 * As qtr_regions_build() returns. */
int aggregate_divide(qtr_regions *regions, const aggregate_config *config, const qtr_mission *mission,
                     const memory_block *scratch);

#endif

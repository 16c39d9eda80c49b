/* Travel times for the tests of spots: from a mission's map, of places on a line, or any at all. */
#ifndef QUARTER_TESTS_SPOT_GROUND_H
#define QUARTER_TESTS_SPOT_GROUND_H

#include "missions.h"
#include "quarter/spots.h"
#include "steps.h"

static qtr_mission mission;                                      /* its weights are the ground's */
static uint8_t steps[4 * (QTR_MAX_PLACES + 1) * QTR_MAX_PLACES]; /* the last node is where a seeker comes from */
static qtr_objective objective;
static qtr_spot_ground ground;

static inline void ground_begin(unsigned places) {
  qtr_objective_init(&objective, &(qtr_aim){.kind = QTR_TIME, .gamma = 0.99}, NULL);
  ground = (qtr_spot_ground){(uint16_t)places, steps, mission.weight, &objective};
}

static inline void set_way(unsigned node, unsigned place, qtr_steps way) {
  steps_put(steps, node * ground.places + place, way);
}

static inline qtr_steps way_of(unsigned node, unsigned place) {
  return steps_get(steps, node * ground.places + place);
}

/* The travel times between the mission's places, and from its first start as one more node. */
static inline void measure(void) {
  static long flooded[QTR_MAX_CELLS];
  ground_begin(mission.places);
  for (unsigned node = 0; node <= mission.places; node++) {
    flood(flooded, &mission, node < mission.places ? mission.place[node] : mission.start[0]);
    for (unsigned p = 0; p < mission.places; p++) {
      const long way = flooded[mission.place[p]];
      set_way(node, p, way < 0 ? QTR_NEVER : (qtr_steps)way);
    }
  }
}

/* Places on a line, and the start as one more node. */
static inline void corridor(unsigned places, const int *at, const double *weights, int start) {
  ground_begin(places);
  memcpy(mission.weight, weights, places * sizeof *weights);
  for (unsigned node = 0; node <= places; node++)
    for (unsigned p = 0; p < places; p++) {
      const int from = node < places ? at[node] : start;
      set_way(node, p, (qtr_steps)(from < at[p] ? at[p] - from : from - at[p]));
    }
}

/* Any travel times at all: not symmetric, no triangle inequality. */
static inline void scatter(test_random *random, unsigned places, qtr_steps longest) {
  ground_begin(places);
  for (unsigned p = 0; p < places; p++) mission.weight[p] = 0.01 + random_unit(random);
  for (unsigned node = 0; node <= places; node++)
    for (unsigned p = 0; p < places; p++) set_way(node, p, node == p ? 0 : random_in(random, 1, longest));
}

#endif

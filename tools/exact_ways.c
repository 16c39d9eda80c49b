#include "exact_ways.h"

#include <stdlib.h>
#include <string.h>

/* So short that the time until a seeker is ready, all looks one after another and the way home are no QTR_NEVER
 * together. */
#define LONGEST_WAY (QTR_NEVER / (4 * (EXACT_TERMS_LOOKS + 2)))

typedef struct {
  const qtr_mission *mission;
  const qtr_robot_class *robot_class; /* the seeker's */
  qtr_travel *travel;
  qtr_grid grid; /* the ground as the seeker sees it */
} surveyor;

/* Rough cells are walls to who may not enter them, but for the cell that it sets out from and comes home to. */
static void see_ground(uint8_t *ground, const qtr_mission *mission, int seeker) {
  const bool smooth_only = mission->robot_class[mission->class_of[seeker]].smooth_only;
  for (uint32_t cell = 0; cell < qtr_mission_cells(mission); cell++) {
    const bool wall = smooth_only && mission->cost[cell] > 1 && cell != mission->start[seeker];
    ground[cell] = wall ? 0 : mission->cost[cell];
  }
}

/* Of the class's steps from a cell to where the travel times lead, then `scan`. -1: too long. */
static int add_up(qtr_steps *sum, const surveyor *survey, qtr_cell from, qtr_steps scan) {
  const qtr_steps base = survey->travel->to_go[from];
  const uint64_t steps = (uint64_t)base * survey->robot_class->cell_steps + scan;
  *sum = base == QTR_NEVER ? QTR_NEVER : (qtr_steps)steps;
  return base == QTR_NEVER || steps <= LONGEST_WAY ? 0 : -1;
}

static qtr_cell cell_of(const surveyor *survey, int seeker, int node) {
  return node < survey->mission->places ? survey->mission->place[node] : survey->mission->start[seeker];
}

static int measure_to_place(exact_ways *ways, const surveyor *survey, int seeker, int place) {
  int status = 0;
  const bool avoided = qtr_places_has(&survey->robot_class->avoided, (unsigned)place);
  qtr_travel_fill(survey->travel, &survey->grid, survey->mission->place[place]);
  for (int node = 0; node <= survey->mission->places; node++) {
    qtr_steps *leg = &ways->leg[seeker][node][place];
    status |= add_up(leg, survey, cell_of(survey, seeker, node), survey->robot_class->scan[place]);
    if (avoided) *leg = QTR_NEVER;
  }
  return status;
}

static int measure_seeker(exact_ways *ways, const surveyor *survey, int seeker) {
  int status = 0;
  for (int p = 0; p < survey->mission->places; p++) status |= measure_to_place(ways, survey, seeker, p);
  qtr_travel_fill(survey->travel, &survey->grid, survey->mission->start[seeker]);
  for (int node = 0; node <= survey->mission->places; node++)
    status |= add_up(&ways->home[seeker][node], survey, cell_of(survey, seeker, node), 0);
  return status | (survey->mission->ready[seeker] <= LONGEST_WAY ? 0 : -1);
}

int exact_measure_ways(exact_ways *ways, const qtr_mission *mission, qtr_travel *travel, fault *why) {
  uint8_t *ground = malloc(qtr_mission_cells(mission));
  surveyor survey = {.mission = mission, .travel = travel, .grid = qtr_mission_grid(mission)};
  if (ground == NULL) return fault_set(why, "exact: out of memory; use `quarter learn`");
  int status = 0;
  survey.grid.cells = ground;
  for (int i = 0; i < mission->seekers; i++) {
    see_ground(ground, mission, i);
    survey.robot_class = &mission->robot_class[mission->class_of[i]];
    status |= measure_seeker(ways, &survey, i);
  }
  free(ground);
  return status == 0 ? 0 : fault_set(why, "exact: a way takes too many steps to add up; use longer steps");
}

/* A mission: the problem that the learner solves. Plain data, filled by the caller; large, keep it in static
 * storage. */
#ifndef QUARTER_MISSION_H
#define QUARTER_MISSION_H

#include "quarter/config.h"
#include "quarter/grid.h"
#include "quarter/joint.h"
#include "quarter/objective.h"
#include "quarter/status.h"
#include "quarter/watch.h"

QTR_C_BEGIN

/* A class of robots: what they differ in. The defaults are a robot's that takes a step for each cell and none to scan,
 * goes everywhere and never tires. */
typedef struct {
  uint32_t cell_steps;            /* 1..65535: steps for a cell of cost 1; a cell of cost c takes c times as many */
  bool smooth_only;               /* may not enter cells of a cost above 1 */
  qtr_steps endurance;            /* from its ready time until it must be home, at its start; QTR_NEVER: no end */
  qtr_places avoided;             /* places that it may not visit */
  qtr_steps scan[QTR_MAX_PLACES]; /* to scan each place: a visit counts, and the seeker goes on, when its scan ends */
} qtr_robot_class;

typedef struct {
  uint32_t made;          /* by qtr_mission_default() */
  uint16_t columns, rows; /* columns * rows <= QTR_MAX_CELLS */
  uint16_t places;        /* 1..QTR_MAX_PLACES */
  uint8_t seekers;        /* 1..QTR_MAX_SEEKERS */
  uint8_t rule;           /* enum qtr_rule */
  qtr_frame frame;        /* where the map lies in the world; goes into the table, the learner ignores it */
  const uint16_t *number; /* of each place in the input, where some were left out; NULL: as here. As the frame */
  uint32_t step_time_us;  /* microseconds a step; 0: not said. As the frame */
  qtr_aim aim;            /* what it is played for */
  qtr_cell start[QTR_MAX_SEEKERS]; /* free cells, may coincide */
  qtr_cell place[QTR_MAX_PLACES];  /* free cells, all different */
  double weight[QTR_MAX_PLACES];   /* likelihood of each place, above 0, in any unit: normalised to sum 1 */
  /* The field's terms: by default there is one class, all are ready at once, and one look finds what is there. */
  uint8_t classes;                              /* 1..QTR_MAX_CLASSES */
  qtr_robot_class robot_class[QTR_MAX_CLASSES]; /* the first is set by default; see qtr_robot_class_default() */
  uint8_t class_of[QTR_MAX_SEEKERS];            /* of each seeker, 0..classes-1 */
  qtr_steps ready[QTR_MAX_SEEKERS];             /* step from which it is in the game */
  double detection[QTR_MAX_PLACES];             /* q: probability that a look finds what is there, above 0 up to 1 */
  uint8_t looks[QTR_MAX_PLACES];                /* at each place at most, 1 or more; in all QTR_MAX_PLACES */
  qtr_watch watch;                              /* ends long work on the mission early; none by default */
  uint8_t cost[QTR_MAX_CELLS]; /* 0 = blocked, 1..255 = steps that entering the cell takes; row 0 on top */
} qtr_mission;

/* An empty mission with the defaults: discounted, free rule, gamma 0.99. Its cells, megabytes of them, are left as they
 * are: fill all of columns x rows in. QTR_OK, or QTR_ERR_CONFIG with nothing written
 * if the caller was built under other sizes. */
#define qtr_mission_default(mission) qtr_mission_default_built(mission, QTR_CONFIG_ID)
int qtr_mission_default_built(qtr_mission *mission, uint32_t config_id);

/* A class as the default mission's. */
void qtr_robot_class_default(qtr_robot_class *robot_class);

/* QTR_OK, QTR_ERR_ARGUMENT for a mission that is not from its default, or what else is wrong (QTR_ERR_LIMIT, _ARGUMENT,
 * _NO_START, _NO_PLACE, _START, _PLACE, _WEIGHT) and in `*culprit` (may be NULL) the index of the start or place at
 * fault. Reachability is checked with the travel times. */
int qtr_mission_check(const qtr_mission *mission, int *culprit);

/* Cells of its map, blocked ones included. */
static inline uint32_t qtr_mission_cells(const qtr_mission *mission) {
  return (uint32_t)mission->columns * mission->rows;
}

/* The mission's cells as a grid; lives as long as the mission. */
qtr_grid qtr_mission_grid(const qtr_mission *mission);

QTR_C_END

#endif

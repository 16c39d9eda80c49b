#include "quarter/mission.h"

#include <float.h>
#include <stddef.h>
#include <string.h>

#include "model/rounding.h"
#include "model/settings.h"

void qtr_robot_class_default(qtr_robot_class *robot_class) {
  memset(robot_class, 0, sizeof *robot_class);
  robot_class->cell_steps = 1;
  robot_class->endurance = QTR_NEVER;
}

/* Free rule: places divide among the seekers, and routes can be told apart, which local search and aggregates need. */
int qtr_mission_default_built(qtr_mission *mission, uint32_t config_id) {
  if (config_id != QTR_CONFIG_ID) return QTR_ERR_CONFIG;
  memset(mission, 0, offsetof(qtr_mission, cost));
  mission->made = SETTINGS_MADE;
  qtr_aim_default(&mission->aim);
  mission->rule = QTR_RULE_FREE;
  mission->classes = 1;
  for (unsigned i = 0; i < QTR_MAX_CLASSES; i++) qtr_robot_class_default(&mission->robot_class[i]);
  for (unsigned place = 0; place < QTR_MAX_PLACES; place++) {
    mission->detection[place] = 1.0;
    mission->looks[place] = 1;
  }
  return QTR_OK;
}

/* A view, no copy: a byte a cell is a grid as it is. */
qtr_grid qtr_mission_grid(const qtr_mission *mission) {
  const qtr_grid grid = {mission->columns, mission->rows, QTR_GRID_BYTES, mission->cost};
  return grid;
}

/* Limits first: an index beyond an array must not be looked at, even to say what is wrong with it. */
static int check_dimensions(const qtr_mission *mission) {
  const uint32_t cells = qtr_mission_cells(mission);
  if (mission->made != SETTINGS_MADE) return QTR_ERR_ARGUMENT;
  if (cells > QTR_MAX_CELLS || mission->places > QTR_MAX_PLACES || mission->seekers > QTR_MAX_SEEKERS)
    return QTR_ERR_LIMIT;
  if (cells == 0) return QTR_ERR_ARGUMENT;
  if (mission->seekers == 0) return QTR_ERR_NO_START;
  return mission->places == 0 ? QTR_ERR_NO_PLACE : QTR_OK;
}

static int check_aim(const qtr_mission *mission) {
  if (mission->rule > QTR_RULE_PAPER) return QTR_ERR_ARGUMENT;
  return qtr_aim_check(&mission->aim);
}

/* Robots set out from free cells and drive to such: travel times are of nothing else. */
static bool is_free(const qtr_mission *mission, qtr_cell cell) {
  return cell < qtr_mission_cells(mission) && mission->cost[cell] > 0;
}

/* A place twice would be one place whose visit counts two times, at two moments. Weights are such that their sum is a
 * double. */
static int check_place(const qtr_mission *mission, int place) {
  if (!is_free(mission, mission->place[place])) return QTR_ERR_PLACE;
  for (int before = 0; before < place; before++)
    if (mission->place[before] == mission->place[place]) return QTR_ERR_PLACE;
  const double weight = mission->weight[place];
  return weight > 0.0 && weight <= DBL_MAX / QTR_MAX_PLACES ? QTR_OK : QTR_ERR_WEIGHT;
}

/* ---- the field's terms ---- */

static bool is_class(const qtr_robot_class *it) {
  return it->cell_steps > 0 && it->cell_steps <= UINT16_MAX && it->endurance > 0;
}

static int check_classes(const qtr_mission *mission, int *at) {
  if (mission->classes > QTR_MAX_CLASSES) return QTR_ERR_LIMIT;
  for (*at = 0; *at < mission->classes; ++*at)
    if (!is_class(&mission->robot_class[*at])) return QTR_ERR_CLASS;
  for (*at = 0; *at < mission->seekers; ++*at)
    if (mission->class_of[*at] >= mission->classes || mission->ready[*at] == QTR_NEVER) return QTR_ERR_CLASS;
  return QTR_OK;
}

/* Looks that take no time would all be made in one moment, where the sorted assignment of worths to moments says
 * nothing of which is which. */
static bool takes_time(const qtr_mission *mission, int place) {
  for (unsigned i = 0; i < mission->classes; i++) {
    const qtr_robot_class *of = &mission->robot_class[i];
    if (of->scan[place] == 0 && !qtr_places_has(&of->avoided, (unsigned)place)) return false;
  }
  return true;
}

static int check_looks(const qtr_mission *mission, int *at) {
  uint32_t looks = 0;
  for (*at = 0; *at < mission->places; ++*at) {
    const double detection = mission->detection[*at];
    if (!(detection > 0.0 && detection <= 1.0) || mission->looks[*at] == 0) return QTR_ERR_LOOKS;
    if (mission->looks[*at] > 1 && !takes_time(mission, *at)) return QTR_ERR_LOOKS;
    looks += mission->looks[*at];
    if (looks > QTR_MAX_PLACES) return QTR_ERR_LIMIT;
  }
  return QTR_OK;
}

static bool is_plain_place(const qtr_mission *mission, unsigned place) {
  const qtr_robot_class *all = &mission->robot_class[0];
  return mission->looks[place] == 1 && mission->detection[place] == 1.0 && all->scan[place] == 0 &&
         !qtr_places_has(&all->avoided, place);
}

static bool is_plain_class(const qtr_robot_class *all) {
  return all->endurance == QTR_NEVER && all->cell_steps == 1 && !all->smooth_only;
}

/* All alike, ready and untiring, that find what is there at a glance: the paper's game. */
static bool is_plain(const qtr_mission *mission) {
  if (mission->classes > 1 || !is_plain_class(&mission->robot_class[0])) return false;
  if (mission->aim.kind == QTR_DEADLINE || mission->aim.home_weight > 0.0) return false;
  for (unsigned i = 0; i < mission->seekers; i++)
    if (mission->ready[i] > 0) return false;
  for (unsigned place = 0; place < mission->places; place++)
    if (!is_plain_place(mission, place)) return false;
  return true;
}

/* Under expected time robots with an end and without one would be played for different sums. */
static int check_endurance(const qtr_mission *mission, int *at) {
  if (mission->aim.kind != QTR_TIME) return QTR_OK;
  const bool tires = mission->robot_class[mission->class_of[0]].endurance != QTR_NEVER;
  for (*at = 0; *at < mission->seekers; ++*at)
    if ((mission->robot_class[mission->class_of[*at]].endurance != QTR_NEVER) != tires) return QTR_ERR_CLASS;
  return QTR_OK;
}

static int check_terms(const qtr_mission *mission, int *at) {
  int status = check_classes(mission, at);
  if (status == QTR_OK) status = check_looks(mission, at);
  if (status == QTR_OK) status = check_endurance(mission, at);
  if (status != QTR_OK || ((QTR_TERMS) && mission->rule == QTR_RULE_FREE)) return status;
  *at = 0;
  return is_plain(mission) ? QTR_OK : QTR_ERR_ARGUMENT;
}

/* What is refused here is what no search can make good; whether places can be reached, only travel times tell. */
int qtr_mission_check(const qtr_mission *mission, int *culprit) {
  int nobody;
  int *const at = culprit != NULL ? culprit : &nobody;
  *at = 0;
  int status = check_dimensions(mission);
  if (status == QTR_OK) status = check_aim(mission);
  if (status != QTR_OK) return status;
  for (*at = 0; *at < mission->seekers; ++*at)
    if (!is_free(mission, mission->start[*at])) return QTR_ERR_START;
  for (*at = 0; *at < mission->places; ++*at) {
    status = check_place(mission, *at);
    if (status != QTR_OK) return status;
  }
  status = check_terms(mission, at);
  if (status == QTR_OK) *at = 0;
  return status;
}

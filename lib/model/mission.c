#include "quarter/mission.h"

#include <float.h>
#include <stddef.h>
#include <string.h>

#include "model/rounding.h"
#include "model/settings.h"

/* Free rule: places divide among the seekers, and routes can be told apart, which local search and aggregates need. */
int qtr_mission_default_built(qtr_mission *mission, uint32_t config_id) {
  if (config_id != QTR_CONFIG_ID) return QTR_ERR_CONFIG;
  memset(mission, 0, sizeof *mission);
  mission->made = SETTINGS_MADE;
  qtr_aim_default(&mission->aim);
  mission->rule = QTR_RULE_FREE;
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
  *at = 0;
  return QTR_OK;
}

#include "host/table/robot_needs.h"

robot_sizes robot_needs(const qtr_policy *policy) {
  const robot_sizes needed = {{[ROBOT_CELLS] = qtr_grid_cells(&policy->grid),
                               [ROBOT_PLACES] = policy->board.places,
                               [ROBOT_SEEKERS] = policy->board.seekers}};
  return needed;
}

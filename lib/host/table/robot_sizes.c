/* config.h as a build sees it that chooses the robots' profile and nothing else. Its numbers alone are taken: its types
 * are not this build's. */
#undef QTR_CONFIG_HEADER
#undef QTR_MAX_CELLS
#undef QTR_MAX_PLACES
#undef QTR_MAX_SEEKERS
#undef QTR_PROFILE_TINY
#undef QTR_PROFILE_MCU
#define QTR_PROFILE_MCU
#include "host/table/robot_sizes.h"
#include "quarter/config.h"

const robot_sizes robot_sizes_mcu = {
    {[ROBOT_CELLS] = QTR_MAX_CELLS, [ROBOT_PLACES] = QTR_MAX_PLACES, [ROBOT_SEEKERS] = QTR_MAX_SEEKERS}};

#define PREFIX "QTR_MAX_"

const char *const robot_size_macro[ROBOT_SIZES] = {
    [ROBOT_CELLS] = PREFIX "CELLS", [ROBOT_PLACES] = PREFIX "PLACES", [ROBOT_SEEKERS] = PREFIX "SEEKERS"};

const uint32_t robot_size_most[ROBOT_SIZES] = {[ROBOT_CELLS] = 16777216, [ROBOT_PLACES] = 4096, [ROBOT_SEEKERS] = 64};

const char *robot_size_word(int size) {
  return robot_size_macro[size] + sizeof PREFIX - 1;
}

bool robot_sizes_fit(const robot_sizes *built, const robot_sizes *needed) {
  for (int i = 0; i < ROBOT_SIZES; i++)
    if (built->of[i] < needed->of[i]) return false;
  return true;
}

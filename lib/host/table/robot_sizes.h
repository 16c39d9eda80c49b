/* The array sizes of a robot's build that decide whether a table fits it. */
#ifndef QUARTER_HOST_ROBOT_SIZES_H
#define QUARTER_HOST_ROBOT_SIZES_H

#include <stdbool.h>
#include <stdint.h>

enum robot_size { ROBOT_CELLS, ROBOT_PLACES, ROBOT_SEEKERS, ROBOT_SIZES };

typedef struct {
  uint32_t of[ROBOT_SIZES];
} robot_sizes;

/* The macros of quarter/config.h, QTR_MAX_CELLS and so on; and of their names what each has for itself: CELLS. */
extern const char *const robot_size_macro[ROBOT_SIZES];
const char *robot_size_word(int size);

/* What quarter/config.h takes of each at most. */
extern const uint32_t robot_size_most[ROBOT_SIZES];

/* Those of the profile QTR_PROFILE_MCU, whatever this build's are. */
extern const robot_sizes robot_sizes_mcu;

/* Whether a build of the sizes `built` holds what is needed. */
bool robot_sizes_fit(const robot_sizes *built, const robot_sizes *needed);

#endif

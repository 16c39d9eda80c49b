/* An input made ready to learn on: read, overridden where its settings say so, its elemental tasks solved. */
#ifndef QUARTER_HOST_PROBLEM_H
#define QUARTER_HOST_PROBLEM_H

#include "host/base/fault.h"
#include "host/base/memory.h"
#include "host/input/input.h"
#include "host/plan/pace.h"
#include "host/plan/plan_config.h"
#include "quarter/game.h"

/* Large: keep it in static storage. */
typedef struct {
  input in;
  memory_block game_block, travel_block; /* as large as the mission asks for */
  qtr_game *game;                        /* in them */
  qtr_travel *travel;
  pace pace;             /* seconds a step */
  double travel_seconds; /* that the elemental tasks took */
} problem;

/* Read the input `path` and override it, all but the travel times. 0, or -1 with *why set. */
int problem_load(problem *p, const char *path, const plan_config *config, fault *why);

/* Room for the game of its mission, or of what is left of it, and for travel times on its map. 0, or -1 with *why
 * set. */
int problem_need_game(problem *p, fault *why);

/* Set its game up: the elemental tasks. Places that no seeker can reach are an error that names them, or are left out
 * if the settings say so. The input's notes are printed. 0, or -1 with *why set. */
int problem_measure(problem *p, const plan_config *config, fault *why);

/* Give back what it took besides itself. */
void problem_give_back(problem *p);

/* Free cells of the map. */
uint32_t problem_free_cells(const problem *p);

#endif

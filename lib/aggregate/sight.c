#include "aggregate/sight.h"

#include <string.h>

#include "quarter/status.h"

/* Keys as the ground has them: time left is seen to the step, and needs no estimate. */
void qtr_sight_exact(qtr_sight *sight, const qtr_game *game) {
  sight->game = game;
  sight->regions = NULL;
  sight->estimating = false;
}

/* ---- ways and times ---- */

/* The true way, by which seekers go on unseen: a direction a cell, in two bits where a time takes 32. */
static void note_way(qtr_sight *sight, const qtr_grid *grid, const qtr_travel *travel, unsigned place) {
  const uint32_t cells = qtr_grid_cells(grid);
  uint8_t *way = sight->way + (size_t)place * sight->way_bytes;
  memset(way, 0, sight->way_bytes);
  for (uint32_t cell = 0; cell < cells; cell++) {
    const qtr_cell next = qtr_travel_next(travel, grid, (qtr_cell)cell);
    if (qtr_grid_cost(grid, (qtr_cell)cell) == 0 || next == QTR_NO_CELL) continue;
    for (unsigned direction = QTR_NORTH; direction <= QTR_WEST; direction++)
      if (qtr_grid_neighbour(grid, (qtr_cell)cell, (enum qtr_direction)direction) == next)
        way[cell / 4] = (uint8_t)(way[cell / 4] | direction << 2 * (cell % 4));
  }
}

static uint32_t way_bytes(const qtr_game *game) {
  return (qtr_mission_cells(game->mission) + 3) / 4;
}

size_t qtr_sight_bytes(const qtr_game *game, uint32_t regions) {
  return (size_t)game->board.places * (regions * sizeof(qtr_steps) + way_bytes(game));
}

int qtr_sight_by_regions(qtr_sight *sight, void *block, const qtr_game *game, const qtr_regions *regions, uint8_t times,
                         qtr_travel *travel) {
  const qtr_grid grid = qtr_mission_grid(game->mission);
  const unsigned places = game->board.places;
  sight->game = game;
  sight->regions = regions;
  sight->estimating = times == QTR_TIMES_STANDING;
  sight->estimate = block;
  sight->way = (uint8_t *)(sight->estimate + (size_t)regions->count * places);
  sight->way_bytes = way_bytes(game);
  for (unsigned place = 0; place < places; place++) {
    if (!qtr_watch_go_on(&game->mission->watch)) return QTR_ERR_STOPPED;
    qtr_travel_fill(travel, &grid, game->mission->place[place]);
    note_way(sight, &grid, travel, place);
    for (uint32_t region = 0; region < regions->count; region++)
      sight->estimate[(size_t)region * places + place] = travel->to_go[regions->representative[region]];
  }
  return QTR_OK;
}

/* ---- walks ---- */

/* Only asked on a way that there is: a direction of 0 is north, and says nothing where no way was noted. */
static qtr_cell next_cell(const qtr_sight *sight, const qtr_grid *grid, qtr_cell cell, unsigned place) {
  const uint8_t *way = sight->way + (size_t)place * sight->way_bytes;
  return qtr_grid_neighbour(grid, cell, (enum qtr_direction)((unsigned)way[cell / 4] >> 2 * (cell % 4) & 3u));
}

/* What is not enough to enter the next cell is carried over: cells take their whole cost, so that many short stretches
 * come as far as a long one. */
void qtr_sight_walk(const qtr_sight *sight, qtr_walk *walk, const qtr_tour *tour, qtr_steps steps) {
  const qtr_mission *mission = sight->game->mission;
  const qtr_grid grid = qtr_mission_grid(mission);
  qtr_steps left = steps + walk->carried;
  for (;;) {
    const uint16_t goal = tour->place[walk->stage];
    if (walk->cell == mission->place[goal]) {
      if (walk->stage + 1u == tour->places) left = 0;
      if (left == 0) break;
      walk->stage++;
      continue;
    }
    const qtr_cell next = next_cell(sight, &grid, walk->cell, goal);
    /* A way leads over free cells, and each takes a step at least: so the walk ends. */
    QTR_ASSERT(next != QTR_NO_CELL && mission->cost[next] > 0);
    if (left < mission->cost[next]) break;
    left -= mission->cost[next];
    walk->cell = next;
  }
  walk->carried = left;
}

/* ---- what is seen ---- */

/* d(representative, next place of the tour) + what follows it (section 5.2.3): alike for all cells of a region, so that
 * tau is. A seeker that is not there yet may be seen there: then a step, or time would not pass. */
qtr_steps qtr_sight_left(const qtr_sight *sight, const qtr_walk *walk, const qtr_tour *tour, qtr_steps exact) {
  if (!sight->estimating) return exact;
  /* Who walks is on its way to one of its tour's places: those before it are done. */
  QTR_ASSERT(walk->stage < tour->places);
  const size_t row = (size_t)sight->regions->of[walk->cell] * sight->game->board.places;
  const qtr_steps left =
      sight->estimate[row + tour->place[walk->stage]] + qtr_tour_length(tour) - tour->step[walk->stage];
  return left > 0 ? left : 1;
}

/* Region and stage in one digit: with the first place of the tour, which the node's digit tells, they are what is
 * seen. */
qtr_steps qtr_sight_digit(const qtr_sight *sight, const qtr_walk *walk, bool is_idle) {
  /* Who is seen stands on a free cell, and each of those has a region: the digit is below its base. */
  QTR_ASSERT(sight->regions->of[walk->cell] < sight->regions->count);
  return (qtr_steps)sight->regions->of[walk->cell] * QTR_MAX_SPOT_SIZE + (is_idle ? 0u : walk->stage);
}

qtr_steps qtr_sight_last_digit(const qtr_sight *sight) {
  return sight->regions->count * QTR_MAX_SPOT_SIZE - 1;
}

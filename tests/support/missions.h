/* Missions for the tests: from a drawing in a string, or at random. */
#ifndef QUARTER_TESTS_MISSIONS_H
#define QUARTER_TESTS_MISSIONS_H

#include <string.h>

#include "quarter/mission.h"
#include "random.h"

static inline void draw_cell(qtr_mission *mission, char glyph, qtr_cell cell) {
  mission->cost[cell] = glyph == '#' ? 0 : glyph == '~' ? 3 : 1;
  if (glyph == 'S') mission->start[mission->seekers++] = cell;
  if (glyph < '1' || glyph > '9') return;
  mission->weight[mission->places] = glyph - '0';
  mission->place[mission->places++] = cell;
}

/* `rows` are separated by '/'. '#' blocked, '~' cost 3, 1..9 a place of that weight, S a seeker. */
static inline void mission_draw(qtr_mission *mission, const char *rows) {
  const char *slash = strchr(rows, '/');
  qtr_cell cell = 0;
  qtr_mission_default(mission);
  mission->columns = (uint16_t)(slash != NULL ? (size_t)(slash - rows) : strlen(rows));
  for (const char *at = rows; *at != '\0'; at++)
    if (*at != '/') draw_cell(mission, *at, cell++);
  mission->rows = (uint16_t)(cell / mission->columns);
}

/* Put `seekers` on the drawing's one start. */
static inline void mission_crew(qtr_mission *mission, uint8_t seekers) {
  for (unsigned i = 1; i < seekers; i++) mission->start[i] = mission->start[0];
  mission->seekers = seekers;
}

/* The cell next to `at` in a direction 0..3; -1 if there is none, or it is blocked. */
static inline long free_neighbour(const qtr_mission *mission, long at, long way) {
  const long columns = mission->columns;
  const long next = at + (way == 0 ? -columns : way == 1 ? 1 : way == 2 ? columns : -1);
  if (next < 0 || next >= columns * mission->rows) return -1;
  if (way % 2 == 1 && next / columns != at / columns) return -1;
  return mission->cost[next] > 0 ? next : -1;
}

/* Steps from cell `from` to every cell; -1 where there is no way. Bellman-Ford: no queue, no order. */
static inline void flood(long *steps, const qtr_mission *mission, qtr_cell from) {
  const long cells = (long)mission->columns * mission->rows;
  for (long c = 0; c < cells; c++) steps[c] = -1;
  steps[from] = 0;
  for (bool moved = true; moved;) {
    moved = false;
    for (long c = 0; c < 4 * cells; c++) {
      const long next = steps[c / 4] < 0 ? -1 : free_neighbour(mission, c / 4, c % 4);
      const long then = next < 0 ? 0 : steps[c / 4] + mission->cost[next];
      if (next < 0 || (steps[next] >= 0 && steps[next] <= then)) continue;
      steps[next] = then;
      moved = true;
    }
  }
}

/* Several looks at some places, with which there are so many in all at most. */
static inline void mission_look_again(qtr_mission *mission, test_random *random, unsigned most) {
  unsigned looks = mission->places;
  for (unsigned place = 0; place < mission->places; place++) {
    const unsigned more = random_below(random, 3);
    if (looks + more > most) continue;
    looks += more;
    mission->looks[place] = (uint8_t)(1 + more);
    mission->detection[place] = 0.2 + 0.7 * random_unit(random);
    mission->robot_class[0].scan[place] = random_in(random, 1, 3);
  }
}

typedef struct {
  unsigned columns, rows;   /* at most */
  unsigned places, seekers; /* at most */
} mission_size;

static inline void random_ground(qtr_mission *mission, test_random *random, const mission_size *most) {
  static const unsigned costs[4] = {1, 1, 4, 255};
  const unsigned walls = random_below(random, 40);
  const unsigned dearest = costs[random_below(random, 4)];
  mission->columns = (uint16_t)random_in(random, 1, most->columns);
  mission->rows = (uint16_t)random_in(random, 1, most->rows);
  for (unsigned cell = 0; cell < (unsigned)mission->columns * mission->rows; cell++)
    mission->cost[cell] = random_chance(random, walls) ? 0 : (uint8_t)random_in(random, 1, dearest);
}

static inline bool is_taken(const qtr_mission *mission, qtr_cell cell) {
  for (unsigned place = 0; place < mission->places; place++)
    if (mission->place[place] == cell) return true;
  return mission->cost[cell] == 0;
}

static inline void random_people(qtr_mission *mission, test_random *random, const mission_size *most) {
  const unsigned cells = (unsigned)mission->columns * mission->rows;
  const unsigned places = random_in(random, 1, most->places);
  const unsigned seekers = random_in(random, 1, most->seekers);
  const bool together = random_chance(random, 40);
  for (unsigned tries = 0; mission->places < places && tries < 200; tries++) {
    const qtr_cell cell = (qtr_cell)random_below(random, cells);
    if (is_taken(mission, cell)) continue;
    mission->weight[mission->places] = random_chance(random, 50) ? random_in(random, 1, 9) : 0.01 + random_unit(random);
    mission->place[mission->places++] = cell;
  }
  for (unsigned tries = 0; mission->seekers < seekers && tries < 200; tries++) {
    const qtr_cell cell = (qtr_cell)random_below(random, cells);
    if (mission->cost[cell] == 0) continue;
    mission->start[mission->seekers++] = cell;
    if (together) mission_crew(mission, (uint8_t)seekers);
  }
}

/* Whether some seeker can reach each place. */
static inline bool all_in_reach(const qtr_mission *mission) {
  static long steps[QTR_MAX_CELLS];
  bool reached[QTR_MAX_PLACES] = {false};
  for (unsigned i = 0; i < mission->seekers; i++) {
    flood(steps, mission, mission->start[i]);
    for (unsigned place = 0; place < mission->places; place++)
      if (steps[mission->place[place]] >= 0) reached[place] = true;
  }
  for (unsigned place = 0; place < mission->places; place++)
    if (!reached[place]) return false;
  return mission->places > 0 && mission->seekers > 0;
}

/* A mission that can be played: any map, some in parts that are cut off from one another, any terrain; seekers apart or
 * together, now and then on a place; either objective, either rule. */
static inline void mission_random(qtr_mission *mission, test_random *random, mission_size most) {
  do {
    qtr_mission_default(mission);
    random_ground(mission, random, &most);
    random_people(mission, random, &most);
  } while (!all_in_reach(mission));
  mission->aim.kind = (uint8_t)random_below(random, 2);
  mission->rule = (uint8_t)random_below(random, 2);
  mission->aim.gamma = random_chance(random, 70) ? 0.99 : 0.98 + 0.0199 * random_unit(random);
}

#endif

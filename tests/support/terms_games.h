/* Small random missions with the field's terms, each named by its seed and its features: what a learner, the exact
 * solver and an enumeration (support/terms_brute.h) are held against one another on. */
#ifndef QUARTER_TESTS_TERMS_GAMES_H
#define QUARTER_TESTS_TERMS_GAMES_H

#include "terms_brute.h"

/* What a game has beside a plain one; any of them together. */
enum terms_feature {
  TERMS_SCAN = 1 << 0,      /* scan times, of places and classes */
  TERMS_LOOKS = 1 << 1,     /* looks that miss, and several of them */
  TERMS_CLASSES = 1 << 2,   /* two or three classes: steps a cell, ground and places that they may not enter */
  TERMS_STARTS = 1 << 3,    /* two seekers or more of one class, from two starts */
  TERMS_READY = 1 << 4,     /* seekers that come later */
  TERMS_ENDURANCE = 1 << 5, /* seekers that must be home in time */
  TERMS_DEADLINE = 1 << 6,  /* played for what is found by a deadline */
  TERMS_HOME = 1 << 7,      /* expected time, coming home counted */
  TERMS_STEPS = 1 << 8,     /* more than one step a cell for all */
  TERMS_FEATURES = 9,
  TERMS_ANY = (1 << TERMS_FEATURES) - 1
};

static const char *const terms_feature_names[TERMS_FEATURES] = {"scan",      "looks",    "classes", "starts", "ready",
                                                                "endurance", "deadline", "home",    "steps"};

/* ---- ground, places and seekers ---- */

/* Returns how many cells are free. */
static inline unsigned terms_ground(qtr_mission *mission, test_random *random) {
  unsigned free_cells = 0;
  const unsigned walls = random_below(random, 30), rough = random_chance(random, 60) ? 25 : 0;
  mission->columns = (uint16_t)random_in(random, 3, 7);
  mission->rows = (uint16_t)random_in(random, 3, 7);
  for (unsigned cell = 0; cell < (unsigned)mission->columns * mission->rows; cell++) {
    mission->cost[cell] = random_chance(random, rough) ? (uint8_t)random_in(random, 2, 4) : 1;
    if (random_chance(random, walls)) mission->cost[cell] = 0;
    free_cells += mission->cost[cell] > 0;
  }
  return free_cells;
}

static inline qtr_cell terms_free_cell(const qtr_mission *mission, test_random *random) {
  qtr_cell cell;
  do cell = (qtr_cell)random_below(random, (unsigned)mission->columns * mission->rows);
  while (mission->cost[cell] == 0);
  return cell;
}

static inline void terms_places(qtr_mission *mission, test_random *random, unsigned least, unsigned most) {
  const unsigned places = random_in(random, least, most);
  while (mission->places < places) {
    const qtr_cell cell = terms_free_cell(mission, random);
    if (is_taken(mission, cell)) continue;
    mission->weight[mission->places] = random_chance(random, 50) ? random_in(random, 1, 9) : 0.1 + random_unit(random);
    mission->place[mission->places++] = cell;
  }
}

static inline void terms_seekers(qtr_mission *mission, test_random *random, unsigned features) {
  const unsigned several = TERMS_CLASSES | TERMS_STARTS | TERMS_READY;
  const bool together = (features & TERMS_STARTS) == 0 && random_chance(random, 50);
  mission->seekers = (uint8_t)random_in(random, features & several ? 2 : 1, TERMS_MOST_SEEKERS);
  for (int i = 0; i < mission->seekers; i++)
    mission->start[i] = together && i > 0 ? mission->start[0] : terms_free_cell(mission, random);
}

/* ---- terms ---- */

static inline void terms_set_looks(qtr_mission *mission, test_random *random) {
  unsigned looks = mission->places;
  for (int p = 0; p < mission->places; p++) {
    mission->detection[p] = random_chance(random, 20) ? 1.0 : 0.3 + 0.7 * random_unit(random);
    const unsigned more = random_below(random, 3);
    if (looks + more > TERMS_MOST_LOOKS - 1) continue;
    mission->looks[p] = (uint8_t)(1 + more);
    looks += more;
  }
}

static inline void terms_set_class(qtr_mission *mission, test_random *random, unsigned features, int number) {
  qtr_robot_class *of = &mission->robot_class[number];
  if (features & TERMS_CLASSES) {
    of->cell_steps = random_in(random, 1, 3);
    of->smooth_only = random_chance(random, 30);
  }
  if (features & TERMS_STEPS) of->cell_steps *= random_in(random, 2, 5);
  for (int p = 0; p < mission->places; p++) {
    if ((features & TERMS_CLASSES) && random_chance(random, 15)) qtr_places_add(&of->avoided, (unsigned)p);
    if (features & TERMS_SCAN) of->scan[p] = random_below(random, 5);
    if (mission->looks[p] > 1 && of->scan[p] == 0) of->scan[p] = random_in(random, 1, 2);
  }
}

static inline void terms_set_classes(qtr_mission *mission, test_random *random, unsigned features) {
  mission->classes = features & TERMS_CLASSES ? (uint8_t)random_in(random, 2, 3) : 1;
  for (int c = 0; c < mission->classes; c++) terms_set_class(mission, random, features, c);
  for (int i = 0; i < mission->seekers; i++) mission->class_of[i] = (uint8_t)random_below(random, mission->classes);
  if (features & TERMS_STARTS) mission->class_of[1] = mission->class_of[0];
}

static inline void terms_set_aim(qtr_mission *mission, test_random *random, unsigned features) {
  static const double gammas[4] = {0.9, 0.95, 0.99, 0.995};
  const bool by_deadline = (features & TERMS_DEADLINE) && (!(features & TERMS_HOME) || random_chance(random, 50));
  mission->aim.gamma = gammas[random_below(random, 4)];
  mission->aim.kind = random_chance(random, 50) ? QTR_TIME : QTR_DISCOUNTED;
  if (features & TERMS_HOME) mission->aim.kind = QTR_TIME;
  if (by_deadline) mission->aim.kind = QTR_DEADLINE;
  if (mission->aim.kind != QTR_TIME || !(features & TERMS_HOME)) return;
  mission->aim.home_weight = random_chance(random, 30) ? 1.0 : 5.0 * random_unit(random) + 0.01;
}

/* ---- what can be played ---- */

/* Nobody sets out from ground that it may not enter. */
static inline void terms_smooth_starts(qtr_mission *mission) {
  for (int i = 0; i < mission->seekers; i++)
    if (terms_class(mission, i)->smooth_only) mission->cost[mission->start[i]] = 1;
}

static inline bool terms_all_in_reach(const terms_ways *ways) {
  for (int p = 0; p < ways->mission->places; p++) {
    bool reached = false;
    for (int i = 0; i < ways->mission->seekers; i++) reached |= ways->leg[i][ways->mission->places][p] >= 0;
    if (!reached) return false;
  }
  return true;
}

/* The step at which the first look can end, its way home walked too if `home`; from who is ready when it is, or from
 * the step 0. */
static inline long terms_soonest(const terms_ways *ways, int seeker, bool home) {
  long soonest = -1;
  for (int p = 0; p < ways->mission->places; p++) {
    const long leg = ways->leg[seeker][ways->mission->places][p];
    const long when = leg + (home && leg >= 0 ? ways->home[seeker][p] : 0);
    if (leg >= 0 && (soonest < 0 || when < soonest)) soonest = when;
  }
  return soonest;
}

/* Under expected time all tire or none. Some class gets somewhere and back, the others perhaps not. */
static inline void terms_set_endurance(const terms_ways *ways, qtr_mission *mission, test_random *random) {
  const int able = (int)random_below(random, mission->seekers);
  for (int i = mission->seekers - 1; i >= 0; i--) {
    const long need = terms_soonest(ways, i, true);
    const long spare = random_below(random, 25) * mission->robot_class[mission->class_of[i]].cell_steps;
    const long endurance = (need < 0 ? 0 : need) + spare - (random_chance(random, 10) ? 5 : 0);
    if (mission->aim.kind != QTR_TIME && random_chance(random, 25)) continue;
    mission->robot_class[mission->class_of[i]].endurance = (qtr_steps)(endurance < 1 ? 1 : endurance);
  }
  const long need = terms_soonest(ways, able, true);
  qtr_robot_class *of = &mission->robot_class[mission->class_of[able]];
  if (need > (long)of->endurance) of->endurance = (qtr_steps)need;
}

/* By when something can be found. */
static inline void terms_set_deadline(const terms_ways *ways, qtr_mission *mission, test_random *random) {
  long soonest = -1;
  for (int i = 0; i < mission->seekers; i++) {
    const long leg = terms_soonest(ways, i, false);
    const long when = leg + (long)mission->ready[i];
    if (leg >= 0 && (soonest < 0 || when < soonest)) soonest = when;
  }
  mission->aim.deadline = (qtr_steps)(soonest + random_below(random, 20));
}

static inline bool terms_something_can_be_found(const terms_ways *ways) {
  const qtr_mission *mission = ways->mission;
  for (int i = 0; i < mission->seekers; i++) {
    for (int p = 0; p < mission->places; p++) {
      const long when = terms_arrival(ways, i, mission->places, (long)mission->ready[i], p);
      const bool in_time = mission->aim.kind != QTR_DEADLINE || when <= (long)mission->aim.deadline;
      if (when >= 0 && in_time) return true;
    }
  }
  return false;
}

static inline bool terms_try(qtr_mission *mission, test_random *random, unsigned features) {
  static terms_ways ways;
  qtr_mission_default(mission);
  if (terms_ground(mission, random) < TERMS_MOST_LOOKS) return false;
  terms_places(mission, random, features & TERMS_LOOKS ? 1 : 2, features & TERMS_LOOKS ? 3 : 5);
  terms_seekers(mission, random, features);
  if (features & TERMS_LOOKS) terms_set_looks(mission, random);
  terms_set_aim(mission, random, features);
  terms_set_classes(mission, random, features);
  terms_smooth_starts(mission);
  if (features & TERMS_READY)
    for (int i = 0; i < mission->seekers; i++) mission->ready[i] = random_below(random, 12);
  terms_measure(&ways, mission);
  if (!terms_all_in_reach(&ways)) return false;
  if (features & TERMS_ENDURANCE) terms_set_endurance(&ways, mission, random);
  if (mission->aim.kind == QTR_DEADLINE) terms_set_deadline(&ways, mission, random);
  return terms_something_can_be_found(&ways);
}

/* Game number `seed` with the features (enum terms_feature) given, under the free rule: 3 x 3 to 7 x 7 cells with walls
 * and rough ground, at most 3 seekers and 5 looks. The features of an aim exclude one another: with a deadline and
 * coming home, it is either. Sets the note that names the seed. */
static inline void terms_game_make(qtr_mission *mission, unsigned seed, unsigned features) {
  test_random random = random_case("terms", seed);
  const size_t noted = strlen(case_note);
  snprintf(case_note + noted, sizeof case_note - noted, ", features 0x%x", features);
  random.state ^= (uint64_t)features << 40;
  while (!terms_try(mission, &random, features)) continue;
}

/* Features of mixed game number `seed`: each as likely as not. */
static inline unsigned terms_mix(unsigned seed) {
  test_random random = random_case("mix", seed);
  return random_below(&random, TERMS_ANY + 1);
}

#endif

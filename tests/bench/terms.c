/* What the field's terms cost: the same maps with them and without, one after the other in one run. */
#include <stdio.h>

#include "bench.h"

enum { MAPS = 20, SIDE = 30, PLACES = 20, SEEKERS = 2 };

#define LIMIT 10.0
#define ENDURANCE 0.8 /* of the longest plain route */

typedef struct {
  double seconds[MAPS];
  unsigned certified;
} tally;

static void count(tally *t, const bench_run *r, unsigned map) {
  t->seconds[map] = r->seconds;
  t->certified += r->certificate.certified;
}

/* ---- the terms ---- */

static void look_twice(qtr_mission *mission) {
  for (unsigned place = 0; place < PLACES; place++) {
    mission->looks[place] = 2;
    mission->detection[place] = 0.8;
    mission->robot_class[0].scan[place] = 2; /* there are no second looks that take no time */
  }
}

/* Steps of the longest of the routes learnt last, up to its last place or until the robot is home again: all start in
 * one cell, and no cell takes more steps than another. */
static qtr_steps longest_route(const qtr_mission *mission, bool with_way_home) {
  const qtr_play *play = qtr_learner_best(bench_learner());
  const qtr_grid grid = qtr_mission_grid(mission);
  qtr_steps last[SEEKERS] = {0}, longest = 0;
  qtr_travel_fill(bench_travel(), &grid, mission->start[0]);
  for (unsigned i = 0; i < play->choices; i++) {
    const unsigned place = play->choice[i];
    if (place >= PLACES) continue;
    const qtr_steps home = with_way_home ? bench_travel()->to_go[mission->place[place]] : 0;
    last[play->seeker[i]] = play->visit[place] + home;
  }
  for (unsigned seeker = 0; seeker < SEEKERS; seeker++)
    if (last[seeker] > longest) longest = last[seeker];
  return longest;
}

/* ---- measuring ---- */

enum term { PLAIN, LOOKS, SHORT_ENDURANCE, LONG_ENDURANCE, TERMS };

static const char *const names[TERMS] = {"plain", "2 looks of q 0.8", "endurance of 0.8 of the longest route",
                                         "endurance of 0.8 of the longest route and its way home"};
static const double targets[TERMS] = {0.0, 4.0, 2.0, 2.0};

static void measure_map(tally *tallies, unsigned map, int objective) {
  qtr_mission *mission = bench_map(map + 1, SIDE, PLACES, SEEKERS, objective);
  bench_run r = bench_learn_for(mission, NULL, LIMIT);
  count(&tallies[PLAIN], &r, map);
  const double route[TERMS] = {
      [SHORT_ENDURANCE] = longest_route(mission, false), [LONG_ENDURANCE] = longest_route(mission, true)};
  for (int term = SHORT_ENDURANCE; term <= LONG_ENDURANCE; term++) {
    mission->robot_class[0].endurance = (qtr_steps)(ENDURANCE * route[term]);
    r = bench_learn_for(mission, NULL, LIMIT);
    count(&tallies[term], &r, map);
  }
  mission->robot_class[0].endurance = QTR_NEVER;
  look_twice(mission);
  r = bench_learn_for(mission, NULL, LIMIT);
  count(&tallies[LOOKS], &r, map);
}

static void measure(int objective) {
  tally tallies[TERMS] = {0};
  double plain = 0.0;
  for (unsigned map = 0; map < MAPS; map++) measure_map(tallies, map, objective);
  for (int term = PLAIN; term < TERMS; term++) {
    tally *t = &tallies[term];
    const double middle = bench_median(t->seconds, MAPS);
    if (term == PLAIN) plain = middle;
    printf("%d places, %d seekers, %s, %s: %u/%d certified  median %.4f s, worst %.3f s", PLACES, SEEKERS,
           bench_objective(objective), names[term], t->certified, MAPS, middle, t->seconds[MAPS - 1]);
    if (term == PLAIN) printf("\n");
    if (term != PLAIN) printf(": %.1f times plain (target: %.0f)\n", middle / plain, targets[term]);
  }
}

void bench_terms(void) {
  for (int objective = QTR_DISCOUNTED; objective <= QTR_TIME; objective++) measure(objective);
}

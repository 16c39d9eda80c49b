/* The optimum of a mission with the field's terms, by going through all plans: who looks where, in which order. A
 * plan's looks are timed one by one and sorted by time; no states, no memory, no bounds, nothing of the core but the
 * mission, nothing of the exact solver. For small games: so many looks by so many seekers. */
#ifndef QUARTER_TESTS_TERMS_BRUTE_H
#define QUARTER_TESTS_TERMS_BRUTE_H

#include <math.h>

#include "missions.h"

enum { TERMS_MOST_LOOKS = 6, TERMS_MOST_SEEKERS = 3, TERMS_MOST_CELLS = 64 };

typedef struct {
  int place;
  long end; /* the step at which its scan is over */
} terms_look;

/* Who looks where, from first to last. */
typedef struct {
  int length[TERMS_MOST_SEEKERS];
  terms_look look[TERMS_MOST_SEEKERS][TERMS_MOST_LOOKS];
} terms_plan;

/* Nodes: the places, then the seeker's own start. */
typedef struct {
  const qtr_mission *mission;
  double total;                                                         /* of the weights */
  long leg[TERMS_MOST_SEEKERS][TERMS_MOST_LOOKS + 1][TERMS_MOST_LOOKS]; /* scan included; -1: none */
  long home[TERMS_MOST_SEEKERS][TERMS_MOST_LOOKS + 1];                  /* -1: none */
} terms_ways;

/* ---- ways ---- */

static inline const qtr_robot_class *terms_class(const qtr_mission *mission, int seeker) {
  return &mission->robot_class[mission->class_of[seeker]];
}

/* Steps from cell to cell of cost 1, for one seeker: over the mission's ground without the cells that it may not
 * enter. */
static inline void terms_flood(long *steps, const qtr_mission *mission, int seeker, qtr_cell from) {
  static qtr_mission ground;
  ground.columns = mission->columns;
  ground.rows = mission->rows;
  for (unsigned cell = 0; cell < (unsigned)mission->columns * mission->rows; cell++) {
    ground.cost[cell] = mission->cost[cell];
    if (terms_class(mission, seeker)->smooth_only && mission->cost[cell] > 1) ground.cost[cell] = 0;
    if (cell == mission->start[seeker]) ground.cost[cell] = mission->cost[cell];
  }
  flood(steps, &ground, from);
}

static inline long terms_steps(long base, const qtr_robot_class *of, long scan) {
  return base < 0 ? -1 : base * (long)of->cell_steps + scan;
}

static inline void terms_measure_node(terms_ways *ways, int seeker, int node) {
  const qtr_mission *mission = ways->mission;
  const qtr_robot_class *of = terms_class(mission, seeker);
  const qtr_cell from = node < mission->places ? mission->place[node] : mission->start[seeker];
  long steps[TERMS_MOST_CELLS];
  terms_flood(steps, mission, seeker, from);
  ways->home[seeker][node] = terms_steps(steps[mission->start[seeker]], of, 0);
  for (int p = 0; p < mission->places; p++) {
    const long leg = terms_steps(steps[mission->place[p]], of, (long)of->scan[p]);
    const bool enters =
        mission->cost[mission->place[p]] == 1 || !of->smooth_only || mission->place[p] == mission->start[seeker];
    ways->leg[seeker][node][p] = qtr_places_has(&of->avoided, (unsigned)p) || !enters ? -1 : leg;
  }
}

static inline void terms_measure(terms_ways *ways, const qtr_mission *mission) {
  ways->mission = mission;
  ways->total = 0.0;
  for (int p = 0; p < mission->places; p++) ways->total += mission->weight[p];
  for (int i = 0; i < mission->seekers; i++)
    for (int node = 0; node <= mission->places; node++) terms_measure_node(ways, i, node);
}

/* When the look of a seeker ends that goes on from `node`, free at step `now`, to `place`, if it may: it has a way, and
 * is at home in time after it. -1: it may not. */
static inline long terms_arrival(const terms_ways *ways, int seeker, int node, long now, int place) {
  const qtr_steps endurance = terms_class(ways->mission, seeker)->endurance;
  const long leg = ways->leg[seeker][node][place];
  if (leg < 0) return -1;
  if (endurance == QTR_NEVER) return now + leg;
  const long end = (long)ways->mission->ready[seeker] + (long)endurance;
  return now + leg + ways->home[seeker][place] <= end ? now + leg : -1;
}

/* ---- what a plan is worth ---- */

static inline bool terms_tires(const qtr_mission *mission) {
  return terms_class(mission, 0)->endurance != QTR_NEVER;
}

static inline long terms_last_end(const qtr_mission *mission) {
  long last = 0;
  for (int i = 0; i < mission->seekers; i++) {
    const long end = (long)mission->ready[i] + (long)terms_class(mission, i)->endurance;
    if (end > last) last = end;
  }
  return last;
}

/* The ends of the looks at one place, the earliest first. Returns how many. */
static inline int terms_sort(long *end, const terms_plan *plan, int seekers, int place) {
  int count = 0;
  for (int i = 0; i < seekers; i++) {
    for (int v = 0; v < plan->length[i]; v++) {
      if (plan->look[i][v].place != place) continue;
      int at = count++;
      for (; at > 0 && end[at - 1] > plan->look[i][v].end; at--) end[at] = end[at - 1];
      end[at] = plan->look[i][v].end;
    }
  }
  return count;
}

/* Looks that can find something: where the first finds what is there, no second. */
static inline int terms_looks_of_use(const qtr_mission *mission, int place) {
  return mission->detection[place] < 1.0 ? mission->looks[place] : 1;
}

typedef struct {
  double discounted, by_deadline, time; /* time: the sum of w t */
  double made, all;                     /* probability of the looks made, and of all that there are */
  bool complete;                        /* all are made */
} terms_sums;

static inline void terms_add_place(terms_sums *sums, const terms_ways *ways, const terms_plan *plan, int place) {
  const qtr_mission *mission = ways->mission;
  const double q = mission->detection[place], share = mission->weight[place] / ways->total;
  long end[TERMS_MOST_LOOKS];
  const int count = terms_sort(end, plan, mission->seekers, place);
  if (count < terms_looks_of_use(mission, place)) sums->complete = false;
  sums->all += share * (1.0 - pow(1.0 - q, mission->looks[place]));
  for (int m = 0; m < count; m++) {
    const double worth = share * q * pow(1.0 - q, m);
    sums->made += worth;
    sums->time += worth * (double)end[m];
    sums->discounted += 10.0 * worth * pow(mission->aim.gamma, end[m] > 1 ? (double)end[m] - 1.0 : 0.0);
    if (end[m] <= (long)mission->aim.deadline) sums->by_deadline += worth;
  }
}

/* Of all seekers: when each is at home. */
static inline double terms_homecoming(const terms_ways *ways, const terms_plan *plan) {
  double sum = 0.0;
  for (int i = 0; i < ways->mission->seekers; i++) {
    const int last = plan->length[i] - 1;
    const terms_look *look = &plan->look[i][last < 0 ? 0 : last];
    sum += last < 0 ? (double)ways->mission->ready[i] : (double)(look->end + ways->home[i][look->place]);
  }
  return sum;
}

/* To be maximised: the objective's figure, the expected time negated; minus infinity for what is no plan. */
static inline double terms_worth(const terms_ways *ways, const terms_plan *plan) {
  const qtr_mission *mission = ways->mission;
  terms_sums sums = {.complete = true};
  for (int p = 0; p < mission->places; p++) terms_add_place(&sums, ways, plan, p);
  if (mission->aim.kind == QTR_DISCOUNTED) return sums.discounted;
  if (mission->aim.kind == QTR_DEADLINE) return sums.by_deadline;
  const double left = sums.all - sums.made;
  if (!terms_tires(mission) && !sums.complete) return -HUGE_VAL;
  if (terms_tires(mission)) sums.time += left * (double)terms_last_end(mission);
  if (mission->aim.home_weight > 0.0)
    sums.time += mission->aim.home_weight / ways->total * terms_homecoming(ways, plan);
  return -sums.time / sums.all;
}

/* ---- all plans ---- */

static inline int terms_looks_planned(const terms_plan *plan, int seekers, int place) {
  int count = 0;
  for (int i = 0; i < seekers; i++)
    for (int v = 0; v < plan->length[i]; v++) count += plan->look[i][v].place == place;
  return count;
}

/* The best plan that goes on from this one by looks of `seeker` and of those after it. */
static inline double terms_best(const terms_ways *ways, terms_plan *plan, int seeker) {
  const qtr_mission *mission = ways->mission;
  if (seeker == mission->seekers) return terms_worth(ways, plan);
  double best = terms_best(ways, plan, seeker + 1); /* it looks no more */
  const int length = plan->length[seeker];
  const terms_look *last = &plan->look[seeker][length > 0 ? length - 1 : 0];
  const int node = length > 0 ? last->place : mission->places;
  const long now = length > 0 ? last->end : (long)mission->ready[seeker];
  for (int p = 0; p < mission->places; p++) {
    const long end = terms_arrival(ways, seeker, node, now, p);
    if (end < 0 || terms_looks_planned(plan, mission->seekers, p) == mission->looks[p]) continue;
    plan->look[seeker][length] = (terms_look){p, end};
    plan->length[seeker] = length + 1;
    best = fmax(best, terms_best(ways, plan, seeker));
    plan->length[seeker] = length;
  }
  return best;
}

/* The optimum in the objective's own unit: the discounted value, the probability by the deadline, the expected time. */
static inline double brute_force_value(const qtr_mission *mission) {
  static terms_ways ways;
  terms_plan plan = {.length = {0}};
  terms_measure(&ways, mission);
  const double best = terms_best(&ways, &plan, 0);
  return mission->aim.kind == QTR_TIME ? -best : best;
}

#endif

/* What a horizon of many steps costs: the same maps with all ways 30 times as long. A second's discount stays what it
 * is, so that it is the same problem in finer steps. */
#include <math.h>
#include <stdio.h>

#include "bench.h"

enum { MAPS = 20, SIDE = 30, STRETCH = 30 };

#define LIMIT 60.0

static void stretch(qtr_mission *mission) {
  mission->robot_class[0].cell_steps = STRETCH;
  mission->aim.gamma = pow(mission->aim.gamma, 1.0 / STRETCH);
}

static void measure(int places, int seekers, int objective) {
  double plain[MAPS], stretched[MAPS];
  unsigned certified = 0;
  for (unsigned map = 0; map < MAPS; map++) {
    qtr_mission *mission = bench_map(map + 1, SIDE, places, seekers, objective);
    plain[map] = bench_learn_for(mission, NULL, LIMIT).seconds;
    stretch(mission);
    const bench_run r = bench_learn_for(mission, NULL, LIMIT);
    stretched[map] = r.seconds;
    certified += r.certificate.certified;
  }
  const double before = bench_median(plain, MAPS);
  const double after = bench_median(stretched, MAPS);
  printf("%d places, %d seekers, %-10s  all ways times %d: %u/%d certified  median %.4f s, worst %.3f s; plain %.4f s, "
         "%.3f s: %.1f times the time (target: 3)\n",
         places, seekers, bench_objective(objective), STRETCH, certified, MAPS, after, stretched[MAPS - 1], before,
         plain[MAPS - 1], after / before);
}

void bench_horizon(void) {
  for (int objective = QTR_DISCOUNTED; objective <= QTR_TIME; objective++) {
    measure(20, 2, objective);
    measure(26, 3, objective);
  }
}

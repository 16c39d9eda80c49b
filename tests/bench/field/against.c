#include "field/against.h"

#define ROUNDING 1e-9 /* relative: what adding up in another order may come to */

/* How much better a figure is than the optimum, relative to it; below 0: worse. */
static double ahead(int objective, double figure, double optimum) {
  const double more = (figure - optimum) / optimum;
  return objective == QTR_TIME ? -more : more;
}

/* The gap is told in shares of the plan, which is up to 1 / (1 - gap) times the optimum. */
const char *against_optimum(const qtr_certificate *certificate, int objective, double gap, double optimum) {
  const double plan = ahead(objective, certificate->objective, optimum);
  if (ahead(objective, certificate->bound, optimum) < -ROUNDING) return "the bound is past the optimum";
  if (plan > ROUNDING) return "the plan is better than the optimum";
  if (certificate->certified && -plan > gap / (1.0 - gap) + ROUNDING) return "the certified plan is not within its gap";
  return NULL;
}

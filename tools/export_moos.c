/* MOOS-IvP: the `points` of a waypoint behaviour, to be included in a vehicle's .bhv file. x is east of the datum and y
 * north. */
#include <inttypes.h>

#include "export_parts.h"
#include "figures.h"

static void put_way(FILE *out, const export_plan *plan, const export_way *w) {
  fprintf(out, "// %s of %s, x,y in metres\n", table_robot_name(plan->t, w->robot).text, plan->source);
  if (plan->t->geo.given)
    fprintf(out, "// LatOrigin = %.9f, LongOrigin = %.9f\n", (double)plan->t->geo.latitude / (double)QTR_GEO_ONE,
            (double)plan->t->geo.longitude / (double)QTR_GEO_ONE);
  for (size_t i = 0; i < w->count; i++)
    if (w->point[i].place != WAY_NO_PLACE)
      fprintf(out, "// %s at %.2f,%.2f, step %" PRIu32 "%s\n",
              table_place_name(plan->t, (unsigned)w->point[i].place).text, w->point[i].east, w->point[i].north,
              w->point[i].step, figures_late(w->point[i].late));
  fputs("points = ", out);
  for (size_t i = 0; i < w->count; i++)
    fprintf(out, "%s%.3f,%.3f", i > 0 ? ":" : "", w->point[i].east, w->point[i].north);
  fputc('\n', out);
}

void export_moos(FILE *out, const export_plan *plan) {
  for (int i = 0; i < plan->ways; i++) put_way(out, plan, &plan->way[i]);
}

/* Nav2: a goal of its FollowWaypoints or NavigateThroughPoses action, as YAML. The start is left out, for the robot
 * stands there. */
#include <inttypes.h>
#include <math.h>

#include "export_parts.h"
#include "figures.h"

static void put_pose(FILE *out, const table *t, const export_point *p) {
  fprintf(out, "  - header: {frame_id: map}  # step %" PRIu32 "%s", p->step, figures_late(p->late));
  if (p->place != WAY_NO_PLACE) fprintf(out, ", %s", table_place_name(t, (unsigned)p->place).text);
  fprintf(out,
          "\n    pose:\n      position: {x: %.6f, y: %.6f, z: 0.0}\n"
          "      orientation: {x: 0.0, y: 0.0, z: %.9f, w: %.9f}\n",
          p->x, p->y, sin(p->heading / 2.0), cos(p->heading / 2.0));
}

static void put_way(FILE *out, const export_plan *plan, const export_way *w) {
  const size_t first = export_first(w);
  fprintf(out, "# %s of %s\n", table_robot_name(plan->t, w->robot).text, plan->source);
  fputs(w->count > first ? "poses:\n" : "poses: []\n", out);
  for (size_t i = first; i < w->count; i++) put_pose(out, plan->t, &w->point[i]);
}

void export_nav2(FILE *out, const export_plan *plan) {
  for (int i = 0; i < plan->ways; i++) put_way(out, plan, &plan->way[i]);
}

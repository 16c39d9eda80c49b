/* Comma-separated values, RFC 4180, a waypoint a row: in cells, and in metres and seconds where these are known. */
#include <inttypes.h>
#include <math.h>

#include "export_parts.h"
#include "host/base/separated.h"

/* Nothing where it is not known. */
static void put_number(FILE *out, double number) {
  fputc(',', out);
  if (!isnan(number)) fprintf(out, "%.6f", number);
}

static void put_point(FILE *out, const table *t, int robot, size_t index, const export_point *p) {
  table_name name = table_robot_name(t, robot);
  fprintf(out, "%d,", robot);
  separated_put(out, name.text);
  fprintf(out, ",%zu,", index);
  if (p->place != WAY_NO_PLACE) {
    name = table_place_name(t, (unsigned)p->place);
    fprintf(out, "%u,", t->number[p->place]);
    separated_put(out, name.text);
  } else {
    fputc(',', out);
  }
  fprintf(out, ",%u,%u", p->column, p->row);
  put_number(out, p->x);
  put_number(out, p->y);
  fprintf(out, ",%" PRIu32, p->step);
  put_number(out, p->seconds);
  if (t->claim.deadline > 0) fprintf(out, ",%d", p->late);
  put_number(out, p->hold);
  fputc('\n', out);
}

void export_csv(FILE *out, const export_plan *plan) {
  fprintf(out, "robot,robot_name,waypoint,place,place_name,column,row,x,y,step,seconds%s,hold_seconds\n",
          plan->t->claim.deadline > 0 ? ",after_deadline" : "");
  for (int i = 0; i < plan->ways; i++)
    for (size_t at = 0; at < plan->way[i].count; at++)
      put_point(out, plan->t, plan->way[i].robot, at, &plan->way[i].point[at]);
}

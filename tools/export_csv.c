/* Comma-separated values, RFC 4180, a waypoint a row: in cells, and in metres and seconds where these are known. */
#include <inttypes.h>
#include <math.h>
#include <string.h>

#include "export_parts.h"

static void put_text(FILE *out, const char *text) {
  if (strpbrk(text, ",\"\r\n") == NULL) {
    fputs(text, out);
    return;
  }
  fputc('"', out);
  for (; *text != '\0'; text++) {
    if (*text == '"') fputc('"', out);
    fputc(*text, out);
  }
  fputc('"', out);
}

/* Nothing where it is not known. */
static void put_number(FILE *out, double number) {
  fputc(',', out);
  if (!isnan(number)) fprintf(out, "%.6f", number);
}

static void put_point(FILE *out, const table *t, int robot, size_t index, const export_point *p) {
  table_name name = table_robot_name(t, robot);
  fprintf(out, "%d,", robot);
  put_text(out, name.text);
  fprintf(out, ",%zu,", index);
  if (p->place != WAY_NO_PLACE) {
    name = table_place_name(t, (unsigned)p->place);
    fprintf(out, "%u,", t->number[p->place]);
    put_text(out, name.text);
  } else {
    fputc(',', out);
  }
  fprintf(out, ",%u,%u", p->column, p->row);
  put_number(out, p->x);
  put_number(out, p->y);
  fprintf(out, ",%" PRIu32, p->step);
  put_number(out, p->seconds);
  fputc('\n', out);
}

void export_csv(FILE *out, const export_plan *plan) {
  fputs("robot,robot_name,waypoint,place,place_name,column,row,x,y,step,seconds\n", out);
  for (int i = 0; i < plan->ways; i++)
    for (size_t at = 0; at < plan->way[i].count; at++)
      put_point(out, plan->t, plan->way[i].robot, at, &plan->way[i].point[at]);
}

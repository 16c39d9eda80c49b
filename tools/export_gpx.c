/* GPX 1.1: a route a robot. Where the table says how long a step is, each point has a time, as if the search began at
 * 1970-01-01T00:00:00Z: a plan has no day. */
#include <inttypes.h>
#include <math.h>
#include <time.h>

#include "export_parts.h"
#include "figures.h"
#include "host/base/xml.h"

enum { LONGEST = 200 }; /* characters of a name */

static void put_time(FILE *out, double seconds) {
  const time_t whole = (time_t)floor(seconds);
  struct tm date;
  char text[40];
  if (isnan(seconds) || gmtime_r(&whole, &date) == NULL) return;
  if (strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%S", &date) == 0) return;
  fprintf(out, "<time>%s.%03dZ</time>", text, (int)(1000.0 * (seconds - floor(seconds))));
}

static void put_point(FILE *out, const table *t, const export_point *p, bool is_start) {
  fprintf(out, "    <rtept lat=\"%.9f\" lon=\"%.9f\">", p->latitude, p->longitude);
  put_time(out, p->seconds);
  if (is_start || p->place != WAY_NO_PLACE) {
    fputs("<name>", out);
    xml_text(out, p->place != WAY_NO_PLACE ? table_place_name(t, (unsigned)p->place).text : "start", LONGEST);
    fputs("</name>", out);
  }
  fprintf(out, "<cmt>step %" PRIu32 "%s</cmt></rtept>\n", p->step, figures_late(p->late));
}

void export_gpx(FILE *out, const export_plan *plan) {
  fputs("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
        "<gpx version=\"1.1\" creator=\"Quarter\" xmlns=\"http://www.topografix.com/GPX/1/1\">\n",
        out);
  for (int i = 0; i < plan->ways; i++) {
    const export_way *w = &plan->way[i];
    fputs("  <rte>\n    <name>", out);
    xml_text(out, table_robot_name(plan->t, w->robot).text, LONGEST);
    fprintf(out, "</name>\n    <number>%d</number>\n", w->robot);
    for (size_t at = 0; at < w->count; at++) put_point(out, plan->t, &w->point[at], at == 0);
    fputs("  </rte>\n", out);
  }
  fputs("</gpx>\n", out);
}

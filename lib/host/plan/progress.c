#include "host/plan/progress.h"

#include <math.h>
#include <stdio.h>
#include <unistd.h>

#define REDRAW_SECONDS 0.2
#define MARK_SECONDS 3.0 /* over which the gap's fall is measured */

bool progress_wanted(bool quiet) {
  return !quiet && isatty(STDERR_FILENO);
}

void progress_begin(progress *p, bool quiet, double time_limit, double gap) {
  *p = (progress){progress_wanted(quiet), time_limit, gap, 0.0, 0.0, HUGE_VAL, 0};
}

/* Seconds until the gap is closed if it goes on falling by the same factor a second; the time limit if that is sooner.
 * Below 0: there is no telling yet. */
static double reckon_left(const progress *p, double gap, double seconds) {
  double left = -1.0;
  const double fall = log(p->mark_gap / gap) / (seconds - p->mark);
  if (gap > 0.0 && p->gap > 0.0 && isfinite(fall) && fall > 1e-6) left = log(gap / p->gap) / fall;
  const double limit = p->time_limit - seconds;
  if (p->time_limit > 0.0 && (left < 0.0 || left > limit)) left = limit;
  return left > 0.0 || p->time_limit > 0.0 ? left : -1.0;
}

static void write_left(char *text, size_t size, double left) {
  if (left < 0.0)
    snprintf(text, size, "?");
  else if (left < 100.0)
    snprintf(text, size, "%.0f s", left);
  else if (left < 6000.0)
    snprintf(text, size, "%.0f min", left / 60.0);
  else
    snprintf(text, size, "over %.0f h", floor(left / 3600.0));
}

void progress_show(progress *p, const qtr_certificate *certificate, double seconds) {
  if (!p->shown || seconds - p->last < REDRAW_SECONDS) return;
  char left[32];
  write_left(left, sizeof left, reckon_left(p, certificate->gap, seconds));
  const double rate = (double)(certificate->episodes - p->mark_episodes) / (seconds - p->mark);
  fprintf(stderr, "\r\033[K%.1f s  %llu episodes (%.0f/s)  best %.6g  bound %.6g  gap %.3g%%  left %s", seconds,
          (unsigned long long)certificate->episodes, rate, certificate->objective, certificate->bound,
          100.0 * certificate->gap, left);
  fflush(stderr);
  p->last = seconds;
  if (seconds - p->mark < MARK_SECONDS && isfinite(p->mark_gap)) return;
  p->mark = seconds;
  p->mark_gap = certificate->gap;
  p->mark_episodes = certificate->episodes;
}

void progress_count(progress *p, const char *what, double done, double all, double seconds) {
  if (done <= 1.0) p->mark = seconds;
  if (!p->shown || seconds - p->last < REDRAW_SECONDS) return;
  char text[32];
  double left = done > 1.0 ? (seconds - p->mark) / (done - 1.0) * (all - done) : -1.0;
  if (p->time_limit > 0.0 && (left < 0.0 || left > p->time_limit - seconds)) left = p->time_limit - seconds;
  write_left(text, sizeof text, left);
  fprintf(stderr, "\r\033[K%.1f s  %s: %.0f of %.0f  left %s", seconds, what, done, all, text);
  fflush(stderr);
  p->last = seconds;
}

void progress_end(progress *p) {
  if (p->shown && p->last > 0.0) fprintf(stderr, "\r\033[K");
}

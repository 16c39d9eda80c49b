#include "host/base/stop.h"

#include <math.h>
#include <signal.h>
#include <stddef.h>
#include <string.h>
#include <sys/time.h>
#include <unistd.h>

#include "host/base/clock.h"
#include "host/base/outfile.h"

static volatile sig_atomic_t interrupted; /* the signal's number */
static volatile sig_atomic_t late;        /* the limit has passed */
static double begin, limit;               /* seconds since; 0: none */

static void end(int number) {
  outfile_abort_all();
  _exit(128 + number);
}

/* Not the second signal ends the program, for some senders, timeout(1) among them, send everything twice. */
static void on_interrupt(int number) {
  static volatile sig_atomic_t count;
  interrupted = number;
  if (++count >= 3) end(number);
}

static void on_limit(int number) {
  (void)number;
  late = 1;
}

static void catch (int number, void (*handler)(int)) {
  struct sigaction action;
  memset(&action, 0, sizeof action);
  action.sa_handler = handler;
  action.sa_flags = SA_RESTART;
  sigaction(number, &action, NULL);
}

static void catch_ends(void (*handler)(int)) {
  sigset_t all;
  catch (SIGINT, handler);
  catch (SIGTERM, handler);
  /* Whoever started this may have held them back until now. */
  sigemptyset(&all);
  sigaddset(&all, SIGINT);
  sigaddset(&all, SIGTERM);
  sigaddset(&all, SIGALRM);
  sigprocmask(SIG_UNBLOCK, &all, NULL);
}

void stop_at_once(void) {
  catch_ends(end);
}

void stop_begin(void) {
  begin = clock_seconds();
  catch (SIGALRM, on_limit);
  catch_ends(on_interrupt);
}

/* A timer, and not the clock looked at: the core asks millions of times a second. */
void stop_after(double seconds) {
  limit = seconds;
  const double left = seconds - stop_seconds();
  struct itimerval timer;
  memset(&timer, 0, sizeof timer);
  setitimer(ITIMER_REAL, &timer, NULL);
  late = seconds > 0.0 && left <= 1e-6;
  if (left <= 1e-6) return;
  timer.it_value.tv_sec = (time_t)left;
  timer.it_value.tv_usec = (suseconds_t)(1e6 * (left - (double)timer.it_value.tv_sec));
  setitimer(ITIMER_REAL, &timer, NULL);
}

bool stop_asked(void) {
  return interrupted != 0 || late != 0;
}

static bool may_go_on(void *nothing) {
  (void)nothing;
  return !stop_asked();
}

qtr_watch stop_watch(void) {
  const qtr_watch watch = {may_go_on, NULL};
  return watch;
}

double stop_seconds(void) {
  return clock_seconds() - begin;
}

double stop_left(void) {
  return limit > 0.0 ? limit - stop_seconds() : HUGE_VAL;
}

int stop_signal(void) {
  return interrupted;
}

const char *stop_reason(void) {
  return interrupted != 0 ? "interrupted" : "time limit";
}

int stop_fault(fault *why, const char *input, const char *what, double needed) {
  fault_set(why, "%s: ended (%s) after %.3g s, before there was %s, which takes about %.2g s here; nothing was written",
            input, stop_reason(), stop_seconds(), what, needed);
  why->status = EXIT_STOPPED;
  return -1;
}

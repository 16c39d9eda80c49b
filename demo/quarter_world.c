/* The world as a program of its own; the robots are others. */
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "outcome.h"
#include "progress.h"
#include "record.h"
#include "settings.h"

#define LISTEN 0.7    /* seconds for another world to give itself away */
#define PATIENCE 15.0 /* seconds for all robots to answer */

static const char help[] =
    "quarter-world MISSION --table mission.qtr       the world of a mission, for robots in processes of their own\n"
    "\n"
    "quarter-demo --processes starts it with its robots. By hand: this, and 'quarter-robot mission.qtr --robot N' for "
    "each\n"
    "robot. The game begins when all robots answer, and runs in real time.\n"
    "\n"
    "Options, as of quarter-demo: -o, --log, --seed, --mine, --clear-all, --faults, --robots, --table, --speed, "
    "--lcm-url,\n"
    "--json, --quiet.\n"
    "\n"
    "Exit status: 0 the game is over; 2 bad input, no robots, or another world on the bus; 130 ended by Ctrl-C.\n";

static volatile int interrupted;
static plan p;
static arena a;

static void on_interrupt(int number) {
  interrupted = 128 + number;
}

static void hear_other_world(void *user, const message_status *m) {
  (void)m;
  *(bool *)user = true;
}

static int check_alone(bus *b, fault *why) {
  static bool other;
  const double end = clock_seconds() + LISTEN;
  bus_hear_status(b, hear_other_world, &other);
  while (clock_seconds() < end && !other) bus_wait(b, 50);
  return other ? fault_set(why, "another world is on this bus already: end it, or give another --lcm-url") : 0;
}

/* Handle what comes until a moment of the clock. */
static void serve_until(bus *b, double end) {
  for (;;) {
    const double left = end - clock_seconds();
    if (left <= 0.0) break;
    bus_wait(b, left > 0.001 ? (int)(1000 * left) : 0);
  }
  bus_drain(b);
}

static int gather(bus *b, fault *why) {
  const double end = clock_seconds() + PATIENCE;
  int missing = 0;
  while (clock_seconds() < end && interrupted == 0) {
    arena_publish(&a);
    serve_until(b, clock_seconds() + ARENA_TICK);
    for (missing = 0; missing < a.robots && a.robot[missing].heard; missing++) continue;
    if (missing == a.robots) return 0;
  }
  if (interrupted != 0) return 0;
  return fault_set(why, "robot %d does not answer: start quarter-robot with this table and bus, --robot %d", missing,
                   missing);
}

/* Ticks keep to the clock, but after a hold-up time is not made up for: in a burst of ticks no robot could answer. */
static void play(bus *b, record *r, double speed) {
  const double tick = ARENA_TICK / speed;
  double due = clock_seconds();
  while (!arena_over(&a) && interrupted == 0) {
    const double now = clock_seconds();
    due = due + tick > now + tick / 2 ? due + tick : now + tick;
    arena_publish(&a);
    serve_until(b, due);
    arena_advance(&a);
    record_watch(r, &a);
  }
  serve_until(b, clock_seconds() + ARENA_TICK); /* what was said last is on its way: the log wants it */
}

static int serve(const settings *s, bus *b, const fault_script *faults, fault *why) {
  record r;
  game_result result;
  const arena_setup setup = {s->seed, s->clear_all, s->mine, faults, 4 * game_plan_seconds(&p.t) + 120};
  if (check_alone(b, why) != 0) return -1;
  if (s->log != NULL && bus_record(b, s->log, why) != 0) return -1;
  if (arena_open(&a, &p.t, b, &setup, why) != 0) return -1;
  record_begin(&r, &p);
  int status = gather(b, why);
  if (status == 0) {
    const double begin = clock_seconds();
    play(b, &r, s->speed > 0.0 ? s->speed : 1.0);
    game_tell(&a, b, &result);
    result.wall_seconds = clock_seconds() - begin;
    if (s->replay != NULL) status = record_page(s->replay, &r, &a, &result, why);
    if (status == 0) status = outcome_print(&p, &result, s, why);
  }
  record_free(&r);
  arena_close(&a);
  return status;
}

int main(int argc, char **argv) {
  static settings s;
  static fault_script faults;
  fault why;
  bus *b = NULL;
  if (settings_parse(&s, argc, argv, &why) != 0) return fault_exit(&why);
  if (s.help) return fputs(help, stdout) < 0 ? EXIT_BAD_INPUT : EXIT_SUCCESS;
  signal(SIGINT, on_interrupt);
  signal(SIGTERM, on_interrupt);
  if (plan_make(&p, s.mission, s.table, s.robots, s.learn_limit, NULL, &why) != 0) return fault_exit(&why);
  int status = s.faults != NULL ? faults_read(&faults, s.faults, p.t.policy.board.seekers, &why) : 0;
  if (status == 0) status = bus_open(&b, s.lcm_url, &why);
  if (status == 0) status = serve(&s, b, &faults, &why);
  bus_close(b);
  plan_free(&p);
  if (status != 0) return fault_exit(&why);
  return interrupted != 0 ? interrupted : EXIT_SUCCESS;
}

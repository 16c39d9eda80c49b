/* The world as a program of its own; the robots are others. */
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "host/base/clock.h"
#include "host/base/count.h"
#include "host/base/stop.h"
#include "outcome.h"
#include "patience.h"
#include "prepare.h"
#include "program.h"
#include "record.h"
#include "settings.h"

#define LISTEN 0.7 /* seconds for another world to give itself away */

static const char help[] =
    "quarter-world MISSION --table mission.qtr       the world of a mission, for robots in processes of their own\n"
    "\n"
    "quarter-demo --processes starts it with its robots. By hand: this, and 'quarter-robot mission.qtr --robot N' for "
    "each\n"
    "robot. The game begins when all robots answer, and runs in real time.\n"
    "\n"
    "Options, as of quarter-demo: -o, --log, --seed, --mine, --clear-all, --faults, --robots, --table, --speed, "
    "--lcm-url, --run-number, --key,\n"
    "--no-ghost, --json, --quiet, --version.\n"
    "\n"
    "Exit status: 0 the game is over; 2 bad input, no robots, another world on the bus, or an output that cannot be "
    "written;\n"
    "3 broken off, replay and log whole: its robots fell silent, or one plays another table; 130 ended by Ctrl-C, "
    "replay and log whole;\n"
    "before the game has begun at once, with nothing written.\n";

static volatile int interrupted;
static plan p;
static arena a;

static void on_interrupt(int number) {
  interrupted = 128 + number;
}

/* Those that came while the plan was made count as well. */
static void catch_interrupts(void) {
  signal(SIGINT, on_interrupt);
  signal(SIGTERM, on_interrupt);
  if (stop_signal() != 0) on_interrupt(stop_signal());
}

static uint64_t statuses; /* heard */

static void hear_status(void *user, const message_status *m) {
  (void)user;
  (void)m;
  statuses++;
}

/* What it says itself comes back to it: more than that is another's. */
static int check_no_other(bus *b, fault *why) {
  if (statuses <= bus_count(b).sent[KIND_STATUS]) return 0;
  return fault_set(why, "another world is on this bus already: end it, or give another --lcm-url");
}

static int check_alone(bus *b, fault *why) {
  const double end = clock_seconds() + LISTEN;
  bus_hear_status(b, hear_status, NULL);
  while (clock_seconds() < end && statuses == 0) bus_wait(b, 50);
  return check_no_other(b, why);
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
  const double end = clock_seconds() + PATIENCE_GATHER;
  int missing = 0;
  while (clock_seconds() < end && interrupted == 0) {
    arena_publish(&a);
    serve_until(b, clock_seconds() + ARENA_TICK);
    if (check_no_other(b, why) != 0) return -1; /* one that began in the same moment */
    for (missing = 0; missing < a.robots && a.robot[missing].heard; missing++) continue;
    if (missing == a.robots) return 0;
  }
  if (interrupted != 0) return 0;
  return fault_set(why, "robot %d does not answer: start quarter-robot with this table and bus, --robot %d", missing,
                   missing);
}

/* Ticks keep to the clock, but after a hold-up time is not made up for: in a burst of ticks no robot could answer.
 * Returns the longest hold-up, in seconds. */
static double play(bus *b, record *r, double speed) {
  const double tick = ARENA_TICK / speed;
  double due = clock_seconds();
  double held = 0.0;
  while (!arena_over(&a) && interrupted == 0 && !bus_log_failed(b)) {
    const double now = clock_seconds();
    if (now - due > held) held = now - due;
    due = due + tick > now + tick / 2 ? due + tick : now + tick;
    arena_publish(&a);
    serve_until(b, due);
    arena_advance(&a);
    record_watch(r, &a);
  }
  serve_until(b, clock_seconds() + ARENA_TICK); /* what was said last is on its way: the log wants it */
  return held;
}

/* Whether all robots played the world's own division: others do not believe them, nor they the others. */
static int check_one_mission(fault *why) {
  if (a.stranger < 0) return 0;
  return fault_set(
      why,
      "robot %d plays another table than this world's, or from other starts, or another --run-number: give "
      "all robots the same; until then they do not believe one another",
      a.stranger);
}

/* Whether robots went away in the midst of it. One whose program ended is as good as lost, and the others go on without
 * it. */
static int check_whole(double held, fault *why) {
  if (held > PATIENCE_SILENCE && arena_silent(&a) > 0)
    return fault_set(why,
                     "the game was broken off: this world stood still for %.1f s, and its robots left; start anew, "
                     "and stop no program of it",
                     held);
  if (arena_abandoned(&a))
    return fault_set(why, "the game was broken off: no robot has answered since %.1f s; were their programs ended?",
                     a.now - ARENA_SILENCE);
  return 0;
}

static int write_replay(const settings *s, record *r, const game_result *result, fault *why) {
  if (settings_want_ghost(s) && record_add_ghost(r, &a.setup, &interrupted, why) != 0) return -1;
  return record_page(s->replay, r, &a, result, why);
}

/* Write what was played, and tell how it came out. The exit status, with *why set if it is not 0. */
static int finish(const settings *s, bus *b, record *r, double begin, double held, fault *why) {
  game_result result;
  game_tell(&a, b, &result);
  result.wall_seconds = clock_seconds() - begin;
  if (bus_end_log(b, why) != 0) return EXIT_BAD_INPUT;
  if (s->replay != NULL && write_replay(s, r, &result, why) != 0) return EXIT_BAD_INPUT;
  if (interrupted == 0 && (check_whole(held, why) != 0 || check_one_mission(why) != 0)) return EXIT_BROKEN_OFF;
  return outcome_print(&p, &result, s, why) == 0 ? 0 : EXIT_BAD_INPUT;
}

static int play_with_robots(const settings *s, bus *b, fault *why) {
  record r;
  int status = EXIT_BAD_INPUT;
  record_begin(&r, &p);
  if (gather(b, why) == 0) {
    const double begin = clock_seconds();
    const double held = play(b, &r, s->speed > 0.0 ? s->speed : 1.0);
    status = finish(s, b, &r, begin, held, why);
  }
  record_free(&r);
  return status;
}

/* The exit status, with *why set if it is not 0. */
static int serve(const settings *s, bus *b, const fault_script *faults, fault *why) {
  const arena_setup setup = {s->seed,          s->clear_all, s->mine, faults, game_limit_seconds(&p.t, faults),
                             (uint32_t)s->run, &p.truth};
  if (check_alone(b, why) != 0) return EXIT_BAD_INPUT;
  if (s->log != NULL && bus_record(b, s->log, why) != 0) return EXIT_BAD_INPUT;
  if (arena_open(&a, &p.t, b, &setup, why) != 0) return EXIT_BAD_INPUT;
  const int status = play_with_robots(s, b, why);
  arena_close(&a);
  return status;
}

/* quarter-demo's options that a world alone knows nothing of. */
static int check_own(const settings *s, fault *why) {
  if (s->save == NULL && s->runs == 0 && !s->live && !s->follow && !s->processes && !s->lose_one && s->strategy == 0)
    return 0;
  return fault_set(why,
                   "quarter-world takes none of --save-table, --runs, --live, --follow, --processes, --lose-one and "
                   "--strategy: they are quarter-demo's");
}

static int check_mine(const settings *s, fault *why) {
  const int places = p.places;
  return s->mine < places ? 0
                          : fault_set(why, "--mine %d: the places of %s are 0 to %d", s->mine, s->mission, places - 1);
}

static void tell_unsealed(const bus *b) {
  if (b != NULL && bus_count(b).unsealed > 0)
    fprintf(stderr, "quarter-world: %s without this key's seal ignored\n",
            counted(bus_count(b).unsealed, "termination signal").text);
}

static int run(const settings *s, fault *why) {
  static fault_script faults;
  bus *b = NULL;
  int status = EXIT_BAD_INPUT;
  if (check_own(s, why) != 0) return EXIT_BAD_INPUT;
  const int unprepared = prepare(&p, s, why);
  if (unprepared != 0) return unprepared;
  catch_interrupts();
  if (check_mine(s, why) == 0 && (s->faults == NULL || faults_read(&faults, s->faults, &p.t, why) == 0) &&
      bus_open_sealed(&b, s->lcm_url, s->key, why) == 0)
    status = serve(s, b, &faults, why);
  tell_unsealed(b);
  bus_close(b);
  plan_free(&p);
  return status;
}

static int print_help(FILE *out) {
  return fputs(help, out);
}

int main(int argc, char **argv) {
  const program self = {"quarter-world", print_help, run, &interrupted};
  return program_main(&self, argc, argv);
}

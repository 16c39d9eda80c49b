/* The demo: a mission is learnt, and robots sweep it in a physical world, with nothing but termination between them. */
#include <signal.h>
#include <stdlib.h>
#include <string.h>

#include "follow.h"
#include "host/base/count.h"
#include "host/base/json.h"
#include "host/base/outfile.h"
#include "host/base/stop.h"
#include "launch.h"
#include "live.h"
#include "outcome.h"
#include "patience.h"
#include "prepare.h"
#include "program.h"
#include "record.h"
#include "runs.h"
#include "seal.h"
#include "settings.h"

static volatile int interrupted;
static plan p;
static table plain; /* of --strategy plain */

static void on_interrupt(int number) {
  interrupted = 128 + number;
}

/* Those that came while the plan was made count as well. */
static void catch_interrupts(void) {
  struct sigaction action;
  memset(&action, 0, sizeof action);
  action.sa_handler = on_interrupt;
  sigaction(SIGINT, &action, NULL);
  sigaction(SIGTERM, &action, NULL);
  if (stop_signal() != 0) on_interrupt(stop_signal());
}

/* ---- one game ---- */

typedef struct {
  const settings *s;
  record r;
  live *view; /* NULL: none */
  int told;   /* events that the view has been told of */
} show;

static void show_live(show *w, const arena *a) {
  world_pose poses[DEMO_MOST_ROBOTS];
  for (int i = 0; i < a->robots; i++) poses[i] = world_pose_of(a->w, i);
  while (w->told < a->events) live_event(w->view, w->r.p, &a->event[w->told++]);
  live_frame(w->view, a->now, a->robots, a->g.grid.rows, poses);
}

static void watch(void *user, const arena *a) {
  show *w = user;
  record_watch(&w->r, a);
  if (w->view != NULL) show_live(w, a);
}

static int finish(void *user, const arena *a, const game_result *result, fault *why) {
  show *w = user;
  if (w->view != NULL) {
    show_live(w, a);
    live_end(w->view, &p, result);
  }
  if (w->s->replay == NULL) return 0;
  if (settings_want_ghost(w->s) && record_add_ghost(&w->r, &a->setup, &interrupted, why) != 0) return -1;
  return record_page(w->s->replay, &w->r, a, result, why);
}

static int play(const settings *s, const fault_script *faults, fault *why) {
  show w = {.s = s};
  game_result result;
  const game_setup setup = {
      .t = &p.t,
      .strategy = s->strategy,
      .log = s->log,
      .user = &w,
      .watch = watch,
      .finish = finish,
      .speed = s->live && s->speed <= 0.0 ? 1.0 : s->speed,
      .plain = s->strategy == STRATEGY_PLAIN ? &plain : NULL,
      .arena = {s->seed, s->clear_all, s->mine, faults, game_limit_seconds(&p.t, faults), .truth = &p.truth}};
  record_begin(&w.r, &p);
  int status = s->live ? live_open(&w.view, s->port, why) : 0;
  if (status == 0 && w.view != NULL) {
    live_hello(w.view, &p, &(record_head){s->seed, s->clear_all, s->mine});
    live_await(w.view, LIVE_PATIENCE, &interrupted);
  }
  if (status == 0) status = game_play(&setup, &result, &interrupted, why);
  live_close(w.view);
  record_free(&w.r);
  if (status != 0) return -1;
  return outcome_print(&p, &result, s, why);
}

/* ---- many games ---- */

static void write_figures(FILE *out, const runs_figures *f, const settings *s) {
  static const char *const kinds[KINDS] = {"pose", "scan", "command", "terminate", "status"};
  json j;
  json_begin(&j, out);
  json_object(&j, NULL);
  json_string(&j, "mission", p.name);
  json_string(&j, "strategy", game_strategies[s->strategy]);
  json_integer(&j, "robots", p.t.policy.board.seekers);
  json_bool(&j, "lose_one", s->lose_one);
  json_natural(&j, "first_seed", s->seed);
  json_integer(&j, "games", f->games);
  json_integer(&j, "found", f->found);
  json_number(&j, "mean", f->mean);
  json_number(&j, "planned_mean", f->planned_mean);
  json_number(&j, "expected", f->expected);
  if (f->end >= 0.0) json_number(&j, "not_found_counts_as", f->end);
  json_number(&j, "median", runs_quantile(f, 0.5));
  json_number(&j, "quantile_90", runs_quantile(f, 0.9));
  json_number(&j, "longest", runs_quantile(f, 1.0));
  json_integer(&j, "games_with_deadlock", f->deadlocked);
  json_natural(&j, "deadlocks", f->deadlocks);
  json_number(&j, "collisions_a_game", (double)f->collisions / f->games);
  json_number(&j, "scanned_a_game", (double)f->scanned / f->games);
  json_number(&j, "duplicates_a_game", (double)f->duplicates / f->games);
  json_number(&j, "times_real_time", f->simulated / f->wall);
  json_flat_object(&j, "messages");
  for (int kind = 0; kind < KINDS; kind++) json_natural(&j, kinds[kind], f->sent[kind]);
  json_end_object(&j);
  json_flat_array(&j, "seeds_to_look_into");
  for (int i = 0; i < f->odd && i < RUNS_ODD; i++) json_natural(&j, NULL, f->odd_seed[i]);
  json_end_array(&j);
  json_flat_array(&j, "found_at");
  for (int i = 0; i < f->games; i++) json_number(&j, NULL, f->by_seed[i]);
  json_end_array(&j);
  json_flat_array(&j, "visits");
  for (int place = 0; place < p.places; place++) json_natural(&j, NULL, f->visits[place]);
  json_end_array(&j);
  json_end_object(&j);
}

static void tell_figures(FILE *out, const runs_figures *f, const settings *s) {
  static const char *const strategies[] = {"the plan", "nearest first, no plan", "nearest first, full communication",
                                           "a plan without the mission's terms"};
  fprintf(out, "%s, %s%s: %s, found in %d\n", p.name, strategies[s->strategy], s->lose_one ? ", one robot lost" : "",
          counted((uint64_t)f->games, "game").text, f->found);
  if (f->found > 0)
    fprintf(out,
            "time to find: mean %.2f s (planned for the same mines %.2f, expected %.2f), median %.1f, 90 %% %.1f, most "
            "%.1f\n",
            f->mean, f->planned_mean, f->expected, runs_quantile(f, 0.5), runs_quantile(f, 0.9), runs_quantile(f, 1.0));
  else
    fprintf(out, "time to find: unknown, for nothing was found (expected %.2f s)\n", f->expected);
  fprintf(out,
          "a game: %.2f places scanned, %.3f of them again, %.3f collisions; games with a deadlock: %d; %.0f times "
          "real time\n",
          (double)f->scanned / f->games, (double)f->duplicates / f->games, (double)f->collisions / f->games,
          f->deadlocked, f->simulated / f->wall);
  if (f->odd > 0) fprintf(out, "not found or a deadlock:");
  for (int i = 0; i < f->odd && i < RUNS_ODD; i++) fprintf(out, " --seed %llu", (unsigned long long)f->odd_seed[i]);
  if (f->odd > 0) fputc('\n', out);
}

static int print_figures(const runs_figures *f, const settings *s, fault *why) {
  outfile out;
  if (outfile_open(&out, s->json && s->json_path != NULL ? s->json_path : "-", why) != 0) return -1;
  if (s->json)
    write_figures(out.file, f, s);
  else if (!s->quiet)
    tell_figures(out.file, f, s);
  return outfile_commit(&out, why);
}

static int play_many(const settings *s, const fault_script *faults, fault *why) {
  runs_figures f;
  const game_setup setup = {
      .t = &p.t,
      .strategy = s->strategy,
      .plain = s->strategy == STRATEGY_PLAIN ? &plain : NULL,
      .arena = {s->seed, s->clear_all, s->mine, faults, game_unplanned_seconds(&p.t, faults), .truth = &p.truth}};
  int status = runs_play(&f, &p, &setup, s->runs, s->lose_one, &interrupted, s->quiet, why);
  if (status == 0 && f.games > 0) status = print_figures(&f, s, why);
  runs_free(&f);
  return status;
}

/* ---- the command ---- */

/* The plan is made: what is asked for. The exit status, with *why set if it is not 0; so below. */
static int play_as_asked(const settings *s, const fault_script *faults, fault *why) {
  if (s->processes) return launch(s, &p, faults, &interrupted, why);
  int status = 0;
  if (s->follow)
    status = follow(s, &p, &interrupted, why);
  else
    status = s->runs > 0 ? play_many(s, faults, why) : play(s, faults, why);
  return status == 0 ? 0 : EXIT_BAD_INPUT;
}

static int run_plan(const settings *s, fault *why) {
  const int places = p.places;
  fault_script faults = {0};
  if (s->faults != NULL && faults_read(&faults, s->faults, &p.t, why) != 0) return EXIT_BAD_INPUT;
  if (s->mine >= places) {
    fault_set(why, "--mine %d: the places of %s are 0 to %d", s->mine, s->mission, places - 1);
    return EXIT_BAD_INPUT;
  }
  if (s->strategy == STRATEGY_PLAIN && plan_make_plain(&plain, &p, s->robots, s->learn_limit, why) != 0)
    return why->status == EXIT_STOPPED ? 128 + stop_signal() : EXIT_BAD_INPUT;
  if (s->lose_one && s->runs == 0) runs_draw_loss(&faults, &p, s->seed);
  return play_as_asked(s, &faults, why);
}

/* Before the learning; the programs that need the key read it themselves. */
static int check_key(const settings *s, fault *why) {
  seal unused;
  if (s->key == NULL) return 0;
  if (!s->processes && !s->follow)
    return fault_set(why, "--key goes with --processes and --follow: in a game of one process nobody else is heard");
  const int status = seal_read(&unused, s->key, why);
  seal_wipe(&unused);
  return status;
}

static int run(const settings *s, fault *why) {
  if (check_key(s, why) != 0) return EXIT_BAD_INPUT;
  int status = prepare(&p, s, why);
  if (status != 0) return status;
  catch_interrupts();
  status = run_plan(s, why);
  table_free(&plain);
  plan_free(&p);
  return status;
}

static int print_help(FILE *out) {
  return option_help(out, &settings_options);
}

int main(int argc, char **argv) {
  const program self = {"quarter-demo", print_help, run, &interrupted};
  return program_main(&self, argc, argv);
}

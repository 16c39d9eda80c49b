#include <inttypes.h>
#include <math.h>
#include <stdlib.h>

#include "commands.h"
#include "figures.h"
#include "host/base/count.h"
#include "host/base/json.h"
#include "host/base/stop.h"
#include "host/plan/simulation.h"
#include "print.h"
#include "products.h"
#include "quarter/status.h"
#include "relearn.h"

static const char intro[] =
    "quarter simulate mission.qtr                       robots walk the grid, each by its own copy of the table\n"
    "quarter simulate mission.qtr --target 3            the target is at place 3: when is it found?\n"
    "quarter simulate mission.qtr --lost 1@40           robot 1 is lost at step 40: the others take its places over\n"
    "quarter simulate mission.qtr --late 0:+30 --late 2:x1.5\n"
    "                                                   robot 0 starts 30 steps late, robot 2 takes half as long "
    "again\n"
    "\n"
    "Nothing passes between the robots but the termination signals FOUND and TERRITORY_DONE.\n"
    "\n";

static const option_line lines[] = {
    OPTION_LINE("target"), OPTION_LINE("clear-all"), {"late", NULL, 47},     OPTION_LINE("lost"),
    OPTION_LINE("from"),   OPTION_LINE("clear"),     OPTION_LINES_OF_ANSWER,
};

static const char outro[] =
    "\n"
    "In JSON: visits are each place's first one; duplicates counts the later ones; value and expected_time are what "
    "the\n"
    "first visits earn (expected_time null if a place was left, but where all robots must be home in time).\n"
    "Places and robots go by their names, or else by the numbers that the input gave them; options take either.\n"
    "\n"
    "Exit status: 0 found, or all places visited; 2 bad input; 4 places were left unvisited and no target was "
    "found;\n" STATUS_OF_SIGNAL("nothing half-written");

static const option_set set = {"simulate", intro, outro, option_records, lines};

/* What a report is made of. */
typedef struct {
  simulation s;
  table t;
  qtr_deployment deployment;
  options *o;
  bool weighed; /* what learning anew would bring */
  relearnt anew;
} account;

static bool was_visited(const simulation *s, const options *o, int place) {
  if (qtr_places_has(&o->game.clear, (unsigned)place)) return true;
  for (int i = 0; i < s->visits; i++)
    if (s->visit[i].place == place) return true;
  return false;
}

static int count_left(const account *a) {
  int left = 0;
  for (int place = 0; place < a->t.policy.board.places; place++) left += !was_visited(&a->s, a->o, place);
  return left;
}

static void write_visits(json *j, const simulation *s, const table *t, const options *o) {
  const naming n = table_naming(t);
  json_array(j, "visits");
  for (int i = 0; i < s->visits; i++) {
    json_flat_object(j, NULL);
    json_integer(j, "place", t->number[s->visit[i].place]);
    naming_json_place(&n, j, s->visit[i].place);
    json_integer(j, "seeker", s->visit[i].seeker);
    json_integer(j, "step", s->visit[i].step);
    figures_json_seconds(j, "seconds", s->visit[i].step, table_step_seconds(t));
    json_end_object(j);
  }
  json_end_array(j);
  json_flat_array(j, "unvisited");
  for (int place = 0; place < t->policy.board.places; place++)
    if (!was_visited(s, o, place)) json_integer(j, NULL, t->number[place]);
  json_end_array(j);
}

static void write_json(FILE *out, const void *what) {
  const account *a = what;
  const simulation *s = &a->s;
  const table *t = &a->t;
  const options *o = a->o;
  const double seconds = table_step_seconds(t);
  json j;
  json_begin(&j, out);
  json_object(&j, NULL);
  json_string(&j, "command", "simulate");
  json_string(&j, "input", o->input);
  json_integer(&j, "places", t->policy.board.places);
  json_integer(&j, "robots", t->policy.board.seekers);
  write_visits(&j, s, t, o);
  json_number(&j, "value", s->value);
  json_number(&j, "expected_time", s->expected_time);
  figures_json_seconds(&j, "expected_time_seconds", s->expected_time, seconds);
  if (t->claim.deadline > 0) json_number(&j, "found_by_deadline", s->found);
  json_natural(&j, "off_table", s->off_table);
  if (a->weighed) relearn_json(&j, &a->anew);
  json_natural(&j, "duplicates", (uint64_t)s->duplicates);
  if (o->game.target != SIMULATION_NO_TARGET) {
    json_integer(&j, "target", t->number[o->game.target]);
    if (s->found_step != QTR_NEVER)
      json_natural(&j, "found_step", s->found_step);
    else
      json_null(&j, "found_step");
    figures_json_seconds(&j, "found_seconds", s->found_step != QTR_NEVER ? (double)s->found_step : (double)NAN,
                         seconds);
  }
  json_natural(&j, "end_step", s->end);
  figures_json_seconds(&j, "end_seconds", s->end, seconds);
  json_natural(&j, "found_signals", s->found_signals);
  json_natural(&j, "territory_done_signals", s->done_signals);
  json_end_object(&j);
}

/* Robots that meet states which nobody learnt go by their rule: no certificate covers that. */
static bool is_off_table(const account *a) {
  return a->s.off_table > 0 && a->o->plan.reading.clears > 0;
}

static void write_off_table(FILE *out, const account *a) {
  const options *o = a->o;
  if (!is_off_table(a)) return;
  fputs("the table was not learnt for these places cleared, and where it has no answer robots go by their rule:\n",
        out);
  if (a->weighed && o->game.lates + o->game.losts > 0) fputs("with all robots, and on time: ", out);
  if (a->weighed) relearn_write(out, &a->anew);
  fputs("a plan of the rest is certified: quarter learn MISSION --clear", out);
  for (int i = 0; i < o->plan.reading.clears; i++)
    fprintf(out, "%s'%s'", i > 0 ? " --clear " : " ", o->plan.reading.clear[i]);
  fputc('\n', out);
}

static void write_head(FILE *out, const account *a) {
  const simulation *s = &a->s;
  const unsigned places = a->t.policy.board.places;
  const bool looks = a->t.claim.own_places != places;
  const char *done = looks ? "made" : "visited";
  fprintf(out, "%s: %d of %s %s by %s, %d %s again, %s off the table\n", a->o->input, s->visits,
          counted(places, looks ? "look" : "place").text, done, figures_moment(s->end, table_step_seconds(&a->t)).text,
          s->duplicates, done, counted(s->off_table, "choice").text);
}

static void write_visit_lines(FILE *out, const account *a) {
  const simulation *s = &a->s;
  const table *t = &a->t;
  const naming n = table_naming(t);
  const double seconds = table_step_seconds(t);
  for (int i = 0; i < s->visits; i++) {
    fprintf(out, "  step %4" PRIu32, s->visit[i].step);
    if (seconds > 0.0) fprintf(out, "  %8.6g s", s->visit[i].step * seconds);
    fprintf(out, "  seeker %s  place %s%s\n", naming_seeker(&n, s->visit[i].seeker).text,
            naming_place(&n, s->visit[i].place).text, figures_late(table_is_late(t, s->visit[i].step)));
  }
  for (int place = 0; place < t->policy.board.places && s->found_step == QTR_NEVER; place++)
    if (!was_visited(s, a->o, place))
      fprintf(out, "  place %s was not visited\n", naming_place(&n, (unsigned)place).text);
}

static void write_text(FILE *out, const void *what) {
  const account *a = what;
  const simulation *s = &a->s;
  const naming n = table_naming(&a->t);
  const double seconds = table_step_seconds(&a->t);
  write_head(out, a);
  write_visit_lines(out, a);
  if (s->found_step != QTR_NEVER)
    fprintf(out, "target found at place %s, %s\n", naming_place(&n, (unsigned)a->o->game.target).text,
            figures_moment(s->found_step, seconds).text);
  else if (isnan(s->expected_time))
    fprintf(out, "discounted value %.6g; expected time unknown, for not all places were visited\n", s->value);
  else
    fprintf(out, "discounted value %.6g, expected time %s\n", s->value, figures_time(s->expected_time, seconds).text);
  if (a->t.claim.deadline > 0 && a->o->game.target == SIMULATION_NO_TARGET)
    fprintf(out, "probability of a find by the deadline %.6g\n", s->found);
  write_off_table(out, a);
}

/* The cells that the options put the seekers on. */
static int find_starts(qtr_cell *starts, const table *t, const options *o, fault *why) {
  const unsigned columns = t->claim.map_columns, rows = t->claim.map_rows;
  if (o->game.froms != t->policy.board.seekers)
    return fault_set(why, "--from: given %s, but the table has %s; give each its start",
                     counted((uint64_t)o->game.froms, "time").text, counted(t->policy.board.seekers, "seeker").text);
  for (int i = 0; i < o->game.froms; i++) {
    if (o->game.from[i].column >= (int)columns || o->game.from[i].row >= (int)rows)
      return fault_set(why, "--from %d,%d: off the map, which has %s and %s", o->game.from[i].column,
                       o->game.from[i].row, counted(columns, "column").text, counted(rows, "row").text);
    starts[i] = table_cell(t, o->game.from[i].column, o->game.from[i].row);
  }
  return 0;
}

/* Names the first cell that is no start for its robot. */
static int refuse_start(const qtr_cell *starts, const account *a, fault *why) {
  const options *o = a->o;
  const qtr_policy *policy = &a->t.policy;
  const naming n = table_naming(&a->t);
  for (unsigned i = 0; i < policy->board.seekers; i++) {
    const unsigned region = qtr_policy_region(policy, starts[i]);
    bool reaches = false;
    for (unsigned place = 0; region < policy->board.starts && place < policy->board.places; place++)
      reaches = reaches || qtr_board_steps(&policy->board, i, policy->board.places + region, place) != QTR_NEVER;
    if (reaches) continue;
    return fault_set(why, "--from %d,%d: %s; give robot %s a free cell with a way to some place",
                     o->game.from[i].column, o->game.from[i].row,
                     region == QTR_POLICY_NO_REGION ? "an obstacle" : "no place can be reached from there",
                     naming_seeker(&n, i).text);
  }
  return fault_set(why, "--from: not a start of %s", o->input);
}

static int deploy(account *a, fault *why) {
  const options *o = a->o;
  const bool elsewhere = o->game.froms > 0;
  qtr_cell starts[QTR_MAX_SEEKERS];
  if (elsewhere && find_starts(starts, &a->t, o, why) != 0) return -1;
  if (qtr_deployment_init(&a->deployment, &a->t.policy, elsewhere ? starts : NULL, &o->game.clear) == QTR_OK) return 0;
  if (elsewhere && a->t.policy.any_start) return refuse_start(starts, a, why);
  return fault_set(why, "--from: an obstacle, or not a start of %s; name free cells, of a table made with --starts any",
                   o->input);
}

/* ---- who and where the options mean ---- */

static int meant_seekers(int *seeker, const char *option, const char *word, const naming *n, fault *why) {
  char wrong[FAULT_LINE];
  *seeker = naming_find_seeker(n, word, wrong);
  return *seeker >= 0 ? 0 : fault_set(why, "--%s: %s", option, wrong);
}

/* Who clears a place clears all looks at it. */
static void clear_looks(qtr_places *clear, const naming *n) {
  for (int place = 0; place < n->places; place++)
    for (int look = place + 1; look < n->places && qtr_places_has(clear, (unsigned)place); look++)
      if (naming_looked_at(n, (unsigned)look) == (unsigned)place) qtr_places_add(clear, (unsigned)look);
}

static int meant_places(options *o, const naming *n, fault *why) {
  char wrong[FAULT_LINE];
  for (int i = 0; i < o->plan.reading.clears; i++)
    if (naming_list_places(&o->game.clear, n, o->plan.reading.clear[i], wrong) != 0)
      return fault_set(why, "--clear: %s", wrong);
  clear_looks(&o->game.clear, n);
  if (o->target == NULL) return 0;
  o->game.target = naming_find_place(n, o->target, wrong);
  return o->game.target >= 0 ? 0 : fault_set(why, "--target: %s", wrong);
}

/* As many steps as begin by then. */
static int count_steps(uint32_t *steps, double seconds, const char *option, const table *t, fault *why) {
  const double step = table_step_seconds(t);
  if (seconds <= 0.0) return 0;
  if (step <= 0.0)
    return fault_set(why, "--%s: given in seconds, and the table does not say how long a step is; give steps", option);
  *steps = (uint32_t)fmin(ceil(seconds / step - 1e-9), 4e9);
  return 0;
}

static int find_meant(options *o, const table *t, fault *why) {
  const naming n = table_naming(t);
  for (int i = 0; i < o->game.lates; i++)
    if (meant_seekers(&o->game.late[i].seeker, "late", o->late[i], &n, why) != 0 ||
        count_steps(&o->game.late[i].wait, o->late_seconds[i], "late", t, why) != 0)
      return -1;
  for (int i = 0; i < o->game.losts; i++)
    if (meant_seekers(&o->game.lost[i].seeker, "lost", o->lost[i], &n, why) != 0 ||
        count_steps(&o->game.lost[i].step, o->lost_seconds[i], "lost", t, why) != 0)
      return -1;
  return meant_places(o, &n, why);
}

/* The table is open. */
static int simulate(account *a, fault *why) {
  if (products_check(a->o, why) != 0 || find_meant(a->o, &a->t, why) != 0 || deploy(a, why) != 0) return -1;
  if (simulation_run(&a->s, &a->t, &a->deployment, &a->o->game, why) != 0) return -1;
  fault unused;
  a->weighed = is_off_table(a) && relearn(&a->anew, &a->t, &a->deployment, &a->o->game, &unused) == 0;
  stop_at_once();
  return print_report(a->o, write_json, write_text, a, why);
}

int command_simulate(int argc, char **argv) {
  static options o;
  static account a = {.o = &o};
  fault why;
  if (options_parse(&o, &set, argc, argv, &why) != 0) return fault_exit(&why);
  if (o.help) return option_help(stdout, &set);
  stop_at_once();
  if (table_read(&a.t, o.input, &why) != 0) return fault_exit(&why);
  const int status = simulate(&a, &why);
  const bool left = a.s.found_step == QTR_NEVER && count_left(&a) > 0;
  table_free(&a.t);
  if (status != 0) return fault_exit(&why);
  return left ? EXIT_UNVISITED : EXIT_SUCCESS;
}

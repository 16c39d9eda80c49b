#include <inttypes.h>
#include <stdlib.h>

#include "commands.h"
#include "figures.h"
#include "host/base/clock.h"
#include "host/base/count.h"
#include "host/base/json.h"
#include "host/base/stop.h"
#include "host/input/words.h"
#include "host/plan/progress.h"
#include "host/plan/study.h"
#include "host/plan/terms.h"
#include "prepare.h"
#include "print.h"

#define TRIES_MOST 512
#define DIAMETERS 6
#define EPISODES_DEFAULT 2000u
#define PROOF_EPISODES 20000u /* for the bound that all are measured against */

static const char intro[] =
    "quarter tune mission.yaml                          which spots lose least on the ground?\n"
    "quarter tune mission.yaml --budget-entries 200     with a Q-table of at most 200 entries\n"
    "quarter tune mission.yaml --learner paper --episodes 20000 --budget-entries 5000\n"
    "\n"
    "Tries sizes, diameters, orders and likelihood weights of spots, in the paper setting also over regions of at "
    "most\n"
    "9 and 25 cells, learns each, and measures what its policy earns on the ground against the bound of the true\n"
    "problem, which the certified setting works out first. The best comes first; its options are printed as\n"
    "'quarter learn' takes them.\n"
    "\n";

static const option_line lines[] = {
    OPTION_LINE("budget-entries"),
    {"episodes", "games for each try (default 2000)", 0},
    {"time-limit", "end with what has been tried after this many seconds", 0},
    {"learner, explore, alpha, seed, robots, objective, gamma, rule,\n"
     "cell-size, skip-unreachable, snap",
     "as in 'quarter learn'", 59},
    OPTION_LINES_OF_REPORT,
};

static const char outro[] = "\n"
                            "Exit status: 0 done; 2 bad input, or nothing that fits the budget; " STATUS_OF_EARLY_END(
                                "the first\n", "what was tried until then is reported");

static const option_set set = {"tune", intro, outro, option_records, lines};

typedef struct {
  aggregate_config how;
  uint32_t regions, spots;
  uint64_t entries;
  qtr_certificate certificate;
} try;

static study *tuned;
static try tries[TRIES_MOST];
static int count;
static int planned, tried; /* a stop leaves the rest out */
static try proven;         /* the certified setting on the true map */

/* ---- what is tried ---- */

static int compare_steps(const void *a, const void *b) {
  const qtr_steps x = *(const qtr_steps *)a;
  const qtr_steps y = *(const qtr_steps *)b;
  return (x > y) - (x < y);
}

/* The ways between places, sorted; returns how many there are. */
static int sort_ways(qtr_steps *all) {
  const qtr_board *board = &tuned->p.game->board;
  int pairs = 0;
  for (unsigned from = 0; from < board->places; from++) {
    for (unsigned to = 0; to < from; to++) {
      const qtr_steps there = qtr_board_class_steps(board, 0, from, to);
      const qtr_steps back = qtr_board_class_steps(board, 0, to, from);
      if (there != QTR_NEVER && back != QTR_NEVER) all[pairs++] = there > back ? there : back;
    }
  }
  qsort(all, (size_t)pairs, sizeof *all, compare_steps);
  return pairs;
}

/* Diameters worth trying: quantiles of the distances between places, the lower ones closer together. */
static int pick_diameters(qtr_steps *diameters) {
  static const double quantiles[DIAMETERS] = {0.03, 0.07, 0.12, 0.2, 0.35, 0.6};
  const size_t places = tuned->p.game->board.places;
  qtr_steps *all = malloc(places * places * sizeof *all);
  const int pairs = all != NULL ? sort_ways(all) : 0;
  int picked = 0;
  for (int i = 0; i < DIAMETERS && pairs > 0; i++) {
    const qtr_steps diameter = all[(int)(quantiles[i] * (pairs - 1))];
    if (picked == 0 || diameter > diameters[picked - 1]) diameters[picked++] = diameter;
  }
  free(all);
  return picked;
}

/* Where the mission's terms take spots. */
static void add_spot_tries(try like) {
  static const uint8_t sizes[] = {2, 3, 5, 8};
  static const double likelihoods[] = {0.0, 0.25, 1.0};
  qtr_steps diameters[DIAMETERS];
  if (terms_leave_no_spots(&tuned->p.in.mission)) return;
  const int picked = pick_diameters(diameters);
  like.how.way = like.how.way == AGGREGATE_REGIONS ? AGGREGATE_BOTH : AGGREGATE_SPOTS;
  for (int size = 0; size < 4 && sizes[size] <= QTR_MAX_SPOT_SIZE; size++)
    for (int i = 0; i < picked; i++)
      for (uint8_t order = QTR_SPOT_BEST; order <= QTR_SPOT_NEAREST; order++)
        for (int weight = 0; weight < 3 && count < TRIES_MOST; weight++) {
          like.how.units.spots.size = sizes[size];
          like.how.units.spots.diameter = diameters[i];
          like.how.units.spot_order = order;
          like.how.units.spots.likelihood = likelihoods[weight];
          tries[count++] = like;
        }
}

static void add_tries(const options *o) {
  try plain = {.spots = 0};
  aggregate_default(&plain.how);
  tries[count++] = plain;
  add_spot_tries(plain);
  if (o->plan.learner.setting != QTR_SETTING_PAPER || terms_any(&tuned->p.in.mission)) return;
  static const uint32_t sizes[][2] = {{9, 6}, {25, 15}};
  for (int i = 0; i < 2; i++) {
    try like = plain;
    like.how.way = AGGREGATE_REGIONS;
    like.how.regions.max_size = sizes[i][0];
    like.how.regions.diameter = sizes[i][1];
    tries[count++] = like;
    add_spot_tries(like);
  }
}

/* ---- trying ---- */

static int learn_try(try *t, const plan_config *asked, uint64_t episodes, fault *why) {
  plan_config config = *asked;
  config.aggregate = t->how;
  if (study_begin(tuned, &config, why) != 0) return -1;
  do qtr_learner_certificate(tuned->learner, &t->certificate);
  while (!stop_asked() && t->certificate.episodes < episodes && study_step(tuned) == QTR_LEARNING);
  qtr_learner_certificate(tuned->learner, &t->certificate);
  t->entries = qtr_learner_entries(tuned->learner);
  t->regions = aggregate_by_regions(t->how.way) && tuned->aggregated ? tuned->regions->count : 0;
  t->spots = aggregate_by_spots(t->how.way) && tuned->aggregated ? qtr_environment_targets(tuned->aggregate) : 0;
  return 0;
}

static int compare_tries(const void *a, const void *b) {
  const try *x = a;
  const try *y = b;
  if (x->certificate.gap != y->certificate.gap) return x->certificate.gap < y->certificate.gap ? -1 : 1;
  return (x->entries > y->entries) - (x->entries < y->entries);
}

/* The bound of the true map, and what is to be had there. */
static int prove(const plan_config *asked, fault *why) {
  plan_config config = *asked;
  config.learner.setting = QTR_SETTING_CERTIFIED;
  proven = (try){.spots = 0};
  aggregate_default(&proven.how);
  return learn_try(&proven, &config, PROOF_EPISODES, why);
}

/* The best bound that any try found is good for all: they share the ground. */
static void share_bound(void) {
  const uint8_t objective = tuned->p.in.mission.aim.kind;
  double bound = proven.certificate.bound;
  for (int i = 0; i < count; i++)
    if (qtr_objective_is_better(objective, bound, tries[i].certificate.bound)) bound = tries[i].certificate.bound;
  for (int i = 0; i < count; i++) {
    qtr_certificate *c = &tries[i].certificate;
    c->bound = bound;
    c->gap = qtr_objective_gap(objective, c->objective, bound);
  }
}

static int learn_all(const options *o, fault *why) {
  const uint64_t episodes = o->episodes > 0 ? o->episodes : EPISODES_DEFAULT;
  const double begin = clock_seconds();
  planned = count;
  for (int i = 0; i < count; i++) {
    if (learn_try(&tries[i], &o->plan, episodes, why) != 0) return -1;
    /* What a stop came into is no fair try, but the first one, the true map, is. */
    if (stop_asked()) count = i > 0 ? i : 1;
    if (progress_wanted(o->quiet))
      fprintf(stderr, "\r\033[Ktry %d of %d  left %.0f s", i + 1, count,
              (clock_seconds() - begin) / (i + 1) * (count - i - 1));
  }
  if (progress_wanted(o->quiet)) fprintf(stderr, "\r\033[K");
  return 0;
}

/* What the mission's terms leave nothing to try of. */
static void note_left_out(const options *o) {
  input *in = &tuned->p.in;
  const int before = in->note.count;
  if (terms_leave_no_spots(&in->mission))
    notes_add(&in->note,
              "%s: there are no spots with classes, looks, ready times, endurance or home_weight: none tried",
              in->path);
  if (o->plan.learner.setting == QTR_SETTING_PAPER && terms_any(&in->mission))
    notes_add(&in->note, "%s: there are no regions with the field's terms: none tried", in->path);
  notes_print(&in->note, before);
}

static int tune(const options *o, fault *why) {
  stop_after(o->time_limit);
  tuned = study_take(why);
  if (tuned == NULL) return -1;
  tuned->measuring = true;
  if (prepare_problem(&tuned->p, o, why) != 0) return -1;
  add_tries(o);
  note_left_out(o);
  if (prove(&o->plan, why) != 0 || learn_all(o, why) != 0) return -1;
  share_bound();
  int kept = 0;
  tried = count;
  for (int i = 0; i < count; i++)
    if (o->budget_entries == 0 || tries[i].entries <= o->budget_entries) tries[kept++] = tries[i];
  count = kept;
  if (count == 0)
    return fault_set(why, "%s: nothing fits %s; allow more with --budget-entries", o->input,
                     counted(o->budget_entries, "Q entry").text);
  qsort(tries, (size_t)count, sizeof *tries, compare_tries);
  return 0;
}

/* ---- the report ---- */

static bool has_regions(const try *t) {
  return aggregate_by_regions(t->how.way);
}
static bool has_spots(const try *t) {
  return aggregate_by_spots(t->how.way);
}

static void write_options(FILE *out, const try *t) {
  const qtr_spots_config *spots = &t->how.units.spots;
  fprintf(out, "--aggregate %s", aggregate_names[t->how.way]);
  if (has_regions(t))
    fprintf(out, " --region-size %" PRIu32 " --region-diameter %" PRIu32, t->how.regions.max_size,
            t->how.regions.diameter);
  if (!has_spots(t)) return;
  fprintf(out, " --spot-size %d --spot-diameter %" PRIu32 " --spot-order %s", spots->size, spots->diameter,
          words_spot_order[t->how.units.spot_order]);
  if (spots->likelihood > 0.0) fprintf(out, " --spot-likelihood %g", spots->likelihood);
}

static bool is_none(const try *t) {
  return t->how.way == AGGREGATE_NONE;
}
static bool is_regions(const try *t) {
  return t->how.way == AGGREGATE_REGIONS;
}
static bool is_spots(const try *t) {
  return t->how.way == AGGREGATE_SPOTS;
}
static bool is_both(const try *t) {
  return t->how.way == AGGREGATE_BOTH;
}
static bool is_nearest(const try *t) {
  return has_spots(t) && t->how.units.spot_order == QTR_SPOT_NEAREST;
}
static bool is_best_order(const try *t) {
  return has_spots(t) && t->how.units.spot_order == QTR_SPOT_BEST;
}
static bool is_blind(const try *t) {
  return has_spots(t) && t->how.units.spots.likelihood == 0.0;
}
static bool is_likely(const try *t) {
  return has_spots(t) && t->how.units.spots.likelihood > 0.0;
}

/* The best try of each kind: what an option buys, all others being free. */
static void write_worth_of_options(FILE *out) {
  static const struct {
    const char *name;
    bool (*holds)(const try *t);
  } kinds[] = {{"no aggregation", is_none},
               {"regions alone", is_regions},
               {"spots alone", is_spots},
               {"both", is_both},
               {"spots, best order", is_best_order},
               {"spots, nearest first", is_nearest},
               {"spots by distance", is_blind},
               {"spots by distance and likelihood", is_likely}};
  fprintf(out, "the best of each kind:\n");
  for (size_t kind = 0; kind < sizeof kinds / sizeof kinds[0]; kind++) {
    int best = 0;
    while (best < count && !kinds[kind].holds(&tries[best])) best++;
    if (best == count) continue;
    fprintf(out, "%8.3f%%  %20s  %s\n", 100.0 * tries[best].certificate.gap,
            counted(tries[best].entries, "Q entry").text, kinds[kind].name);
  }
}

/* A step's, where people are told of them; else 0. */
static double told_seconds(void) {
  return tuned->p.pace.stated ? tuned->p.pace.seconds_per_step : 0.0;
}

/* By what an objective's figure is multiplied to be in its own unit. */
static double unit(void) {
  return figures_unit(tuned->p.in.mission.aim.kind, told_seconds());
}

static void write_units(FILE *out) {
  if (told_seconds() <= 0.0) return;
  fprintf(out, "a step is %.6g s: %sdiameters are in steps, as the options take them\n", told_seconds(),
          tuned->p.in.mission.aim.kind == QTR_TIME ? "figures are in seconds, " : "");
}

static void write_text(FILE *out, const void *what) {
  const options *o = what;
  fprintf(out, "%s: bound %.6g for any policy; certified learning on the true map: %.6g, %s\n", o->input,
          unit() * tries[0].certificate.bound, unit() * proven.certificate.objective,
          counted(proven.entries, "Q entry").text);
  write_units(out);
  fprintf(out, "the best of %s, by what they earn on the ground:\n", counted((uint64_t)count, "try").text);
  fprintf(out, "      gap    objective   Q entries  targets  options\n");
  for (int i = 0; i < count && i < 10; i++) {
    const try *t = &tries[i];
    fprintf(out, "%8.3f%%  %11.6g  %10" PRIu64 "  %7" PRIu32 "  ", 100.0 * t->certificate.gap,
            unit() * t->certificate.objective, t->entries, has_spots(t) ? t->spots : tuned->p.game->board.places);
    write_options(out, t);
    fputc('\n', out);
  }
  write_worth_of_options(out);
  if (stop_asked()) fprintf(out, "ended (%s) before %d more were tried\n", stop_reason(), planned - tried);
}

static void write_json(FILE *out, const void *what) {
  const options *o = what;
  json j;
  json_begin(&j, out);
  json_object(&j, NULL);
  json_string(&j, "command", "tune");
  json_string(&j, "input", o->input);
  if (told_seconds() > 0.0) json_number(&j, "seconds_per_step", told_seconds());
  json_number(&j, "objective_bound", unit() * tries[0].certificate.bound);
  json_flat_object(&j, "certified_setting");
  json_number(&j, "objective_value", unit() * proven.certificate.objective);
  json_bool(&j, "certified", proven.certificate.certified);
  json_natural(&j, "episodes", proven.certificate.episodes);
  json_natural(&j, "q_entries", proven.entries);
  json_end_object(&j);
  json_integer(&j, "planned", planned);
  json_integer(&j, "tried", tried);
  json_array(&j, "tries");
  for (int i = 0; i < count; i++) {
    const try *t = &tries[i];
    json_flat_object(&j, NULL);
    json_number(&j, "gap", t->certificate.gap);
    json_number(&j, "objective_value", unit() * t->certificate.objective);
    json_natural(&j, "q_entries", t->entries);
    json_natural(&j, "regions", t->regions);
    json_natural(&j, "spots", t->spots);
    json_integer(&j, "region_size", has_regions(t) ? (int)t->how.regions.max_size : 0);
    json_integer(&j, "region_diameter", has_regions(t) ? (int)t->how.regions.diameter : 0);
    json_integer(&j, "spot_size", has_spots(t) ? t->how.units.spots.size : 0);
    json_integer(&j, "spot_diameter", has_spots(t) ? t->how.units.spots.diameter : 0);
    if (has_spots(t)) figures_json_seconds(&j, "spot_diameter_seconds", t->how.units.spots.diameter, told_seconds());
    json_string(&j, "spot_order", words_spot_order[t->how.units.spot_order]);
    json_number(&j, "spot_likelihood", t->how.units.spots.likelihood);
    json_end_object(&j);
  }
  json_end_array(&j);
  notes_json(&tuned->p.in.note, &j);
  json_end_object(&j);
}

int command_tune(int argc, char **argv) {
  static options o;
  fault why;
  if (options_parse(&o, &set, argc, argv, &why) != 0) return fault_exit(&why);
  if (o.help) return option_help(stdout, &set);
  stop_begin();
  if (tune(&o, &why) != 0 || print_report(&o, write_json, write_text, &o, &why) != 0) return fault_exit(&why);
  return stop_signal() != 0 ? 128 + stop_signal() : EXIT_SUCCESS;
}

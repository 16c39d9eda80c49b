#include "options.h"

#include <errno.h>
#include <getopt.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "host/base/refusal.h"
#include "quarter/joint.h"
#include "quarter/mission.h"

/* One row an option: how it is spelt, and how its value is taken. */
typedef struct {
  const char *name;
  int argument; /* as in struct option */
  int letter;   /* its short form, or 0 */
  int (*take)(options *o, const char *name, const char *value, fault *why);
} option_row;

/* ---- numbers ---- */

static int take_number(double *number, const char *name, const char *value, const char *range, double least,
                       double most, fault *why) {
  char *end;
  errno = 0;
  *number = strtod(value, &end);
  if (end == value || *end != '\0' || !(*number >= least && *number <= most) || errno == ERANGE)
    return fault_set(why, "--%s %s: not a number %s", name, value, range);
  return 0;
}

static int take_count(uint64_t *count, const char *name, const char *value, uint64_t least, uint64_t most, fault *why) {
  char *end;
  errno = 0;
  *count = strtoull(value, &end, 10);
  if (value[0] < '0' || value[0] > '9' || *end != '\0' || errno == ERANGE || *count < least || *count > most)
    return fault_set(why, "--%s %s: not a whole number from %llu to %llu", name, value, (unsigned long long)least,
                     (unsigned long long)most);
  return 0;
}

static int take_int(int *number, const char *name, const char *value, int least, int most, fault *why) {
  uint64_t count;
  if (take_count(&count, name, value, (uint64_t)least, (uint64_t)most, why) != 0) return -1;
  *number = (int)count;
  return 0;
}

static int take_word(int *number, const char *name, const char *value, const char *zero, const char *one, fault *why) {
  if (strcmp(value, zero) != 0 && strcmp(value, one) != 0)
    return fault_set(why, "--%s %s: say %s or %s", name, value, zero, one);
  *number = strcmp(value, one) == 0;
  return 0;
}

/* ---- one function an option ---- */

static int take_output(options *o, const char *name, const char *value, fault *why) {
  if (value[0] == '\0') return fault_set(why, "--%s: the name of the file is empty", name);
  o->output = value;
  return 0;
}

static int take_c(options *o, const char *name, const char *value, fault *why) {
  if (value[0] == '\0') return fault_set(why, "--%s: the name of the file is empty", name);
  o->c_output = value;
  return 0;
}

static int take_curve(options *o, const char *name, const char *value, fault *why) {
  if (value[0] == '\0') return fault_set(why, "--%s: the name of the file is empty", name);
  o->curve = value;
  return 0;
}

static int take_json(options *o, const char *name, const char *value, fault *why) {
  if (value != NULL && value[0] == '\0') return fault_set(why, "--%s: the name of the file is empty", name);
  o->json = true;
  o->json_path = value;
  return 0;
}

static int take_quiet(options *o, const char *name, const char *value, fault *why) {
  (void)name;
  (void)value;
  (void)why;
  o->quiet = true;
  return 0;
}

static int take_help(options *o, const char *name, const char *value, fault *why) {
  (void)name;
  (void)value;
  (void)why;
  o->help = true;
  return 0;
}

static int take_robots(options *o, const char *name, const char *value, fault *why) {
  uint64_t count;
  if (take_count(&count, name, value, 1, 1000000, why) != 0) return -1;
  if (count > QTR_MAX_SEEKERS)
    return fault_set(why, "--%s %s: this build holds %d seekers; rebuild with a larger QTR_MAX_SEEKERS", name, value,
                     QTR_MAX_SEEKERS);
  o->plan.reading.robots = (int)count;
  return 0;
}

static int take_objective(options *o, const char *name, const char *value, fault *why) {
  return take_word(&o->plan.objective, name, value, "discounted", "time", why);
}

static int take_rule(options *o, const char *name, const char *value, fault *why) {
  return take_word(&o->plan.rule, name, value, "free", "paper", why);
}

static int take_gamma(options *o, const char *name, const char *value, fault *why) {
  if (take_number(&o->plan.gamma, name, value, "above 0 and below 1", 0.0, 1.0, why) != 0) return -1;
  if (o->plan.gamma <= 0.0 || o->plan.gamma >= 1.0)
    return fault_set(why, "--%s %s: not a number above 0 and below 1", name, value);
  return 0;
}

static int take_cell_size(options *o, const char *name, const char *value, fault *why) {
  return take_number(&o->plan.reading.cell_size, name, value, "of metres, from 0.001 to 1000", 1e-3, 1e3, why);
}

static int take_skip_unreachable(options *o, const char *name, const char *value, fault *why) {
  (void)name;
  (void)value;
  (void)why;
  o->plan.reading.skip = true;
  return 0;
}

static int take_snap(options *o, const char *name, const char *value, fault *why) {
  return take_number(&o->plan.reading.snap, name, value, "of metres (of cells, on a map without metres), from 0 to 1e6",
                     0.0, 1e6, why);
}

static int take_learner(options *o, const char *name, const char *value, fault *why) {
  int setting = 0;
  if (take_word(&setting, name, value, "certified", "paper", why) != 0) return -1;
  o->plan.learner.setting = (uint8_t)setting;
  return 0;
}

/* KIND[:FIRST[:LAST[:DECAY]]] */
static int take_explore(options *o, const char *name, const char *value, fault *why) {
  static const char *const kinds[] = {"uniform", "epsilon", "softmax"};
  qtr_exploration_plan *plan = &o->plan.learner.exploration;
  const size_t length = strcspn(value, ":");
  int kind = 0;
  while (kind < 3 && (strlen(kinds[kind]) != length || strncmp(kinds[kind], value, length) != 0)) kind++;
  if (kind == 3) return fault_set(why, "--%s %s: say uniform, epsilon or softmax", name, value);
  plan->kind = (uint8_t)kind;
  const char *rates = value[length] == ':' ? value + length + 1 : NULL;
  int taken = 0;
  if (rates == NULL) return 0;
  const int fields =
      sscanf(rates, "%lf%n:%lf%n:%lf%n", &plan->first, &taken, &plan->last, &taken, &plan->decay, &taken);
  if (fields < 1 || rates[taken] != '\0')
    return fault_set(why, "--%s %s: say KIND:FIRST:LAST:DECAY, as softmax:1:0.01:0.9995", name, value);
  qtr_explorer explorer;
  if (qtr_explorer_init(&explorer, plan, 1) != 0)
    return fault_set(why, "--%s %s: rates are 0 to 1 (softmax: temperatures above 0), the decay 0 to 1", name, value);
  return 0;
}

static int take_alpha(options *o, const char *name, const char *value, fault *why) {
  return take_number(&o->plan.learner.alpha, name, value, "above 0 up to 1", 1e-9, 1.0, why);
}

static int take_aggregate(options *o, const char *name, const char *value, fault *why) {
  static const char *const words[] = {"none", "regions", "spots", "both"};
  for (int i = 0; i < 4; i++) {
    if (strcmp(value, words[i]) != 0) continue;
    o->plan.aggregation.by_regions = (i & 1) != 0;
    o->plan.aggregation.by_spots = (i & 2) != 0;
    return 0;
  }
  return fault_set(why, "--%s %s: say none, regions, spots or both", name, value);
}

static int take_region_size(options *o, const char *name, const char *value, fault *why) {
  return take_int(&o->plan.aggregation.region_size, name, value, 1, QTR_MAX_REGION_SIZE, why);
}

static int take_region_diameter(options *o, const char *name, const char *value, fault *why) {
  return take_int(&o->plan.aggregation.region_diameter, name, value, 1, QTR_MAX_REGION_DIAMETER, why);
}

static int take_region_likelihood(options *o, const char *name, const char *value, fault *why) {
  return take_number(&o->plan.aggregation.region_likelihood, name, value, "from 0 to 1000", 0.0, 1000.0, why);
}

static int take_region_times(options *o, const char *name, const char *value, fault *why) {
  return take_word(&o->plan.aggregation.region_times, name, value, "representative", "true", why);
}

static int take_spot_size(options *o, const char *name, const char *value, fault *why) {
  return take_int(&o->plan.aggregation.spot_size, name, value, 1, QTR_MAX_SPOT_SIZE, why);
}

static int take_spot_diameter(options *o, const char *name, const char *value, fault *why) {
  return take_int(&o->plan.aggregation.spot_diameter, name, value, 1, 1000000000, why);
}

static int take_spot_order(options *o, const char *name, const char *value, fault *why) {
  return take_word(&o->plan.aggregation.spot_order, name, value, "best", "nearest", why);
}

static int take_spot_likelihood(options *o, const char *name, const char *value, fault *why) {
  return take_number(&o->plan.aggregation.spot_likelihood, name, value, "from 0 to 1000", 0.0, 1000.0, why);
}

static int take_starts(options *o, const char *name, const char *value, fault *why) {
  int any = 0;
  if (take_word(&any, name, value, "mission", "any", why) != 0) return -1;
  o->plan.any_starts = any != 0;
  return 0;
}

static int take_cleared(options *o, const char *name, const char *value, fault *why) {
  int any = 0;
  if (take_word(&any, name, value, "none", "any", why) != 0) return -1;
  o->plan.any_cleared = any != 0;
  return 0;
}

static int take_table_limit(options *o, const char *name, const char *value, fault *why) {
  return take_number(&o->plan.table_limit, name, value, "of megabytes, from 0.001 to 1000", 1e-3, 1e3, why);
}

static int take_budget_entries(options *o, const char *name, const char *value, fault *why) {
  return take_count(&o->budget_entries, name, value, 1, UINT64_MAX - 1, why);
}

static int take_gap(options *o, const char *name, const char *value, fault *why) {
  return take_number(&o->plan.learner.gap, name, value, "from 0 to 1 (0.01 is one per cent)", 0.0, 1.0, why);
}

static int take_time_limit(options *o, const char *name, const char *value, fault *why) {
  return take_number(&o->time_limit, name, value, "of seconds, from 0.001 to 1e7", 1e-3, 1e7, why);
}

static int take_episodes(options *o, const char *name, const char *value, fault *why) {
  return take_count(&o->episodes, name, value, 1, UINT64_MAX - 1, why);
}

static int take_seed(options *o, const char *name, const char *value, fault *why) {
  return take_count(&o->plan.learner.seed, name, value, 0, UINT64_MAX - 1, why);
}

/* SEEKER:+STEPS or SEEKER:xFACTOR */
static int take_late(options *o, const char *name, const char *value, fault *why) {
  if (o->game.lates == QTR_MAX_SEEKERS) return fault_set(why, "--%s: given more than %d times", name, QTR_MAX_SEEKERS);
  simulation_late *late = &o->game.late[o->game.lates];
  char seeker[32];
  const char *colon = strchr(value, ':');
  if (colon == NULL || colon == value || (size_t)(colon - value) >= sizeof seeker ||
      (colon[1] != '+' && colon[1] != 'x'))
    return fault_set(why, "--%s %s: say SEEKER:+STEPS or SEEKER:xFACTOR, as 1:+30 or 1:x2.5", name, value);
  snprintf(seeker, sizeof seeker, "%.*s", (int)(colon - value), value);
  late->wait = 0;
  late->factor = 1.0;
  if (take_int(&late->seeker, name, seeker, 0, QTR_MAX_SEEKERS - 1, why) != 0) return -1;
  o->game.lates++;
  if (colon[1] == 'x')
    return take_number(&late->factor, name, colon + 2, "from 1 to 1000 after the x", 1.0, 1000.0, why);
  uint64_t wait;
  if (take_count(&wait, name, colon + 2, 0, 1000000000, why) != 0) return -1;
  late->wait = (uint32_t)wait;
  return 0;
}

/* SEEKER@STEP */
static int take_lost(options *o, const char *name, const char *value, fault *why) {
  if (o->game.losts == QTR_MAX_SEEKERS) return fault_set(why, "--%s: given more than %d times", name, QTR_MAX_SEEKERS);
  simulation_lost *lost = &o->game.lost[o->game.losts];
  char seeker[32];
  uint64_t step;
  const char *at = strchr(value, '@');
  if (at == NULL || at == value || (size_t)(at - value) >= sizeof seeker)
    return fault_set(why, "--%s %s: say SEEKER@STEP, as 1@40", name, value);
  snprintf(seeker, sizeof seeker, "%.*s", (int)(at - value), value);
  if (take_int(&lost->seeker, name, seeker, 0, QTR_MAX_SEEKERS - 1, why) != 0) return -1;
  if (take_count(&step, name, at + 1, 0, 4000000000u, why) != 0) return -1;
  lost->step = (uint32_t)step;
  o->game.losts++;
  return 0;
}

/* COLUMN,ROW */
static int take_from(options *o, const char *name, const char *value, fault *why) {
  int taken = 0;
  if (o->game.froms == QTR_MAX_SEEKERS) return fault_set(why, "--%s: given more than %d times", name, QTR_MAX_SEEKERS);
  const int fields =
      sscanf(value, "%6d,%6d%n", &o->game.from[o->game.froms].column, &o->game.from[o->game.froms].row, &taken);
  if (fields != 2 || value[taken] != '\0' || o->game.from[o->game.froms].column < 0 ||
      o->game.from[o->game.froms].row < 0)
    return fault_set(why, "--%s %s: say COLUMN,ROW, counted from 0 at the top left", name, value);
  o->game.froms++;
  return 0;
}

/* PLACE,PLACE,... */
static int take_clear(options *o, const char *name, const char *value, fault *why) {
  for (const char *at = value; at != NULL; at = strchr(at, ',') != NULL ? strchr(at, ',') + 1 : NULL) {
    char word[16];
    int place;
    snprintf(word, sizeof word, "%.*s", (int)strcspn(at, ","), at);
    if (take_int(&place, name, word, 0, QTR_MAX_PLACES - 1, why) != 0) return -1;
    qtr_places_add(&o->game.clear, (unsigned)place);
  }
  return 0;
}

static int take_target(options *o, const char *name, const char *value, fault *why) {
  return take_int(&o->game.target, name, value, 0, QTR_MAX_PLACES - 1, why);
}

static int take_clear_all(options *o, const char *name, const char *value, fault *why) {
  (void)name;
  (void)value;
  (void)why;
  o->game.clear_all = true;
  return 0;
}

static int take_history(options *o, const char *name, const char *value, fault *why) {
  (void)name;
  (void)why;
  o->history = value;
  return 0;
}

static int take_belief(options *o, const char *name, const char *value, fault *why) {
  (void)name;
  (void)why;
  o->belief = value;
  return 0;
}

static int take_prior(options *o, const char *name, const char *value, fault *why) {
  return take_number(&o->prior, name, value, "of finds, from 1e-6 to 1e12", 1e-6, 1e12, why);
}

static int take_keep(options *o, const char *name, const char *value, fault *why) {
  return take_number(&o->keep, name, value, "above 0 up to 1 (1: nothing is forgotten)", 1e-9, 1.0, why);
}

static int take_detection(options *o, const char *name, const char *value, fault *why) {
  return take_number(&o->detection, name, value, "from 0 to 1 (1: nothing is overlooked)", 0.0, 1.0, why);
}

static int take_regions(options *o, const char *name, const char *value, fault *why) {
  (void)name;
  (void)value;
  (void)why;
  o->regions = true;
  return 0;
}

static int take_spots(options *o, const char *name, const char *value, fault *why) {
  (void)name;
  (void)value;
  (void)why;
  o->spots = true;
  return 0;
}

static const option_row rows[] = {{"output", required_argument, 'o', take_output},
                                  {"c", required_argument, 0, take_c},
                                  {"curve", required_argument, 0, take_curve},
                                  {"json", optional_argument, 0, take_json},
                                  {"quiet", no_argument, 'q', take_quiet},
                                  {"help", no_argument, 'h', take_help},
                                  {"robots", required_argument, 0, take_robots},
                                  {"objective", required_argument, 0, take_objective},
                                  {"rule", required_argument, 0, take_rule},
                                  {"gamma", required_argument, 0, take_gamma},
                                  {"cell-size", required_argument, 0, take_cell_size},
                                  {"skip-unreachable", no_argument, 0, take_skip_unreachable},
                                  {"snap", required_argument, 0, take_snap},
                                  {"learner", required_argument, 0, take_learner},
                                  {"explore", required_argument, 0, take_explore},
                                  {"alpha", required_argument, 0, take_alpha},
                                  {"aggregate", required_argument, 0, take_aggregate},
                                  {"region-size", required_argument, 0, take_region_size},
                                  {"region-diameter", required_argument, 0, take_region_diameter},
                                  {"region-likelihood", required_argument, 0, take_region_likelihood},
                                  {"region-times", required_argument, 0, take_region_times},
                                  {"spot-size", required_argument, 0, take_spot_size},
                                  {"spot-diameter", required_argument, 0, take_spot_diameter},
                                  {"spot-order", required_argument, 0, take_spot_order},
                                  {"spot-likelihood", required_argument, 0, take_spot_likelihood},
                                  {"starts", required_argument, 0, take_starts},
                                  {"cleared", required_argument, 0, take_cleared},
                                  {"table-limit", required_argument, 0, take_table_limit},
                                  {"budget-entries", required_argument, 0, take_budget_entries},
                                  {"gap", required_argument, 0, take_gap},
                                  {"time-limit", required_argument, 0, take_time_limit},
                                  {"episodes", required_argument, 0, take_episodes},
                                  {"seed", required_argument, 0, take_seed},
                                  {"late", required_argument, 0, take_late},
                                  {"lost", required_argument, 0, take_lost},
                                  {"from", required_argument, 0, take_from},
                                  {"clear", required_argument, 0, take_clear},
                                  {"target", required_argument, 0, take_target},
                                  {"regions", no_argument, 0, take_regions},
                                  {"spots", no_argument, 0, take_spots},
                                  {"clear-all", no_argument, 0, take_clear_all},
                                  {"history", required_argument, 0, take_history},
                                  {"belief", required_argument, 0, take_belief},
                                  {"prior", required_argument, 0, take_prior},
                                  {"keep", required_argument, 0, take_keep},
                                  {"detection", required_argument, 0, take_detection}};
enum { ROWS = sizeof rows / sizeof rows[0] };

/* ---- the whole line ---- */

static bool is_allowed(const option_set *set, const char *name) {
  char word[64];
  snprintf(word, sizeof word, " %s ", name);
  return strcmp(name, "help") == 0 || strstr(set->allowed, word) != NULL;
}

/* getopt's tables for what this command takes: a long option returns its row's number, counted from 1. */
static void make_tables(const option_set *set, struct option *longs, char *shorts) {
  int count = 0;
  *shorts++ = ':';
  for (int i = 0; i < ROWS; i++) {
    if (!is_allowed(set, rows[i].name)) continue;
    longs[count++] = (struct option){rows[i].name, rows[i].argument, NULL, i + 1};
    if (rows[i].letter == 0) continue;
    *shorts++ = (char)rows[i].letter;
    if (rows[i].argument == required_argument) *shorts++ = ':';
  }
  longs[count] = (struct option){NULL, 0, NULL, 0};
  *shorts = '\0';
}

static const option_row *find_row(int code) {
  if (code >= 1 && code <= ROWS) return &rows[code - 1];
  for (int i = 0; i < ROWS; i++)
    if (rows[i].letter == code) return &rows[i];
  return NULL;
}

static void set_defaults(options *o) {
  memset(o, 0, sizeof *o);
  plan_config_default(&o->plan);
  simulation_config_default(&o->game);
  o->detection = 1.0;
}

static int check_input(options *o, const option_set *set, int argc, char **argv, fault *why) {
  if (o->help) return 0;
  if (optind == argc) return fault_set(why, "%s: name an input; 'quarter %s --help' shows how", set->name, set->name);
  if (optind + 1 < argc)
    return fault_set(why, "%s: one input at a time, and '%s' is a second one", set->name, argv[optind + 1]);
  o->input = argv[optind];
  return 0;
}

int options_parse(options *o, const option_set *set, int argc, char **argv, fault *why) {
  struct option longs[ROWS + 1];
  char shorts[3 * ROWS];
  make_tables(set, longs, shorts);
  set_defaults(o);
  opterr = 0;
  optind = 1;
  int code;
  while ((code = getopt_long(argc, argv, shorts, longs, NULL)) != -1) {
    if (code == '?' || code == ':') return refuse_option(set->name, code, argv[optind - 1], longs, why);
    const option_row *row = find_row(code);
    if (row->take(o, row->name, optarg, why) != 0) return -1;
  }
  return check_input(o, set, argc, argv, why);
}

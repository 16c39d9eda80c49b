#include "options.h"

#include <getopt.h>
#include <stdio.h>
#include <string.h>

#include "history.h"
#include "host/input/words.h"
#include "quarter/regions.h"
#include "quarter/spots.h"

/* ---- options that take their values themselves ---- */

static int take_json(void *settings, const option_record *record, const char *value, fault *why) {
  options *o = settings;
  if (value != NULL && value[0] == '\0') return fault_set(why, "--%s: the name of the file is empty", record->name);
  o->json = true;
  o->json_path = value;
  return 0;
}

static int take_robots(void *settings, const option_record *record, const char *value, fault *why) {
  options *o = settings;
  uint64_t count;
  if (option_count(&count, record->name, value, 1, 1000000, why) != 0) return -1;
  if (count > QTR_MAX_SEEKERS)
    return fault_set(why, "--%s %s: this build holds %d seekers; rebuild with a larger QTR_MAX_SEEKERS", record->name,
                     value, QTR_MAX_SEEKERS);
  o->plan.reading.robots = (int)count;
  return 0;
}

/* KIND[:FIRST[:LAST[:DECAY]]] */
static int take_explore(void *settings, const option_record *record, const char *value, fault *why) {
  options *o = settings;
  qtr_exploration_plan *plan = &o->plan.learner.exploration;
  const char *name = record->name;
  const size_t length = strcspn(value, ":");
  int kind;
  if (option_word(&kind, name, value, length, words_exploration, why) != 0) return -1;
  plan->kind = (uint8_t)kind;
  const char *rates = value[length] == ':' ? value + length + 1 : NULL;
  int taken = 0;
  if (rates == NULL) return 0;
  const int fields =
      sscanf(rates, "%lf%n:%lf%n:%lf%n", &plan->first, &taken, &plan->last, &taken, &plan->decay, &taken);
  if (fields < 1 || rates[taken] != '\0')
    return fault_set(why, "--%s %s: say KIND:FIRST:LAST:DECAY, as softmax:1:0.01:0.9995", name, value);
  if (qtr_exploration_check(plan) != QTR_OK)
    return fault_set(why, "--%s %s: rates are 0 to 1 (softmax: temperatures above 0), the decay 0 to 1", name, value);
  return 0;
}

/* The word before a mark that has been found in `value`: who that is, the table tells. */
static void take_who(char *who, const char *value, const char *mark) {
  snprintf(who, QTR_SITE_NAME_BYTES, "%.*s", (int)(mark - value), value);
}

static bool splits(const char *value, const char *mark) {
  return mark != NULL && mark != value && mark - value < QTR_SITE_NAME_BYTES;
}

static int too_many(const char *name, fault *why) {
  return fault_set(why, "--%s: given more than %d times", name, QTR_MAX_SEEKERS);
}

/* Steps, or seconds, "30s", of which the table tells how many steps they are. */
static int take_moment(uint32_t *steps, double *seconds, const char *name, const char *value, uint64_t most,
                       fault *why) {
  char number[32];
  const size_t length = strlen(value);
  uint64_t count;
  *seconds = 0.0;
  *steps = 0;
  if (length > 1 && length < sizeof number && value[length - 1] == 's') {
    snprintf(number, sizeof number, "%.*s", (int)(length - 1), value);
    return option_number(seconds, name, number, "of seconds, from 0 to 1e9", 0.0, 1e9, why);
  }
  if (strspn(value, "0123456789") != length)
    return fault_set(why, "--%s: '%s' is no moment; say steps, as 40, or seconds, as 40s", name, value);
  if (option_count(&count, name, value, 0, most, why) != 0) return -1;
  *steps = (uint32_t)count;
  return 0;
}

/* SEEKER:+STEPS or SEEKER:xFACTOR */
static int take_late(void *settings, const option_record *record, const char *value, fault *why) {
  options *o = settings;
  const char *name = record->name, *colon = strrchr(value, ':');
  if (o->game.lates == QTR_MAX_SEEKERS) return too_many(name, why);
  if (!splits(value, colon) || (colon[1] != '+' && colon[1] != 'x'))
    return fault_set(why, "--%s %s: say SEEKER:+STEPS or SEEKER:xFACTOR, as 1:+30, 1:+30s (seconds) or 1:x2.5", name,
                     value);
  simulation_late *late = &o->game.late[o->game.lates];
  *late = (simulation_late){0, 0, 1.0};
  double *seconds = &o->late_seconds[o->game.lates];
  take_who(o->late[o->game.lates++], value, colon);
  if (colon[1] == 'x')
    return option_number(&late->factor, name, colon + 2, "from 1 to 1000 after the x", 1.0, 1000.0, why);
  return take_moment(&late->wait, seconds, name, colon + 2, 1000000000, why);
}

/* SEEKER@STEP */
static int take_lost(void *settings, const option_record *record, const char *value, fault *why) {
  options *o = settings;
  const char *name = record->name, *at = strrchr(value, '@');
  if (o->game.losts == QTR_MAX_SEEKERS) return too_many(name, why);
  if (!splits(value, at)) return fault_set(why, "--%s %s: say SEEKER@STEP, as 1@40, or 1@40s (seconds)", name, value);
  simulation_lost *lost = &o->game.lost[o->game.losts];
  double *seconds = &o->lost_seconds[o->game.losts];
  take_who(o->lost[o->game.losts++], value, at);
  return take_moment(&lost->step, seconds, name, at + 1, 4000000000u, why);
}

/* COLUMN,ROW */
static int take_from(void *settings, const option_record *record, const char *value, fault *why) {
  options *o = settings;
  int taken = 0;
  if (o->game.froms == QTR_MAX_SEEKERS) return too_many(record->name, why);
  simulation_start *from = &o->game.from[o->game.froms];
  const int fields = sscanf(value, "%6d,%6d%n", &from->column, &from->row, &taken);
  if (fields != 2 || value[taken] != '\0' || from->column < 0 || from->row < 0)
    return fault_set(why, "--%s %s: say COLUMN,ROW, counted from 0 at the top left", record->name, value);
  o->game.froms++;
  return 0;
}

/* Words of which the input, or the table, tells what they mean. */
static int take_one(const char **words, int *count, const char *name, const char *value, fault *why) {
  if (*count == INPUT_WORDS) return fault_set(why, "--%s: given more than %d times", name, INPUT_WORDS);
  words[(*count)++] = value;
  return 0;
}

static int take_clear(void *settings, const option_record *record, const char *value, fault *why) {
  input_options *reading = &((options *)settings)->plan.reading;
  return take_one(reading->clear, &reading->clears, record->name, value, why);
}

static int take_without(void *settings, const option_record *record, const char *value, fault *why) {
  input_options *reading = &((options *)settings)->plan.reading;
  return take_one(reading->without, &reading->withouts, record->name, value, why);
}

static int take_add(void *settings, const option_record *record, const char *value, fault *why) {
  input_options *reading = &((options *)settings)->plan.reading;
  return take_one(reading->add, &reading->adds, record->name, value, why);
}

/* ---- all options ---- */

#define MARK(field) .kind = OPTION_MARK, OPTION_FIELD(options, field)
#define TEXT(field) .kind = OPTION_TEXT, OPTION_FIELD(options, field)
#define FILE_NAME(field) .kind = OPTION_FILE, OPTION_FIELD(options, field)
#define NUMBER(field, low, high, words)                                                                                \
  .kind = OPTION_NUMBER, OPTION_FIELD(options, field), .least = (low), .most = (high), .range = (words)
#define COUNT(field, low, high) .kind = OPTION_COUNT, OPTION_FIELD(options, field), .first = (low), .last = (high)
#define WORD(field, list) .kind = OPTION_WORD, OPTION_FIELD(options, field), .words = (list)
#define OWN(taker) .kind = OPTION_OWN, .take = (taker)

static const char *const starts_words[] = {"mission", "any", NULL};
static const char *const cleared_words[] = {"none", "any", NULL};

option_table option_records = {
    {.name = "output",
     .letter = 'o',
     .argument = "FILE",
     .help = "write the policy table; '-' is standard output",
     FILE_NAME(output)},
    {.name = "c", .argument = "FILE", .help = "write it as C source", FILE_NAME(c_output)},
    {.name = "profile",
     .argument = "mcu|FILE",
     .help = "the robots' array sizes: the profile mcu, or the header that QTR_CONFIG_HEADER names there.\n"
             "Tells what a table takes of flash and RAM, and refuses one that does not fit",
     FILE_NAME(profile)},
    {.name = "curve",
     .argument = "FILE",
     .help = "write MaxQ, the best value, the bound and the Q entries, game by game, as CSV",
     FILE_NAME(curve)},
    {.name = "json", .argument = "[=FILE]", .help = "print the report as JSON, or write it to FILE", OWN(take_json)},
    {.name = "quiet", .letter = 'q', .help = "no progress, no report but JSON", MARK(quiet)},
    {.name = "help", .letter = 'h', .help = "tell what the command takes", MARK(help)},
    {.name = "robots", .argument = "K", .help = "K robots, where the input has one start", OWN(take_robots)},
    {.name = "objective",
     .argument = "WHAT",
     .help = "discounted (maximise w P gamma^(t-1), the default), time (least expected time) or deadline\n"
             "(greatest probability of a find by --deadline)",
     WORD(plan.aim.kind, qtr_objective_names)},
    {.name = "deadline",
     .argument = "SECONDS",
     .help = "find by then, with the greatest probability: the mission's objective and deadline set aside",
     NUMBER(plan.deadline_seconds, 0.0, 1e7, "of seconds, above 0 up to 1e7"),
     .open = true},
    {.name = "rule",
     .argument = "RULE",
     .help = "free (robots may stand down, the default) or paper (Table 1: they must choose)",
     WORD(plan.rule, words_rule)},
    {.name = "gamma",
     .argument = "G",
     .help = "discount a second, above 0 and below 1 (default %s)",
     .standard = "0.99",
     NUMBER(plan.aim.gamma, 0.0, 1.0, "above 0 and below 1"),
     .open = true},
    {.name = "cell-size",
     .argument = "M",
     .help = "metres a cell",
     NUMBER(plan.reading.cell_size, 1e-3, 1e3, "of metres, from 0.001 to 1000")},
    {.name = "skip-unreachable",
     .help = "leave out places that no robot can reach, or that are on no free cell",
     MARK(plan.reading.skip)},
    {.name = "snap",
     .argument = "METRES",
     .help = "move robots and places that are on no free cell to the nearest one, as far as this (cells, on a\n"
             "map without metres); a place takes a cell that no other place has",
     NUMBER(plan.reading.snap, 0.0, 1e6, "of metres (of cells, on a map without metres), from 0 to 1e6")},
    {.name = "learner",
     .argument = "SETTING",
     .help = "certified (the default) or paper: Q from 0, exploring, as the paper learns",
     WORD(plan.learner.setting, words_setting)},
    {.name = "explore",
     .argument = "PLAN",
     .help = "paper setting: KIND:FIRST:LAST:DECAY, KIND being uniform, epsilon or softmax; the rate\n"
             "(epsilon, or softmax's temperature) is DECAYed every game (default %s)",
     .standard = "epsilon:0.3:0.3:1",
     OWN(take_explore)},
    {.name = "alpha",
     .argument = "A",
     .help = "paper setting: learning rate, above 0 up to 1 (default %s)",
     .standard = "1",
     NUMBER(plan.learner.alpha, 1e-9, 1.0, "above 0 up to 1")},
    {.name = "aggregate", .argument = "WHAT", .help = aggregate_help, WORD(plan.aggregate.way, aggregate_names)},
    {.name = "region-size",
     .argument = "N",
     .standard = "25",
     COUNT(plan.aggregate.regions.max_size, 1, QTR_MAX_REGION_SIZE)},
    {.name = "region-diameter",
     .argument = "D",
     .standard = "15",
     COUNT(plan.aggregate.regions.diameter, 1, QTR_MAX_REGION_DIAMETER)},
    {.name = "region-likelihood",
     .argument = "W",
     .help = "as --spot-likelihood, for the places of a region",
     NUMBER(plan.aggregate.regions.likelihood, 0.0, 1000.0, "from 0 to 1000")},
    {.name = "region-times",
     .argument = "WHAT",
     .help = "representative (the default) or true: the paper's first, oscillating way, to show it",
     WORD(plan.aggregate.units.region_times, words_region_times)},
    {.name = "spot-size",
     .argument = "N",
     .standard = "5",
     COUNT(plan.aggregate.units.spots.size, 1, QTR_MAX_SPOT_SIZE)},
    {.name = "spot-diameter",
     .argument = "D",
     .standard = "25",
     COUNT(plan.aggregate.units.spots.diameter, 1, 1000000000)},
    {.name = "spot-order",
     .argument = "ORDER",
     .help = "inside a spot: best (the default) or nearest first",
     WORD(plan.aggregate.units.spot_order, words_spot_order)},
    {.name = "spot-likelihood",
     .argument = "W",
     .help = "%s (the default) or more: likely places keep away from unlikely ones",
     .standard = "0",
     NUMBER(plan.aggregate.units.spots.likelihood, 0.0, 1000.0, "from 0 to 1000")},
    {.name = "starts",
     .argument = "any",
     .help = "one table for starts anywhere on the map: seekers are put elsewhere at run time",
     WORD(plan.any_starts, starts_words)},
    {.name = "start-regions",
     .argument = "N",
     .help = "so many regions at most (default: as many as --table-limit, --time-limit and some minutes allow)",
     COUNT(plan.start_regions, 1, QTR_MAX_STARTS - QTR_MAX_SEEKERS)},
    {.name = "cleared",
     .argument = "any",
     .help = "one table for any set of places cleared beforehand: a mission resumed",
     WORD(plan.any_cleared, cleared_words)},
    {.name = "table-limit",
     .argument = "MB",
     .help = "make no larger table for any start or progress (default %s)",
     .standard = "4",
     NUMBER(plan.table_limit, 1e-3, 1e3, "of megabytes, from 0.001 to 1000")},
    {.name = "against",
     .argument = "TABLE",
     .help = "tell what changes against this plan (the default is the one that --output replaces)",
     FILE_NAME(against)},
    {.name = "budget-entries",
     .argument = "N",
     .help = "leave out what needs more Q entries",
     COUNT(budget_entries, 1, UINT64_MAX - 1)},
    {.name = "gap",
     .argument = "X",
     .help = "stop within this relative gap of the optimum (default %s; the paper setting, with 0,\n"
             "learns on until something else ends it)",
     .standard = "1e-5",
     NUMBER(plan.learner.gap, 0.0, 1.0, "from 0 to 1 (0.01 is one per cent)")},
    {.name = "time-limit",
     .argument = "S",
     .help = "stop after this many seconds, reading and travel times included (with --starts or --cleared\n"
             "any the mission's own plan gets half of them)",
     NUMBER(time_limit, 1e-3, 1e7, "of seconds, from 0.001 to 1e7")},
    {.name = "episodes", .argument = "N", .help = "stop after this many games", COUNT(episodes, 1, UINT64_MAX - 1)},
    {.name = "seed",
     .argument = "N",
     .help = "of random choices (default %s): how the paper setting explores, how local search on the\n"
             "first plans shakes; what is certified holds with every seed",
     .standard = "1",
     COUNT(plan.learner.seed, 0, UINT64_MAX - 1)},
    {.name = "late",
     .argument = "SEEKER:+STEPS or SEEKER:xFACTOR",
     .help = "30s are 30 seconds; may be given several times",
     OWN(take_late)},
    {.name = "lost",
     .argument = "SEEKER@STEP",
     .help = "40s are 40 seconds; may be given several times",
     OWN(take_lost)},
    {.name = "from",
     .argument = "COLUMN,ROW",
     .help = "where a seeker starts, given once for each: a table made with --starts any takes any cell",
     OWN(take_from)},
    {.name = "clear",
     .argument = "PLACE,...",
     .help = "places cleared beforehand, as every robot knows: their names or numbers",
     OWN(take_clear)},
    {.name = "without",
     .argument = "NAME",
     .help = "leave a place or a robot out, by name or as place:3, robot:1; may be given several times",
     OWN(take_without)},
    {.name = "add",
     .argument = "X,Y,W[,NAME]",
     .help = "one more place, behind the input's own; may be given several times",
     OWN(take_add)},
    {.name = "target", .argument = "PLACE", .help = "where the target is; its finder stops everyone", TEXT(target)},
    {.name = "dark", .help = "for dark pages", MARK(dark)},
    {.name = "grid", .help = "lines over the map, to read positions from", MARK(grid)},
    {.name = "picture",
     .argument = "FILE",
     .help = "the picture (default: beside the mission, .svg); .png and .pdf too",
     FILE_NAME(picture)},
    {.name = "open",
     .argument = "WxH",
     .help = "no map, but open ground, so many metres wide and high",
     FILE_NAME(open)},
    {.name = "resolution",
     .argument = "M",
     .help = "metres a pixel, of an image: the map YAML that says so is written beside it",
     NUMBER(resolution, 1e-4, 1e3, "of metres, from 0.0001 to 1000")},
    {.name = "force", .help = "write over a mission and a picture that are there", MARK(force)},
    {.name = "regions", .help = "draw the borders of the map's regions", MARK(regions)},
    {.name = "spots", .help = "mark the places of each hiding spot alike, for inputs", MARK(spots)},
    {.name = "format", .argument = "FORMAT", .help = "of the output; else as its name ends", TEXT(format)},
    {.name = "robot", .argument = "ROBOT", .help = "of this robot alone: its name or number", TEXT(robot)},
    {.name = "places", .help = "the places alone, without the corners between them", MARK(places)},
    {.name = "altitude",
     .argument = "METRES",
     .help = "qgc-plan, qgc-wpl: above home, of a drone, which takes off first (default: a rover)",
     NUMBER(altitude, 0.0, 10000.0, "of metres, from 0 to 10000")},
    {.name = "hold",
     .argument = "SECONDS",
     .help = "to stay at each place (default: as long as its scan takes, by the mission's scan_seconds); told by csv,\n"
             "geojson, qgc-plan and qgc-wpl",
     NUMBER(hold, 0.0, 1e6, "of seconds, from 0 to 1e6")},
    {.name = "clear-all", .help = "go on after the find, until every territory is done", MARK(game.clear_all)},
    {.name = "history", .argument = "FILE", .help = "the games to learn from", TEXT(history)},
    {.name = "belief",
     .argument = "FILE",
     .help = "go on from the belief saved there, if there is one, and save the new one. Games of the\n"
             "history are added to those that it holds: give each game once",
     TEXT(belief)},
    {.name = "prior",
     .argument = "FINDS",
     .help = "how many finds the mission's own weights count for (default: half as many as places).\n"
             "Few: the first games decide; many: the weights hold for long",
     NUMBER(prior, 1e-6, 1e12, "of finds, from 1e-6 to 1e12")},
    {.name = "keep",
     .argument = "SHARE",
     .help = "what a find still counts for after one more game (default %s: nothing is forgotten)",
     .standard = "1",
     NUMBER(keep, 1e-9, 1.0, "above 0 up to 1 (1: nothing is forgotten)")},
    {.name = "detection",
     .argument = "P",
     .help = "how often a look sees a target that is there, for rows with found 0 (default: as the\n"
             "mission says of each place)",
     NUMBER(detection, 0.0, 1.0, "from 0 to 1 (1: nothing is overlooked)")},
    {.name = NULL}};

/* ---- the whole line ---- */

void options_default(options *o) {
  memset(o, 0, sizeof *o);
  plan_config_default(&o->plan);
  simulation_config_default(&o->game);
  o->detection = HISTORY_OF_PLACES;
  o->hold = -1.0;
}

int options_parse_any(options *o, const option_set *set, int argc, char **argv, fault *why) {
  options_default(o);
  if (option_parse(o, set, argc, argv, why) != 0) return -1;
  if (o->help) return 0;
  if (optind + 1 < argc)
    return fault_set(why, "%s: one input at a time, and '%s' is a second one", set->name, argv[optind + 1]);
  o->input = optind < argc ? argv[optind] : NULL;
  return 0;
}

int options_parse(options *o, const option_set *set, int argc, char **argv, fault *why) {
  if (options_parse_any(o, set, argc, argv, why) != 0) return -1;
  if (o->help || o->input != NULL) return 0;
  return fault_set(why, "%s: name an input; 'quarter %s --help' shows how", set->name, set->name);
}

int options_parse_two(options *o, const option_set *set, int argc, char **argv, fault *why) {
  options_default(o);
  if (option_parse(o, set, argc, argv, why) != 0) return -1;
  if (o->help) return 0;
  if (argc - optind != 2)
    return fault_set(why, "%s: name two tables; 'quarter %s --help' shows how", set->name, set->name);
  o->input = argv[optind];
  o->second = argv[optind + 1];
  return 0;
}

int options_parse_alone(options *o, const option_set *set, int argc, char **argv, fault *why) {
  options_default(o);
  if (option_parse(o, set, argc, argv, why) != 0) return -1;
  if (o->help || optind == argc) return 0;
  return fault_set(why, "%s: takes no input, and '%s' is one", set->name, argv[optind]);
}

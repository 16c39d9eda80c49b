#include "settings.h"

#include <errno.h>
#include <getopt.h>
#include <stdlib.h>
#include <string.h>

#include "game.h"
#include "host/base/refusal.h"

enum letter {
  TABLE = 1,
  SAVE,
  LOG,
  FAULTS,
  LCM_URL,
  JSON,
  CLEAR_ALL,
  LOSE_ONE,
  PROCESSES,
  LIVE,
  FOLLOW,
  PORT,
  ROBOTS,
  MINE,
  RUNS,
  STRATEGY,
  SEED,
  SPEED,
  LEARN_LIMIT,
  VERSION
};

static const struct option longs[] = {{"output", required_argument, NULL, 'o'},
                                      {"table", required_argument, NULL, TABLE},
                                      {"save-table", required_argument, NULL, SAVE},
                                      {"log", required_argument, NULL, LOG},
                                      {"faults", required_argument, NULL, FAULTS},
                                      {"lcm-url", required_argument, NULL, LCM_URL},
                                      {"json", optional_argument, NULL, JSON},
                                      {"quiet", no_argument, NULL, 'q'},
                                      {"help", no_argument, NULL, 'h'},
                                      {"version", no_argument, NULL, VERSION},
                                      {"clear-all", no_argument, NULL, CLEAR_ALL},
                                      {"lose-one", no_argument, NULL, LOSE_ONE},
                                      {"processes", no_argument, NULL, PROCESSES},
                                      {"live", no_argument, NULL, LIVE},
                                      {"follow", no_argument, NULL, FOLLOW},
                                      {"port", required_argument, NULL, PORT},
                                      {"robots", required_argument, NULL, ROBOTS},
                                      {"mine", required_argument, NULL, MINE},
                                      {"runs", required_argument, NULL, RUNS},
                                      {"strategy", required_argument, NULL, STRATEGY},
                                      {"seed", required_argument, NULL, SEED},
                                      {"speed", required_argument, NULL, SPEED},
                                      {"learn-limit", required_argument, NULL, LEARN_LIMIT},
                                      {NULL, 0, NULL, 0}};

static int take_number(const char *name, const char *text, double least, double most, double *number, fault *why) {
  char *end;
  errno = 0;
  *number = strtod(text, &end);
  if (end != text && *end == '\0' && errno == 0 && *number >= least && *number <= most) return 0;
  return fault_set(why, "--%s %s: not a number from %g to %g", name, text, least, most);
}

static int take_whole(const char *name, const char *text, double least, double most, int *number, fault *why) {
  double value;
  if (take_number(name, text, least, most, &value, why) != 0) return -1;
  *number = (int)value;
  return value == (double)*number ? 0 : fault_set(why, "--%s %s: not a whole number", name, text);
}

static int take_seed(const char *text, uint64_t *seed, fault *why) {
  char *end;
  errno = 0;
  *seed = strtoull(text, &end, 10);
  if (text[0] >= '0' && text[0] <= '9' && *end == '\0' && errno == 0) return 0;
  return fault_set(why, "--seed %s: not a whole number", text);
}

static int take_strategy(const char *text, int *strategy, fault *why) {
  static const char *const words[] = {"plan", "nearest", "informed"};
  for (int i = 0; i < 3; i++) {
    if (strcmp(text, words[i]) != 0) continue;
    *strategy = i;
    return 0;
  }
  return fault_set(why, "--strategy %s: say plan, nearest or informed", text);
}

/* Options that are a word or a mark. False: it is none of them. */
static bool take_plain(settings *s, int letter, const char *value) {
  switch (letter) {
  case 'o': s->replay = value; return true;
  case 'q': s->quiet = true; return true;
  case 'h': s->help = true; return true;
  case VERSION: s->version = true; return true;
  case TABLE: s->table = value; return true;
  case SAVE: s->save = value; return true;
  case LOG: s->log = value; return true;
  case FAULTS: s->faults = value; return true;
  case LCM_URL: s->lcm_url = value; return true;
  default: return false;
  }
}

static bool take_mark(settings *s, int letter, const char *value) {
  switch (letter) {
  case JSON:
    s->json = true;
    s->json_path = value;
    return true;
  case CLEAR_ALL: s->clear_all = true; return true;
  case LOSE_ONE: s->lose_one = true; return true;
  case PROCESSES: s->processes = true; return true;
  case LIVE: s->live = true; return true;
  case FOLLOW: s->follow = true; return true;
  default: return false;
  }
}

static int take_value(settings *s, int letter, const char *value, fault *why) {
  switch (letter) {
  case PORT: return take_whole("port", value, 0, 65535, &s->port, why);
  case ROBOTS: return take_whole("robots", value, 1, DEMO_MOST_ROBOTS, &s->robots, why);
  case RUNS: return take_whole("runs", value, 1, 1000000, &s->runs, why);
  case STRATEGY: return take_strategy(value, &s->strategy, why);
  case SEED: return take_seed(value, &s->seed, why);
  case SPEED: return take_number("speed", value, 0.01, 1e6, &s->speed, why);
  case LEARN_LIMIT: return take_number("learn-limit", value, 0.01, 1e5, &s->learn_limit, why);
  default:
    if (strcmp(value, "none") == 0) {
      s->mine = -2;
      return 0;
    }
    return take_whole("mine", value, 0, DEMO_MOST_PLACES - 1, &s->mine, why);
  }
}

/* Ways to play, of which a command names one at most; none: a single game in this process. */
static int count_ways(const settings *s) {
  return (s->runs > 0) + s->processes + s->follow + s->live;
}

static int check(const settings *s, fault *why) {
  const bool writes = s->replay != NULL || s->log != NULL;
  if (count_ways(s) > 1)
    return fault_set(why, "--runs, --live, --follow and --processes do not go together: leave out all but one");
  if (writes && s->runs > 0) return fault_set(why, "--runs plays many games: it goes without -o and --log");
  if (writes && s->follow) return fault_set(why, "--follow plays no game of its own: it goes without -o and --log");
  if (s->processes && s->strategy != STRATEGY_PLAN)
    return fault_set(why, "--strategy: robots in processes of their own have the plan alone");
  return 0;
}

int settings_parse(settings *s, int argc, char **argv, fault *why) {
  int letter;
  *s = (settings){.mine = -1, .seed = 1, .learn_limit = 10.0};
  opterr = 0;
  optind = 1;
  while ((letter = getopt_long(argc, argv, ":o:qh", longs, NULL)) != -1) {
    if (letter == '?' || letter == ':') return refuse_option(NULL, letter, argv[optind - 1], longs, why);
    if (take_plain(s, letter, optarg) || take_mark(s, letter, optarg)) continue;
    if (take_value(s, letter, optarg, why) != 0) return -1;
  }
  if (s->help || s->version) return 0;
  if (optind + 1 != argc)
    return fault_set(why, "name one mission, as demo/missions/minefield/mission.yaml; --help shows how");
  s->mission = argv[optind];
  return check(s, why);
}

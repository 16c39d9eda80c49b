#include "settings.h"

#include <errno.h>
#include <getopt.h>
#include <stdlib.h>
#include <string.h>

#include "game.h"

static int take_json(void *into, const option_record *record, const char *value, fault *why) {
  settings *s = into;
  (void)record;
  (void)why;
  s->json = true;
  s->json_path = value;
  return 0;
}

/* A number, in whatever way it is written, that is whole. */
static int take_whole(void *into, const option_record *record, const char *value, fault *why) {
  double number;
  if (option_number(&number, record->name, value, NULL, record->least, record->most, why) != 0) return -1;
  const int whole = (int)number;
  if (number != (double)whole) return fault_set(why, "--%s %s: not a whole number", record->name, value);
  memcpy((char *)into + record->at, &whole, sizeof whole);
  return 0;
}

static int take_mine(void *into, const option_record *record, const char *value, fault *why) {
  settings *s = into;
  if (strcmp(value, "none") != 0) return take_whole(into, record, value, why);
  s->mine = SETTINGS_NO_MINE;
  return 0;
}

static int take_seed(void *into, const option_record *record, const char *value, fault *why) {
  settings *s = into;
  char *end;
  errno = 0;
  s->seed = strtoull(value, &end, 10);
  if (value[0] >= '0' && value[0] <= '9' && *end == '\0' && errno == 0) return 0;
  return fault_set(why, "--%s %s: not a whole number", record->name, value);
}

#define MARK(field) .kind = OPTION_MARK, OPTION_FIELD(settings, field)
#define TEXT(field) .kind = OPTION_TEXT, OPTION_FIELD(settings, field)
#define NUMBER(field, low, high) .kind = OPTION_NUMBER, OPTION_FIELD(settings, field), .least = (low), .most = (high)
#define WHOLE(field, low, high)                                                                                        \
  .kind = OPTION_OWN, .take = take_whole, OPTION_FIELD(settings, field), .least = (low), .most = (high)
#define WORD(field, list) .kind = OPTION_WORD, OPTION_FIELD(settings, field), .words = (list)
#define OWN(taker) .kind = OPTION_OWN, .take = (taker)

static option_table records = {
    {.name = "output",
     .letter = 'o',
     .argument = "FILE.html",
     .help = "the game as a page that plays it",
     TEXT(replay)},
    {.name = "table",
     .argument = "FILE",
     .help = "run this policy table instead of learning one; it must be the mission's",
     TEXT(table)},
    {.name = "save-table", .argument = "FILE", .help = "write the table", TEXT(save)},
    {.name = "log", .argument = "FILE", .help = "all messages as an LCM log, for lcm-logplayer and others", TEXT(log)},
    {.name = "faults",
     .argument = "FILE",
     .help = "what goes wrong, when: see demo/missions/minefield/faults.yaml",
     TEXT(faults)},
    {.name = "lcm-url", .argument = "URL", .help = "default: LCM_DEFAULT_URL, or udpm on this machine", TEXT(lcm_url)},
    {.name = "key",
     .argument = "FILE",
     .help =
         "seal termination signals by this key, and believe no others: docs/security.md; of --processes and --follow",
     TEXT(key)},
    {.name = "json", .argument = "[=FILE]", .help = "print the outcome as JSON, or write it to FILE", OWN(take_json)},
    {.name = "quiet", .letter = 'q', .help = "say nothing but JSON", MARK(quiet)},
    {.name = "help", .letter = 'h', .help = "tell what there is", MARK(help)},
    {.name = "version", .help = "print it", MARK(version)},
    {.name = "clear-all",
     .help = "a find stops nobody: the mission ends when all territories are done",
     MARK(clear_all)},
    {.name = "lose-one", .help = "a robot, drawn by the seed, is lost at a random time", MARK(lose_one)},
    {.name = "no-ghost",
     .help = "leave out of the page the same game without a plan, which it shows beside",
     MARK(no_ghost)},
    {.name = "processes", .help = "a process for each robot and one for the world, over --lcm-url", MARK(processes)},
    {.name = "live", .help = "serve the viewer on this machine alone, while the game runs", MARK(live)},
    {.name = "follow",
     .help = "serve the viewer for a game on the bus: of --processes, or played by lcm-logplayer",
     MARK(follow)},
    {.name = "port", .argument = "N", .help = "the viewer's port; any free one without it", WHOLE(port, 0, 65535)},
    {.name = "robots",
     .argument = "K",
     .help = "K robots, where the mission has one start",
     WHOLE(robots, 1, DEMO_MOST_ROBOTS)},
    {.name = "mine",
     .argument = "P",
     .help = "where the mine lies: a place, or none (default: drawn by the likelihoods)",
     OWN(take_mine),
     OPTION_FIELD(settings, mine),
     .least = 0,
     .most = DEMO_MOST_PLACES - 1},
    {.name = "run-number",
     .argument = "N",
     .help = "which search by this table it is (default %s): signals of another one are ignored",
     .standard = "0",
     WHOLE(run, 0, 2147483647)},
    {.name = "runs", .argument = "N", .help = "N games with seeds from --seed on", WHOLE(runs, 1, 1000000)},
    {.name = "strategy",
     .argument = "WHAT",
     .help = "plan (default); to compare: nearest (no plan), informed (no plan, full communication), plain (a plan as "
             "if robots "
             "were alike and never tired, and sensors perfect)",
     WORD(strategy, game_strategies)},
    {.name = "seed",
     .argument = "N",
     .help = "of the mine's place, noise and losses (default %s): same seed, same game",
     .standard = "1",
     OWN(take_seed)},
    {.name = "speed",
     .argument = "X",
     .help = "X times real time (default: as fast as the machine can; 1 with --live or --processes)",
     NUMBER(speed, 0.01, 1e6)},
    {.name = "learn-limit",
     .argument = "S",
     .help = "seconds to learn at most (default %s)",
     .standard = "10",
     NUMBER(learn_limit, 0.01, 1e5)},
    {.name = NULL}};

static const char intro[] =
    "quarter-demo demo/missions/minefield/mission.yaml -o replay.html      learn, play a game, watch it in a browser\n"
    "quarter-demo MISSION -o replay.html --faults faults.yaml              with robots lost or stuck, signals lost\n"
    "quarter-demo MISSION --live                                           watch it while it runs\n"
    "quarter-demo MISSION --processes --log game.lcm                       a process a robot, over udpm\n"
    "quarter-demo MISSION --runs 1000 --json                               many games, in figures\n"
    "\n";

static const option_line lines[] = {
    OPTION_LINE("output"),     OPTION_LINE("log"),         OPTION_LINE("seed"),     OPTION_LINE("mine"),
    OPTION_LINE("clear-all"),  OPTION_LINE("faults"),      OPTION_LINE("robots"),   OPTION_LINE("table"),
    OPTION_LINE("save-table"), OPTION_LINE("learn-limit"), OPTION_LINE("speed"),    OPTION_LINE("live [port]"),
    OPTION_LINE("follow"),     OPTION_LINE("processes"),   OPTION_LINE("lcm-url"),  OPTION_LINE("run-number"),
    OPTION_LINE("key"),        OPTION_LINE("runs"),        OPTION_LINE("lose-one"), OPTION_LINE("strategy"),
    OPTION_LINE("no-ghost"),   OPTION_LINE("json"),        OPTION_LINE("quiet"),    OPTION_LINE("version"),
    {NULL, NULL, 0},
};

static const char outro[] = "\n"
                            "Exit status: 0 done; 2 bad input, or an output that cannot be written; 3 a game of "
                            "--processes was broken off, for world\n"
                            "or robots fell silent; 130 ended by Ctrl-C, replay and log whole; before the game\n"
                            "has begun at once, with nothing written.\n";

const option_set settings_options = {NULL, intro, outro, records, lines};

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

bool settings_want_ghost(const settings *s) {
  return !s->no_ghost && s->strategy == STRATEGY_PLAN;
}

int settings_parse(settings *s, int argc, char **argv, fault *why) {
  *s = (settings){.mine = SETTINGS_ANY_MINE, .seed = 1, .learn_limit = 10.0};
  if (option_parse(s, &settings_options, argc, argv, why) != 0) return -1;
  if (s->help || s->version) return 0;
  if (optind + 1 != argc)
    return fault_set(why, "name one mission, as demo/missions/minefield/mission.yaml; --help shows how");
  s->mission = argv[optind];
  return check(s, why);
}

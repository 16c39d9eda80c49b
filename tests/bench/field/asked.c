#include "field/asked.h"

#include <unistd.h>

#include "host/base/option.h"
#include "quarter/objective.h"

static const char *const tasks[] = {"write", "certified", "paper", "exact", "judge", NULL};
static const char *const rows[] = {"memory", "terms", "horizon", "paper", "plans", NULL};
static const char *const objectives[] = {"discounted", "time", NULL};

static option_table records = {
    {.name = "help", .letter = 'h', .help = "this", .kind = OPTION_MARK, OPTION_FIELD(bench_asked, help)},
    {.name = "json", .help = "print JSON", .kind = OPTION_MARK, OPTION_FIELD(bench_asked, json)},
    {.name = "clone",
     .help = "time a fresh clone up to its certified demo policy, too",
     .kind = OPTION_MARK,
     OPTION_FIELD(bench_asked, clone)},
    {.name = "takeover",
     .help = "what robots do for a lost one is worth, and nothing else",
     .kind = OPTION_MARK,
     OPTION_FIELD(bench_asked, takeover)},
    {.name = "row",
     .argument = "NAME",
     .help = "memory, terms, horizon, paper (its setting's speed: 3 minutes)\n"
             "or plans (after 1 s and 10 s against 60 s: half an hour), and\n"
             "nothing else; the last two are measured here alone",
     .kind = OPTION_WORD,
     .words = rows,
     OPTION_FIELD(bench_asked, row)},
    {.name = "certificates",
     .argument = "N",
     .help = "of so many random missions, from --seed on, against the exact\n"
             "optimum, and nothing else; 500: two minutes",
     .kind = OPTION_COUNT,
     .first = 1,
     .last = 1000000,
     OPTION_FIELD(bench_asked, certificates)},
    {.name = "instances",
     .argument = "DIR",
     .help = "learn TSPLIB files (a folder's *.tsp, or one) as problems of\n"
             "repairmen: robots start at the first town, all others are places\n"
             "of weight 1; nothing else is measured",
     .kind = OPTION_FILE,
     OPTION_FIELD(bench_asked, instances)},
    {.name = "robots",
     .argument = "K",
     .help = "that there are (default %s)",
     .standard = "1",
     .kind = OPTION_COUNT,
     .first = 1,
     .last = 64,
     OPTION_FIELD(bench_asked, family.robots)},
    {.name = "return",
     .help = "each robot's arrival back at its start counts as a place's",
     .kind = OPTION_MARK,
     OPTION_FIELD(bench_asked, comes_home)},
    {.name = "objective",
     .argument = "WHAT",
     .help = "time or discounted (default %s)",
     .standard = "time",
     .kind = OPTION_WORD,
     .words = objectives,
     OPTION_FIELD(bench_asked, family.objective)},
    {.name = "gamma",
     .argument = "G",
     .help = "a step's discount (default %s)",
     .standard = "0.999",
     .kind = OPTION_NUMBER,
     .least = 0.0,
     .most = 1.0,
     .open = true,
     OPTION_FIELD(bench_asked, family.gamma)},
    {.name = "time-limit",
     .argument = "S",
     .help = "seconds of the processor for each (default %s)",
     .standard = "10",
     .kind = OPTION_NUMBER,
     .least = 0.0,
     .most = 1e6,
     .open = true,
     OPTION_FIELD(bench_asked, time_limit)},
    {.name = "family",
     .argument = "NAME",
     .help = "a problem of a family: scatter, rooms, corridors or floor",
     .kind = OPTION_WORD,
     .words = family_names,
     OPTION_FIELD(bench_asked, family.family)},
    {.name = "task",
     .argument = "WHAT",
     .help = "with it: write (as JSON), certified, paper (learn), exact\n"
             "(solve), or judge (plans from standard input, a line of\n"
             "looks for each robot)",
     .kind = OPTION_WORD,
     .words = tasks,
     OPTION_FIELD(bench_asked, task)},
    {.name = "seed",
     .argument = "N",
     .help = "which of the family, or the first of the missions (default %s)",
     .standard = "1",
     .kind = OPTION_COUNT,
     .first = 0,
     .last = 4000000000,
     OPTION_FIELD(bench_asked, family.seed)},
    {.name = "side",
     .argument = "CELLS",
     .help = "of the ground, but of the floor (default %s)",
     .standard = "30",
     .kind = OPTION_COUNT,
     .first = 2,
     .last = 4096,
     OPTION_FIELD(bench_asked, family.side)},
    {.name = "places",
     .argument = "H",
     .help = "places in all (default %s)",
     .standard = "12",
     .kind = OPTION_COUNT,
     .first = 1,
     .last = 4096,
     OPTION_FIELD(bench_asked, family.places)},
    {.name = "looks",
     .argument = "N",
     .help = "at each; of two or more one in five misses (default %s)",
     .standard = "1",
     .kind = OPTION_COUNT,
     .first = 1,
     .last = 10,
     OPTION_FIELD(bench_asked, family.looks)},
    {.name = "classes",
     .argument = "N",
     .help = "of robots; the second is half as fast (default %s)",
     .standard = "1",
     .kind = OPTION_COUNT,
     .first = 1,
     .last = 2,
     OPTION_FIELD(bench_asked, family.classes)},
    {.name = "stretch",
     .argument = "STEPS",
     .help = "that a cell takes (default %s)",
     .standard = "1",
     .kind = OPTION_COUNT,
     .first = 1,
     .last = 1000,
     OPTION_FIELD(bench_asked, family.stretch)},
    {.name = NULL},
};

static const option_line lines[] = {
    OPTION_LINE("row"),       OPTION_LINE("certificates"), OPTION_LINE("clone"),  OPTION_LINE("takeover"),
    OPTION_LINE("instances"), OPTION_LINE("family"),       OPTION_LINE("task"),   OPTION_LINE("seed"),
    OPTION_LINE("side"),      OPTION_LINE("places"),       OPTION_LINE("looks"),  OPTION_LINE("classes"),
    OPTION_LINE("stretch"),   OPTION_LINE("robots"),       OPTION_LINE("return"), OPTION_LINE("objective"),
    OPTION_LINE("gamma"),     OPTION_LINE("time-limit"),   OPTION_LINE("json"),   {.options = NULL}};

static const option_set set = {
    NULL, "./run bench [OPTIONS]: what Quarter takes on this machine, beside what it promises\n",
    "\n./run bench --field runs it beside other solvers and has options of its own: ./run bench --field --help\n",
    records, lines};

static int check(const bench_asked *asked, fault *why) {
  const bool competes = asked->task != BENCH_NO_TASK;
  if (competes != (asked->family.family != FAMILIES)) return fault_set(why, "--family and --task go together");
  if (asked->clone + asked->takeover + (asked->instances != NULL) + competes + (asked->row != BENCH_NO_ROW) +
          (asked->certificates > 0) >
      1)
    return fault_set(why, "--row, --certificates, --clone, --takeover, --instances and --family: one at a time");
  if (asked->json && !asked->takeover && asked->instances == NULL)
    return fault_set(why, "--json goes with --takeover or --instances");
  if (asked->comes_home && (asked->instances == NULL || asked->family.objective != QTR_TIME))
    return fault_set(why, "--return goes with --instances and --objective time alone");
  return 0;
}

int bench_ask(bench_asked *asked, int argc, char **argv, fault *why) {
  *asked = (bench_asked){.time_limit = 10.0, .task = BENCH_NO_TASK, .row = BENCH_NO_ROW};
  asked->family = (family_wish){.family = FAMILIES,
                                .seed = 1,
                                .side = 30,
                                .places = 12,
                                .robots = 1,
                                .looks = 1,
                                .classes = 1,
                                .stretch = 1,
                                .objective = QTR_TIME,
                                .gamma = 0.999};
  if (option_parse(asked, &set, argc, argv, why) != 0) return -1;
  if (asked->help) return 0;
  if (optind < argc) return fault_set(why, "'%s' is no option; ./run bench --help names them", argv[optind]);
  return check(asked, why);
}

int bench_help(FILE *out) {
  return option_help(out, &set);
}

int bench_fail(const fault *why) {
  fprintf(stderr, "bench: %s\n", why->text);
  return why->status;
}

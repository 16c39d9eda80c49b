#include "field/asked.h"

#include <unistd.h>

#include "host/base/option.h"
#include "quarter/config.h"
#include "quarter/objective.h"

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
    {.name = "instances",
     .argument = "DIR",
     .help = "learn TSPLIB files (a folder's *.tsp, or one) as problems of\n"
             "repairmen: robots start at the first town, all others are places\n"
             "of weight 1; nothing else is measured",
     .kind = OPTION_FILE,
     OPTION_FIELD(bench_asked, instances)},
    {.name = "robots",
     .argument = "K",
     .help = "of these (default %s)",
     .standard = "1",
     .kind = OPTION_COUNT,
     .first = 1,
     .last = QTR_MAX_SEEKERS,
     OPTION_FIELD(bench_asked, robots)},
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
     OPTION_FIELD(bench_asked, objective)},
    {.name = "gamma",
     .argument = "G",
     .help = "a step's discount (default %s)",
     .standard = "0.999",
     .kind = OPTION_NUMBER,
     .least = 0.0,
     .most = 1.0,
     .open = true,
     OPTION_FIELD(bench_asked, gamma)},
    {.name = "time-limit",
     .argument = "S",
     .help = "seconds of the processor for each (default %s)",
     .standard = "10",
     .kind = OPTION_NUMBER,
     .least = 0.0,
     .most = 1e6,
     .open = true,
     OPTION_FIELD(bench_asked, time_limit)},
    {.name = NULL},
};

static const option_line lines[] = {OPTION_LINE("clone"),  OPTION_LINE("takeover"),   OPTION_LINE("instances"),
                                    OPTION_LINE("robots"), OPTION_LINE("return"),     OPTION_LINE("objective"),
                                    OPTION_LINE("gamma"),  OPTION_LINE("time-limit"), OPTION_LINE("json"),
                                    {.options = NULL}};

static const option_set set = {
    NULL, "./run bench [OPTIONS]: what Quarter takes on this machine, beside what it promises\n", "", records, lines};

static int check(const bench_asked *asked, fault *why) {
  if (asked->json && !asked->takeover && asked->instances == NULL)
    return fault_set(why, "--json goes with --takeover or --instances");
  if (asked->instances != NULL && (asked->clone || asked->takeover))
    return fault_set(why, "--instances goes with neither --clone nor --takeover");
  if (asked->comes_home && asked->objective != QTR_TIME)
    return fault_set(why, "--return goes with --objective time alone");
  return 0;
}

int bench_ask(bench_asked *asked, int argc, char **argv, fault *why) {
  *asked = (bench_asked){.robots = 1, .objective = QTR_TIME, .gamma = 0.999, .time_limit = 10.0};
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

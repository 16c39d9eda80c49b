/* One robot as a program of its own: a policy table, a bus, and nothing else of Quarter than the robot side. */
#include <getopt.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "bus.h"
#include "host/base/clock.h"
#include "host/base/count.h"
#include "host/base/file.h"
#include "host/base/option.h"
#include "host/base/outfile.h"
#include "host/table/table_check.h"
#include "patience.h"
#include "printing.h"
#include "quarter/names.h"
#include "quarter/status.h"
#include "wiring.h"

#define TABLE_MOST ((size_t)64 << 20) /* bytes */

typedef struct {
  const char *table, *url, *save, *key;
  uint8_t self; /* NOBODY: not said */
  uint32_t run;
  bool clear_all, help, version;
} words;

enum { NOBODY = UINT8_MAX };
_Static_assert(DEMO_MOST_ROBOTS <= NOBODY, "every robot has a number");

/* ---- the command line ---- */

static option_table records = {
    {.name = "robot",
     .argument = "N",
     .help = "which robot, from 0",
     .kind = OPTION_COUNT,
     OPTION_FIELD(words, self),
     .last = DEMO_MOST_ROBOTS - 1},
    {.name = "lcm-url",
     .argument = "URL",
     .help = "the bus (default: LCM_DEFAULT_URL, or udpm on this machine)",
     .kind = OPTION_TEXT,
     OPTION_FIELD(words, url)},
    {.name = "run-number",
     .argument = "N",
     .help = "which search by this table it is (default %s): signals of another one are ignored",
     .standard = "0",
     .kind = OPTION_COUNT,
     OPTION_FIELD(words, run),
     .last = 0x7FFFFFFE},
    {.name = "save",
     .argument = "FILE",
     .help = "keep there what must outlast a reset, and go on from it if there is one, until the search is over",
     .kind = OPTION_TEXT,
     OPTION_FIELD(words, save)},
    {.name = "key",
     .argument = "FILE",
     .help = "seal termination signals by this key, and believe no others: docs/security.md",
     .kind = OPTION_TEXT,
     OPTION_FIELD(words, key)},
    {.name = "clear-all", .help = "a find stops nobody", .kind = OPTION_MARK, OPTION_FIELD(words, clear_all)},
    {.name = "help", .letter = 'h', .help = "tell what there is", .kind = OPTION_MARK, OPTION_FIELD(words, help)},
    {.name = "version", .help = "print it", .kind = OPTION_MARK, OPTION_FIELD(words, version)},
    {.name = NULL}};

static const char intro[] =
    "quarter-robot mission.qtr --robot 0         robot 0 of the table's, on the bus that LCM_DEFAULT_URL names\n"
    "\n"
    "It hears its own pose and scan and TERMINATE, and says its own command and TERMINATE. Start quarter-world first.\n"
    "\n";

static const option_line lines[] = {{"robot", NULL, 22},   {"lcm-url", NULL, 22}, {"run-number", NULL, 22},
                                    {"save", NULL, 22},    {"key", NULL, 22},     {"clear-all", NULL, 22},
                                    {"version", NULL, 22}, {NULL, NULL, 0}};

static const char outro[] =
    "\n"
    "Exit status: 0 its search is over; 2 bad input; 3 no world on the bus, or it fell silent before the search was "
    "over.\n";

static const option_set set = {NULL, intro, outro, records, lines};

static int parse(words *w, int argc, char **argv, fault *why) {
  *w = (words){.self = NOBODY};
  if (option_parse(w, &set, argc, argv, why) != 0) return -1;
  if (w->help || w->version) return 0;
  if (optind + 1 != argc)
    return fault_set(why, "name one table and a robot, as mission.qtr --robot N; --help shows how");
  if (w->self == NOBODY) return fault_set(why, "say which robot it is: --robot N");
  w->table = argv[optind];
  return 0;
}

static volatile sig_atomic_t ended;
static qtr_policy policy;
static qtr_seeker seeker;
static robot self;

static void on_end(int number) {
  (void)number;
  ended = 1;
}

static int complain(const char *what, const char *why) {
  fprintf(stderr, "quarter-robot: %s: %s\n", what, why);
  return 2;
}

static int refuse(const fault *why) {
  fprintf(stderr, "quarter-robot: %s\n", why->text);
  return why->status;
}

/* What is asked of the program itself. */
static int tell(const words *w) {
  if (w->help)
    option_help(stdout, &set);
  else
    fputs("quarter-robot " QTR_VERSION_STRING "\n", stdout);
  return print_end("quarter-robot");
}

/* ---- what outlasts a reset ---- */

static uint8_t saved[QTR_SAVE_BYTES];
static bool unsaved; /* it could not be written, and that was said */

/* As at the start, or from the save, if that is of this robot, table and run. QTR_OK, or what qtr_seeker_init()
 * says. */
static int begin(const words *w) {
  FILE *file = w->save != NULL ? fopen(w->save, "rb") : NULL;
  const uint32_t size = file != NULL ? (uint32_t)fread(saved, 1, sizeof saved, file) : 0;
  if (file != NULL) fclose(file);
  if (qtr_seeker_restore(&seeker, &policy, w->self, saved, size) == QTR_OK && seeker.run == w->run) return QTR_OK;
  return qtr_seeker_init(&seeker, &policy, w->self, NULL, w->run);
}

/* Write it when it has changed: after each place and each signal. A robot that cannot searches on all the same. */
static void keep(const words *w) {
  uint8_t now[QTR_SAVE_BYTES];
  outfile out;
  fault why;
  if (w->save == NULL || unsaved) return;
  const int32_t size = qtr_seeker_save(&seeker, now, sizeof now);
  if (size < 0 || memcmp(now, saved, (size_t)size) == 0) return;
  memcpy(saved, now, (size_t)size);
  if (outfile_open(&out, w->save, &why) == 0) {
    fwrite(now, 1, (size_t)size, out.file);
    if (outfile_commit(&out, &why) == 0) return;
  }
  unsaved = true;
  complain("after a reset it would begin anew", why.text);
}

/* ---- the bus ---- */

/* A world ends without a word. What it leaves is a robot that has stopped, or one that is still on its way. Its save
 * goes with it: in the next search it would announce what was scanned in this one. */
static int judge(const words *w) {
  if (w->save != NULL) unlink(w->save);
  if (robot_stopped(&self)) return 0;
  fprintf(stderr,
          "quarter-robot: robot %d: its world has been silent for %.0f s, and its search is not over: look why "
          "quarter-world stopped\n",
          self.self, PATIENCE_SILENCE);
  return EXIT_BROKEN_OFF;
}

/* Until the world is over. The exit status. */
static int run(bus *b, const words *w) {
  double last = clock_seconds();
  uint64_t poses = 0;
  robot_init(&self, &policy, w->self, w->clear_all, robot_pilot_of_plan(&seeker), wiring_voice(b));
  wiring_listen(b, &self);
  while (!ended) {
    bus_wait(b, 100);
    keep(w);
    const double now = clock_seconds();
    if (self.poses != poses) last = now;
    poses = self.poses;
    if (poses == 0 && now - last > PATIENCE_GATHER) {
      complain("no world on this bus", "start quarter-world first, on the same --lcm-url");
      return EXIT_BROKEN_OFF;
    }
    if (poses > 0 && now - last > PATIENCE_SILENCE) return judge(w);
  }
  return 0;
}

/* ---- the table ---- */

/* As a host does, for a table may come from anywhere: what stands behind the robot's part must be whole, too. */
static int open_table(const void *bytes, uint32_t size) {
  static qtr_names names;
  qtr_geo geo;
  int status = qtr_policy_open(&policy, bytes, size);
  if (status == QTR_OK) status = qtr_policy_check(&policy);
  if (status != QTR_OK) return status;
  return qtr_names_read(&names, &geo, (const uint8_t *)bytes + policy.size, size - policy.size);
}

/* The bus, sealed if there is a key; nothing that was read will be written over. 0, or the exit status, with one line
 * said. */
static int open_bus(bus **b, const words *w) {
  fault why;
  if (bus_open_sealed(b, w->url, w->key, &why) != 0) return refuse(&why);
  if (w->save == NULL || !file_was_read(w->save)) return 0;
  bus_close(*b);
  return complain(w->save, "is what is read; name another file to save in");
}

/* Who was not believed: a team of mixed tables or keys finds out by this. */
static void tell_strangers(const bus *b, const words *w) {
  if (qtr_seeker_foreign(&seeker) > 0)
    fprintf(stderr, "quarter-robot: robot %d: %s of another table, other starts or another run ignored\n", w->self,
            counted(qtr_seeker_foreign(&seeker), "signal").text);
  if (bus_count(b).unsealed > 0)
    fprintf(stderr, "quarter-robot: robot %d: %s without this key's seal ignored\n", w->self,
            counted(bus_count(b).unsealed, "signal").text);
}

/* The table and the seeker. 0, or the exit status, with one line said. */
static int prepare(const words *w, file_bytes *bytes) {
  fault why;
  if (file_read(bytes, w->table, TABLE_MOST, NULL, &why) != 0) return refuse(&why);
  const int status = open_table(bytes->data, (uint32_t)bytes->size);
  if (status != QTR_OK) return complain(w->table, qtr_strerror(status));
  if (table_check(&policy, w->table, &why) != 0) return refuse(&why);
  return begin(w) == QTR_OK ? 0 : complain("--robot", "the table has no such robot");
}

int main(int argc, char **argv) {
  words w;
  file_bytes bytes;
  bus *b;
  fault why;
  if (parse(&w, argc, argv, &why) != 0) return refuse(&why);
  if (w.help || w.version) return tell(&w);
  int status = prepare(&w, &bytes);
  if (status == 0) status = open_bus(&b, &w);
  if (status != 0) return status;
  signal(SIGINT, on_end);
  signal(SIGTERM, on_end);
  status = run(b, &w);
  tell_strangers(b, &w);
  bus_close(b);
  file_free(&bytes);
  return status;
}

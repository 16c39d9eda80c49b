/* One robot as a program of its own: a policy table, a bus, and nothing else of Quarter than the robot side. */
#include <getopt.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "bus.h"
#include "host/base/clock.h"
#include "host/base/count.h"
#include "host/table/table_check.h"
#include "patience.h"
#include "printing.h"
#include "quarter/status.h"
#include "wiring.h"

#define TABLE_MOST (64u << 20)

static const char help[] =
    "quarter-robot mission.qtr --robot 0         robot 0 of the table's, on the bus that LCM_DEFAULT_URL names\n"
    "\n"
    "It hears its own pose and scan and TERMINATE, and says its own command and TERMINATE. Start quarter-world first.\n"
    "\n"
    "      --robot N       which robot, from 0\n"
    "      --lcm-url URL   the bus (default: LCM_DEFAULT_URL, or udpm on this machine)\n"
    "      --run-number N  which search by this table it is (default 0): signals of another one are ignored\n"
    "      --clear-all     a find stops nobody\n"
    "      --version       print it\n"
    "\n"
    "Exit status: 0 its search is over; 2 bad input; 3 no world on the bus, or it fell silent before the search was "
    "over.\n";

typedef struct {
  const char *table, *url;
  int self;
  long run;
  bool clear_all, version;
} words;

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

/* ---- the bus ---- */

/* A world ends without a word. What it leaves is a robot that has stopped, or one that is still on its way. */
static int judge(void) {
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
    const double now = clock_seconds();
    if (self.poses != poses) last = now;
    poses = self.poses;
    if (poses == 0 && now - last > PATIENCE_GATHER) {
      complain("no world on this bus", "start quarter-world first, on the same --lcm-url");
      return EXIT_BROKEN_OFF;
    }
    if (poses > 0 && now - last > PATIENCE_SILENCE) return judge();
  }
  return 0;
}

/* ---- the table ---- */

/* A plain file: a pipe might never end. NULL with *why set if it is none, or cannot be read. */
static void *read_whole(const char *path, uint32_t *size, const char **why) {
  struct stat about;
  *why = "cannot be read";
  if (stat(path, &about) == 0 && !S_ISREG(about.st_mode)) {
    *why = S_ISDIR(about.st_mode) ? "is a folder; name a file in it"
                                  : "is a device or pipe; save what it gives in a file and name that";
    return NULL;
  }
  FILE *file = fopen(path, "rb");
  if (file == NULL) return NULL;
  void *bytes = malloc(TABLE_MOST);
  *size = bytes != NULL ? (uint32_t)fread(bytes, 1, TABLE_MOST, file) : 0;
  fclose(file);
  return bytes;
}

/* A number below `most`; -1: it is none. */
static long number_of(const char *text, long most) {
  char *end;
  const long number = strtol(text, &end, 10);
  return end != text && *end == '\0' && number >= 0 && number < most ? number : -1;
}

/* 0: more may come; 1: something to be printed; -1: no such option. */
static int take(words *w, int letter) {
  switch (letter) {
  case 'r': w->self = (int)number_of(optarg, DEMO_MOST_ROBOTS); return 0;
  case 'n': w->run = number_of(optarg, 0x7FFFFFFF); return 0;
  case 'u': w->url = optarg; return 0;
  case 'c': w->clear_all = true; return 0;
  case 'v': w->version = true; return 1;
  default: return letter == 'h' ? 1 : -1;
  }
}

static int parse(words *w, int argc, char **argv) {
  static const struct option longs[] = {{"robot", required_argument, NULL, 'r'},
                                        {"lcm-url", required_argument, NULL, 'u'},
                                        {"run-number", required_argument, NULL, 'n'},
                                        {"clear-all", no_argument, NULL, 'c'},
                                        {"help", no_argument, NULL, 'h'},
                                        {"version", no_argument, NULL, 'v'},
                                        {NULL, 0, NULL, 0}};
  int letter;
  *w = (words){.self = -1};
  while ((letter = getopt_long(argc, argv, "h", longs, NULL)) != -1) {
    const int asked = take(w, letter);
    if (asked != 0) return asked;
  }
  w->table = optind + 1 == argc ? argv[optind] : NULL;
  return w->table != NULL && w->self >= 0 && w->run >= 0 ? 0 : -1;
}

int main(int argc, char **argv) {
  words w;
  uint32_t size = 0;
  bus *b;
  fault why;
  const int asked = parse(&w, argc, argv);
  if (asked > 0) return print_whole("quarter-robot", w.version ? "quarter-robot " QTR_VERSION_STRING "\n" : help);
  if (asked < 0) {
    fputs(help, stderr);
    return 2;
  }
  const char *unread;
  void *bytes = read_whole(w.table, &size, &unread);
  if (bytes == NULL) return complain(w.table, unread);
  int status = qtr_policy_open(&policy, bytes, size);
  if (status != QTR_OK) return complain(w.table, qtr_strerror(status));
  if (table_check(&policy, w.table, &why) != 0) {
    fprintf(stderr, "quarter-robot: %s\n", why.text);
    return 2;
  }
  status = qtr_seeker_init(&seeker, &policy, (unsigned)w.self, NULL, (uint32_t)w.run);
  if (status != QTR_OK) return complain("--robot", "the table has no such robot");
  if (bus_open(&b, w.url, &why) != 0) return complain("the bus", why.text);
  signal(SIGINT, on_end);
  signal(SIGTERM, on_end);
  status = run(b, &w);
  if (qtr_seeker_foreign(&seeker) > 0)
    fprintf(stderr, "quarter-robot: robot %d: %s of another table, other starts or another run ignored\n", w.self,
            counted(qtr_seeker_foreign(&seeker), "signal").text);
  bus_close(b);
  free(bytes);
  return status;
}

#include "launch.h"

#include <dirent.h>
#include <errno.h>
#include <libgen.h>
#include <limits.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "arena.h"
#include "bus.h"
#include "host/base/clock.h"
#include "patience.h"
#include "world.h"

#define WORDS_MOST 40
#define INHERITED 256 /* files that the launcher has open, at most: its children need none of them */

typedef struct {
  char programs[PATH_MAX]; /* the folder that they are in */
  char own[PATH_MAX];      /* the game's folder, which nobody else can write to: of the table and the saves */
  char table[PATH_MAX + 16];
  pid_t world;
  pid_t robot[DEMO_MOST_ROBOTS]; /* 0: it has ended */
  int robots;
  const settings *s;
  bus *b;                     /* by which the world says who has no power; NULL: all have */
  bool cut[DEMO_MOST_ROBOTS]; /* it has none, and so its process was ended */
  bool abandoned;             /* all robots' processes ended before the world's */
  double since;               /* when they had */
} crew;

/* ---- starting ---- */

static int find_programs(crew *c, fault *why) {
  char self[PATH_MAX];
  const ssize_t length = readlink("/proc/self/exe", self, sizeof self - 1);
  if (length < 0) return fault_set(why, "the programs beside quarter-demo cannot be found: %s", strerror(errno));
  self[length] = '\0';
  snprintf(c->programs, sizeof c->programs, "%s", dirname(self));
  return 0;
}

static int make_folder(crew *c, fault *why) {
  const char *folder = getenv("TMPDIR");
  snprintf(c->own, sizeof c->own, "%s/quarter-demo-XXXXXX", folder != NULL && folder[0] != '\0' ? folder : "/tmp");
  if (mkdtemp(c->own) == NULL) return fault_set(why, "%s: cannot be made: %s", c->own, strerror(errno));
  snprintf(c->table, sizeof c->table, "%s/table", c->own);
  return 0;
}

/* With what robots left that were killed while they wrote. */
static void remove_folder(const crew *c) {
  char path[PATH_MAX + NAME_MAX + 2];
  DIR *folder = opendir(c->own);
  for (struct dirent *entry; folder != NULL && (entry = readdir(folder)) != NULL;) {
    snprintf(path, sizeof path, "%s/%s", c->own, entry->d_name);
    unlink(path); /* not "." and "..", which are folders */
  }
  if (folder != NULL) closedir(folder);
  rmdir(c->own);
}

static int write_table(const crew *c, const plan *p, fault *why) {
  FILE *file = fopen(c->table, "wb");
  if (file == NULL) return fault_set(why, "%s: cannot be written: %s", c->table, strerror(errno));
  const size_t written = fwrite(p->t.bytes.data, 1, p->t.bytes.size, file);
  if (fclose(file) == 0 && written == p->t.bytes.size) return 0;
  return fault_set(why, "%s: cannot be written whole; is the disk full?", c->table);
}

/* Each child is a process group of its own: Ctrl-C reaches the launcher alone, which ends them in order. A signal that
 * comes before the program runs ends the child; the launcher's handler, which it has until then, would swallow it. */
static pid_t start(const crew *c, const char *program, const char *const *words) {
  char path[PATH_MAX + 32];
  sigset_t ends, before;
  snprintf(path, sizeof path, "%s/%s", c->programs, program);
  sigemptyset(&ends);
  sigaddset(&ends, SIGINT);
  sigaddset(&ends, SIGTERM);
  sigprocmask(SIG_BLOCK, &ends, &before);
  const pid_t child = fork();
  if (child == 0) {
    signal(SIGINT, SIG_DFL);
    signal(SIGTERM, SIG_DFL);
  }
  sigprocmask(SIG_SETMASK, &before, NULL);
  if (child != 0) return child;
  setpgid(0, 0);
  for (int file = 3; file < INHERITED; file++) close(file);
  execv(path, (char *const *)(uintptr_t)words);
  fprintf(stderr, "quarter: %s: %s\n", path, strerror(errno));
  _exit(127);
}

/* The words of a command line, as many as there are. */
typedef struct {
  int count;
  const char *word[WORDS_MOST];
} words;

static void add(words *w, const char *word) {
  if (w->count + 1 < WORDS_MOST) w->word[w->count++] = word;
}

static void add_pair(words *w, const char *name, const char *value) {
  if (value == NULL) return;
  add(w, name);
  add(w, value);
}

static void add_mark(words *w, const char *name, bool given) {
  if (given) add(w, name);
}

static pid_t start_world(const crew *c, const settings *s) {
  char seed[32], speed[32], mine[16], robots[16], run[16], json[PATH_MAX + 16];
  words w = {0, {NULL}};
  snprintf(seed, sizeof seed, "%llu", (unsigned long long)s->seed);
  snprintf(speed, sizeof speed, "%.17g", s->speed > 0.0 ? s->speed : 1.0);
  snprintf(mine, sizeof mine, s->mine == SETTINGS_NO_MINE ? "none" : "%d", s->mine);
  snprintf(robots, sizeof robots, "%d", s->robots);
  snprintf(run, sizeof run, "%d", s->run);
  snprintf(json, sizeof json, s->json_path != NULL ? "--json=%s" : "--json", s->json_path);
  add(&w, "quarter-world");
  add(&w, s->mission);
  add_pair(&w, "--table", c->table);
  add_pair(&w, "--seed", seed);
  add_pair(&w, "--speed", speed);
  add_pair(&w, "-o", s->replay);
  add_pair(&w, "--log", s->log);
  add_pair(&w, "--faults", s->faults);
  add_pair(&w, "--lcm-url", s->lcm_url);
  add_pair(&w, "--run-number", run);
  add_pair(&w, "--key", s->key);
  add_pair(&w, "--mine", s->mine != -1 ? mine : NULL);
  add_pair(&w, "--robots", s->robots > 0 ? robots : NULL);
  add_mark(&w, json, s->json);
  add_mark(&w, "--quiet", s->quiet);
  add_mark(&w, "--clear-all", s->clear_all);
  add_mark(&w, "--no-ghost", s->no_ghost);
  return start(c, "quarter-world", w.word);
}

static pid_t start_robot(const crew *c, int number) {
  const settings *s = c->s;
  char self[16], run[16], save[PATH_MAX + 16];
  words w = {0, {NULL}};
  snprintf(self, sizeof self, "%d", number);
  snprintf(save, sizeof save, "%s/robot%d", c->own, number);
  snprintf(run, sizeof run, "%d", s->run);
  add(&w, "quarter-robot");
  add(&w, c->table);
  add_pair(&w, "--robot", self);
  add_pair(&w, "--lcm-url", s->lcm_url);
  add_pair(&w, "--run-number", run);
  add_pair(&w, "--key", s->key);
  add_pair(&w, "--save", c->b != NULL ? save : NULL);
  add_mark(&w, "--clear-all", s->clear_all);
  return start(c, "quarter-robot", w.word);
}

/* ---- power ---- */

/* A process without power ends in whatever it is at. */
static void cut_power(crew *c, int number) {
  c->cut[number] = true;
  if (c->robot[number] <= 0) return;
  kill(c->robot[number], SIGKILL);
  waitpid(c->robot[number], NULL, 0);
  c->robot[number] = 0;
}

static void restore_power(crew *c, int number) {
  c->cut[number] = false;
  c->robot[number] = start_robot(c, number);
}

/* At each word of the world's, though several wait: power may be away for less time than the launcher looks away. Who
 * is lost without power stays so. */
static void hear_status(void *user, const message_status *m) {
  crew *c = user;
  for (int i = 0; i < c->robots && i < m->robots; i++) {
    const bool off = m->state[i] == STATE_OFF;
    if (off && !c->cut[i]) cut_power(c, i);
    if (!off && c->cut[i] && m->state[i] != STATE_LOST) restore_power(c, i);
  }
}

/* Nothing of this is needed where no power fails. */
static int open_power(crew *c, const fault_script *faults, fault *why) {
  if (faults_count(faults, FAULT_RESET) == 0) return 0;
  if (bus_open(&c->b, c->s->lcm_url, why) != 0) return -1;
  bus_hear_status(c->b, hear_status, c);
  return 0;
}

/* ---- watching and ending ---- */

static void end_robots(crew *c) {
  for (int i = 0; i < c->robots; i++)
    if (c->robot[i] > 0) kill(c->robot[i], SIGTERM);
  for (int i = 0; i < c->robots; i++)
    if (c->robot[i] > 0) waitpid(c->robot[i], NULL, 0);
}

static void note_end_of_robot(crew *c, pid_t child, int status) {
  int left = 0;
  for (int i = 0; i < c->robots; i++) {
    if (c->robot[i] == child) {
      c->robot[i] = 0;
      fprintf(stderr, "quarter-demo: robot %d's process ended (%s %d)\n", i, WIFSIGNALED(status) ? "signal" : "status",
              WIFSIGNALED(status) ? WTERMSIG(status) : WEXITSTATUS(status));
    }
    left += c->robot[i] > 0 || c->cut[i];
  }
  if (left > 0) return;
  c->abandoned = true;
  c->since = clock_seconds();
}

/* A world without robots finds that out, and ends whole. One that is stopped finds out nothing. */
static void hurry(const crew *c, double speed) {
  const double patience = ARENA_SILENCE / (speed > 0.0 ? speed : 1.0) + PATIENCE_END;
  if (c->abandoned && clock_seconds() - c->since > patience) kill(c->world, SIGKILL);
}

/* Until the world ends. Returns its wait status. Looks every now and then, for an interrupt that comes just before a
 * wait would be waited through. */
static int watch(crew *c, double speed, const volatile int *interrupted) {
  const struct timespec soon = {0, 20000000};
  bool told = false;
  for (;;) {
    int status = 0;
    if (*interrupted != 0 && !told) kill(c->world, SIGINT);
    told = *interrupted != 0;
    hurry(c, speed);
    if (c->b != NULL) bus_drain(c->b);
    const pid_t child = waitpid(-1, &status, WNOHANG);
    if (child == c->world) return status;
    if (child > 0) note_end_of_robot(c, child, status);
    if (child < 0 && errno != EINTR) return -1;
    if (child <= 0) nanosleep(&soon, NULL);
  }
}

/* The exit status that the world's wait status makes, with *why set if it is not 0. */
static int judge(const crew *c, int status, bool interrupted, fault *why) {
  const int ended = status >= 0 && WIFEXITED(status) ? WEXITSTATUS(status) : EXIT_BROKEN_OFF;
  if (ended == 0 || (interrupted && ended != EXIT_BAD_INPUT)) return 0;
  if (c->abandoned)
    fault_set(why, "the game was broken off: all robots' processes ended before the world's (see above)");
  else
    fault_set(why, "the world's process did not end well (see above)");
  return ended == EXIT_BAD_INPUT ? EXIT_BAD_INPUT : EXIT_BROKEN_OFF;
}

/* The exit status, with *why set if it is not 0. */
static int play(crew *c, const volatile int *interrupted, fault *why) {
  fflush(NULL);
  c->world = start_world(c, c->s);
  for (int i = 0; i < c->robots; i++) c->robot[i] = start_robot(c, i);
  const int status = c->world > 0 ? watch(c, c->s->speed, interrupted) : -1;
  end_robots(c);
  return judge(c, status, *interrupted != 0, why);
}

int launch(const settings *s, const plan *p, const fault_script *faults, const volatile int *interrupted, fault *why) {
  crew c = {.robots = p->t.policy.board.seekers, .s = s};
  if (find_programs(&c, why) != 0 || make_folder(&c, why) != 0) return EXIT_BAD_INPUT;
  int status = EXIT_BAD_INPUT;
  if (write_table(&c, p, why) == 0 && open_power(&c, faults, why) == 0) status = play(&c, interrupted, why);
  bus_close(c.b);
  remove_folder(&c);
  return status;
}

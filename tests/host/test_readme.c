#define _DEFAULT_SOURCE /* MAP_ANONYMOUS */
/* The robot loop of README.md, word for word, over the table that README.md has learnt: one process a robot, a step of
 * time whenever all have moved, and nothing shared but the signals. */
#include <signal.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include "host/table/table.h"
#include "quarter/robot.h"
#include "support/random.h"
#include "unity.h"

extern const uint8_t patrol[];
extern const uint32_t patrol_size;

enum { ROBOTS = 3, MOST_STEPS = 5000, INBOX = 64, NEVER = -1, NOWHERE = -1 };

/* What a robot's process and the game tell one another. */
typedef struct {
  int what; /* 'b'roadcast, 's'canned a cell, one step 't'aken; to the robot: a signal 'h'eard, 'g'o on */
  int cell;
  qtr_signal signal;
} word;

/* ---- a robot's side: what README.md leaves to the firmware ---- */

static unsigned my_number;
static int line; /* to the game */
static const uint32_t run_number = 4;
static qtr_cell here, target_at, shut_at;
static uint8_t (*memory)[QTR_SAVE_BYTES]; /* of each robot: it outlasts its process */
static const qtr_grid *ground;
static word inbox[INBOX];
static int waiting;

static void tell(int what, int cell, const qtr_signal *signal) {
  word w;
  memset(&w, 0, sizeof w);
  w.what = what;
  w.cell = cell;
  if (signal != NULL) w.signal = *signal;
  if (send(line, &w, sizeof w, MSG_NOSIGNAL) != sizeof w) _exit(3);
}

static void halt(void) {
  _exit(2);
}

static uint8_t *memory_that_lasts(void) {
  return memory[my_number];
}

static qtr_cell my_cell(void) {
  return here;
}

static void take_step(void) {
  word w;
  tell('t', 0, NULL);
  for (;;) {
    if (recv(line, &w, sizeof w, 0) != sizeof w) _exit(3);
    if (w.what == 'g') return;
    if (waiting == INBOX) _exit(4);
    inbox[waiting++] = w;
  }
}

static bool drive_to(qtr_cell cell) {
  if (cell == shut_at) return false;
  for (unsigned steps = qtr_grid_cost(ground, cell); steps > 0; steps--) take_step();
  here = cell;
  return true;
}

static bool receive(qtr_signal *signal) {
  if (waiting == 0) return false;
  *signal = inbox[0].signal;
  memmove(inbox, inbox + 1, (size_t)--waiting * sizeof *inbox);
  return true;
}

static void broadcast(const qtr_signal *signal) {
  tell('b', 0, signal);
}

static bool scan_finds_it(void) {
  tell('s', (int)here, NULL);
  return here == target_at;
}

static void live(void) {
#include "readme_loop.inc"
}

/* ---- the game ---- */

typedef struct {
  int line; /* -1: stopped or lost */
  pid_t process;
  int lost_at;  /* the step at which it breaks down; NEVER */
  int reset_at; /* the step at which its power is cut for a moment: it goes on from its start; NEVER */
  int late;     /* steps before it sets out */
  int stopped;  /* at which step; NEVER */
  word heard[INBOX];
  int count;
} robot;

static struct {
  robot robot[ROBOTS];
  int now;
  int scanned[QTR_MAX_PLACES]; /* the step of the first scan; NEVER */
  int last_scan;
} game;

static qtr_policy table_policy;
static table_route plan[QTR_MAX_SEEKERS];
static char note[160];

static void begin(void) {
  memset(&game, 0, sizeof game);
  for (int i = 0; i < ROBOTS; i++)
    game.robot[i] = (robot){.line = -1, .lost_at = NEVER, .reset_at = NEVER, .stopped = NEVER};
  memset(memory, 0, ROBOTS * sizeof *memory);
  shut_at = QTR_NO_CELL;
  for (unsigned p = 0; p < QTR_MAX_PLACES; p++) game.scanned[p] = NEVER;
}

static void set_out(int number, int found_at) {
  int pair[2];
  robot *r = &game.robot[number];
  TEST_ASSERT_EQUAL_INT(0, socketpair(AF_UNIX, SOCK_SEQPACKET, 0, pair));
  fflush(stdout);
  r->process = fork();
  TEST_ASSERT_TRUE(r->process >= 0);
  if (r->process == 0) {
    for (int i = 0; i < number; i++)
      if (game.robot[i].line >= 0) close(game.robot[i].line);
    close(pair[0]);
    line = pair[1];
    my_number = (unsigned)number;
    here = qtr_policy_cell(&table_policy, table_policy.board.places + table_policy.board.start_of[number]);
    ground = &table_policy.grid;
    target_at = found_at == NOWHERE ? QTR_NO_CELL : qtr_policy_cell(&table_policy, (unsigned)found_at);
    live();
    _exit(0);
  }
  close(pair[1]);
  r->line = pair[0];
}

static void part_with(robot *r, bool lost) {
  int status;
  if (lost) kill(r->process, SIGKILL);
  close(r->line);
  r->line = -1;
  TEST_ASSERT_EQUAL_INT(r->process, waitpid(r->process, &status, 0));
  if (lost) return;
  r->stopped = game.now;
  TEST_ASSERT_TRUE_MESSAGE(WIFEXITED(status) && WEXITSTATUS(status) == 0, note);
}

static void hear_all(const word *w, int from) {
  for (int i = 0; i < ROBOTS; i++) {
    robot *r = &game.robot[i];
    if (i == from || r->line < 0) continue;
    TEST_ASSERT_LESS_THAN_INT_MESSAGE(INBOX, r->count, note);
    r->heard[r->count] = *w;
    r->heard[r->count++].what = 'h';
  }
}

static void note_scan(int cell) {
  game.last_scan = game.now;
  for (unsigned p = 0; p < table_policy.board.places; p++)
    if ((int)qtr_policy_cell(&table_policy, p) == cell && game.scanned[p] == NEVER) game.scanned[p] = game.now;
}

/* What a robot does until it takes a step or stops. */
static void attend(int number) {
  robot *r = &game.robot[number];
  for (word w; r->line >= 0;) {
    if (recv(r->line, &w, sizeof w, 0) != sizeof w) {
      part_with(r, false);
      return;
    }
    if (w.what == 't') return;
    if (w.what == 'b') hear_all(&w, number);
    if (w.what == 's') note_scan(w.cell);
  }
}

static void let_go(robot *r) {
  word go;
  memset(&go, 0, sizeof go);
  go.what = 'g';
  for (int i = 0; i < r->count; i++) (void)!send(r->line, &r->heard[i], sizeof(word), MSG_NOSIGNAL);
  r->count = 0;
  (void)!send(r->line, &go, sizeof go, MSG_NOSIGNAL);
}

static bool is_held_up(const robot *r) {
  return game.now < r->late;
}

/* A robot's power is cut and comes back: its program begins anew, over the memory that lasts. */
static void reset(int number, int found_at) {
  robot *r = &game.robot[number];
  if (r->line < 0 || game.now != r->reset_at) return;
  part_with(r, true);
  r->count = 0;
  set_out(number, found_at);
  attend(number);
}

static void pass_a_step(int found_at) {
  for (int i = 0; i < ROBOTS; i++)
    if (game.robot[i].line >= 0 && game.now == game.robot[i].lost_at) part_with(&game.robot[i], true);
  for (int i = 0; i < ROBOTS; i++) reset(i, found_at);
  for (int i = 0; i < ROBOTS; i++)
    if (game.robot[i].line >= 0 && !is_held_up(&game.robot[i])) let_go(&game.robot[i]);
  game.now++;
  for (int i = 0; i < ROBOTS; i++)
    if (game.now > game.robot[i].late) attend(i);
}

/* Play with the target at a place, or NOWHERE, until all have stopped or are lost. */
static void play(int found_at) {
  bool any = true;
  for (int i = 0; i < ROBOTS; i++) set_out(i, found_at);
  for (int i = 0; i < ROBOTS; i++) attend(i);
  while (any) {
    TEST_ASSERT_LESS_THAN_INT_MESSAGE(MOST_STEPS, game.now, note);
    pass_a_step(found_at);
    any = false;
    for (int i = 0; i < ROBOTS; i++) any = any || game.robot[i].line >= 0;
  }
}

static void expect_all_scanned(void) {
  for (unsigned p = 0; p < table_policy.board.places; p++)
    TEST_ASSERT_NOT_EQUAL_INT_MESSAGE(NEVER, game.scanned[p], note);
}

/* ---- tests ---- */

void setUp(void) {
  snprintf(note, sizeof note, "%s", "");
  begin();
}

void tearDown(void) {
  for (int i = 0; i < ROBOTS; i++)
    if (game.robot[i].line >= 0) part_with(&game.robot[i], true);
}

static void test_all_places_are_scanned_when_the_plan_says(void) {
  play(NOWHERE);
  expect_all_scanned();
  for (int i = 0; i < ROBOTS; i++)
    for (int v = 0; v < plan[i].places; v++)
      TEST_ASSERT_EQUAL_INT((int)plan[i].step[v], game.scanned[plan[i].place[v]]);
}

static void test_a_find_ends_it_for_all(void) {
  for (int i = 0; i < ROBOTS; i++)
    for (int v = 0; v < plan[i].places; v++) {
      const int step = (int)plan[i].step[v];
      snprintf(note, sizeof note, "target at place %d", plan[i].place[v]);
      begin();
      play(plan[i].place[v]);
      TEST_ASSERT_EQUAL_INT_MESSAGE(step, game.scanned[plan[i].place[v]], note);
      TEST_ASSERT_LESS_OR_EQUAL_INT_MESSAGE(step + 1, game.last_scan, note);
      for (int r = 0; r < ROBOTS; r++) TEST_ASSERT_LESS_OR_EQUAL_INT_MESSAGE(step + 2, game.robot[r].stopped, note);
    }
}

static void test_the_places_of_a_lost_robot_are_taken_over(void) {
  for (int lost = 0; lost < ROBOTS; lost++)
    for (int step = 0; step < 40; step += 10) {
      snprintf(note, sizeof note, "robot %d lost at step %d", lost, step);
      begin();
      game.robot[lost].lost_at = step;
      play(NOWHERE);
      expect_all_scanned();
    }
}

static void test_a_late_robot_breaks_nothing(void) {
  for (int late = 0; late < ROBOTS; late++) {
    snprintf(note, sizeof note, "robot %d late", late);
    begin();
    game.robot[late].late = 30;
    play(NOWHERE);
    expect_all_scanned();
  }
}

static void test_a_robot_that_was_reset_goes_on(void) {
  for (int which = 0; which < ROBOTS; which++)
    for (int step = 0; step < 50; step += 7) {
      snprintf(note, sizeof note, "robot %d reset at step %d", which, step);
      begin();
      game.robot[which].reset_at = step;
      play(NOWHERE);
      expect_all_scanned();
    }
}

/* A door that stays shut: all else is scanned, and all stop. */
static void test_a_place_behind_a_shut_door_is_left_out(void) {
  for (unsigned shut = 0; shut < table_policy.board.places; shut += 3) {
    snprintf(note, sizeof note, "place %u is shut", shut);
    begin();
    shut_at = qtr_policy_cell(&table_policy, shut);
    play(NOWHERE);
    for (unsigned p = 0; p < table_policy.board.places; p++)
      TEST_ASSERT_EQUAL_INT_MESSAGE(p == shut, game.scanned[p] == NEVER, note);
  }
}

/* Some robot always gets through; the target is found wherever it is. */
static void test_whatever_goes_wrong_the_target_is_found(void) {
  for (unsigned i = 0; i < 60; i++) {
    test_random random = random_case("readme", i);
    const int spared = (int)random_below(&random, ROBOTS);
    const int found_at = (int)random_below(&random, table_policy.board.places);
    snprintf(note, sizeof note, "game %u, target at place %d, robot %d spared", i, found_at, spared);
    begin();
    for (int r = 0; r < ROBOTS; r++) {
      game.robot[r].late = random_chance(&random, 50) ? (int)random_below(&random, 60) : 0;
      game.robot[r].reset_at = random_chance(&random, 30) ? (int)random_below(&random, 60) : NEVER;
      if (r != spared && random_chance(&random, 60)) game.robot[r].lost_at = (int)random_below(&random, 60);
    }
    play(found_at);
    TEST_ASSERT_NOT_EQUAL_INT_MESSAGE(NEVER, game.scanned[found_at], note);
  }
}

int main(void) {
  static table learnt;
  fault why;
  UNITY_BEGIN();
  if (table_read(&learnt, "patrol.qtr", &why) != 0) return 1;
  table_routes(&learnt, plan);
  table_policy = learnt.policy;
  memory = mmap(NULL, ROBOTS * sizeof *memory, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) return 1;
  RUN_TEST(test_all_places_are_scanned_when_the_plan_says);
  RUN_TEST(test_a_find_ends_it_for_all);
  RUN_TEST(test_the_places_of_a_lost_robot_are_taken_over);
  RUN_TEST(test_a_late_robot_breaks_nothing);
  RUN_TEST(test_a_robot_that_was_reset_goes_on);
  RUN_TEST(test_a_place_behind_a_shut_door_is_left_out);
  RUN_TEST(test_whatever_goes_wrong_the_target_is_found);
  table_free(&learnt);
  return UNITY_END();
}

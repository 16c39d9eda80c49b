/* The robot loop of README.md, word for word, on a board: each robot of the mission alone, as if all others were lost,
 * and with its power cut at any step. It announces nothing that it has not scanned, and scans all. */
#include <setjmp.h>
#include <stdio.h>
#include <string.h>

#include "quarter/robot.h"
#include "unity.h"

extern const uint8_t patrol[];
extern const uint32_t patrol_size;

enum { NEVER = -1, MOST_STEPS = 2000 };

/* On the slowest boards the power fails at one step in so many. */
#ifndef POWER_STRIDE
#define POWER_STRIDE 1
#endif

/* ---- what README.md leaves to the firmware ---- */

static unsigned my_number;
static const uint32_t run_number = 4;
static struct {
  qtr_cell here;
  qtr_cell shut; /* a door that opens after some tries */
  int tries;
  int now;
  int power_fails; /* at this step; NEVER */
  qtr_places scanned;
  uint8_t memory[QTR_SAVE_BYTES];
  char note[40];
} world;
static qtr_policy known; /* to the world: a policy of its own */
static jmp_buf reset, stop;

static void halt(void) {
  longjmp(stop, 1);
}

static uint8_t *memory_that_lasts(void) {
  return world.memory;
}

static qtr_cell my_cell(void) {
  return world.here;
}

static bool drive_to(qtr_cell cell) {
  if (cell == world.shut && world.tries-- > 0) return false;
  TEST_ASSERT_GREATER_THAN_MESSAGE(0, qtr_grid_cost(&known.grid, cell), world.note);
  world.here = cell;
  TEST_ASSERT_LESS_THAN_MESSAGE(MOST_STEPS, ++world.now, world.note);
  if (world.now == world.power_fails) longjmp(reset, 1);
  return true;
}

static bool receive(qtr_signal *signal) {
  (void)signal;
  return false;
}

static void broadcast(const qtr_signal *signal) {
  qtr_division division;
  qtr_deployment home;
  qtr_deployment_home(&home, &known);
  qtr_division_begin(&division, &known, &home);
  while (qtr_division_play(&division, &known)) {}
  TEST_ASSERT_EQUAL_MESSAGE(QTR_SIGNAL_TERRITORY_DONE, signal->kind, world.note);
  for (unsigned i = 0; i < division.moves; i++)
    if (division.seeker[i] == signal->territory)
      TEST_ASSERT_TRUE_MESSAGE(qtr_places_has(&world.scanned, division.place[i]), world.note);
}

static bool scan_finds_it(void) {
  for (unsigned place = 0; place < known.board.places; place++)
    if (qtr_policy_cell(&known, place) == world.here) qtr_places_add(&world.scanned, place);
  return false;
}

static void live(void) {
#include "readme_loop.inc"
}

/* ---- the game ---- */

void setUp(void) {
  TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_policy_open(&known, patrol, patrol_size));
}

void tearDown(void) {
}

/* Returns the steps that it took. */
static int play(unsigned robot, int power_fails, unsigned shut_place) {
  static volatile int halted;
  const qtr_cell start = qtr_policy_cell(&known, (unsigned)known.board.places + known.board.start_of[robot]);
  my_number = robot;
  memset(&world, 0, sizeof world);
  world.here = start;
  world.power_fails = power_fails;
  world.shut = qtr_policy_cell(&known, shut_place);
  world.tries = shut_place < known.board.places ? 1 : 0;
  snprintf(world.note, sizeof world.note, "robot %u, power fails at %d", robot, power_fails);
  halted = 0;
  if (setjmp(stop) != 0) {
    halted = 1;
  } else {
    (void)setjmp(reset); /* the program begins anew, the world goes on */
    live();
  }
  TEST_ASSERT_EQUAL_MESSAGE(0, halted, world.note);
  for (unsigned place = 0; place < known.board.places; place++)
    TEST_ASSERT_TRUE_MESSAGE(qtr_places_has(&world.scanned, place), world.note);
  return world.now;
}

static void test_each_robot_alone_searches_all(void) {
  for (unsigned robot = 0; robot < known.board.seekers; robot++) play(robot, NEVER, QTR_STAND_DOWN);
}

static void test_the_power_fails_at_any_step(void) {
  for (unsigned robot = 0; robot < known.board.seekers; robot++) {
    const int steps = play(robot, NEVER, QTR_STAND_DOWN);
    for (int at = 1; at < steps; at += POWER_STRIDE) play(robot, at, QTR_STAND_DOWN);
  }
}

static void test_a_door_is_shut_for_a_while(void) {
  for (unsigned place = 0; place < known.board.places; place++) play(0, NEVER, place);
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_each_robot_alone_searches_all);
  RUN_TEST(test_the_power_fails_at_any_step);
  RUN_TEST(test_a_door_is_shut_for_a_while);
  return UNITY_END();
}

/* The physical world: the same for the same seed, walls that hold, ground that slows, wheels that can be stopped, and
 * rays that see what is there. */
#include <math.h>

#include "support/tables.h"
#include "world.h"

#define TURN 6.283185307179586

enum { RAYS = 24 };

static qtr_policy policy;
static ground g;
static world *w;

void setUp(void) {
  snprintf(case_note, sizeof case_note, "by hand");
}

void tearDown(void) {
  world_free(w);
  w = NULL;
}

static void use(const char *rows, uint64_t seed) {
  world_free(w);
  table_draw(rows, 0);
  table_open(&policy);
  g = ground_of(&policy);
  w = world_new(&policy, seed);
  TEST_ASSERT_NOT_NULL(w);
}

static double x_of(int robot) {
  return world_pose_of(w, robot).at.x;
}

static double apart(int a, int b) {
  const point p = world_pose_of(w, a).at, q = world_pose_of(w, b).at;
  return hypot(p.x - q.x, p.y - q.y);
}

static void step_seconds(double seconds) {
  for (int i = 0; i < (int)(seconds * 60); i++) world_step(w);
}

/* Steer for a heading, at `speed` cells a second where the ground is good. */
static void head(int robot, double heading, double speed) {
  const double off = remainder(heading - world_pose_of(w, robot).heading, TURN);
  const double ahead = fabs(off) < 0.5 ? speed : 0.0;
  world_drive(w, robot, ahead - 0.4 * off, ahead + 0.4 * off);
}

/* ---- starting ---- */

static void test_robots_stand_on_their_start_cells(void) {
  use("S1../...S/....", 1);
  TEST_ASSERT_DOUBLE_WITHIN(1e-6, 0.5, world_pose_of(w, 0).at.x);
  TEST_ASSERT_DOUBLE_WITHIN(1e-6, 2.5, world_pose_of(w, 0).at.y);
  TEST_ASSERT_DOUBLE_WITHIN(1e-6, 3.5, world_pose_of(w, 1).at.x);
  TEST_ASSERT_DOUBLE_WITHIN(1e-6, 1.5, world_pose_of(w, 1).at.y);
}

/* Nine stand in three rows of three. */
static void test_robots_that_share_a_start_do_not_overlap(void) {
  for (uint8_t crew = 2; crew <= 9; crew++) {
    table_draw("###/#S1/###", crew);
    table_open(&policy);
    world_free(w);
    w = world_new(&policy, 1);
    for (int a = 0; a < crew; a++)
      for (int b = 0; b < a; b++) TEST_ASSERT_TRUE(apart(a, b) > 2 * DEMO_RADIUS);
  }
}

/* ---- the same again ---- */

static void play_1000_steps(uint64_t seed, world_pose end[3]) {
  use("S....~~../.#..#..~1/..S..S..#", seed);
  world_slip(w, 1, 0.3);
  for (int i = 0; i < 1000; i++) {
    for (int robot = 0; robot < 3; robot++)
      world_drive(w, robot, 0.9 - 0.3 * robot, 0.5 + 0.2 * robot - (i % 200 < 20));
    world_step(w);
  }
  for (int robot = 0; robot < 3; robot++) end[robot] = world_pose_of(w, robot);
}

static void test_the_same_seed_gives_the_same_poses_bit_for_bit_and_another_seed_others(void) {
  world_pose first[3], again[3], other[3];
  play_1000_steps(7, first);
  play_1000_steps(7, again);
  play_1000_steps(8, other);
  for (int robot = 0; robot < 3; robot++) {
    TEST_ASSERT_EQUAL_MEMORY(&first[robot], &again[robot], sizeof first[robot]);
    TEST_ASSERT_TRUE(memcmp(&first[robot], &other[robot], sizeof first[robot]) != 0);
  }
}

/* ---- walls ---- */

static void assert_off_the_walls(void) {
  for (int robot = 0; robot < policy.board.seekers; robot++) {
    const point at = world_pose_of(w, robot).at;
    const qtr_cell cell = ground_cell(&g, at);
    TEST_ASSERT_TRUE_MESSAGE(cell != QTR_NO_CELL, case_note);
    TEST_ASSERT_TRUE_MESSAGE(qtr_grid_cost(&g.grid, cell) > 0, case_note);
  }
}

static void test_no_robot_gets_into_a_wall_or_off_the_map(void) {
  for (unsigned number = 0; number < 60; number++) {
    test_random random = random_case("walls hold", number);
    table_random(&random, (mission_size){8, 8, 2, 6});
    table_open(&policy);
    g = ground_of(&policy);
    world_free(w);
    w = world_new(&policy, number);
    for (int step = 0; step < 900; step++) {
      for (int robot = 0; robot < policy.board.seekers && step % 30 == 0; robot++)
        world_drive(w, robot, 5.0 * random_unit(&random) - 2.0, 5.0 * random_unit(&random) - 2.0);
      world_step(w);
      assert_off_the_walls();
    }
  }
}

/* A robot's body is 0.12 cells in radius, and the physics lets bodies into one another by a hundredth or so. */
static void test_driven_against_a_wall_it_stays_a_radius_away(void) {
  use("S...#1/....#./......", 3);
  for (int i = 0; i < 600; i++) {
    head(0, 0.0, 1.5);
    world_step(w);
  }
  TEST_ASSERT_DOUBLE_WITHIN(0.03, 4.0 - DEMO_RADIUS, x_of(0));
  TEST_ASSERT_EQUAL_INT(0, world_collisions(w));
}

static void test_robots_that_run_into_one_another_are_counted_and_do_not_pass(void) {
  use("S.....S/.1....1", 3);
  for (int i = 0; i < 400; i++) {
    head(0, 0.0, 1.0);
    head(1, TURN / 2, 1.0);
    world_step(w);
    TEST_ASSERT_TRUE(apart(0, 1) > 2 * DEMO_RADIUS - 0.03);
  }
  TEST_ASSERT_GREATER_OR_EQUAL_INT(1, world_collisions(w));
}

/* ---- wheels and ground ---- */

/* Steps of the world in which a robot comes from x = 2 to x = 6, heading east. */
static int steps_to_cross(const char *rows, double slip) {
  int steps = 0;
  use(rows, 5);
  world_slip(w, 0, slip);
  for (int i = 0; i < 6000 && x_of(0) < 6.0; i++) {
    head(0, 0.0, 1.0);
    world_step(w);
    steps += x_of(0) >= 2.0;
  }
  TEST_ASSERT_TRUE(x_of(0) >= 6.0);
  return steps;
}

static void test_four_cells_of_good_ground_take_four_seconds(void) {
  TEST_ASSERT_INT_WITHIN(24, 240, steps_to_cross("......../S......1/........", 0.0));
}

static void test_ground_of_cost_three_takes_three_times_as_long(void) {
  const double good = steps_to_cross("......../S......1/........", 0.0);
  const double slow = steps_to_cross("~~~~~~~~/S~~~~~~1/~~~~~~~~", 0.0);
  TEST_ASSERT_DOUBLE_WITHIN(0.6, 3.0, slow / good);
}

/* Slip takes up to its share, at random: half of it on average. */
static void test_slipping_wheels_are_slower_by_half_the_share(void) {
  const double good = steps_to_cross("......../S......1/........", 0.0);
  const double slipping = steps_to_cross("......../S......1/........", 0.8);
  TEST_ASSERT_DOUBLE_WITHIN(0.2, 1.0 / 0.6, slipping / good);
}

static void test_a_wheel_does_two_cells_a_second_at_most(void) {
  use("............./S...........1/.............", 5);
  double fastest = 0.0;
  for (int i = 0; i < 240; i++) {
    const double before = x_of(0);
    head(0, 0.0, 1000.0);
    world_step(w);
    fastest = fmax(fastest, (x_of(0) - before) * 60);
  }
  TEST_ASSERT_TRUE(fastest > 1.5);
  TEST_ASSERT_TRUE(fastest < 2.6);
}

static void test_stopped_wheels_stand_until_they_are_let_go(void) {
  use("......../S......1/........", 5);
  world_stop_wheels(w, 0, true);
  const world_pose before = world_pose_of(w, 0);
  world_drive(w, 0, 1.0, 0.5);
  step_seconds(5.0);
  const world_pose after = world_pose_of(w, 0);
  TEST_ASSERT_EQUAL_MEMORY(&before, &after, sizeof before);
  world_stop_wheels(w, 0, false);
  step_seconds(0.5);
  TEST_ASSERT_TRUE(hypot(world_pose_of(w, 0).at.x - before.at.x, world_pose_of(w, 0).at.y - before.at.y) > 0.1);
}

static void test_moving_wheels_that_are_stopped_come_to_rest(void) {
  use("......../S......1/........", 5);
  for (int i = 0; i < 200; i++) {
    head(0, 0.0, 1.0);
    world_step(w);
  }
  world_stop_wheels(w, 0, true);
  step_seconds(0.5);
  const double rest = x_of(0);
  step_seconds(5.0);
  TEST_ASSERT_DOUBLE_WITHIN(1e-4, rest, x_of(0));
}

static void test_wheels_at_equal_and_opposite_speeds_turn_on_the_spot(void) {
  use(".../.S1/...", 5);
  const double before = world_pose_of(w, 0).heading;
  world_drive(w, 0, -0.1, 0.1); /* a radian a second, on an axle of 0.2 */
  step_seconds(2.0);
  TEST_ASSERT_DOUBLE_WITHIN(0.2, 2.0, remainder(world_pose_of(w, 0).heading - before, TURN));
  TEST_ASSERT_DOUBLE_WITHIN(0.05, 1.5, x_of(0));
}

/* ---- rays ---- */

/* From inside a rectangle along a direction to its side. */
static double to_rectangle(point at, double direction, double left, double right, double bottom, double top) {
  const double dx = cos(direction), dy = sin(direction);
  const double x = fabs(dx) < 1e-9 ? 1e9 : ((dx > 0 ? right : left) - at.x) / dx;
  const double y = fabs(dy) < 1e-9 ? 1e9 : ((dy > 0 ? top : bottom) - at.y) / dy;
  return fmin(x, y);
}

/* To a robot's round body; 1e9 past it. */
static double to_robot(point at, double direction, point other) {
  const double x = other.x - at.x, y = other.y - at.y;
  const double along = x * cos(direction) + y * sin(direction);
  const double aside = y * cos(direction) - x * sin(direction);
  if (along <= 0.0 || fabs(aside) >= DEMO_RADIUS) return 1e9;
  return along - sqrt(DEMO_RADIUS * DEMO_RADIUS - aside * aside);
}

/* The physics works out angles to a few thousandths of a radian, which a ray that grazes a wall makes larger. */
static void assert_rays_in_a_room(double left, double right, double bottom, double top) {
  float range[RAYS];
  const world_pose self = world_pose_of(w, 0);
  world_look(w, 0, range, RAYS);
  for (int ray = 0; ray < RAYS; ray++) {
    const double expected = to_rectangle(self.at, self.heading + TURN * ray / RAYS, left, right, bottom, top);
    TEST_ASSERT_DOUBLE_WITHIN_MESSAGE(0.01, fmin(expected, DEMO_EYE_RANGE), (double)range[ray], case_note);
  }
}

static void test_rays_reach_to_the_walls(void) {
  for (unsigned seed = 0; seed < 50; seed++) {
    snprintf(case_note, sizeof case_note, "rays to walls: seed %u", seed);
    use("#####/#S1.#/#####", seed);
    assert_rays_in_a_room(0.0, 3.0, 0.0, 1.0); /* the table's grid is what robots get about in */
  }
}

/* The other robot is 2 cells away, beyond the rays' reach: it is brought nearer first. */
static void test_rays_see_another_robot(void) {
  float range[1];
  use("S.1S", 1);
  for (int i = 0; i < 600; i++) {
    head(1, TURN / 2, x_of(1) > 1.5 ? 0.6 : 0.0);
    head(0, 0.0, 0.0);
    world_step(w);
  }
  world_drive(w, 0, 0.0, 0.0);
  world_drive(w, 1, 0.0, 0.0);
  step_seconds(1.0);
  world_look(w, 0, range, 1);
  const world_pose self = world_pose_of(w, 0);
  const double expected = to_robot(self.at, self.heading, world_pose_of(w, 1).at);
  TEST_ASSERT_TRUE(expected < 1.2);
  TEST_ASSERT_DOUBLE_WITHIN(0.01, expected, (double)range[0]);
}

static void test_where_nothing_is_rays_have_their_full_reach(void) {
  float range[RAYS];
  use("...../...../..S../...../....1", 1);
  world_look(w, 0, range, RAYS);
  for (int ray = 0; ray < RAYS; ray++) TEST_ASSERT_EQUAL_FLOAT(DEMO_EYE_RANGE, range[ray]);
}

static void test_the_maps_edge_is_seen_as_a_wall(void) {
  use("S1", 1);
  assert_rays_in_a_room(0.0, 2.0, 0.0, 1.0);
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_robots_stand_on_their_start_cells);
  RUN_TEST(test_robots_that_share_a_start_do_not_overlap);
  RUN_TEST(test_the_same_seed_gives_the_same_poses_bit_for_bit_and_another_seed_others);
  RUN_TEST(test_no_robot_gets_into_a_wall_or_off_the_map);
  RUN_TEST(test_driven_against_a_wall_it_stays_a_radius_away);
  RUN_TEST(test_robots_that_run_into_one_another_are_counted_and_do_not_pass);
  RUN_TEST(test_four_cells_of_good_ground_take_four_seconds);
  RUN_TEST(test_ground_of_cost_three_takes_three_times_as_long);
  RUN_TEST(test_slipping_wheels_are_slower_by_half_the_share);
  RUN_TEST(test_a_wheel_does_two_cells_a_second_at_most);
  RUN_TEST(test_stopped_wheels_stand_until_they_are_let_go);
  RUN_TEST(test_moving_wheels_that_are_stopped_come_to_rest);
  RUN_TEST(test_wheels_at_equal_and_opposite_speeds_turn_on_the_spot);
  RUN_TEST(test_rays_reach_to_the_walls);
  RUN_TEST(test_rays_see_another_robot);
  RUN_TEST(test_where_nothing_is_rays_have_their_full_reach);
  RUN_TEST(test_the_maps_edge_is_seen_as_a_wall);
  return UNITY_END();
}

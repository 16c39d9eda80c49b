/* The driver: keeps right, goes straight where it can, drives around what stands in the way, and never just stands
 * there. */
#include <math.h>
#include <string.h>

#include "driver.h"
#include "support/missions.h"
#include "unity.h"

#define PI 3.14159265358979323846
#define REACH 1.45

enum { RAYS = 24 };

static qtr_mission mission;
static qtr_field way;
static ground g;
static float range[RAYS];

void setUp(void) {
  snprintf(case_note, sizeof case_note, "by hand");
  for (int ray = 0; ray < RAYS; ray++) range[ray] = 1.5f;
}

void tearDown(void) {
}

static void use_ground(void) {
  g = (ground){{mission.columns, mission.rows, QTR_GRID_BYTES, mission.cost}, 1.0, 0.0, 0.0, 1.0, 0.0, 0.0};
}

/* ---- where to ---- */

static void assert_aim(double x, double y, qtr_cell target, point at) {
  qtr_field_fill(&way, &g.grid, target);
  const point aim = driver_aim(&g, &way, target, at, DEMO_LANE);
  TEST_ASSERT_DOUBLE_WITHIN_MESSAGE(1e-9, x, aim.x, case_note);
  TEST_ASSERT_DOUBLE_WITHIN_MESSAGE(1e-9, y, aim.y, case_note);
}

/* From the middle of a 5x5 map; 0.25 beyond the side and 0.2 to the right of the middle line. */
static void test_aims_through_the_right_half_of_the_next_cells_side(void) {
  mission_draw(&mission, "...../...../..S../...../.....");
  use_ground();
  assert_aim(2.7, 3.25, 2, (point){2.5, 2.5});  /* north: right is east */
  assert_aim(3.25, 2.3, 14, (point){2.5, 2.5}); /* east: right is south */
  assert_aim(2.3, 1.75, 22, (point){2.5, 2.5}); /* south: right is west */
  assert_aim(1.75, 2.7, 10, (point){2.5, 2.5}); /* west: right is north */
}

static void test_where_it_stands_in_its_cell_does_not_move_the_aim(void) {
  mission_draw(&mission, "...../...../..S../...../.....");
  use_ground();
  assert_aim(3.25, 2.3, 14, (point){2.01, 2.99});
  assert_aim(3.25, 2.3, 14, (point){2.99, 2.01});
}

/* Who cannot get on tries the other side of the road. */
static void test_a_lane_below_zero_is_on_the_left(void) {
  mission_draw(&mission, "...../...../..S../...../.....");
  use_ground();
  qtr_field_fill(&way, &g.grid, 14);
  const point aim = driver_aim(&g, &way, 14, (point){2.5, 2.5}, -DEMO_LANE);
  TEST_ASSERT_DOUBLE_WITHIN(1e-9, 3.25, aim.x);
  TEST_ASSERT_DOUBLE_WITHIN(1e-9, 2.7, aim.y);
}

static void test_in_the_goals_cell_it_aims_for_the_middle(void) {
  mission_draw(&mission, "...../...../..S../...../.....");
  use_ground();
  assert_aim(2.5, 2.5, 12, (point){2.9, 2.1});
}

static void test_where_there_is_no_way_it_aims_for_the_goal_itself(void) {
  mission_draw(&mission, "..#../..#../..#..");
  use_ground();
  assert_aim(4.5, 2.5, 4, (point){0.5, 0.5});
  assert_aim(4.5, 2.5, 4, (point){-3.0, 0.5});
  assert_aim(4.5, 2.5, 4, (point){2.5, 0.5}); /* inside a wall */
}

/* On random maps: the aim lies in a free cell beside, one step nearer, to the right of the line between the middles. */
static void test_every_aim_lies_to_the_right_in_a_cell_one_step_nearer(void) {
  static long steps[QTR_MAX_CELLS];
  for (unsigned number = 0; number < 100; number++) {
    test_random random = random_case("aims", number);
    qtr_mission_default(&mission);
    random_ground(&mission, &random, &(mission_size){12, 12, 1, 1});
    for (int cell = 0; cell < mission.columns * mission.rows; cell++) mission.cost[cell] = mission.cost[cell] > 0;
    use_ground();
    const qtr_cell target = random_below(&random, (unsigned)mission.columns * mission.rows);
    if (mission.cost[target] == 0) continue;
    flood(steps, &mission, target);
    qtr_field_fill(&way, &g.grid, target);
    for (qtr_cell cell = 0; cell < (qtr_cell)(mission.columns * mission.rows); cell++) {
      if (steps[cell] <= 0) continue;
      const point at = ground_centre(&g, cell);
      const point aim = driver_aim(&g, &way, target, at, DEMO_LANE);
      const qtr_cell next = ground_cell(&g, aim);
      TEST_ASSERT_NOT_EQUAL_UINT_MESSAGE(QTR_NO_CELL, next, case_note);
      TEST_ASSERT_EQUAL_INT_MESSAGE(steps[cell] - 1, steps[next], case_note);
      const point to = ground_centre(&g, next);
      const double left = (to.x - at.x) * (aim.y - at.y) - (to.y - at.y) * (aim.x - at.x);
      TEST_ASSERT_DOUBLE_WITHIN_MESSAGE(1e-9, -DEMO_LANE, left, case_note);
    }
  }
}

/* ---- wheels ---- */

static driver_wheels steer(double heading, point aim) {
  const driver_view view = {{0.0, 0.0}, heading, RAYS, range, REACH, DRIVER_SPEED};
  return driver_steer(&view, aim);
}

/* What the rays see of a disc, from the middle of things at heading 0. */
static void see_disc(double x, double y, double radius) {
  for (int ray = 0; ray < RAYS; ray++) {
    const double angle = 2 * PI * ray / RAYS;
    const double along = x * cos(angle) + y * sin(angle);
    const double aside = fabs(y * cos(angle) - x * sin(angle));
    if (along <= 0.0 || aside >= radius) continue;
    const double reach = along - sqrt(radius * radius - aside * aside);
    if (reach < (double)range[ray]) range[ray] = (float)reach;
  }
}

static void test_where_all_is_free_it_goes_straight_at_full_speed(void) {
  for (int turn = 0; turn < 8; turn++) {
    const double heading = PI * turn / 4 - PI;
    const driver_wheels wheels = steer(heading, (point){cos(heading), sin(heading)});
    TEST_ASSERT_DOUBLE_WITHIN(1e-9, DRIVER_SPEED, wheels.left);
    TEST_ASSERT_DOUBLE_WITHIN(1e-9, DRIVER_SPEED, wheels.right);
  }
}

static void test_it_turns_towards_the_aim(void) {
  const driver_wheels left = steer(0.0, (point){1.0, 0.5});
  const driver_wheels right = steer(0.0, (point){1.0, -0.5});
  TEST_ASSERT_TRUE(left.right > left.left);
  TEST_ASSERT_TRUE(right.left > right.right);
  const driver_wheels over_the_seam =
      steer(PI - 0.1, (point){-1.0, -0.1}); /* a little to the left, past the half turn */
  TEST_ASSERT_TRUE(over_the_seam.right > over_the_seam.left);
  TEST_ASSERT_TRUE(over_the_seam.left > 0.0);
}

static void test_it_turns_on_the_spot_towards_what_is_behind(void) {
  const driver_wheels wheels = steer(0.0, (point){-1.0, -0.2});
  TEST_ASSERT_DOUBLE_WITHIN(1e-9, 0.0, wheels.left + wheels.right);
  TEST_ASSERT_TRUE(wheels.left > 0.1);
}

static void test_around_something_ahead_it_goes_to_the_right_when_both_sides_are_free(void) {
  see_disc(0.45, 0.0, 0.12);
  const driver_wheels wheels = steer(0.0, (point){1.0, 0.0});
  TEST_ASSERT_TRUE(wheels.left > wheels.right);
  TEST_ASSERT_TRUE(wheels.left + wheels.right > 0.0);
}

static void test_around_something_ahead_it_goes_to_the_left_when_the_right_is_blocked(void) {
  see_disc(0.45, 0.0, 0.12);
  for (int i = 1; i < 6; i++) see_disc(0.45, -0.2 * i, 0.12);
  const driver_wheels wheels = steer(0.0, (point){1.0, 0.0});
  TEST_ASSERT_TRUE(wheels.right > wheels.left);
}

static void test_what_lies_behind_the_aim_is_no_hindrance(void) {
  see_disc(0.6, 0.0, 0.12);
  const driver_wheels wheels = steer(0.0, (point){0.25, 0.0});
  TEST_ASSERT_DOUBLE_WITHIN(1e-9, wheels.left, wheels.right);
}

/* A thing 0.3 ahead is touched after 0.15: the body's 0.12 and 0.03 of air. Half of what it wants free: 0.12 + 0.88 /
 * 2. */
static void test_it_slows_down_by_what_is_left_before_its_body_touches(void) {
  range[0] = 0.3f;
  const driver_wheels wheels = steer(0.0, (point){0.1, 0.0});
  TEST_ASSERT_DOUBLE_WITHIN(1e-5, 0.56, (wheels.left + wheels.right) / 2);
}

static void test_where_it_is_tight_it_creeps_instead_of_stopping(void) {
  for (int ray = 0; ray < RAYS; ray++) range[ray] = 0.13f;
  const driver_wheels wheels = steer(0.0, (point){1.0, 0.0});
  const double speed = (wheels.left + wheels.right) / 2;
  TEST_ASSERT_TRUE(speed > 0.05);
  TEST_ASSERT_TRUE(speed < 0.3);
}

/* The wheels' speeds are bounded and finite whatever it sees and wherever it is. */
static void test_any_view_gives_finite_wheels(void) {
  static const double extremes[] = {0.0, 1e-300, 1.0, 1e6, 1e15, 1e300, 1.7e308};
  for (unsigned number = 0; number < 2000; number++) {
    test_random random = random_case("any view", number);
    double value[5];
    for (int i = 0; i < 5; i++) value[i] = extremes[random_below(&random, 7)] * (random_chance(&random, 50) ? 1 : -1);
    for (int ray = 0; ray < RAYS; ray++)
      range[ray] = random_chance(&random, 20) ? 0.0f : random_chance(&random, 20) ? 3e38f : (float)random_unit(&random);
    const driver_view view = {{value[0], value[1]}, value[2], RAYS, range, REACH, DRIVER_SPEED};
    const driver_wheels wheels = driver_steer(&view, (point){value[3], value[4]});
    TEST_ASSERT_TRUE_MESSAGE(fabs(wheels.left) < 2.0, case_note);
    TEST_ASSERT_TRUE_MESSAGE(fabs(wheels.right) < 2.0, case_note);
  }
}

/* ---- over time ---- */

/* A robot without noise that does as its wheels are told, past a disc as large as itself: how near it comes, from
 * middle to middle. Negative if it does not reach the aim. */
static double drive_past(double heading, point disc, point aim) {
  double x = 0.0, y = 0.0, nearest = 10.0;
  for (int tick = 0; tick < 400; tick++) {
    setUp();
    const double dx = disc.x - x, dy = disc.y - y;
    see_disc(dx * cos(heading) + dy * sin(heading), dy * cos(heading) - dx * sin(heading), DEMO_RADIUS);
    const driver_view view = {{x, y}, heading, RAYS, range, REACH, DRIVER_SPEED};
    const driver_wheels wheels = driver_steer(&view, aim);
    const double speed = (wheels.left + wheels.right) / 2;
    heading += 0.05 * (wheels.right - wheels.left) / DEMO_AXLE;
    x += 0.05 * speed * cos(heading);
    y += 0.05 * speed * sin(heading);
    nearest = fmin(nearest, hypot(disc.x - x, disc.y - y));
    if (hypot(aim.x - x, aim.y - y) < 0.1) return nearest;
  }
  return -1.0;
}

static void test_it_comes_past_another_robot_without_touching_it(void) {
  for (unsigned number = 0; number < 200; number++) {
    test_random random = random_case("past a robot", number);
    const double heading = 2 * PI * random_unit(&random) - PI;
    const point disc = {0.8 + 0.8 * random_unit(&random), 0.4 * random_unit(&random) - 0.2};
    const double nearest = drive_past(heading, disc, (point){2.5, 0.0});
    snprintf(case_note, sizeof case_note, "past a robot: seed %u, nearest %g", number, nearest);
    TEST_ASSERT_TRUE_MESSAGE(nearest > 2 * DEMO_RADIUS, case_note);
  }
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_aims_through_the_right_half_of_the_next_cells_side);
  RUN_TEST(test_where_it_stands_in_its_cell_does_not_move_the_aim);
  RUN_TEST(test_a_lane_below_zero_is_on_the_left);
  RUN_TEST(test_in_the_goals_cell_it_aims_for_the_middle);
  RUN_TEST(test_where_there_is_no_way_it_aims_for_the_goal_itself);
  RUN_TEST(test_every_aim_lies_to_the_right_in_a_cell_one_step_nearer);
  RUN_TEST(test_where_all_is_free_it_goes_straight_at_full_speed);
  RUN_TEST(test_it_turns_towards_the_aim);
  RUN_TEST(test_it_turns_on_the_spot_towards_what_is_behind);
  RUN_TEST(test_around_something_ahead_it_goes_to_the_right_when_both_sides_are_free);
  RUN_TEST(test_around_something_ahead_it_goes_to_the_left_when_the_right_is_blocked);
  RUN_TEST(test_what_lies_behind_the_aim_is_no_hindrance);
  RUN_TEST(test_it_slows_down_by_what_is_left_before_its_body_touches);
  RUN_TEST(test_where_it_is_tight_it_creeps_instead_of_stopping);
  RUN_TEST(test_any_view_gives_finite_wheels);
  RUN_TEST(test_it_comes_past_another_robot_without_touching_it);
  return UNITY_END();
}

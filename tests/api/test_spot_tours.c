/* profiles: host mcu */
/* The tour inside a spot: against all orders there are, and by hand. */
#include <math.h>
#include <string.h>

#include "quarter/spots.h"
#include "support/spot_ground.h"
#include "unity.h"

static qtr_spot_tour tour;
static qtr_spot_scratch scratch;

void setUp(void) {
}

void tearDown(void) {
}

static void discount(double gamma) {
  qtr_objective_init(&objective, &(qtr_aim){.kind = QTR_DISCOUNTED, .gamma = gamma}, NULL);
}

/* A tour measured from its order alone: its worth, that of what waits until its end, and when it ends. */
typedef struct {
  double worth, whole;
  qtr_steps finish;
} measured;

static measured measure_tour(unsigned node, const uint16_t *order, unsigned count, double rest) {
  measured m = {0.0, 0.0, 0};
  for (unsigned i = 0; i < count; i++) {
    m.finish += way_of(node, order[i]);
    node = order[i];
    m.worth += mission.weight[node] *
               (objective.kind == QTR_DISCOUNTED ? pow(objective.power[1], m.finish) : -(double)m.finish);
  }
  m.whole = m.worth + rest * (objective.kind == QTR_DISCOUNTED ? pow(objective.power[1], m.finish) : -(double)m.finish);
  return m;
}

static bool next_permutation(uint16_t *order, unsigned count) {
  unsigned i = count - 1;
  while (i > 0 && order[i - 1] >= order[i]) i--;
  if (i == 0) return false;
  unsigned j = count - 1;
  while (order[j] <= order[i - 1]) j--;
  const uint16_t swapped = order[i - 1];
  order[i - 1] = order[j];
  order[j] = swapped;
  for (unsigned a = i, b = count - 1; a < b; a++, b--) {
    const uint16_t kept = order[a];
    order[a] = order[b];
    order[b] = kept;
  }
  return true;
}

/* The best of all orders of the first `count` places that end at `exit`. */
static measured best_of_all(unsigned node, unsigned count, int exit, double rest) {
  uint16_t order[QTR_MAX_SPOT_SIZE];
  measured best = {0.0, -HUGE_VAL, 0};
  for (unsigned i = 0; i < count; i++) order[i] = (uint16_t)i;
  do {
    if (exit != QTR_SPOT_ANY_EXIT && order[count - 1] != exit) continue;
    const measured m = measure_tour(node, order, count, rest);
    const double slack = 1e-11 * fabs(best.whole);
    const bool equal = best.whole > -HUGE_VAL && fabs(m.whole - best.whole) <= slack;
    if (equal ? m.finish < best.finish : m.whole > best.whole) best = m;
  } while (next_permutation(order, count));
  return best;
}

static void expect_tour_is_whole(unsigned node, unsigned count) {
  bool seen[QTR_MAX_SPOT_SIZE] = {false};
  qtr_steps now = 0;
  TEST_ASSERT_EQUAL_UINT_MESSAGE(count, tour.places, case_note);
  for (unsigned i = 0; i < count; i++) {
    TEST_ASSERT_TRUE_MESSAGE(tour.place[i] < count && !seen[tour.place[i]], case_note);
    seen[tour.place[i]] = true;
    now += way_of(i > 0 ? tour.place[i - 1] : node, tour.place[i]);
    TEST_ASSERT_EQUAL_UINT32_MESSAGE(now, tour.step[i], case_note);
  }
  TEST_ASSERT_DOUBLE_WITHIN_MESSAGE(1e-9 * (1 + fabs(tour.worth)), measure_tour(node, tour.place, count, 0).worth,
                                    tour.worth, case_note);
}

static void expect_best(unsigned count, int exit, double rest) {
  uint16_t place[QTR_MAX_SPOT_SIZE] = {0};
  const unsigned node = ground.places;
  for (unsigned i = 0; i < count; i++) place[i] = (uint16_t)i;
  TEST_ASSERT_TRUE_MESSAGE(qtr_spot_tour_best(&tour, &ground, node, place, count, exit, rest, &scratch), case_note);
  expect_tour_is_whole(node, count);
  const measured best = best_of_all(node, count, exit, rest);
  const measured got = measure_tour(node, tour.place, count, rest);
  TEST_ASSERT_DOUBLE_WITHIN_MESSAGE(1e-9 * (1 + fabs(best.whole)), best.whole, got.whole, case_note);
  TEST_ASSERT_EQUAL_UINT32_MESSAGE(best.finish, got.finish, case_note);
  if (exit != QTR_SPOT_ANY_EXIT) TEST_ASSERT_EQUAL_INT_MESSAGE(exit, tour.place[count - 1], case_note);
}

static void test_the_best_tour_is_the_best_of_all_orders_for_every_exit(void) {
  for (unsigned number = 0; number < 120; number++) {
    test_random random = random_case("best tours", number);
    const unsigned count = random_in(&random, 1, QTR_MAX_SPOT_SIZE < 6 ? QTR_MAX_SPOT_SIZE : 6);
    scatter(&random, count, 20);
    if (random_chance(&random, 50)) discount(0.5 + 0.49 * random_unit(&random));
    const double rest = random_chance(&random, 50) ? 0.0 : random_unit(&random);
    expect_best(count, QTR_SPOT_ANY_EXIT, rest);
    for (unsigned exit = 0; exit < count; exit++) expect_best(count, (int)exit, rest);
  }
}

static void test_the_best_tour_of_the_largest_spot(void) {
  for (unsigned number = 0; number < 4; number++) {
    test_random random = random_case("largest spots", number);
    scatter(&random, QTR_MAX_SPOT_SIZE, 20);
    if (number % 2 == 1) discount(0.9);
    expect_best(QTR_MAX_SPOT_SIZE, QTR_SPOT_ANY_EXIT, 0.0);
  }
}

static void test_steps_past_the_powers_kept_are_discounted_all_the_same(void) {
  for (unsigned number = 0; number < 20; number++) {
    test_random random = random_case("long ways", number);
    scatter(&random, 4, 3 * QTR_OBJECTIVE_POWERS);
    discount(0.9998);
    expect_best(4, QTR_SPOT_ANY_EXIT, 0.0);
  }
}

static void test_nearest_first_and_best_order_by_hand(void) {
  /* from 10: places at 8 (weight 1) and 13 (weight 3); nearest goes to 8 first, 2 and 7 steps */
  const uint16_t place[2] = {0, 1};
  corridor(2, (int[]){8, 13}, (double[]){1, 3}, 10);
  TEST_ASSERT_TRUE(qtr_spot_tour_nearest(&tour, &ground, 2, place, 2));
  TEST_ASSERT_EQUAL_UINT(0, tour.place[0]);
  TEST_ASSERT_EQUAL_UINT32(7, tour.step[1]);
  TEST_ASSERT_EQUAL_DOUBLE(-23.0, tour.worth); /* 2 + 3 * 7 */
  TEST_ASSERT_TRUE(qtr_spot_tour_best(&tour, &ground, 2, place, 2, QTR_SPOT_ANY_EXIT, 0.0, &scratch));
  TEST_ASSERT_EQUAL_UINT(1, tour.place[0]);
  TEST_ASSERT_EQUAL_DOUBLE(-17.0, tour.worth); /* 3 * 3 + 8 */
  /* with 7 more waiting for the end the shorter tour is the better one: 23 + 49 against 17 + 56 */
  TEST_ASSERT_TRUE(qtr_spot_tour_best(&tour, &ground, 2, place, 2, QTR_SPOT_ANY_EXIT, 7.0, &scratch));
  TEST_ASSERT_EQUAL_UINT(0, tour.place[0]);
}

static void test_nearest_first_goes_on_from_where_it_is(void) {
  /* from 10: 12 is nearest, from there 15, then back to 7; not 7 second though it is 3 from the start */
  const uint16_t place[3] = {0, 1, 2};
  corridor(3, (int[]){7, 15, 12}, (double[]){1, 1, 1}, 10);
  TEST_ASSERT_TRUE(qtr_spot_tour_nearest(&tour, &ground, 3, place, 3));
  TEST_ASSERT_EQUAL_UINT(2, tour.place[0]);
  TEST_ASSERT_EQUAL_UINT(1, tour.place[1]);
  TEST_ASSERT_EQUAL_UINT(0, tour.place[2]);
  TEST_ASSERT_EQUAL_UINT32(13, tour.step[2]);
}

static void test_equally_near_places_are_visited_lowest_first(void) {
  const uint16_t place[2] = {1, 0};
  corridor(2, (int[]){12, 8}, (double[]){1, 1}, 10);
  TEST_ASSERT_TRUE(qtr_spot_tour_nearest(&tour, &ground, 2, place, 2));
  TEST_ASSERT_EQUAL_UINT(0, tour.place[0]);
}

static void test_a_tour_may_take_what_is_left_of_a_spot(void) {
  const uint16_t place[2] = {3, 1};
  corridor(4, (int[]){1, 2, 3, 4}, (double[]){1, 1, 1, 1}, 0);
  TEST_ASSERT_TRUE(qtr_spot_tour_best(&tour, &ground, 4, place, 2, QTR_SPOT_ANY_EXIT, 0.0, &scratch));
  TEST_ASSERT_EQUAL_UINT(1, tour.place[0]);
  TEST_ASSERT_EQUAL_UINT(3, tour.place[1]);
  TEST_ASSERT_EQUAL_UINT32(4, tour.step[1]);
  TEST_ASSERT_TRUE(qtr_spot_tour_best(&tour, &ground, 4, place, 2, 1, 0.0, &scratch));
  TEST_ASSERT_EQUAL_UINT(1, tour.place[1]); /* exit 1 is place 1 */
}

static void test_no_tour_to_what_cannot_be_reached(void) {
  const uint16_t place[2] = {0, 1};
  corridor(2, (int[]){1, 2}, (double[]){1, 1}, 0);
  set_way(2, 0, QTR_NEVER);
  set_way(2, 1, QTR_NEVER);
  TEST_ASSERT_FALSE(qtr_spot_tour_nearest(&tour, &ground, 2, place, 2));
  TEST_ASSERT_FALSE(qtr_spot_tour_best(&tour, &ground, 2, place, 2, QTR_SPOT_ANY_EXIT, 0.0, &scratch));
  discount(0.9);
  TEST_ASSERT_FALSE(qtr_spot_tour_best(&tour, &ground, 2, place, 2, 0, 0.0, &scratch));
  qtr_objective_init(&objective, &(qtr_aim){.kind = QTR_TIME, .gamma = 0.9}, NULL);
  set_way(2, 0, 1);
  set_way(0, 1, QTR_NEVER); /* 0 can only be the last */
  TEST_ASSERT_FALSE(qtr_spot_tour_best(&tour, &ground, 2, place, 2, 1, 0.0, &scratch));
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_the_best_tour_is_the_best_of_all_orders_for_every_exit);
  RUN_TEST(test_the_best_tour_of_the_largest_spot);
  RUN_TEST(test_steps_past_the_powers_kept_are_discounted_all_the_same);
  RUN_TEST(test_nearest_first_and_best_order_by_hand);
  RUN_TEST(test_nearest_first_goes_on_from_where_it_is);
  RUN_TEST(test_equally_near_places_are_visited_lowest_first);
  RUN_TEST(test_a_tour_may_take_what_is_left_of_a_spot);
  RUN_TEST(test_no_tour_to_what_cannot_be_reached);
  return UNITY_END();
}

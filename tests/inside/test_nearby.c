/* profiles: host mcu */
/* Bounded searches: the distances of listed cells, against all-pairs distances worked out on their own. */
#include <string.h>

#include "aggregate/nearby.h"
#include "support/distances.h"
#include "unity.h"

static qtr_nearby nearby;
static uint64_t block[2 * QTR_MAX_CELLS + 5]; /* what qtr_nearby_bytes() makes of all cells, or more */

void setUp(void) {
  begin_map();
  TEST_ASSERT_LESS_OR_EQUAL(sizeof block, qtr_nearby_bytes(QTR_MAX_CELLS));
  memset(&nearby, 0xA5, sizeof nearby);
  snprintf(case_note, sizeof case_note, "%s", "");
}

void tearDown(void) {
}

static void expect_distances(int from, qtr_steps limit) {
  bool near = true;
  const bool said = qtr_nearby_measure(&nearby, (qtr_cell)from, limit);
  for (uint32_t i = 0; i < nearby.listed; i++) {
    const int distance = apart[from][nearby.list[i]];
    const bool beyond = distance > (int)limit;
    TEST_ASSERT_EQUAL_UINT32_MESSAGE(beyond ? QTR_NEVER : (qtr_steps)distance, nearby.away[i], case_note);
    near = near && !beyond;
  }
  TEST_ASSERT_EQUAL_INT_MESSAGE(near, said, case_note);
}

static void test_distances_are_those_of_the_map(void) {
  static const unsigned costs[4] = {1, 1, 4, 255};
  for (unsigned i = 0; i < 300; i++) {
    test_random random = random_case("distances", i);
    const unsigned dearest = costs[random_below(&random, 4)];
    scatter(&random, random_in(&random, 1, 14), random_in(&random, 1, 14), random_below(&random, 50), dearest);
    cost[0] = 1;
    work_out_distances();
    qtr_nearby_init(&nearby, block, &grid);
    for (int k = 0; k < 10; k++) { /* one structure for them all: a search leaves nothing behind */
      const unsigned many = random_in(&random, 0, 40);
      qtr_nearby_clear(&nearby);
      for (unsigned n = 0; n < many; n++)
        qtr_nearby_list(&nearby, (qtr_cell)free_cell[random_below(&random, (unsigned)free_count)]);
      if (nearby.listed > 3) qtr_nearby_unlist(&nearby, random_below(&random, nearby.listed));
      expect_distances(free_cell[random_below(&random, (unsigned)free_count)], random_below(&random, 20 * dearest));
    }
  }
}

/* 3 steps into each rough cell: through them 3 + 3 + 3 + 1, round by the top 8. */
static void test_the_shortest_way_counts(void) {
  draw("...../.###./.~~~.");
  qtr_nearby_init(&nearby, block, &grid);
  qtr_nearby_list(&nearby, 14);
  TEST_ASSERT_FALSE(qtr_nearby_measure(&nearby, 10, 7));
  TEST_ASSERT_EQUAL_UINT32(QTR_NEVER, nearby.away[0]);
  TEST_ASSERT_TRUE(qtr_nearby_measure(&nearby, 10, 8));
  TEST_ASSERT_EQUAL_UINT32(8, nearby.away[0]);
}

static void test_the_longer_direction_counts(void) {
  draw(".~#~."); /* 3 steps into the rough cell, 1 out of it */
  qtr_nearby_init(&nearby, block, &grid);
  qtr_nearby_list(&nearby, 1);
  TEST_ASSERT_FALSE(qtr_nearby_measure(&nearby, 0, 2));
  TEST_ASSERT_TRUE(qtr_nearby_measure(&nearby, 0, 3));
  TEST_ASSERT_EQUAL_UINT32(3, nearby.away[0]);
  qtr_nearby_clear(&nearby);
  qtr_nearby_list(&nearby, 0);
  TEST_ASSERT_TRUE(qtr_nearby_measure(&nearby, 1, 3));
  TEST_ASSERT_EQUAL_UINT32(3, nearby.away[0]);
}

static void test_a_cell_out_of_reach_is_beyond_every_limit(void) {
  draw("..#.");
  qtr_nearby_init(&nearby, block, &grid);
  qtr_nearby_list(&nearby, 3);
  qtr_nearby_list(&nearby, 0);
  TEST_ASSERT_FALSE(qtr_nearby_measure(&nearby, 1, 65535));
  TEST_ASSERT_EQUAL_UINT32(QTR_NEVER, nearby.away[0]);
  TEST_ASSERT_EQUAL_UINT32(1, nearby.away[1]);
}

static void test_listing_twice_lists_once(void) {
  draw("...");
  qtr_nearby_init(&nearby, block, &grid);
  qtr_nearby_list(&nearby, 2);
  qtr_nearby_list(&nearby, 2);
  TEST_ASSERT_EQUAL_UINT32(1, nearby.listed);
  qtr_nearby_list(&nearby, 0);
  qtr_nearby_unlist(&nearby, 0);
  TEST_ASSERT_EQUAL_UINT32(1, nearby.listed);
  TEST_ASSERT_EQUAL_UINT32(0, nearby.list[0]);
}

/* Not a step further than the furthest cell listed: in a corridor one cell after the other comes up. */
static void test_a_search_ends_with_the_last_cell_found(void) {
  draw("..............................");
  qtr_nearby_init(&nearby, block, &grid);
  qtr_nearby_list(&nearby, 4);
  qtr_nearby_measure(&nearby, 0, 65535);
  TEST_ASSERT_EQUAL_UINT64(5, nearby.work);
}

static void test_neighbours_come_in_the_order_north_east_south_west(void) {
  qtr_cell next[4];
  draw("#../.../.#.");
  qtr_nearby_init(&nearby, block, &grid);
  TEST_ASSERT_EQUAL_INT(3, qtr_nearby_neighbours(&nearby, 4, next));
  TEST_ASSERT_EQUAL_UINT32(1, next[0]);
  TEST_ASSERT_EQUAL_UINT32(5, next[1]);
  TEST_ASSERT_EQUAL_UINT32(3, next[2]);
  TEST_ASSERT_EQUAL_INT(3, qtr_nearby_neighbours(&nearby, 5, next)); /* the edge of the map is a wall */
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_distances_are_those_of_the_map);
  RUN_TEST(test_the_shortest_way_counts);
  RUN_TEST(test_the_longer_direction_counts);
  RUN_TEST(test_a_cell_out_of_reach_is_beyond_every_limit);
  RUN_TEST(test_listing_twice_lists_once);
  RUN_TEST(test_a_search_ends_with_the_last_cell_found);
  RUN_TEST(test_neighbours_come_in_the_order_north_east_south_west);
  return UNITY_END();
}

/* profiles: host mcu */
/* Shortest travel times against a slow search, and walks by next steps that take exactly as long as they should. */
#include <string.h>

#include "quarter/field.h"
#include "quarter/travel.h"
#include "support/missions.h"
#include "support/random.h"
#include "unity.h"

static qtr_mission mission;
static qtr_travel travel;
static long steps[QTR_MAX_CELLS];

void setUp(void) {
  memset(&travel, 0xA5, sizeof travel);
}

void tearDown(void) {
}

static unsigned cells(void) {
  return (unsigned)mission.columns * mission.rows;
}

static void fill(qtr_cell target) {
  const qtr_grid grid = qtr_mission_grid(&mission);
  qtr_travel_fill(&travel, &grid, target);
}

static void random_map(test_random *random, unsigned most_columns, unsigned most_rows) {
  const mission_size size = {most_columns, most_rows, 1, 1};
  do {
    qtr_mission_default(&mission);
    random_ground(&mission, random, &size);
    random_people(&mission, random, &size);
  } while (mission.places == 0);
}

/* Walk from a cell to the target and count the steps. */
static long walk(qtr_cell cell) {
  const qtr_grid grid = qtr_mission_grid(&mission);
  long taken = 0;
  for (unsigned moves = 0; travel.to_go[cell] > 0; moves++) {
    const qtr_cell next = qtr_travel_next(&travel, &grid, cell);
    TEST_ASSERT_LESS_THAN_MESSAGE(cells(), next, case_note);
    TEST_ASSERT_LESS_THAN_MESSAGE(cells(), moves, case_note);
    const unsigned apart = next > cell ? (unsigned)next - cell : (unsigned)cell - next;
    TEST_ASSERT_TRUE_MESSAGE(
        apart == mission.columns || (apart == 1 && next / mission.columns == cell / mission.columns), case_note);
    TEST_ASSERT_NOT_EQUAL_MESSAGE(0, mission.cost[next], case_note);
    taken += mission.cost[next];
    cell = next;
  }
  TEST_ASSERT_EQUAL_UINT32_MESSAGE(mission.place[0], cell, case_note);
  TEST_ASSERT_EQUAL_UINT32_MESSAGE(cell, qtr_travel_next(&travel, &grid, cell), case_note);
  return taken;
}

/* Travel times from `from`, by the slow search, against the search of every target in turn. */
static void test_travel_times_are_the_shortest(void) {
  for (unsigned number = 0; number < 150; number++) {
    test_random random = random_case("maps", number);
    random_map(&random, 14, 14);
    const qtr_cell from = mission.place[0];
    flood(steps, &mission, from);
    for (unsigned target = 0; target < cells(); target++) {
      if (mission.cost[target] == 0) continue;
      fill((qtr_cell)target);
      const qtr_steps expected = steps[target] < 0 ? QTR_NEVER : (qtr_steps)steps[target];
      TEST_ASSERT_EQUAL_UINT32_MESSAGE(expected, travel.to_go[from], case_note);
    }
  }
}

static void test_blocked_cells_are_never_reached(void) {
  for (unsigned number = 0; number < 100; number++) {
    test_random random = random_case("walls", number);
    random_map(&random, 20, 20);
    fill(mission.place[0]);
    for (unsigned cell = 0; cell < cells(); cell++)
      if (mission.cost[cell] == 0) TEST_ASSERT_EQUAL_UINT32_MESSAGE(QTR_NEVER, travel.to_go[cell], case_note);
  }
}

static void test_walks_reach_the_target_in_exactly_the_time_to_go(void) {
  for (unsigned number = 0; number < 150; number++) {
    test_random random = random_case("walks", number);
    random_map(&random, 20, 20);
    fill(mission.place[0]);
    for (unsigned cell = 0; cell < cells(); cell++)
      if (travel.to_go[cell] != QTR_NEVER)
        TEST_ASSERT_EQUAL_MESSAGE(travel.to_go[cell], walk((qtr_cell)cell), case_note);
  }
}

/* Of all next steps that keep to a shortest way, the first in the order N, E, S, W. */
static void test_ties_are_broken_north_east_south_west(void) {
  static const enum qtr_direction order[4] = {QTR_NORTH, QTR_EAST, QTR_SOUTH, QTR_WEST};
  unsigned ties = 0;
  for (unsigned number = 0; number < 60; number++) {
    test_random random = random_case("ties", number);
    random_map(&random, 12, 12);
    const qtr_grid grid = qtr_mission_grid(&mission);
    fill(mission.place[0]);
    for (unsigned cell = 0; cell < cells(); cell++) {
      if (travel.to_go[cell] == QTR_NEVER || travel.to_go[cell] == 0) continue;
      qtr_cell first = QTR_NO_CELL;
      for (int i = 3; i >= 0; i--) {
        const qtr_cell next = qtr_grid_neighbour(&grid, (qtr_cell)cell, order[i]);
        if (next == QTR_NO_CELL || travel.to_go[next] == QTR_NEVER) continue;
        if (travel.to_go[next] + mission.cost[next] != travel.to_go[cell]) continue;
        ties += first != QTR_NO_CELL;
        first = next;
      }
      TEST_ASSERT_EQUAL_UINT32_MESSAGE(first, qtr_travel_next(&travel, &grid, (qtr_cell)cell), case_note);
    }
  }
  TEST_ASSERT_GREATER_THAN(100, ties);
}

/* To the south-east corner of open ground two ways are as short: east comes before south. To the north-west one, north
 * before west. */
static void test_ties_by_hand(void) {
  mission_draw(&mission, ".../.../...");
  const qtr_grid grid = qtr_mission_grid(&mission);
  fill(8);
  TEST_ASSERT_EQUAL_UINT32(5, qtr_travel_next(&travel, &grid, 4));
  TEST_ASSERT_EQUAL_UINT32(1, qtr_travel_next(&travel, &grid, 0));
  fill(0);
  TEST_ASSERT_EQUAL_UINT32(1, qtr_travel_next(&travel, &grid, 4));
  fill(6);
  TEST_ASSERT_EQUAL_UINT32(7, qtr_travel_next(&travel, &grid, 4));
}

/* Entering costs, leaving does not: with dear ground on one side the ways there and back differ. */
static void test_terrain_makes_the_way_back_longer(void) {
  mission_draw(&mission, "..~~");
  fill(3);
  TEST_ASSERT_EQUAL_UINT32(7, travel.to_go[0]);
  fill(0);
  TEST_ASSERT_EQUAL_UINT32(5, travel.to_go[3]);
}

static void test_detour_round_dear_ground_is_taken(void) {
  mission_draw(&mission, ".~~./....");
  fill(3);
  TEST_ASSERT_EQUAL_UINT32(5, travel.to_go[0]);
  const qtr_grid grid = qtr_mission_grid(&mission);
  TEST_ASSERT_EQUAL_UINT32(4, qtr_travel_next(&travel, &grid, 0));
}

static void test_cut_off_cells_have_no_way(void) {
  mission_draw(&mission, "..#./..#.");
  const qtr_grid grid = qtr_mission_grid(&mission);
  fill(0);
  TEST_ASSERT_EQUAL_UINT32(QTR_NEVER, travel.to_go[3]);
  TEST_ASSERT_EQUAL_UINT32(QTR_NO_CELL, qtr_travel_next(&travel, &grid, 3));
}

static void test_single_cell_is_its_own_target(void) {
  mission_draw(&mission, ".");
  const qtr_grid grid = qtr_mission_grid(&mission);
  fill(0);
  TEST_ASSERT_EQUAL_UINT32(0, travel.to_go[0]);
  TEST_ASSERT_EQUAL_UINT32(0, qtr_travel_next(&travel, &grid, 0));
}

static void test_row_and_column_of_the_greatest_length_at_the_greatest_cost(void) {
  const unsigned longest = QTR_MAX_CELLS < 65535 ? QTR_MAX_CELLS : 65535;
  for (int column = 0; column < 2; column++) {
    qtr_mission_default(&mission);
    mission.columns = (uint16_t)(column ? 1 : longest);
    mission.rows = (uint16_t)(column ? longest : 1);
    memset(mission.cost, 255, longest);
    fill(0);
    TEST_ASSERT_EQUAL_UINT32(255u * (longest - 1), travel.to_go[longest - 1]);
  }
}

/* A corridor that turns at every row fills the largest map. */
static void test_largest_map_is_filled_whole(void) {
  const unsigned side = QTR_MAX_CELLS < 1024 * 1024 ? 32 : 1024;
  qtr_mission_default(&mission);
  mission.columns = mission.rows = (uint16_t)side;
  memset(mission.cost, 255, (size_t)side * side);
  for (unsigned row = 1; row < side; row += 2)
    for (unsigned column = 0; column < side; column++)
      if (column != (row % 4 == 1 ? side - 1 : 0)) mission.cost[row * side + column] = 0;
  fill(0);
  const unsigned corridor = side / 2 * side + side / 2 - 1; /* cells after the first, to the end of the last open row */
  const unsigned last_row = side - 2;
  const unsigned end = last_row % 4 == 0 ? last_row * side + side - 1 : last_row * side;
  TEST_ASSERT_EQUAL_UINT32(255u * (corridor - 1), travel.to_go[end]);
}

static void test_grid_of_bits_gives_the_times_of_a_grid_of_ones(void) {
  static uint8_t bits[(20 * 20 + 7) / 8];
  static qtr_travel other;
  for (unsigned number = 0; number < 50; number++) {
    test_random random = random_case("bits", number);
    random_map(&random, 20, 20);
    memset(bits, 0, sizeof bits);
    for (unsigned cell = 0; cell < cells(); cell++) {
      mission.cost[cell] = mission.cost[cell] > 0;
      bits[cell / 8] = (uint8_t)(bits[cell / 8] | mission.cost[cell] << cell % 8);
    }
    const qtr_grid grid = {mission.columns, mission.rows, QTR_GRID_BITS, bits};
    fill(mission.place[0]);
    qtr_travel_fill(&other, &grid, mission.place[0]);
    TEST_ASSERT_EQUAL_MEMORY_MESSAGE(travel.to_go, other.to_go, cells() * sizeof travel.to_go[0], case_note);
  }
}

/* What a robot goes by are the same steps, from the same cells. */
static void test_robots_field_gives_the_same_steps(void) {
  static qtr_field field;
  for (unsigned number = 0; number < 300; number++) {
    test_random random = random_case("fields", number);
    mission_random(&mission, &random, (mission_size){20, 16, 5, 2});
    const qtr_grid grid = qtr_mission_grid(&mission);
    for (unsigned place = 0; place < mission.places; place++) {
      TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_travel_fill(&travel, &grid, mission.place[place]));
      TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_field_fill(&field, &grid, mission.place[place]));
      for (unsigned cell = 0; cell < qtr_grid_cells(&grid); cell++)
        TEST_ASSERT_EQUAL_UINT32_MESSAGE(qtr_travel_next(&travel, &grid, (qtr_cell)cell),
                                         qtr_field_next(&field, &grid, (qtr_cell)cell), case_note);
    }
  }
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_travel_times_are_the_shortest);
  RUN_TEST(test_blocked_cells_are_never_reached);
  RUN_TEST(test_robots_field_gives_the_same_steps);
  RUN_TEST(test_walks_reach_the_target_in_exactly_the_time_to_go);
  RUN_TEST(test_ties_are_broken_north_east_south_west);
  RUN_TEST(test_ties_by_hand);
  RUN_TEST(test_terrain_makes_the_way_back_longer);
  RUN_TEST(test_detour_round_dear_ground_is_taken);
  RUN_TEST(test_cut_off_cells_have_no_way);
  RUN_TEST(test_single_cell_is_its_own_target);
  RUN_TEST(test_row_and_column_of_the_greatest_length_at_the_greatest_cost);
  RUN_TEST(test_largest_map_is_filled_whole);
  RUN_TEST(test_grid_of_bits_gives_the_times_of_a_grid_of_ones);
  return UNITY_END();
}

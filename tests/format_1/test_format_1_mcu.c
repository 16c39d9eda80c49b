/* A robot's build that is told to read tables of format 1 (QTR_READ_FORMAT_1), under the mcu sizes. */
#include <stdio.h>

#include "quarter/robot.h"
#include "unity.h"

#define GOLDEN QUARTER_SOURCE_DIR "/tests/golden/"

static uint8_t bytes[8192];
static qtr_policy policy;

void setUp(void) {
}

void tearDown(void) {
}

static uint32_t read_golden(const char *path) {
  FILE *file = fopen(path, "rb");
  TEST_ASSERT_NOT_NULL_MESSAGE(file, path);
  const size_t size = fread(bytes, 1, sizeof bytes, file);
  fclose(file);
  TEST_ASSERT_LESS_THAN_MESSAGE(sizeof bytes, size, path);
  return (uint32_t)size;
}

static void expect_move(qtr_joint *joint, int seeker, uint16_t choice, qtr_steps now) {
  qtr_move move;
  TEST_ASSERT_TRUE(qtr_policy_move(&policy, joint, &move));
  TEST_ASSERT_EQUAL_INT(seeker, move.seeker);
  TEST_ASSERT_EQUAL_HEX16(choice, move.choice);
  TEST_ASSERT_EQUAL_UINT32(now, joint->now);
  TEST_ASSERT_FALSE(move.off_table);
}

/* The plan of any-start.read: robot 0 goes 1@0 2@4 0@5, robot 1 goes 3@0, and is done at 1. */
static void test_a_table_of_format_1_is_opened_and_played(void) {
  qtr_joint joint;
  qtr_move move;
  TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_policy_open(&policy, bytes, read_golden(GOLDEN "any-start.qtr")));
  TEST_ASSERT_EQUAL_UINT8(1, policy.format);
  qtr_joint_start(&joint, &policy.board, NULL, NULL);
  expect_move(&joint, 0, 1, 0);
  expect_move(&joint, 1, 3, 0);
  expect_move(&joint, 1, QTR_STAND_DOWN, 1);
  expect_move(&joint, 0, 2, 4);
  expect_move(&joint, 0, 0, 5);
  TEST_ASSERT_FALSE(qtr_policy_move(&policy, &joint, &move));
  TEST_ASSERT_EQUAL_UINT16(0, joint.unvisited);
}

static void test_one_that_is_cut_is_refused(void) {
  const uint32_t size = read_golden(GOLDEN "any-start.qtr");
  for (uint32_t cut = 0; cut < size; cut++) TEST_ASSERT_NOT_EQUAL(QTR_OK, qtr_policy_open(&policy, bytes, cut));
}

static void test_one_with_a_bit_flipped_is_refused(void) {
  const uint32_t size = read_golden(GOLDEN "any-start.qtr");
  for (uint32_t bit = 0; bit < 8 * size; bit++) {
    bytes[bit / 8] ^= (uint8_t)(1u << (bit % 8));
    TEST_ASSERT_NOT_EQUAL(QTR_OK, qtr_policy_open(&policy, bytes, size));
    bytes[bit / 8] ^= (uint8_t)(1u << (bit % 8));
  }
}

static void test_one_of_more_places_than_there_is_room_for_is_refused(void) {
  TEST_ASSERT_EQUAL_INT(QTR_ERR_LIMIT, qtr_policy_open(&policy, bytes, read_golden(GOLDEN "places-31.qtr")));
}

static void test_format_2_is_read_beside_it(void) {
  TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_policy_open(&policy, bytes, read_golden(GOLDEN "2-plain.qtr")));
  TEST_ASSERT_EQUAL_UINT8(2, policy.format);
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_a_table_of_format_1_is_opened_and_played);
  RUN_TEST(test_one_that_is_cut_is_refused);
  RUN_TEST(test_one_with_a_bit_flipped_is_refused);
  RUN_TEST(test_one_of_more_places_than_there_is_room_for_is_refused);
  RUN_TEST(test_format_2_is_read_beside_it);
  return UNITY_END();
}

/* profiles: host mcu */
/* Keys with a clock, and of seekers of more than one kind; those of today's games are in test_joint.c. */
#include <string.h>

#include "quarter/joint.h"
#include "quarter/key.h"
#include "quarter/status.h"
#include "unity.h"

static qtr_key_shape shape;

void setUp(void) {
  shape = (qtr_key_shape){.places = 2, .nodes = 4, .longest = 9, .seekers = 2};
  qtr_key_measure(&shape);
}

void tearDown(void) {
}

static qtr_key make(qtr_steps clock, uint16_t one, uint16_t other) {
  qtr_joint joint;
  qtr_key key;
  memset(&joint, 0, sizeof joint);
  memset(&key, 0, sizeof key);
  joint.node[0] = one;
  joint.node[1] = other;
  joint.now = clock;
  qtr_joint_key(&key, &joint, &shape);
  return key;
}

static bool same(qtr_key a, qtr_key b) {
  return memcmp(&a, &b, sizeof a) == 0;
}

static void test_clock_has_bits_of_its_own(void) {
  const uint16_t bits = shape.bits; /* 3 for a node, 4 for a time, of 2 seekers; 2 places */
  TEST_ASSERT_EQUAL_UINT16(16, bits);
  shape.clock = 7;
  qtr_key_measure(&shape);
  TEST_ASSERT_EQUAL_UINT16(bits + 3, shape.bits);
  for (qtr_steps clock = 0; clock <= shape.clock; clock++)
    for (qtr_steps other = 0; other <= shape.clock; other++)
      TEST_ASSERT_EQUAL(clock == other, same(make(clock, 0, 1), make(other, 0, 1)));
}

static void test_seekers_of_one_kind_are_interchangeable_and_no_others(void) {
  TEST_ASSERT_TRUE(same(make(0, 0, 1), make(0, 1, 0)));
  shape.kind[1] = 1;
  TEST_ASSERT_FALSE(same(make(0, 0, 1), make(0, 1, 0)));
}

/* Who is who is not in the key, so neither may it say who chooses first. */
static void test_at_one_node_the_lower_kind_chooses_first(void) {
  static const uint8_t steps[4 * 3] = {0, 0, 0, 0, 3, 0, 0, 0, 3, 0, 0, 0};
  qtr_board board = {.places = 1, .starts = 1, .seekers = 2, .rule = QTR_RULE_FREE, .step_bytes = 4, .steps = steps};
  qtr_joint joint;
  TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_board_init(&board));
  qtr_joint_start(&joint, &board, NULL, NULL);
  TEST_ASSERT_EQUAL_INT(0, qtr_joint_chooser(&joint, &board));
  board.keys.kind[0] = 1;
  TEST_ASSERT_EQUAL_INT(1, qtr_joint_chooser(&joint, &board));
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_clock_has_bits_of_its_own);
  RUN_TEST(test_seekers_of_one_kind_are_interchangeable_and_no_others);
  RUN_TEST(test_at_one_node_the_lower_kind_chooses_first);
  return UNITY_END();
}

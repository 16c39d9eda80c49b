/* profiles: host mcu */
/* The policy table as a robot opens it: damaged, forged or foreign tables are refused, and what is accepted can be
 * played to its end whatever it says. */
#include <string.h>

#include "quarter/claim.h"
#include "quarter/seeker.h"
#include "support/forging.h"

static qtr_policy policy;
static uint8_t copy[TABLE_MOST];

static qtr_field table_field;

void setUp(void) {
  snprintf(case_note, sizeof case_note, "by hand");
}

void tearDown(void) {
}

/* Two seekers, four places, terrain, two starts: every section is there. */
static void make_table(void) {
  table_draw("1..S..2/.#~..1./3.....S", 0);
  table_open(&policy);
  memcpy(copy, table_bytes, table_size);
}

static int open_copy(void) {
  return table_open_checked(&policy, copy, table_size);
}

/* ---- damage ---- */

static void test_every_truncation_is_refused(void) {
  make_table();
  for (uint32_t size = 0; size < table_size; size++) {
    /* At the end of the array, so that a read beyond `size` is one beyond the array. */
    uint8_t *end = copy + sizeof copy - size;
    memcpy(end, table_bytes, size);
    TEST_ASSERT_EQUAL_INT(QTR_ERR_TRUNCATED, qtr_policy_open(&policy, end, size));
  }
}

/* Names may stand there, for people. */
static void test_bytes_after_the_robots_part_are_not_looked_at(void) {
  make_table();
  for (uint32_t more = 1; more < 10; more++) {
    memset(copy + table_size, 0xA5, more);
    TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_policy_open(&policy, copy, table_size + more));
    TEST_ASSERT_EQUAL_UINT32(table_size, policy.size);
  }
}

static bool is_expected_of_flip(uint32_t byte, int status) {
  if (byte < QTR_POLICY_VERSION) return status == QTR_ERR_MAGIC;
  if (byte < QTR_POLICY_HEADER) return status == QTR_ERR_FORMAT;
  if (byte < QTR_POLICY_SIZE) return status == QTR_ERR_CORRUPT;
  if (byte < QTR_POLICY_CRC)
    return status == QTR_ERR_TRUNCATED || status == QTR_ERR_CORRUPT || status == QTR_ERR_CHECKSUM;
  return status == QTR_ERR_CHECKSUM;
}

static void test_every_single_bit_flip_is_refused(void) {
  make_table();
  for (uint32_t bit = 0; bit < 8 * table_size; bit++) {
    copy[bit / 8] = (uint8_t)(copy[bit / 8] ^ 1u << bit % 8);
    TEST_ASSERT_TRUE(is_expected_of_flip(bit / 8, open_copy()));
    copy[bit / 8] = (uint8_t)(copy[bit / 8] ^ 1u << bit % 8);
  }
  TEST_ASSERT_EQUAL_INT(QTR_OK, open_copy());
}

static void test_empty_erased_and_zeroed_flash_are_refused(void) {
  memset(copy, 0, sizeof copy);
  TEST_ASSERT_EQUAL_INT(QTR_ERR_TRUNCATED, qtr_policy_open(&policy, copy, 0));
  TEST_ASSERT_EQUAL_INT(QTR_ERR_MAGIC, qtr_policy_open(&policy, copy, 1000));
  memset(copy, 0xFF, sizeof copy);
  TEST_ASSERT_EQUAL_INT(QTR_ERR_MAGIC, qtr_policy_open(&policy, copy, 1000));
}

static void test_table_is_read_at_any_address(void) {
  static uint8_t shifted[TABLE_MOST + 8];
  for (unsigned shift = 0; shift < 8; shift++) {
    uint16_t choice;
    qtr_joint joint;
    make_table();
    memcpy(shifted + shift, table_bytes, table_size);
    TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_policy_open(&policy, shifted + shift, table_size));
    qtr_joint_start(&joint, &policy.board, NULL, NULL);
    TEST_ASSERT_TRUE(qtr_policy_lookup(&policy, &joint, &choice));
    TEST_ASSERT_EQUAL_HEX16(qtr_learner_best(table_learner)->choice[0], choice);
  }
}

static void test_caller_of_another_build_is_refused(void) {
  make_table();
  TEST_ASSERT_EQUAL_INT(QTR_ERR_CONFIG, qtr_policy_open_built(&policy, copy, table_size, QTR_CONFIG_ID + 1u));
}

/* ---- tables whose checksum is right and whose content is not ---- */

static void expect_field(int status, uint32_t offset, uint32_t value, unsigned bytes) {
  memcpy(copy, table_bytes, table_size);
  if (bytes == 1) copy[offset] = (uint8_t)value;
  if (bytes == 2) qtr_store16(copy + offset, value);
  if (bytes == 4) qtr_store32(copy + offset, value);
  table_seal(copy, table_size);
  snprintf(case_note, sizeof case_note, "%u at offset %u", (unsigned)value, (unsigned)offset);
  TEST_ASSERT_EQUAL_INT_MESSAGE(status, open_copy(), case_note);
}

static void test_dimensions_of_nothing_are_refused(void) {
  make_table();
  expect_field(QTR_ERR_CORRUPT, QTR_POLICY_COLUMNS, 0, 2);
  expect_field(QTR_ERR_CORRUPT, QTR_POLICY_ROWS, 0, 2);
  expect_field(QTR_ERR_CORRUPT, QTR_POLICY_PLACES, 0, 2);
  expect_field(QTR_ERR_CORRUPT, QTR_POLICY_SEEKERS, 0, 1);
  expect_field(QTR_ERR_CORRUPT, QTR_POLICY_STARTS, 0, 2);
}

static void test_values_out_of_their_range_are_refused(void) {
  make_table();
  expect_field(QTR_ERR_CORRUPT, QTR_POLICY_STARTS, 0x8000, 2);
  expect_field(QTR_ERR_CORRUPT, QTR_POLICY_ANY_START, 2, 1);
  expect_field(QTR_ERR_CORRUPT, QTR_POLICY_RULE, 2, 1);
  expect_field(QTR_ERR_CORRUPT, QTR_POLICY_GRID, 2, 1);
  expect_field(QTR_ERR_CORRUPT, QTR_POLICY_ORIGIN_X + 4, 0x7FFFFFFF, 4);
  expect_field(QTR_ERR_CORRUPT, QTR_POLICY_ORIGIN_Y + 4, 0x80000000, 4);
  expect_field(QTR_ERR_CORRUPT, QTR_POLICY_HEADER_BYTES + 1, 2, 1); /* seeker 1's start */
}

static void test_objective_that_is_none_is_refused(void) {
  make_table();
  expect_field(QTR_ERR_CORRUPT, QTR_POLICY_OBJECTIVE, 3, 1);
}

static void test_more_than_the_build_holds_is_refused(void) {
  make_table();
  expect_field(QTR_ERR_LIMIT, QTR_POLICY_PLACES, QTR_MAX_PLACES + 1, 2);
  expect_field(QTR_ERR_LIMIT, QTR_POLICY_SEEKERS, QTR_MAX_SEEKERS + 1, 1);
  memcpy(copy, table_bytes, table_size);
  qtr_store16(copy + QTR_POLICY_COLUMNS, 65535);
  qtr_store16(copy + QTR_POLICY_ROWS, 65535);
  table_seal(copy, table_size);
  TEST_ASSERT_EQUAL_INT(QTR_ERR_LIMIT, open_copy());
}

static void test_sizes_that_do_not_add_up_are_refused(void) {
  make_table();
  expect_field(QTR_ERR_CORRUPT, QTR_POLICY_RECORDS, policy.records + 1, 4);
  expect_field(QTR_ERR_CORRUPT, QTR_POLICY_RECORDS, 0, 4);
  expect_field(QTR_ERR_CORRUPT, QTR_POLICY_RECORDS, 0xFFFFFFFF, 4);
  expect_field(QTR_ERR_CORRUPT, QTR_POLICY_RECORDS, 0x20000000, 4); /* times 8 is 0 in 32 bits */
  expect_field(QTR_ERR_CORRUPT, QTR_POLICY_COLUMNS, 8, 2);
  expect_field(QTR_ERR_CORRUPT, QTR_POLICY_ROWS, 4, 2);
}

/* Bytes that belong to no section, though size and checksum count them. */
static void test_gap_in_the_table_is_refused(void) {
  make_table();
  for (uint32_t more = 1; more <= 16; more++) {
    memset(copy + table_size, 0, more);
    qtr_store32(copy + QTR_POLICY_SIZE, table_size + more);
    table_seal(copy, table_size + more);
    TEST_ASSERT_EQUAL_INT(QTR_ERR_CORRUPT, qtr_policy_open(&policy, copy, table_size + more));
  }
}

static uint32_t cells_at(void) {
  return QTR_POLICY_HEADER_BYTES + 4;
}

static uint32_t weights_at(void) {
  return cells_at() + 2 * 6;
}

static uint32_t travel_at(void) {
  return weights_at() + 4 * 4;
}

static uint32_t records_at(void) {
  return travel_at() + 6 * 4;
}

static void test_nodes_on_obstacles_or_off_the_map_are_refused(void) {
  make_table();
  for (unsigned node = 0; node < 6; node++) {
    expect_field(QTR_ERR_CORRUPT, cells_at() + 2 * node, 8, 2); /* the obstacle */
    expect_field(QTR_ERR_CORRUPT, cells_at() + 2 * node, 21, 2);
    expect_field(QTR_ERR_CORRUPT, cells_at() + 2 * node, 0xFFFF, 2);
  }
}

static void test_place_without_weight_is_refused(void) {
  make_table();
  for (unsigned place = 0; place < 4; place++) expect_field(QTR_ERR_CORRUPT, weights_at() + 4 * place, 0, 4);
}

static void test_choices_out_of_range_are_refused(void) {
  make_table();
  const uint32_t choice = records_at() + policy.records_shape.key_bytes;
  expect_field(QTR_ERR_CORRUPT, choice, 4, 1);
  expect_field(QTR_ERR_CORRUPT, choice, 0xFE, 1);
}

static void test_records_out_of_order_or_twice_are_refused(void) {
  make_table();
  const uint32_t bytes = policy.records_shape.bytes;
  uint8_t *first = copy + records_at();
  memcpy(first, table_bytes + records_at() + bytes, bytes);
  table_seal(copy, table_size);
  TEST_ASSERT_EQUAL_INT(QTR_ERR_CORRUPT, open_copy()); /* the second one twice */
  memcpy(first + bytes, table_bytes + records_at(), bytes);
  table_seal(copy, table_size);
  TEST_ASSERT_EQUAL_INT(QTR_ERR_CORRUPT, open_copy()); /* both, exchanged */
}

/* Of more places than there are bits in 255 bytes. */
static void test_records_of_long_keys_are_counted_whole(void) {
  const qtr_board board = {.places = 4096, .keys = {.bits = 7200, .words = 225}};
  TEST_ASSERT_EQUAL_UINT(900, record_shape_of(QTR_POLICY_FORMAT, &board).key_bytes);
  TEST_ASSERT_GREATER_THAN_UINT(900, record_shape_of(QTR_POLICY_FORMAT, &board).bytes);
}

static void test_table_of_a_build_that_plays_otherwise_is_refused(void) {
  make_table();
  expect_field(QTR_ERR_SELFTEST, QTR_POLICY_DIGEST, qtr_load32(table_bytes + QTR_POLICY_DIGEST) ^ 1, 4);
  expect_field(QTR_ERR_SELFTEST, QTR_POLICY_KEY_WORDS, policy.board.keys.words + 1, 1);
}

/* The certificate is for people: hosts check it. */
static void test_robot_plays_a_table_whose_objective_it_does_not_know_and_a_host_refuses_it(void) {
  qtr_claim claim;
  make_table();
  copy[QTR_POLICY_OBJECTIVE] = 99;
  table_seal(copy, table_size);
  TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_policy_open(&policy, copy, table_size));
  TEST_ASSERT_EQUAL_INT(QTR_ERR_CORRUPT, qtr_policy_check(&policy));
  qtr_claim_read(&claim, &policy);
  TEST_ASSERT_EQUAL_UINT8(0, claim.objective);
}

static const uint8_t *key_bytes(const qtr_key *key) {
  static uint8_t bytes[4];
  qtr_store32(bytes, key->word[0]);
  return bytes;
}

/* The start state's record says another place: the game is no longer that of the digest. */
static void test_record_that_changes_the_game_is_refused(void) {
  qtr_joint start;
  qtr_key key;
  uint32_t at = records_at();
  make_table();
  qtr_joint_start(&start, &policy.board, NULL, NULL);
  qtr_joint_key(&key, &start, &policy.board.keys);
  TEST_ASSERT_EQUAL_UINT8(1, policy.board.keys.words);
  const qtr_record_shape shape = policy.records_shape;
  while (memcmp(table_bytes + at, key_bytes(&key), shape.key_bytes) != 0) at += shape.bytes;
  const uint32_t choice = table_bytes[at + shape.key_bytes];
  for (uint32_t other = 0; other < 4; other++)
    expect_field(other == choice ? QTR_OK : QTR_ERR_SELFTEST, at + shape.key_bytes, other, 1);
}

/* ---- forged tables: whatever opens can be read and played without going out of range or on for ever ---- */

static void play_forged(unsigned self, const qtr_places *cleared) {
  qtr_seeker seeker;
  qtr_signal signal;
  const qtr_cell home = qtr_policy_cell(&policy, (unsigned)policy.board.places + policy.board.start_of[self]);
  const unsigned most = (policy.board.places + 1u) * policy.board.seekers + 2u;
  qtr_deployment deployment;
  TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_deployment_init(&deployment, &policy, NULL, cleared));
  TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_OK, qtr_seeker_init(&seeker, &policy, self, &deployment, 0), case_note);
  unsigned visits = 0;
  for (; qtr_seeker_target(&seeker) != QTR_STAND_DOWN; visits++) {
    const uint16_t target = qtr_seeker_target(&seeker);
    TEST_ASSERT_LESS_THAN_MESSAGE(policy.board.places, target, case_note);
    TEST_ASSERT_LESS_THAN_MESSAGE(most, visits, case_note);
    if (!qtr_seeker_field(&seeker, &table_field, home)) break;
    const qtr_cell next = qtr_field_next(&table_field, &policy.grid, home);
    TEST_ASSERT_TRUE_MESSAGE(next < (unsigned)policy.grid.columns * policy.grid.rows, case_note);
    qtr_seeker_visited(&seeker, qtr_seeker_target(&seeker));
    while (qtr_seeker_announce(&seeker, &signal))
      TEST_ASSERT_LESS_THAN_MESSAGE(policy.board.seekers, signal.territory, case_note);
  }
}

static void play_all_forged(test_random *random) {
  qtr_places cleared;
  for (unsigned w = 0; w < QTR_PLACE_WORDS; w++) cleared.word[w] = (uint32_t)random_bits(random);
  for (unsigned self = 0; self < policy.board.seekers; self++) {
    play_forged(self, NULL);
    play_forged(self, &cleared);
  }
}

/* Somewhere in the header's dimensions, or anywhere; a bit, a byte, or four of a telling value. */
static void mutate(test_random *random) {
  static const uint32_t telling[] = {0, 1, 0xFFFFFFFF, 0xFFFFFFFE, 0x7FFFFFFF, 0x80000000, 0x0000FFFF, 0x00010000};
  const uint32_t at = random_chance(random, 20) ? random_in(random, QTR_POLICY_COLUMNS, QTR_POLICY_DIGEST - 1)
                                                : random_in(random, QTR_POLICY_HEADER_BYTES, table_size - 4);
  const unsigned kind = random_below(random, 4);
  if (kind == 0) copy[at] = (uint8_t)(copy[at] ^ 1u << random_below(random, 8));
  if (kind == 1) copy[at] = (uint8_t)random_bits(random);
  if (kind == 2) qtr_store32(copy + at / 4 * 4, telling[random_below(random, 8)]);
  if (kind == 3) qtr_store32(copy + at / 4 * 4, random_below(random, 40));
}

static void test_forged_tables_are_refused_or_harmless(void) {
  unsigned opened = 0;
  for (unsigned number = 0; number < 14000; number++) {
    static test_random random;
    if (number % 100 == 0) {
      random = random_case("forged", number / 100);
      table_random(&random, (mission_size){8, 6, 6, 3});
    }
    memcpy(copy, table_bytes, table_size);
    for (unsigned changes = random_in(&random, 1, 4); changes > 0; changes--) mutate(&random);
    const int status = table_forge_for_robots(&policy, copy, table_size);
    TEST_ASSERT_LESS_OR_EQUAL_MESSAGE(0, status, case_note);
    if (status != QTR_OK) continue;
    opened++;
    play_all_forged(&random);
  }
  TEST_ASSERT_GREATER_THAN(600, opened);
}

/* ---- off the table ---- */

static void forget_records(void) {
  const uint32_t bytes = policy.records * policy.records_shape.bytes;
  const uint32_t at = policy.at[SECTION_RECORDS];
  memmove(copy + at, copy + at + bytes, table_size - at - bytes);
  table_size -= bytes;
  qtr_store32(copy + QTR_POLICY_SIZE, table_size);
  qtr_store32(copy + QTR_POLICY_RECORDS, 0);
  TEST_ASSERT_EQUAL_INT(QTR_OK, table_forge(&policy, copy, table_size));
}

static void expect_off_table(const char *rows, uint16_t expected) {
  qtr_joint joint;
  bool off_table = false;
  table_draw(rows, 1);
  memcpy(copy, table_bytes, table_size);
  table_open(&policy);
  forget_records();
  qtr_joint_start(&joint, &policy.board, NULL, NULL);
  TEST_ASSERT_EQUAL_HEX16_MESSAGE(expected, qtr_policy_choose(&policy, &joint, 0, &off_table), rows);
  TEST_ASSERT_TRUE(off_table);
  TEST_ASSERT_EQUAL_HEX16(expected, qtr_policy_choose(&policy, &joint, 0, NULL));
}

static void test_off_the_table_the_most_weight_for_a_step_is_chosen(void) {
  expect_off_table("1.S...3", 1);   /* 1/2 < 3/4 */
  expect_off_table("3.S...1", 0);   /* 3/2 > 1/4 */
  expect_off_table("2..S.1", 0);    /* 2/3 > 1/2 */
  expect_off_table("3.....S.1", 0); /* 3/6 = 1/2: the lower one */
  expect_off_table("1.S.....3", 0); /* 1/2 = 3/6: the lower one */
  expect_off_table("2....S.1", 1);  /* 2/5 < 1/2 */
}

static void test_off_the_table_a_place_at_no_distance_comes_first(void) {
  qtr_joint joint;
  mission_draw(&table_mission, "9S..1");
  table_mission.start[0] = table_mission.place[1];
  table_learn(100);
  table_export();
  memcpy(copy, table_bytes, table_size);
  table_open(&policy);
  forget_records();
  qtr_joint_start(&joint, &policy.board, NULL, NULL);
  TEST_ASSERT_EQUAL_HEX16(1, qtr_policy_choose(&policy, &joint, 0, NULL));
}

static void test_cleared_places_lead_off_the_table_and_are_counted(void) {
  qtr_joint joint;
  qtr_places cleared;
  uint32_t off_table = 0;
  qtr_steps now = 0;
  table_draw("1....S.2...3", 1);
  table_open(&policy);
  qtr_places_clear(&cleared);
  qtr_places_add(&cleared, 1);
  qtr_joint_start(&joint, &policy.board, NULL, &cleared);
  TEST_ASSERT_EQUAL_HEX16(2, qtr_policy_play(&policy, &joint, 0, &now, &off_table)); /* 3/6 > 1/5 */
  TEST_ASSERT_EQUAL_HEX16(0, qtr_policy_play(&policy, &joint, 0, &now, &off_table));
  TEST_ASSERT_EQUAL_UINT32(6, now);
  TEST_ASSERT_EQUAL_HEX16(QTR_STAND_DOWN, qtr_policy_play(&policy, &joint, 0, &now, &off_table));
  TEST_ASSERT_EQUAL_HEX16(QTR_STAND_DOWN, qtr_policy_play(&policy, &joint, 0, NULL, NULL));
  TEST_ASSERT_EQUAL_UINT32(1, off_table); /* the best game comes by places 1 and 2 to place 0 as well */
  TEST_ASSERT_EQUAL_UINT32(17, now);
}

static void test_states_of_the_nominal_game_are_never_off_the_table(void) {
  for (unsigned number = 0; number < 200; number++) {
    test_random random = random_case("nominal", number);
    table_random(&random, (mission_size){12, 10, 8, 4});
    table_open(&policy);
    for (int seeker = 0; seeker < policy.board.seekers; seeker++) {
      qtr_joint joint;
      uint32_t off_table = 0;
      qtr_joint_start(&joint, &policy.board, NULL, NULL);
      while (qtr_policy_play(&policy, &joint, seeker, NULL, &off_table) != QTR_STAND_DOWN) {}
      TEST_ASSERT_EQUAL_UINT32_MESSAGE(0, off_table, case_note);
    }
  }
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_every_truncation_is_refused);
  RUN_TEST(test_bytes_after_the_robots_part_are_not_looked_at);
  RUN_TEST(test_every_single_bit_flip_is_refused);
  RUN_TEST(test_empty_erased_and_zeroed_flash_are_refused);
  RUN_TEST(test_table_is_read_at_any_address);
  RUN_TEST(test_caller_of_another_build_is_refused);
  RUN_TEST(test_dimensions_of_nothing_are_refused);
  RUN_TEST(test_values_out_of_their_range_are_refused);
  RUN_TEST(test_objective_that_is_none_is_refused);
  RUN_TEST(test_more_than_the_build_holds_is_refused);
  RUN_TEST(test_sizes_that_do_not_add_up_are_refused);
  RUN_TEST(test_gap_in_the_table_is_refused);
  RUN_TEST(test_nodes_on_obstacles_or_off_the_map_are_refused);
  RUN_TEST(test_place_without_weight_is_refused);
  RUN_TEST(test_choices_out_of_range_are_refused);
  RUN_TEST(test_records_out_of_order_or_twice_are_refused);
  RUN_TEST(test_records_of_long_keys_are_counted_whole);
  RUN_TEST(test_table_of_a_build_that_plays_otherwise_is_refused);
  RUN_TEST(test_robot_plays_a_table_whose_objective_it_does_not_know_and_a_host_refuses_it);
  RUN_TEST(test_record_that_changes_the_game_is_refused);
  RUN_TEST(test_forged_tables_are_refused_or_harmless);
  RUN_TEST(test_off_the_table_the_most_weight_for_a_step_is_chosen);
  RUN_TEST(test_off_the_table_a_place_at_no_distance_comes_first);
  RUN_TEST(test_cleared_places_lead_off_the_table_and_are_counted);
  RUN_TEST(test_states_of_the_nominal_game_are_never_off_the_table);
  return UNITY_END();
}

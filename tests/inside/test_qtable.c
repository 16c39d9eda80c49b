/* profiles: host mcu */
/* The compact Q-table against a plain array, while it grows, when it is full, and how few bytes it takes. */
#include <math.h>
#include <string.h>

#include "core/bytes.h"
#include "quarter/board.h"
#include "quarter/status.h"
#include "search/qtable.h"
#include "support/random.h"
#include "unity.h"

enum { POOL = 12000, MOST_NODES = QTR_MAX_PLACES + QTR_MAX_SEEKERS };

static qtr_qtable table;
static uint32_t words[QTR_QTABLE_WORDS];
static qtr_board board;
static uint8_t steps[4 * MOST_NODES * QTR_MAX_PLACES];
static struct {
  double value;
  bool known;
} plain[POOL];
static bool precise; /* whether the table in the test holds doubles */

void setUp(void) {
  memset(plain, 0, sizeof plain);
}

void tearDown(void) {
}

/* A board whose travel times are all `longest`. */
static void set_board(unsigned places, unsigned seekers, unsigned longest) {
  memset(&board, 0, sizeof board);
  board.places = (uint16_t)places;
  board.seekers = (uint8_t)seekers;
  board.starts = 1;
  board.step_bytes = 4;
  board.steps = steps;
  for (unsigned i = 0; i < (places + 1) * places; i++) qtr_store32(steps + 4 * i, longest);
  TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_board_init(&board));
  memset(words, 0xA5, 1 << 14);
  qtr_qtable_init(&table, words, QTR_QTABLE_WORDS, &board.keys, precise);
}

/* Key number n: all different, all within the board's key bits, and spread over the words. */
static qtr_key key_of(unsigned n) {
  qtr_key key;
  memset(&key, 0xA5, sizeof key);
  for (unsigned w = 0; w < board.keys.words; w++) key.word[w] = w % 2 == 0 ? n * (w + 1) : ~n;
  const unsigned top = board.keys.bits - 32u * (board.keys.words - 1u);
  if (top < 32) key.word[board.keys.words - 1] &= ((uint32_t)1 << top) - 1;
  if (board.keys.words == 1) key.word[0] = n;
  return key;
}

static void expect_as_plain(unsigned n) {
  const qtr_key key = key_of(n);
  double value = -1.0;
  TEST_ASSERT_EQUAL_MESSAGE(plain[n].known, qtr_qtable_get(&table, &key, &value), case_note);
  if (plain[n].known) TEST_ASSERT_TRUE_MESSAGE(value == plain[n].value, case_note);
}

/* Set an entry in both, new ones as the table takes them. */
static void set_in_both(unsigned n, double value) {
  const qtr_key key = key_of(n);
  const uint32_t entries = table.entries;
  const uint32_t refused = table.refused;
  const bool taken = qtr_qtable_set(&table, &key, value);
  TEST_ASSERT_TRUE_MESSAGE(taken || !plain[n].known, case_note);
  TEST_ASSERT_EQUAL_UINT32_MESSAGE(entries + (taken && !plain[n].known), table.entries, case_note);
  TEST_ASSERT_EQUAL_UINT32_MESSAGE(refused + !taken, table.refused, case_note);
  if (!taken) return;
  plain[n].known = true;
  plain[n].value = precise ? value : (double)(float)value;
}

static void expect_all_as_plain(void) {
  unsigned known = 0;
  for (unsigned n = 0; n < POOL; n++) {
    expect_as_plain(n);
    known += plain[n].known;
  }
  TEST_ASSERT_EQUAL_UINT32_MESSAGE(known, table.entries, case_note);
}

/* As if the block held so many slots alone. */
static void limit_slots(uint32_t slots) {
  if (slots >= table.slots_limit) return;
  table.slots_limit = slots;
  if (table.slots > slots) table.slots = slots;
}

static void work(test_random *random, unsigned operations, unsigned keys) {
  for (unsigned i = 0; i < operations; i++) {
    const unsigned n = random_below(random, keys);
    if (random_chance(random, 50))
      set_in_both(n, ((double)random_below(random, 1000) - 500.0) / 3.0);
    else
      expect_as_plain(n);
  }
}

/* ---- against a plain array ---- */

static void test_table_is_a_plain_map(void) {
  static const unsigned boards[][3] = {{13, 1, 3}, {14, 2, 20}, {16, 4, 100}, {12, 2, 1000000}};
  for (unsigned number = 0; number < 4; number++) {
    test_random random = random_case("map", number);
    memset(plain, 0, sizeof plain);
    set_board(boards[number][0], boards[number][1], boards[number][2]);
    work(&random, 100000, 1200);
    expect_all_as_plain();
    TEST_ASSERT_EQUAL_UINT32(0, table.refused);
  }
}

static void test_growing_table_keeps_every_entry(void) {
  set_board(14, 2, 20);
  snprintf(case_note, sizeof case_note, "growth");
  const unsigned most = table.slots_limit / 16 * 15 - 1;
  unsigned slots = table.slots;
  unsigned grown = 0;
  for (unsigned n = 0; n < POOL && n < most; n++) {
    set_in_both(n, (double)n / 7.0);
    if (table.slots == slots) continue;
    TEST_ASSERT_GREATER_THAN(slots, table.slots);
    slots = table.slots;
    grown++;
    expect_all_as_plain();
  }
  TEST_ASSERT_GREATER_THAN(0, grown);
  expect_all_as_plain();
}

/* Room made ahead is the room that the entries would have made, and nothing else changes. */
static void test_room_made_ahead_in_shares_keeps_every_entry(void) {
  enum { MORE = 100 };
  set_board(14, 2, 20);
  snprintf(case_note, sizeof case_note, "room ahead");
  const unsigned most = table.slots_limit / 16 * 15 - 1;
  unsigned grown = 0;
  for (unsigned n = 0; n < POOL && n < most; n++) {
    const uint32_t slots = table.slots;
    unsigned shares = 0;
    while (qtr_qtable_make_room(&table, MORE)) shares++;
    TEST_ASSERT_EQUAL(table.slots > slots, shares > 0);
    if (slots > 8192) TEST_ASSERT_NOT_EQUAL(1, shares);
    if (table.slots < table.slots_limit) TEST_ASSERT_LESS_THAN(table.slots / 8 * 7, table.entries + MORE);
    if (shares > 0) expect_all_as_plain();
    grown += shares > 0;
    set_in_both(n, (double)n / 7.0);
  }
  TEST_ASSERT_GREATER_THAN(0, grown);
  expect_all_as_plain();
}

/* Every number of slots that an odd array may give, growing to it from any step before. */
static void test_tables_of_every_small_size_fill_and_stay_right(void) {
  for (unsigned slots = 2; slots < 300; slots++) {
    snprintf(case_note, sizeof case_note, "%u slots", slots);
    memset(plain, 0, sizeof plain);
    set_board(14, 2, 20);
    limit_slots(slots);
    table.slots = slots < 8 ? slots : slots / 3;
    for (unsigned n = 0; n < slots + 20; n++) set_in_both(n, (double)n / 7.0);
    TEST_ASSERT_GREATER_THAN(0, table.refused);
    for (unsigned n = 0; n < slots + 20; n++) expect_as_plain(n);
    TEST_ASSERT_LESS_THAN(slots, table.entries);
    if (slots >= 16) TEST_ASSERT_GREATER_OR_EQUAL(slots * 14 / 16 - 2, table.entries);
  }
}

static void test_full_table_refuses_counts_and_stays_right(void) {
  for (unsigned number = 0; number < 3; number++) {
    test_random random = random_case("full", number);
    memset(plain, 0, sizeof plain);
    set_board(14, number + 1, 20);
    limit_slots(1000 + 777 * number);
    work(&random, 60000, POOL);
    TEST_ASSERT_GREATER_THAN(1000, table.refused);
    expect_all_as_plain();
    /* What it has can still be changed. */
    for (unsigned n = 0; n < POOL; n++)
      if (plain[n].known) set_in_both(n, -1.0 - (double)n / 7.0);
    expect_all_as_plain();
  }
}

static void test_block_itself_bounds_the_table(void) {
  set_board(16, 4, 100);
  TEST_ASSERT_TRUE((uint64_t)table.slots_limit * table.entry_words <= QTR_QTABLE_WORDS);
  TEST_ASSERT_TRUE((uint64_t)(table.slots_limit + 1) * table.entry_words > QTR_QTABLE_WORDS);
#ifdef QTR_PROFILE_MCU
  snprintf(case_note, sizeof case_note, "block");
  for (unsigned n = 0; n < POOL; n++) set_in_both(n, (double)n / 7.0);
  TEST_ASSERT_GREATER_THAN(0, table.refused);
  TEST_ASSERT_GREATER_OR_EQUAL(table.slots_limit * 9 / 10, table.entries);
  expect_all_as_plain();
#endif
}

/* Moved to a larger block whenever it asks for one: nothing is refused, and nothing is lost on the way. */
static void test_table_that_grows_takes_what_a_large_one_takes(void) {
  enum { AHEAD = 100 };
  static uint32_t other[QTR_QTABLE_WORDS];
  uint32_t *at = words;
  size_t held = QTR_QTABLE_LEAST_WORDS;
  unsigned moves = 0;
  snprintf(case_note, sizeof case_note, "growing");
  set_board(14, 2, 20);
  const uint32_t most = table.slots_limit / 16 * 15 - 1;
  qtr_qtable_init(&table, at, held, &board.keys, precise);
  for (unsigned n = 0; n < POOL && n < most; n++) {
    const size_t needed = qtr_qtable_needs(&table, AHEAD);
    TEST_ASSERT_LESS_OR_EQUAL(QTR_QTABLE_WORDS, needed);
    if (n % AHEAD == 0 && needed > held) {
      uint32_t *to = at == words ? other : words;
      memcpy(to, at, held * sizeof *to);
      memset(at, 0xA5, held * sizeof *at);
      TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_qtable_move(&table, to, needed));
      at = to;
      held = needed;
      moves++;
    }
    set_in_both(n, (double)n / 7.0);
  }
  TEST_ASSERT_GREATER_THAN(2, moves);
  TEST_ASSERT_EQUAL_UINT32(0, table.refused);
  expect_all_as_plain();
}

static void test_table_moves_to_no_smaller_block(void) {
  set_board(14, 2, 20);
  const size_t used = (size_t)table.slots * table.entry_words;
  TEST_ASSERT_EQUAL_INT(QTR_ERR_SPACE, qtr_qtable_move(&table, words, used - 1));
  TEST_ASSERT_EQUAL_INT(QTR_ERR_SPACE, qtr_qtable_move(&table, NULL, QTR_QTABLE_WORDS));
  TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_qtable_move(&table, words, used));
}

static void test_init_empties_the_table(void) {
  double value;
  set_board(14, 2, 20);
  for (unsigned n = 0; n < 500; n++) set_in_both(n, 1.0);
  qtr_qtable_init(&table, words, QTR_QTABLE_WORDS, &board.keys, precise);
  TEST_ASSERT_EQUAL_UINT32(0, table.entries);
  TEST_ASSERT_EQUAL_UINT32(0, table.refused);
  for (unsigned n = 0; n < 500; n++) {
    const qtr_key key = key_of(n);
    TEST_ASSERT_FALSE(qtr_qtable_get(&table, &key, &value));
  }
}

static qtr_key greatest_key(void) {
  qtr_key key;
  const unsigned top = board.keys.bits - 32u * (board.keys.words - 1u);
  memset(&key, 0xFF, sizeof key);
  key.word[board.keys.words - 1] >>= 32 - top;
  return key;
}

/* Keys that differ in one of their highest bits alone, beside which the table keeps its own. */
static void expect_high_bits_kept_apart(void) {
  qtr_key keys[6];
  double value;
  memset(keys, 0, sizeof keys);
  for (unsigned i = 1; i < 6; i++) {
    const unsigned bit = board.keys.bits > i ? board.keys.bits - i : 0;
    keys[i] = greatest_key();
    if (i > 1 && bit > 0) keys[i].word[bit / 32] &= ~((uint32_t)1 << bit % 32);
    if (i > 1 && bit == 0) return; /* a key of few bits has few to differ in */
  }
  for (unsigned i = 0; i < 6; i++) TEST_ASSERT_TRUE(qtr_qtable_set(&table, &keys[i], (double)i));
  TEST_ASSERT_EQUAL_UINT32(6, table.entries);
  for (unsigned i = 0; i < 6; i++) TEST_ASSERT_TRUE(qtr_qtable_get(&table, &keys[i], &value) && value == (double)i);
}

static void test_greatest_keys_are_kept_apart_whatever_their_bits(void) {
  bool seen[32] = {false};
  for (unsigned places = 1; places <= QTR_MAX_PLACES; places += places < 128 ? 1 : 64) {
    for (unsigned longest = 1; longest < 1u << 12; longest *= 2) {
      set_board(places, 1 + places % QTR_MAX_SEEKERS, longest);
      seen[board.keys.bits % 32] = true;
      expect_high_bits_kept_apart();
    }
  }
  for (unsigned i = 0; i < 32; i++) TEST_ASSERT_TRUE(seen[i]);
}

/* ---- what a value becomes ---- */

static void test_value_rounded_up_is_the_least_that_bounds_it(void) {
  test_random random = random_case("rounding", 0);
  set_board(14, 2, 20);
  for (unsigned i = 0; i < 100000; i++) {
    const double value = ldexp(random_unit(&random) - 0.5, (int)random_below(&random, 300) - 150);
    const double up = qtr_qtable_round_up(&table, value);
    const double nearest = qtr_qtable_nearest(&table, value);
    TEST_ASSERT_TRUE(up >= value && nearest <= up);
    TEST_ASSERT_TRUE(qtr_qtable_nearest(&table, up) == up);
    if (precise)
      TEST_ASSERT_TRUE(up == value && nearest == value);
    else
      TEST_ASSERT_TRUE(up == value || (double)nextafterf((float)up, -HUGE_VALF) < value);
  }
}

/* ---- sizes ---- */

static uint32_t entry_bytes(unsigned places, unsigned seekers, unsigned longest) {
  set_board(places, seekers, longest);
  TEST_ASSERT_EQUAL_UINT32(4u * table.entry_words, qtr_qtable_entry_bytes(&table));
  return qtr_qtable_entry_bytes(&table);
}

static void test_entries_are_small(void) {
  const uint32_t more = precise ? 4 : 0;
#ifdef QTR_PROFILE_MCU
  TEST_ASSERT_LESS_OR_EQUAL(12 + more, entry_bytes(16, 2, 200));
  TEST_ASSERT_LESS_OR_EQUAL(16 + more, entry_bytes(16, 4, 400));
#else
  TEST_ASSERT_LESS_OR_EQUAL(12 + more, entry_bytes(20, 2, 200));
  TEST_ASSERT_LESS_OR_EQUAL(20 + more, entry_bytes(40, 4, 400));
  TEST_ASSERT_LESS_OR_EQUAL(24 + more, entry_bytes(60, 5, 800));
#endif
}

static void run_all(void) {
  RUN_TEST(test_table_is_a_plain_map);
  RUN_TEST(test_growing_table_keeps_every_entry);
  RUN_TEST(test_room_made_ahead_in_shares_keeps_every_entry);
  RUN_TEST(test_tables_of_every_small_size_fill_and_stay_right);
  RUN_TEST(test_full_table_refuses_counts_and_stays_right);
  RUN_TEST(test_block_itself_bounds_the_table);
  RUN_TEST(test_table_that_grows_takes_what_a_large_one_takes);
  RUN_TEST(test_table_moves_to_no_smaller_block);
  RUN_TEST(test_init_empties_the_table);
  RUN_TEST(test_greatest_keys_are_kept_apart_whatever_their_bits);
  RUN_TEST(test_value_rounded_up_is_the_least_that_bounds_it);
  RUN_TEST(test_entries_are_small);
}

int main(void) {
  UNITY_BEGIN();
  run_all();
  precise = true;
  run_all();
  return UNITY_END();
}

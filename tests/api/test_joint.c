/* profiles: host mcu */
/* The joint game by hand, against the paper's rules written down a second time, and its keys: equal if, and only if,
 * the states are equal but for who is who. */
#include <string.h>

#include "quarter/joint.h"
#include "quarter/status.h"
#include "support/brute.h"
#include "support/random.h"
#include "support/steps.h"
#include "unity.h"

enum { MOST_NODES = QTR_MAX_PLACES + QTR_MAX_SEEKERS, POOL = 2500 };

static qtr_board board;
static uint8_t steps[4 * MOST_NODES * QTR_MAX_PLACES];
static qtr_joint joint;
static qtr_mission mission;
static brute_game brute;

void setUp(void) {
  memset(&board, 0, sizeof board);
  memset(&joint, 0xA5, sizeof joint);
  snprintf(case_note, sizeof case_note, "by hand");
}

void tearDown(void) {
}

static void set_steps(unsigned node, unsigned place, qtr_steps value) {
  steps_put(steps, node * board.places + place, value);
}

static qtr_steps apart(unsigned a, unsigned b) {
  return a < b ? b - a : a - b;
}

/* A corridor: places and starts by their columns, a start for each seeker. Seekers that share one must follow. */
static void corridor(uint8_t rule, unsigned places, const unsigned *at, unsigned seekers, const unsigned *from) {
  board.places = (uint16_t)places;
  board.seekers = (uint8_t)seekers;
  board.rule = rule;
  board.step_bytes = 4;
  board.steps = steps;
  for (unsigned i = 0; i < seekers; i++) {
    if (i == 0 || from[i] != from[i - 1]) board.starts++;
    board.start_of[i] = (uint8_t)(board.starts - 1);
    for (unsigned p = 0; p < places; p++) set_steps(places + board.start_of[i], p, apart(from[i], at[p]));
  }
  for (unsigned q = 0; q < places; q++)
    for (unsigned p = 0; p < places; p++) set_steps(q, p, apart(at[q], at[p]));
  TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_board_init(&board));
  qtr_joint_start(&joint, &board, NULL, NULL);
}

static void expect_choices(int seeker, uint32_t places, bool may_stand_down) {
  qtr_places choices;
  TEST_ASSERT_EQUAL_INT(seeker, qtr_joint_chooser(&joint, &board));
  TEST_ASSERT_EQUAL(may_stand_down, qtr_joint_choices(&joint, &board, seeker, &choices));
  TEST_ASSERT_EQUAL_HEX32(places, choices.word[0]);
}

static void expect_advance(qtr_steps passed, uint32_t places) {
  qtr_places arrived;
  qtr_places_clear(&arrived);
  TEST_ASSERT_EQUAL_INT(QTR_NOBODY, qtr_joint_chooser(&joint, &board));
  TEST_ASSERT_EQUAL_UINT32(passed, qtr_joint_advance(&joint, &board, &arrived));
  TEST_ASSERT_EQUAL_HEX32(places, arrived.word[0]);
}

static bool choose(int seeker, uint16_t choice) {
  return qtr_joint_choose(&joint, &board, seeker, choice);
}

/* ---- games played by hand ---- */

static void test_two_seekers_share_three_places(void) {
  corridor(QTR_RULE_FREE, 3, (unsigned[]){0, 6, 10}, 2, (unsigned[]){4, 4});
  TEST_ASSERT_EQUAL_UINT32(10, board.keys.longest);
  expect_choices(0, 7, true);
  TEST_ASSERT_FALSE(choose(0, 1));
  expect_choices(1, 5, true);
  TEST_ASSERT_FALSE(choose(1, 0));
  expect_advance(2, 2);
  expect_choices(0, 4, true); /* place 0 is the other one's */
  choose(0, 2);
  expect_advance(2, 1);
  TEST_ASSERT_EQUAL_HEX16(QTR_STAND_DOWN, joint.node[1]); /* nothing is left for it */
  expect_advance(2, 4);
  TEST_ASSERT_EQUAL_UINT16(0, joint.unvisited);
  expect_advance(0, 0);
}

static void test_last_seeker_in_play_may_not_stand_down(void) {
  corridor(QTR_RULE_FREE, 3, (unsigned[]){0, 6, 10}, 2, (unsigned[]){4, 4});
  expect_choices(0, 7, true);
  choose(0, QTR_STAND_DOWN);
  expect_choices(1, 7, false);
  choose(1, 0);
  expect_advance(4, 1);
  expect_choices(1, 6, false);
  choose(1, 2);
  expect_advance(10, 4);
  expect_choices(1, 2, false);
}

static void test_seeker_on_its_way_can_take_the_rest(void) {
  corridor(QTR_RULE_FREE, 2, (unsigned[]){0, 9}, 2, (unsigned[]){4, 4});
  choose(0, 0);
  expect_choices(1, 2, true);
  choose(1, QTR_STAND_DOWN);
  expect_advance(4, 1);
  expect_choices(0, 2, false);
}

static void test_arrivals_in_the_same_step_are_one_advance(void) {
  corridor(QTR_RULE_FREE, 2, (unsigned[]){0, 8}, 2, (unsigned[]){4, 4});
  choose(0, 0);
  choose(1, 1);
  expect_advance(4, 3);
  TEST_ASSERT_EQUAL_UINT16(0, joint.unvisited);
}

static void test_idle_seekers_choose_from_the_lowest_node_up(void) {
  corridor(QTR_RULE_FREE, 4, (unsigned[]){0, 8, 20, 30}, 2, (unsigned[]){4, 4});
  choose(0, 1);
  choose(1, 0);
  expect_advance(4, 3);
  expect_choices(1, 12, true); /* it stands on place 0, the other one on place 1 */
}

static void test_place_at_a_start_is_visited_at_once(void) {
  corridor(QTR_RULE_FREE, 2, (unsigned[]){4, 9}, 2, (unsigned[]){4, 4});
  expect_choices(0, 3, true);
  TEST_ASSERT_TRUE(choose(0, 0));
  TEST_ASSERT_TRUE(qtr_places_has(&joint.visited, 0));
  TEST_ASSERT_FALSE(qtr_places_has(&joint.bound, 0));
  TEST_ASSERT_EQUAL_UINT16(1, joint.unvisited);
  expect_choices(0, 2, true); /* no time has passed: it stands at node 0, below the start */
}

static void test_papers_rule_forces_a_place_of_ones_own_while_there_are_enough(void) {
  corridor(QTR_RULE_PAPER, 2, (unsigned[]){0, 9}, 2, (unsigned[]){4, 4});
  expect_choices(0, 3, false);
  choose(0, 0);
  expect_choices(1, 2, false);
}

static void test_papers_rule_lets_all_go_for_the_last_places(void) {
  corridor(QTR_RULE_PAPER, 1, (unsigned[]){9}, 2, (unsigned[]){4, 6});
  expect_choices(0, 1, false);
  choose(0, 0);
  expect_choices(1, 1, false);
  choose(1, 0);
  expect_advance(3, 1);
  TEST_ASSERT_EQUAL_UINT16(0, joint.unvisited);
  expect_advance(0, 0); /* the other one is still on its way, to no use */
}

static void test_late_follower_chooses_again_where_it_arrives(void) {
  corridor(QTR_RULE_PAPER, 2, (unsigned[]){9, 30}, 3, (unsigned[]){4, 6, 6});
  choose(0, 0);
  choose(1, 0);
  choose(2, 0);
  expect_advance(3, 1); /* seekers 1 and 2; seeker 0 is 2 steps short */
  expect_choices(1, 2, false);
  choose(1, 1);
  choose(2, 1);
  expect_advance(2, 0); /* seeker 0 comes to a place already visited */
  expect_choices(0, 2, false);
}

static void test_cut_off_seeker_keeps_to_its_side(void) {
  corridor(QTR_RULE_FREE, 2, (unsigned[]){0, 9}, 2, (unsigned[]){4, 6});
  const unsigned none[4][2] = {{0, 1}, {1, 0}, {2, 1}, {3, 0}}; /* node, place without a way */
  for (int i = 0; i < 4; i++) set_steps(none[i][0], none[i][1], QTR_NEVER);
  TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_board_init(&board));
  TEST_ASSERT_EQUAL_UINT32(4, board.keys.longest);
  qtr_joint_start(&joint, &board, NULL, NULL);
  expect_choices(0, 1, false); /* nobody else can come here */
  choose(0, 0);
  expect_choices(1, 2, false);
}

static void test_cleared_places_are_visited_from_the_start(void) {
  qtr_places cleared;
  corridor(QTR_RULE_FREE, 3, (unsigned[]){0, 6, 10}, 2, (unsigned[]){4, 4});
  qtr_places_clear(&cleared);
  qtr_places_add(&cleared, 1);
  qtr_joint_start(&joint, &board, NULL, &cleared);
  TEST_ASSERT_EQUAL_UINT16(2, joint.unvisited);
  expect_choices(0, 5, true);
  qtr_places_add(&cleared, 0);
  qtr_places_add(&cleared, 2);
  qtr_joint_start(&joint, &board, NULL, &cleared);
  TEST_ASSERT_EQUAL_UINT16(0, joint.unvisited);
  TEST_ASSERT_EQUAL_HEX16(QTR_STAND_DOWN, joint.node[0]);
  expect_advance(0, 0);
}

/* A set from outside may have bits beyond the last place. */
static void test_cleared_bits_beyond_the_places_mean_nothing(void) {
  qtr_places cleared;
  memset(&cleared, 0xFF, sizeof cleared);
  corridor(QTR_RULE_FREE, 3, (unsigned[]){0, 6, 10}, 1, (unsigned[]){4});
  qtr_places_remove(&cleared, 1);
  qtr_joint_start(&joint, &board, NULL, &cleared);
  TEST_ASSERT_EQUAL_UINT16(1, joint.unvisited);
  TEST_ASSERT_EQUAL_HEX32(5, joint.visited.word[0]);
}

/* ---- boards ---- */

static int init_with(uint16_t places, uint8_t seekers, uint16_t starts, uint8_t rule) {
  board.places = places;
  board.seekers = seekers;
  board.starts = starts;
  board.rule = rule;
  return qtr_board_init(&board);
}

static void test_board_out_of_range_is_refused(void) {
  corridor(QTR_RULE_FREE, 2, (unsigned[]){0, 9}, 2, (unsigned[]){4, 6});
  TEST_ASSERT_EQUAL_INT(QTR_ERR_ARGUMENT, init_with(0, 2, 2, 0));
  TEST_ASSERT_EQUAL_INT(QTR_ERR_ARGUMENT, init_with(2, 0, 1, 0));
  TEST_ASSERT_EQUAL_INT(QTR_ERR_ARGUMENT, init_with(2, 2, 0, 0));
  TEST_ASSERT_EQUAL_INT(QTR_ERR_ARGUMENT, init_with(2, 2, QTR_MAX_STARTS + 1, 0));
  TEST_ASSERT_EQUAL_INT(QTR_ERR_ARGUMENT, init_with(2, 2, 2, 2));
  TEST_ASSERT_EQUAL_INT(QTR_ERR_LIMIT, init_with(QTR_MAX_PLACES + 1, 2, 2, 0));
  TEST_ASSERT_EQUAL_INT(QTR_ERR_LIMIT, init_with(2, QTR_MAX_SEEKERS + 1, 2, 0));
  board.start_of[1] = 2;
  TEST_ASSERT_EQUAL_INT(QTR_ERR_ARGUMENT, init_with(2, 2, 2, 0));
}

static void test_travel_times_that_might_overflow_are_refused(void) {
  corridor(QTR_RULE_FREE, 2, (unsigned[]){0, 9}, 1, (unsigned[]){4});
  set_steps(0, 1, UINT32_MAX / 3);
  TEST_ASSERT_EQUAL_INT(QTR_ERR_LIMIT, qtr_board_init(&board));
  set_steps(0, 1, UINT32_MAX / 3 - 0x10000);
  TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_board_init(&board));
}

/* 3 places, 2 seekers from one start, ways of up to 10 steps: nodes are 0 to 4 (a place, the start, stood down), 3
 * bits, times 4 bits, the visited places 3: 2 * (3 + 4) + 3 = 17 bits. */
static void test_key_takes_the_bits_that_its_numbers_need(void) {
  corridor(QTR_RULE_FREE, 3, (unsigned[]){0, 6, 10}, 2, (unsigned[]){4, 4});
  TEST_ASSERT_EQUAL_UINT16(17, board.keys.bits);
  TEST_ASSERT_EQUAL_UINT8(1, board.keys.words);
}

static void test_key_by_hand(void) {
  qtr_key key;
  corridor(QTR_RULE_FREE, 3, (unsigned[]){0, 6, 10}, 2, (unsigned[]){4, 4});
  choose(0, 2);
  choose(1, 1);
  expect_advance(2, 2);
  qtr_joint_key(&key, &joint, &board.keys);
  /* sorted: (place 1, 0 steps), (place 2, 4 steps); visited: place 1 */
  TEST_ASSERT_EQUAL_UINT32(1u << 14 | 0u << 10 | 2u << 7 | 4u << 3 | 2u, key.word[0]);
}

static void test_largest_board_has_keys_within_the_array(void) {
  qtr_key key;
  memset(steps, 0, sizeof steps);
  board.places = QTR_MAX_PLACES;
  board.seekers = QTR_MAX_SEEKERS;
  board.starts = QTR_MAX_SEEKERS;
  board.step_bytes = 4;
  board.steps = steps;
  for (unsigned i = 0; i < QTR_MAX_SEEKERS; i++) board.start_of[i] = (uint8_t)i;
  for (unsigned node = 0; node < MOST_NODES; node++)
    for (unsigned place = 0; place < QTR_MAX_PLACES; place++)
      set_steps(node, place, (QTR_NEVER - 1) / (QTR_MAX_PLACES + 1) - 0x10000);
  TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_board_init(&board));
  TEST_ASSERT_LESS_OR_EQUAL(QTR_KEY_WORDS, board.keys.words);
  TEST_ASSERT_LESS_OR_EQUAL(32 * board.keys.words, board.keys.bits);
  TEST_ASSERT_GREATER_THAN(32 * (board.keys.words - 1), board.keys.bits);
  qtr_joint_start(&joint, &board, NULL, NULL);
  qtr_joint_key(&key, &joint, &board.keys);
}

/* ---- against the rules written down a second time ---- */

static void board_of_brute(void) {
  memset(&board, 0, sizeof board);
  board.places = (uint16_t)brute.places;
  board.seekers = (uint8_t)brute.seekers;
  board.rule = brute.paper ? QTR_RULE_PAPER : QTR_RULE_FREE;
  board.step_bytes = 4;
  board.steps = steps;
  for (int i = 0; i < brute.seekers; i++) {
    const int start = brute.start[i] - brute.places;
    if (start >= board.starts) board.starts = (uint8_t)(start + 1);
    board.start_of[i] = (uint8_t)start;
  }
  for (int node = 0; node < brute.places + board.starts; node++)
    for (int p = 0; p < brute.places; p++)
      set_steps((unsigned)node, (unsigned)p, brute.way[node][p] < 0 ? QTR_NEVER : (qtr_steps)brute.way[node][p]);
  TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_OK, qtr_board_init(&board), case_note);
}

static void expect_same_state(const brute_state *state) {
  TEST_ASSERT_EQUAL_HEX32_MESSAGE(state->visited, joint.visited.word[0], case_note);
  TEST_ASSERT_EQUAL_HEX32_MESSAGE(brute_bound(&brute, state), joint.bound.word[0], case_note);
  TEST_ASSERT_EQUAL_MESSAGE(brute_unvisited(&brute, state), joint.unvisited, case_note);
  for (int i = 0; i < brute.seekers; i++) {
    const uint16_t node = state->node[i] == BRUTE_GONE ? QTR_STAND_DOWN : (uint16_t)state->node[i];
    TEST_ASSERT_EQUAL_HEX16_MESSAGE(node, joint.node[i], case_note);
    TEST_ASSERT_EQUAL_UINT32_MESSAGE(state->left[i], joint.remaining[i], case_note);
  }
}

/* Make the same random choice in both. */
static void choose_in_both(test_random *random, brute_state *state, int seeker) {
  qtr_places choices;
  const bool may_stand_down = qtr_joint_choices(&joint, &board, seeker, &choices);
  const unsigned places = brute_choices(&brute, state, state->node[seeker]);
  TEST_ASSERT_EQUAL_INT_MESSAGE(seeker, qtr_joint_chooser(&joint, &board), case_note);
  TEST_ASSERT_EQUAL_HEX32_MESSAGE(places, choices.word[0], case_note);
  TEST_ASSERT_EQUAL_MESSAGE(brute_may_stand_down(&brute, state, seeker), may_stand_down, case_note);
  int choice = (int)random_below(random, (unsigned)brute.places);
  while (!(places >> choice & 1u)) choice = (choice + 1) % brute.places;
  if (may_stand_down && random_chance(random, 20)) choice = BRUTE_GONE;
  const long before = state->left[seeker];
  brute_choose(&brute, state, seeker, choice);
  const bool at_once = choice != BRUTE_GONE && state->left[seeker] == 0 && before == 0;
  TEST_ASSERT_EQUAL_MESSAGE(at_once, choose(seeker, choice == BRUTE_GONE ? QTR_STAND_DOWN : (uint16_t)choice),
                            case_note);
}

static bool advance_in_both(brute_state *state) {
  bool on;
  qtr_places arrived;
  const unsigned before = state->visited;
  const long now = state->now;
  qtr_places_clear(&arrived);
  brute_pass(&brute, state, &on);
  TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_NOBODY, qtr_joint_chooser(&joint, &board), case_note);
  TEST_ASSERT_EQUAL_UINT32_MESSAGE(state->now - now, qtr_joint_advance(&joint, &board, &arrived), case_note);
  TEST_ASSERT_EQUAL_HEX32_MESSAGE(state->visited & ~before, arrived.word[0], case_note);
  return on;
}

static void test_random_plays_keep_to_the_papers_rules(void) {
  for (unsigned number = 0; number < 3000; number++) {
    test_random random = random_case("plays", number);
    brute_state state;
    mission_random(&mission, &random, (mission_size){10, 6, 9, 4});
    brute_set_up(&brute, &mission);
    board_of_brute();
    brute_begin(&brute, &state);
    qtr_joint_start(&joint, &board, NULL, NULL);
    expect_same_state(&state);
    for (bool on = true; on;) {
      const int seeker = brute_chooser(&brute, &state);
      if (seeker >= 0)
        choose_in_both(&random, &state, seeker);
      else
        on = advance_in_both(&state);
      expect_same_state(&state);
    }
    TEST_ASSERT_EQUAL_UINT16_MESSAGE(0, joint.unvisited, case_note);
  }
}

/* ---- keys ---- */

static struct {
  qtr_joint joint;
  qtr_key key;
} pool[POOL];

/* Equal but for who is who: the same visited places, and the seekers' (node, remaining) pairs match one to one. */
static bool is_same(const qtr_joint *a, const qtr_joint *b) {
  bool used[QTR_MAX_SEEKERS] = {false};
  if (memcmp(&a->visited, &b->visited, sizeof a->visited) != 0) return false;
  for (unsigned i = 0; i < board.seekers; i++) {
    unsigned j = 0;
    while (j < board.seekers && (used[j] || a->node[i] != b->node[j] || a->remaining[i] != b->remaining[j])) j++;
    if (j == board.seekers) return false;
    used[j] = true;
  }
  return true;
}

static unsigned gather_states(test_random *random, unsigned most) {
  unsigned count = 0;
  while (count < most) {
    qtr_joint_start(&joint, &board, NULL, NULL);
    for (bool on = true; on && count < most;) {
      const int seeker = qtr_joint_chooser(&joint, &board);
      qtr_places choices;
      if (seeker == QTR_NOBODY) {
        on = qtr_joint_advance(&joint, &board, NULL) > 0;
      } else {
        const bool may_stand_down = qtr_joint_choices(&joint, &board, seeker, &choices);
        unsigned choice = random_below(random, board.places);
        while (!qtr_places_has(&choices, choice)) choice = (choice + 1) % board.places;
        choose(seeker, may_stand_down && random_chance(random, 10) ? QTR_STAND_DOWN : (uint16_t)choice);
      }
      memset(&pool[count].key, 0xA5, sizeof pool[count].key);
      pool[count].joint = joint;
      qtr_joint_key(&pool[count++].key, &joint, &board.keys);
    }
  }
  return count;
}

static void expect_key_within_the_greatest(const qtr_key *key) {
  const unsigned top = board.keys.bits - 32u * (board.keys.words - 1u);
  TEST_ASSERT_TRUE_MESSAGE(top == 32 || key->word[board.keys.words - 1] >> top == 0, case_note);
}

static void test_keys_are_equal_if_and_only_if_states_are(void) {
  unsigned equal = 0;
  for (unsigned number = 0; number < 12; number++) {
    test_random random = random_case("keys", number);
    const bool large = number % 2 == 1;
    mission_random(&mission, &random, large ? (mission_size){9, 9, 9, 4} : (mission_size){4, 2, 4, 3});
    brute_set_up(&brute, &mission);
    board_of_brute();
    const unsigned count = gather_states(&random, POOL);
    for (unsigned i = 0; i < count; i++) {
      expect_key_within_the_greatest(&pool[i].key);
      for (unsigned j = 0; j < i; j++) {
        const bool keys = memcmp(pool[i].key.word, pool[j].key.word, 4u * board.keys.words) == 0;
        if (keys != is_same(&pool[i].joint, &pool[j].joint)) TEST_FAIL_MESSAGE(case_note);
        equal += keys;
      }
    }
  }
  TEST_ASSERT_GREATER_THAN(10000, equal);
}

/* The same on boards of many places and long ways, whose keys take several words. */
static void test_long_keys_tell_states_apart(void) {
  for (unsigned number = 0; number < 6; number++) {
    test_random random = random_case("long keys", number);
    const unsigned longest = 1u << random_in(&random, 1, 17);
    memset(&board, 0, sizeof board);
    board.places = (uint16_t)random_in(&random, QTR_MAX_PLACES / 2, QTR_MAX_PLACES);
    board.seekers = (uint8_t)random_in(&random, 1, QTR_MAX_SEEKERS);
    board.starts = 1;
    board.step_bytes = 4;
    board.steps = steps;
    for (unsigned node = 0; node <= board.places; node++)
      for (unsigned place = 0; place < board.places; place++) set_steps(node, place, random_in(&random, 1, longest));
    TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_OK, qtr_board_init(&board), case_note);
    const unsigned count = gather_states(&random, 800);
    for (unsigned i = 0; i < count; i++) {
      expect_key_within_the_greatest(&pool[i].key);
      for (unsigned j = 0; j < i; j++) {
        const bool keys = memcmp(pool[i].key.word, pool[j].key.word, 4u * board.keys.words) == 0;
        if (keys != is_same(&pool[i].joint, &pool[j].joint)) TEST_FAIL_MESSAGE(case_note);
      }
    }
  }
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_two_seekers_share_three_places);
  RUN_TEST(test_last_seeker_in_play_may_not_stand_down);
  RUN_TEST(test_seeker_on_its_way_can_take_the_rest);
  RUN_TEST(test_arrivals_in_the_same_step_are_one_advance);
  RUN_TEST(test_idle_seekers_choose_from_the_lowest_node_up);
  RUN_TEST(test_place_at_a_start_is_visited_at_once);
  RUN_TEST(test_papers_rule_forces_a_place_of_ones_own_while_there_are_enough);
  RUN_TEST(test_papers_rule_lets_all_go_for_the_last_places);
  RUN_TEST(test_late_follower_chooses_again_where_it_arrives);
  RUN_TEST(test_cut_off_seeker_keeps_to_its_side);
  RUN_TEST(test_cleared_places_are_visited_from_the_start);
  RUN_TEST(test_cleared_bits_beyond_the_places_mean_nothing);
  RUN_TEST(test_board_out_of_range_is_refused);
  RUN_TEST(test_travel_times_that_might_overflow_are_refused);
  RUN_TEST(test_key_takes_the_bits_that_its_numbers_need);
  RUN_TEST(test_key_by_hand);
  RUN_TEST(test_largest_board_has_keys_within_the_array);
  RUN_TEST(test_random_plays_keep_to_the_papers_rules);
  RUN_TEST(test_keys_are_equal_if_and_only_if_states_are);
  RUN_TEST(test_long_keys_tell_states_apart);
  return UNITY_END();
}

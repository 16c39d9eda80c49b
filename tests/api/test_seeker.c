/* profiles: host mcu */
/* The executors: together they play the learner's best game without a word, alone they leave no place out, and signals
 * spare them what is done. */
#include <string.h>

#include "quarter/seeker.h"
#include "support/tables.h"

enum { MOST_SEEKERS = 4 };

static qtr_policy policy[MOST_SEEKERS]; /* each robot opens the bytes itself */
static qtr_seeker seeker[MOST_SEEKERS];
static qtr_field table_field;

/* What a robot did: the places it visited, in order, and the territory and pass in which it did. */
typedef struct {
  unsigned visits;
  uint16_t place[QTR_MAX_PLACES];
  uint8_t territory[QTR_MAX_PLACES];
  uint8_t pass[QTR_MAX_PLACES];
  qtr_places visited;
  unsigned announced[MOST_SEEKERS];
} diary;

static diary diaries[MOST_SEEKERS];

void setUp(void) {
  snprintf(case_note, sizeof case_note, "by hand");
}

void tearDown(void) {
}

static unsigned robots(void) {
  return policy[0].board.seekers;
}

/* What a robot says is true: it has scanned every place of the territory itself. */
static void expect_scanned(unsigned self, unsigned territory) {
  const qtr_division *division = &seeker[self].division;
  for (unsigned i = 0; i < division->moves; i++)
    if (division->seeker[i] == territory)
      TEST_ASSERT_TRUE_MESSAGE(qtr_places_has(&diaries[self].visited, division->place[i]), case_note);
}

static void take_announcements(unsigned self) {
  qtr_signal signal;
  for (unsigned count = 0; qtr_seeker_announce(&seeker[self], &signal); count++) {
    TEST_ASSERT_EQUAL_MESSAGE(QTR_SIGNAL_TERRITORY_DONE, signal.kind, case_note);
    TEST_ASSERT_LESS_THAN_MESSAGE(robots(), signal.territory, case_note);
    TEST_ASSERT_LESS_THAN_MESSAGE(robots(), count, case_note);
    expect_scanned(self, signal.territory);
    diaries[self].announced[signal.territory]++;
  }
}

static bool tell(unsigned self, unsigned kind, unsigned territory) {
  const qtr_signal signal = {seeker[self].identity, seeker[self].run, (uint8_t)kind, (uint8_t)territory};
  return qtr_seeker_hear(&seeker[self], &signal);
}

static unsigned pass_of(unsigned self, unsigned territory) {
  return (territory + robots() - self) % robots();
}

static void start_robots(const qtr_places *cleared) {
  qtr_deployment deployment;
  memset(diaries, 0, sizeof diaries);
  for (unsigned self = 0; self == 0 || self < robots(); self++) {
    table_open(&policy[self]);
    memset(&seeker[self], 0xA5, sizeof seeker[self]);
    TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_deployment_init(&deployment, &policy[self], NULL, cleared));
    TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_OK, qtr_seeker_init(&seeker[self], &policy[self], self, &deployment, 7),
                                  case_note);
    memset(&deployment, 0xA5, sizeof deployment); /* a seeker has a copy */
    take_announcements(self);
  }
}

/* The robot comes to its target. */
static void visit_target(unsigned self) {
  diary *d = &diaries[self];
  const uint16_t target = qtr_seeker_target(&seeker[self]);
  TEST_ASSERT_LESS_THAN_MESSAGE(policy[0].board.places, target, case_note);
  TEST_ASSERT_FALSE_MESSAGE(qtr_places_has(&d->visited, target), case_note);
  qtr_places_add(&d->visited, target);
  d->place[d->visits] = target;
  d->territory[d->visits] = (uint8_t)qtr_seeker_territory(&seeker[self]);
  d->pass[d->visits] = (uint8_t)pass_of(self, d->territory[d->visits]);
  d->visits++;
  qtr_seeker_visited(&seeker[self], qtr_seeker_target(&seeker[self]));
  take_announcements(self);
}

static bool is_idle(unsigned self) {
  return qtr_seeker_target(&seeker[self]) == QTR_STAND_DOWN;
}

static void run_alone(unsigned self) {
  while (!is_idle(self)) visit_target(self);
}

static bool can_reach(unsigned self, unsigned place) {
  const qtr_board *board = &policy[0].board;
  return qtr_board_steps(board, self, (unsigned)board->places + board->start_of[self], place) != QTR_NEVER;
}

static void random_robots(const char *test, unsigned number) {
  test_random random = random_case(test, number);
  table_random(&random, (mission_size){10, 8, 8, MOST_SEEKERS});
  start_robots(NULL);
}

/* ---- together ---- */

/* Robot `self`'s own route in the learner's best game. */
static unsigned best_route(unsigned self, uint16_t *route) {
  const qtr_play *best = qtr_learner_best(table_learner);
  unsigned length = 0;
  for (unsigned i = 0; i < best->choices; i++)
    if (best->seeker[i] == self && best->choice[i] != QTR_STAND_DOWN) route[length++] = best->choice[i];
  return length;
}

static void test_robots_together_play_the_best_game(void) {
  for (unsigned number = 0; number < random_cases(400); number++) {
    qtr_steps visit[QTR_MAX_PLACES];
    random_robots("together", number);
    for (unsigned place = 0; place < QTR_MAX_PLACES; place++) visit[place] = QTR_NEVER;
    for (unsigned self = 0; self < robots(); self++) {
      uint16_t route[QTR_MAX_PLACES];
      const unsigned length = best_route(self, route);
      unsigned node = policy[self].board.places + policy[self].board.start_of[self];
      qtr_steps now = 0;
      for (unsigned i = 0; i < length; i++) {
        const uint16_t target = qtr_seeker_target(&seeker[self]);
        TEST_ASSERT_EQUAL_HEX16_MESSAGE(route[i], target, case_note);
        TEST_ASSERT_EQUAL_MESSAGE(self, qtr_seeker_territory(&seeker[self]), case_note);
        now += qtr_board_steps(&policy[self].board, self, node, target);
        if (now < visit[target]) visit[target] = now;
        node = target;
        visit_target(self);
      }
      TEST_ASSERT_TRUE_MESSAGE(is_idle(self) || qtr_seeker_territory(&seeker[self]) != self, case_note);
      TEST_ASSERT_EQUAL_UINT32_MESSAGE(0, seeker[self].division.off_table, case_note);
    }
    for (unsigned place = 0; place < policy[0].board.places; place++)
      TEST_ASSERT_EQUAL_UINT32_MESSAGE(qtr_learner_best(table_learner)->visit[place], visit[place], case_note);
  }
}

/* On the grid, cell by cell. */
static void test_walk_on_the_grid_takes_the_nominal_time(void) {
  for (unsigned number = 0; number < random_cases(100); number++) {
    random_robots("walk", number);
    for (unsigned self = 0; self < robots(); self++) {
      qtr_cell cell = qtr_policy_cell(&policy[self], policy[self].board.places + policy[self].board.start_of[self]);
      unsigned node = policy[self].board.places + policy[self].board.start_of[self];
      while (!is_idle(self)) {
        const uint16_t target = qtr_seeker_target(&seeker[self]);
        qtr_steps taken = 0;
        TEST_ASSERT_TRUE_MESSAGE(qtr_seeker_field(&seeker[self], &table_field, cell), case_note);
        while (cell != qtr_policy_cell(&policy[self], target)) {
          cell = qtr_field_next(&table_field, &policy[self].grid, cell);
          taken += qtr_grid_cost(&policy[self].grid, cell);
        }
        TEST_ASSERT_EQUAL_UINT32_MESSAGE(qtr_board_steps(&policy[self].board, self, node, target), taken, case_note);
        node = target;
        visit_target(self);
      }
      TEST_ASSERT_FALSE_MESSAGE(qtr_seeker_field(&seeker[self], &table_field, cell), case_note);
    }
  }
}

/* ---- alone ---- */

static void expect_all_in_reach_visited(unsigned self, const qtr_places *cleared) {
  for (unsigned place = 0; place < policy[0].board.places; place++) {
    const bool wanted = can_reach(self, place) && !(cleared != NULL && qtr_places_has(cleared, place));
    TEST_ASSERT_EQUAL_MESSAGE(wanted, qtr_places_has(&diaries[self].visited, place), case_note);
  }
}

/* All others lost: whoever is left scans every place that it can reach, once. */
static void test_single_survivor_scans_every_place_in_its_reach(void) {
  for (unsigned number = 0; number < random_cases(400); number++) {
    random_robots("survivor", number);
    for (unsigned self = 0; self < robots(); self++) {
      run_alone(self);
      expect_all_in_reach_visited(self, NULL);
    }
  }
}

static void expect_territories_in_turn(unsigned self) {
  const diary *d = &diaries[self];
  for (unsigned i = 0; i < d->visits; i++) {
    TEST_ASSERT_EQUAL_MESSAGE((self + d->pass[i]) % robots(), d->territory[i], case_note);
    TEST_ASSERT_TRUE_MESSAGE(i == 0 || d->pass[i] >= d->pass[i - 1], case_note);
  }
}

/* In a neighbour's territory the neighbour's order, in odd passes from its end. */
static void expect_neighbours_order(unsigned self, unsigned territory) {
  const diary *d = &diaries[self];
  uint16_t route[QTR_MAX_PLACES];
  const unsigned length = best_route(territory, route);
  const bool backwards = pass_of(self, territory) % 2 == 1;
  unsigned at = 0;
  for (unsigned i = 0; i < d->visits; i++) {
    if (d->territory[i] != territory) continue;
    while (at < length && route[backwards ? length - 1 - at : at] != d->place[i]) at++;
    TEST_ASSERT_LESS_THAN_MESSAGE(length, at, case_note);
  }
}

static void test_neighbours_territories_follow_in_turn_from_alternate_ends(void) {
  for (unsigned number = 0; number < random_cases(300); number++) {
    random_robots("neighbours", number);
    for (unsigned self = 0; self < robots(); self++) {
      run_alone(self);
      expect_territories_in_turn(self);
      for (unsigned territory = 0; territory < robots(); territory++) expect_neighbours_order(self, territory);
    }
  }
}

/* Territories do not overlap under the free rule, and no two robots are in the same one in the same pass. */
static void test_survivors_do_not_repeat_one_another_within_a_pass(void) {
  for (unsigned number = 0; number < random_cases(300); number++) {
    random_robots("passes", number);
    if (policy[0].board.rule == QTR_RULE_PAPER) continue;
    qtr_places seen[MOST_SEEKERS];
    memset(seen, 0, sizeof seen);
    for (unsigned self = 0; self < robots(); self++) {
      run_alone(self);
      for (unsigned i = 0; i < diaries[self].visits; i++) {
        qtr_places *pass = &seen[diaries[self].pass[i]];
        TEST_ASSERT_FALSE_MESSAGE(qtr_places_has(pass, diaries[self].place[i]), case_note);
        qtr_places_add(pass, diaries[self].place[i]);
      }
    }
  }
}

static void test_cleared_places_are_not_visited_again(void) {
  for (unsigned number = 0; number < random_cases(300); number++) {
    qtr_places cleared;
    random_robots("cleared", number);
    test_random random = random_case("cleared", number + 1000000);
    for (unsigned w = 0; w < QTR_PLACE_WORDS; w++) cleared.word[w] = (uint32_t)random_bits(&random);
    start_robots(&cleared);
    for (unsigned self = 0; self < robots(); self++) {
      run_alone(self);
      expect_all_in_reach_visited(self, &cleared);
    }
  }
}

/* What all robots together take for their own when places are cleared is still every place, once. */
static void test_territories_left_by_a_cleared_set_cover_the_rest(void) {
  for (unsigned number = 0; number < random_cases(300); number++) {
    qtr_places cleared;
    qtr_places seen;
    random_robots("rest", number);
    test_random random = random_case("rest", number + 1000000);
    for (unsigned w = 0; w < QTR_PLACE_WORDS; w++) cleared.word[w] = (uint32_t)random_bits(&random);
    qtr_places_clear(&seen);
    start_robots(&cleared);
    for (unsigned self = 0; self < robots(); self++) {
      while (!is_idle(self) && qtr_seeker_territory(&seeker[self]) == self) {
        const uint16_t target = qtr_seeker_target(&seeker[self]);
        TEST_ASSERT_TRUE_MESSAGE(policy[0].board.rule == QTR_RULE_PAPER || !qtr_places_has(&seen, target), case_note);
        qtr_places_add(&seen, target);
        visit_target(self);
      }
    }
    for (unsigned place = 0; place < policy[0].board.places; place++)
      TEST_ASSERT_EQUAL_MESSAGE(!qtr_places_has(&cleared, place), qtr_places_has(&seen, place), case_note);
  }
}

/* ---- signals ---- */

static void tell_all(unsigned from, unsigned alive, unsigned territory) {
  for (unsigned self = 0; self < robots(); self++)
    if (self != from && (alive >> self & 1u)) tell(self, QTR_SIGNAL_TERRITORY_DONE, territory);
}

static void pass_words_on(unsigned alive, diary *heard) {
  bool news = true;
  while (news) {
    news = false;
    for (unsigned self = 0; self < robots(); self++) {
      for (unsigned t = 0; (alive >> self & 1u) && t < robots(); t++) {
        if (diaries[self].announced[t] == heard[self].announced[t]) continue;
        heard[self].announced[t]++;
        tell_all(self, alive, t);
        news = true;
      }
    }
  }
}

/* The survivors go on in any order, as late as they like, and hear one another. */
static void run_survivors(test_random *random, unsigned alive) {
  static diary heard[MOST_SEEKERS];
  memset(heard, 0, sizeof heard);
  pass_words_on(alive, heard);
  for (bool on = true; on;) {
    on = false;
    for (unsigned self = 0; self < robots(); self++) {
      if (!(alive >> self & 1u) || is_idle(self)) continue;
      on = true;
      if (random_chance(random, 50)) continue;
      visit_target(self);
      pass_words_on(alive, heard);
    }
  }
}

static void expect_survivors_were_enough(unsigned alive) {
  for (unsigned place = 0; place < policy[0].board.places; place++) {
    bool wanted = false;
    bool visited = false;
    for (unsigned self = 0; self < robots(); self++) {
      if (!(alive >> self & 1u)) continue;
      wanted = wanted || can_reach(self, place);
      visited = visited || qtr_places_has(&diaries[self].visited, place);
    }
    TEST_ASSERT_EQUAL_MESSAGE(wanted, visited, case_note);
  }
}

static void test_any_survivors_that_hear_one_another_leave_nothing_out(void) {
  for (unsigned number = 0; number < random_cases(150); number++) {
    random_robots("survivors", number);
    test_random random = random_case("survivors", number + 1000000);
    for (unsigned alive = 1; alive < 1u << robots(); alive++) {
      start_robots(NULL);
      run_survivors(&random, alive);
      expect_survivors_were_enough(alive);
    }
  }
}

/* A territory announced is one that has been scanned whole, by those who can say so. */
static void test_territory_is_announced_once_and_only_when_scanned(void) {
  for (unsigned number = 0; number < random_cases(300); number++) {
    random_robots("announced", number);
    for (unsigned self = 0; self < robots(); self++) {
      run_alone(self);
      for (unsigned territory = 0; territory < robots(); territory++) {
        uint16_t route[QTR_MAX_PLACES];
        bool all = true;
        for (unsigned i = best_route(territory, route); i-- > 0;) all = all && can_reach(self, route[i]);
        TEST_ASSERT_EQUAL_MESSAGE(all, diaries[self].announced[territory], case_note);
      }
    }
  }
}

/* Two parts that are cut off from one another: each robot does its own and says so, and does not speak for the
 * other. */
static void test_territory_out_of_reach_is_not_announced_as_done(void) {
  table_draw("S1.#.2S", 0);
  start_robots(NULL);
  run_alone(0);
  TEST_ASSERT_EQUAL(1, diaries[0].visits);
  TEST_ASSERT_EQUAL(1, diaries[0].announced[0]);
  TEST_ASSERT_EQUAL(0, diaries[0].announced[1]);
}

static void test_announcement_is_made_when_the_last_place_is_visited(void) {
  table_draw("1.1.S.2", 2);
  start_robots(NULL);
  const unsigned left = qtr_seeker_target(&seeker[0]) == 2 ? 1 : 0; /* the robot that goes left */
  TEST_ASSERT_EQUAL_HEX16(1, qtr_seeker_target(&seeker[left]));
  visit_target(left);
  TEST_ASSERT_EQUAL(0, diaries[left].announced[left]);
  visit_target(left);
  TEST_ASSERT_EQUAL(1, diaries[left].announced[left]);
  TEST_ASSERT_EQUAL_HEX16(2, qtr_seeker_target(&seeker[left])); /* on with its neighbour's */
  visit_target(left);
  TEST_ASSERT_EQUAL(1, diaries[left].announced[1 - left]);
  TEST_ASSERT_TRUE(is_idle(left));
}

static void test_territory_heard_to_be_done_is_skipped(void) {
  table_draw("1.1.S.2", 2);
  start_robots(NULL);
  const unsigned left = qtr_seeker_target(&seeker[0]) == 2 ? 1 : 0;
  tell(left, QTR_SIGNAL_TERRITORY_DONE, 1 - left);
  visit_target(left);
  visit_target(left);
  TEST_ASSERT_TRUE(is_idle(left));
  TEST_ASSERT_EQUAL(0, diaries[left].announced[1 - left]);
}

static void test_territory_done_by_another_is_left_at_once(void) {
  table_draw("1.1.S.2", 2);
  start_robots(NULL);
  const unsigned left = qtr_seeker_target(&seeker[0]) == 2 ? 1 : 0;
  tell(left, QTR_SIGNAL_TERRITORY_DONE, left);
  TEST_ASSERT_EQUAL_HEX16(2, qtr_seeker_target(&seeker[left]));
  TEST_ASSERT_EQUAL(0, diaries[left].announced[left]);
}

static void test_all_stop_when_the_target_is_found(void) {
  for (unsigned number = 0; number < random_cases(100); number++) {
    random_robots("found", number);
    for (unsigned self = 0; self < robots(); self++) {
      for (unsigned visits = number % 4; visits > 0 && !is_idle(self); visits--) visit_target(self);
      const unsigned done = diaries[self].visits;
      tell(self, QTR_SIGNAL_FOUND, 0);
      TEST_ASSERT_TRUE_MESSAGE(is_idle(self), case_note);
      qtr_seeker_visited(&seeker[self], qtr_seeker_target(&seeker[self]));
      tell(self, QTR_SIGNAL_TERRITORY_DONE, 0);
      tell(self, QTR_SIGNAL_FOUND, 77);
      take_announcements(self);
      TEST_ASSERT_TRUE_MESSAGE(is_idle(self), case_note);
      TEST_ASSERT_EQUAL_MESSAGE(done, diaries[self].visits, case_note);
    }
  }
}

/* ---- set-up ---- */

static void test_robot_of_no_such_number_is_refused(void) {
  table_draw("1.1.S.2", 2);
  start_robots(NULL);
  TEST_ASSERT_EQUAL_INT(QTR_ERR_ARGUMENT, qtr_seeker_init(&seeker[0], &policy[0], 2, NULL, 0));
  TEST_ASSERT_EQUAL_INT(QTR_ERR_ARGUMENT, qtr_seeker_init(&seeker[0], &policy[0], 0xFFFFFFFF, NULL, 0));
}

static void test_all_cleared_leaves_nothing_to_do(void) {
  qtr_places cleared;
  table_draw("1.1.S.2", 2);
  memset(&cleared, 0xFF, sizeof cleared);
  start_robots(&cleared);
  for (unsigned self = 0; self < 2; self++) {
    TEST_ASSERT_TRUE(is_idle(self));
    TEST_ASSERT_EQUAL(1, diaries[self].announced[self]);
  }
}

static void test_robot_standing_on_a_place_visits_it_first(void) {
  mission_draw(&table_mission, "2.S..1");
  table_mission.start[0] = table_mission.place[1];
  table_learn(100);
  table_export();
  start_robots(NULL);
  TEST_ASSERT_EQUAL_HEX16(1, qtr_seeker_target(&seeker[0]));
  visit_target(0);
  TEST_ASSERT_EQUAL_HEX16(0, qtr_seeker_target(&seeker[0]));
}

/* A signal on the way changes the target: the place that was driven to all the same is not taken for the new one. */
static void test_a_place_scanned_late_is_not_taken_for_the_new_target(void) {
  table_draw("1S..........\n1...........\n............1", 2);
  start_robots(NULL);
  const uint16_t first = qtr_seeker_target(&seeker[0]);
  tell(0, QTR_SIGNAL_TERRITORY_DONE, 0);
  const uint16_t second = qtr_seeker_target(&seeker[0]);
  TEST_ASSERT_TRUE(second != first && second != QTR_STAND_DOWN);
  qtr_seeker_visited(&seeker[0], first);
  TEST_ASSERT_EQUAL_UINT16(second, qtr_seeker_target(&seeker[0]));
  take_announcements(0);
  TEST_ASSERT_EQUAL_UINT(0, diaries[0].announced[1]);
  qtr_seeker_visited(&seeker[0], 60000);
  TEST_ASSERT_EQUAL_UINT16(second, qtr_seeker_target(&seeker[0]));
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_robots_together_play_the_best_game);
  RUN_TEST(test_walk_on_the_grid_takes_the_nominal_time);
  RUN_TEST(test_single_survivor_scans_every_place_in_its_reach);
  RUN_TEST(test_neighbours_territories_follow_in_turn_from_alternate_ends);
  RUN_TEST(test_survivors_do_not_repeat_one_another_within_a_pass);
  RUN_TEST(test_cleared_places_are_not_visited_again);
  RUN_TEST(test_territories_left_by_a_cleared_set_cover_the_rest);
  RUN_TEST(test_any_survivors_that_hear_one_another_leave_nothing_out);
  RUN_TEST(test_territory_is_announced_once_and_only_when_scanned);
  RUN_TEST(test_territory_out_of_reach_is_not_announced_as_done);
  RUN_TEST(test_announcement_is_made_when_the_last_place_is_visited);
  RUN_TEST(test_territory_heard_to_be_done_is_skipped);
  RUN_TEST(test_territory_done_by_another_is_left_at_once);
  RUN_TEST(test_all_stop_when_the_target_is_found);
  RUN_TEST(test_robot_of_no_such_number_is_refused);
  RUN_TEST(test_all_cleared_leaves_nothing_to_do);
  RUN_TEST(test_robot_standing_on_a_place_visits_it_first);
  RUN_TEST(test_a_place_scanned_late_is_not_taken_for_the_new_target);
  return UNITY_END();
}

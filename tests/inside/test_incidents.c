/* profiles: host mcu */
/* No false "done", whatever happens: power cuts, shut doors, lost robots, robots of another table, other starts or
 * another search, at any moment and all at once. What a robot believes to be done has been scanned by somebody, and all
 * survivors come to an end. */
#include <string.h>

#include "quarter/seeker.h"
#include "support/forging.h"

enum { MOST_SEEKERS = 4, TABLES = 2, NOBODY = -1 };

static uint8_t bytes[TABLES][TABLE_MOST]; /* two tables of one mission that divide it differently */
static qtr_policy policy[TABLES];
static qtr_seeker seeker[MOST_SEEKERS];

/* The world: what is true, whatever robots believe. */
static struct {
  bool alive[MOST_SEEKERS];
  qtr_places scanned;
  qtr_places by[MOST_SEEKERS]; /* scanned by each robot */
  qtr_places shut;             /* no way to these places */
  uint8_t save[MOST_SEEKERS][QTR_SAVE_BYTES];
  qtr_places cleared; /* before the start */
} world;

void setUp(void) {
}

void tearDown(void) {
}

static unsigned robots(void) {
  return policy[0].board.seekers;
}

static unsigned places(void) {
  return policy[0].board.places;
}

/* The same places under other weights: mostly another division. */
static void make_tables(const char *test, unsigned number) {
  test_random random = random_case(test, number);
  mission_random(&table_mission, &random, (mission_size){10, 8, 8, MOST_SEEKERS});
  for (int t = 0; t < TABLES; t++) {
    table_learn(3);
    table_export();
    memcpy(bytes[t], table_bytes, table_size);
    TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_OK, qtr_policy_open(&policy[t], bytes[t], table_size), case_note);
    for (unsigned p = 0; p < table_mission.places; p++) table_mission.weight[p] = 1.0 + random_below(&random, 9);
  }
}

static void begin(void) {
  memset(&world, 0, sizeof world);
  for (unsigned i = 0; i < robots(); i++) {
    world.alive[i] = true;
    TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_OK, qtr_seeker_init(&seeker[i], &policy[0], i, NULL, 0), case_note);
  }
}

/* ---- what holds at every moment ---- */

/* Whatever a robot takes for done has been scanned, place by place. */
static void expect_truth(unsigned i) {
  qtr_signal signal;
  const qtr_division *division = &seeker[i].division;
  for (unsigned n = 0; qtr_seeker_known(&seeker[i], n, &signal); n++)
    for (unsigned m = 0; m < division->moves; m++)
      if (division->seeker[m] == signal.territory)
        TEST_ASSERT_TRUE_MESSAGE(qtr_places_has(&world.scanned, division->place[m]), case_note);
}

/* What a robot says it has seen itself. */
static void expect_own(unsigned i, const qtr_signal *signal) {
  const qtr_division *division = &seeker[i].division;
  TEST_ASSERT_EQUAL_MESSAGE(QTR_SIGNAL_TERRITORY_DONE, signal->kind, case_note);
  for (unsigned m = 0; m < division->moves; m++)
    if (division->seeker[m] == signal->territory)
      TEST_ASSERT_TRUE_MESSAGE(qtr_places_has(&world.by[i], division->place[m]), case_note);
}

/* ---- what robots do ---- */

static void save(unsigned i) {
  TEST_ASSERT_GREATER_THAN_MESSAGE(0, qtr_seeker_save(&seeker[i], world.save[i], QTR_SAVE_BYTES), case_note);
}

/* Say what is to be said; each hearer hears it or not. */
static void speak(unsigned i, test_random *random, unsigned chance) {
  qtr_signal signal;
  while (qtr_seeker_announce(&seeker[i], &signal)) {
    uint8_t packet[QTR_SIGNAL_BYTES];
    qtr_signal heard;
    expect_own(i, &signal);
    qtr_signal_write(&signal, packet);
    TEST_ASSERT_TRUE(qtr_signal_read(&heard, packet, sizeof packet));
    for (unsigned j = 0; j < robots(); j++) {
      if (j == i || !world.alive[j] || !random_chance(random, chance)) continue;
      qtr_seeker_hear(&seeker[j], &heard);
      save(j);
      expect_truth(j);
    }
  }
  expect_truth(i);
  save(i);
}

/* Go to the target, and scan it if there is a way. */
static void move(unsigned i) {
  const uint16_t target = qtr_seeker_target(&seeker[i]);
  if (qtr_places_has(&world.shut, target)) {
    qtr_seeker_blocked(&seeker[i], target);
    return;
  }
  qtr_places_add(&world.scanned, target);
  qtr_places_add(&world.by[i], target);
  qtr_seeker_visited(&seeker[i], target);
}

static void power_cut(unsigned i) {
  const qtr_policy *mine = seeker[i].policy;
  memset(&seeker[i], 0xA5, sizeof seeker[i]);
  TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_OK, qtr_seeker_restore(&seeker[i], mine, i, world.save[i], QTR_SAVE_BYTES),
                                case_note);
}

static bool stands(unsigned i) {
  return !world.alive[i] || qtr_seeker_target(&seeker[i]) == QTR_STAND_DOWN;
}

/* Until all survivors stand, in any order; each turn `incident` may happen to the robot whose turn it is. */
static void play(test_random *random, unsigned chance, void (*incident)(unsigned i, test_random *random)) {
  unsigned turns = 0;
  for (bool on = true; on;) {
    on = false;
    for (unsigned i = 0; i < robots(); i++) {
      if (incident != NULL && world.alive[i]) incident(i, random);
      if (world.alive[i]) speak(i, random, chance);
      if (stands(i)) continue;
      on = true;
      TEST_ASSERT_LESS_THAN_MESSAGE(40u * MOST_SEEKERS * (places() + 1), turns++, case_note);
      if (random_chance(random, 50)) move(i);
      speak(i, random, chance);
    }
  }
}

static bool can_reach(unsigned i, unsigned place) {
  const qtr_board *board = &policy[0].board;
  return qtr_board_steps(board, i, (unsigned)board->places + board->start_of[i], place) != QTR_NEVER;
}

/* Who stands for "done" is right, and who stands for "blocked" left nothing that it could have scanned. */
static void expect_rightly_ended(void) {
  for (unsigned i = 0; i < robots(); i++) {
    qtr_places left;
    if (!world.alive[i]) continue;
    const unsigned count = qtr_seeker_left(&seeker[i], &left);
    const bool is_done = qtr_seeker_standing(&seeker[i]) == QTR_STANDS_DONE;
    TEST_ASSERT_EQUAL_MESSAGE(is_done ? QTR_STANDS_DONE : QTR_STANDS_BLOCKED, qtr_seeker_standing(&seeker[i]),
                              case_note);
    TEST_ASSERT_EQUAL_MESSAGE(is_done, count == 0, case_note);
    for (unsigned p = 0; p < places(); p++)
      if (qtr_places_has(&left, p))
        TEST_ASSERT_TRUE_MESSAGE(!can_reach(i, p) || qtr_places_has(&world.shut, p), case_note);
  }
}

/* ---- power cuts ---- */

/* Two of a kind; what happens to one happens to the other. */
static void tell_both(qtr_seeker *twin, unsigned i, unsigned territory) {
  const qtr_signal signal = {twin->identity, 0, QTR_SIGNAL_TERRITORY_DONE, (uint8_t)territory};
  qtr_seeker_hear(twin, &signal);
  qtr_seeker_hear(&seeker[i], &signal);
}

static void bring_both(qtr_seeker *twin, unsigned i, uint16_t place, bool is_shut) {
  if (is_shut) {
    qtr_seeker_blocked(twin, place);
    qtr_seeker_blocked(&seeker[i], place);
  } else {
    qtr_seeker_visited(twin, place);
    qtr_seeker_visited(&seeker[i], place);
  }
}

/* One of them has its power cut before each step. */
static void expect_the_same_from_both(unsigned i, test_random *random) {
  qtr_seeker twin = seeker[i];
  bool is_shut = false;
  /* On its last round a robot forgets with its power what it tried again. */
  while (qtr_seeker_target(&twin) != QTR_STAND_DOWN && !(is_shut && twin.last_round)) {
    const unsigned heard = random_below(random, 8);
    if (heard < robots()) tell_both(&twin, i, heard);
    save(i);
    power_cut(i);
    const uint16_t target = qtr_seeker_target(&twin);
    TEST_ASSERT_EQUAL_HEX16_MESSAGE(target, qtr_seeker_target(&seeker[i]), case_note);
    TEST_ASSERT_EQUAL_MESSAGE(qtr_seeker_territory(&twin), qtr_seeker_territory(&seeker[i]), case_note);
    is_shut = random_chance(random, 30);
    if (target != QTR_STAND_DOWN) bring_both(&twin, i, target, is_shut);
  }
}

static void test_a_restart_at_any_step_changes_nothing(void) {
  for (unsigned number = 0; number < random_cases(200); number++) {
    test_random random = random_case("restart", number);
    make_tables("restart", number);
    begin();
    for (unsigned i = 0; i < robots(); i++) expect_the_same_from_both(i, &random);
  }
}

/* Told again what was known, in any order, without a save. */
static void test_what_was_known_can_be_told_again_in_any_order(void) {
  for (unsigned number = 0; number < random_cases(200); number++) {
    test_random random = random_case("told", number);
    make_tables("told", number);
    begin();
    qtr_seeker again;
    unsigned order[QTR_MAX_PLACES];
    for (unsigned moves = random_below(&random, places() + 1); moves > 0 && !stands(0); moves--) move(0);
    TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_seeker_init(&again, &policy[0], 0, NULL, 0));
    for (unsigned p = 0; p < places(); p++) {
      const unsigned at = random_below(&random, p + 1);
      order[p] = order[at];
      order[at] = p;
    }
    for (unsigned p = 0; p < places(); p++)
      if (qtr_places_has(&world.by[0], order[p])) qtr_seeker_visited(&again, order[p]);
    TEST_ASSERT_EQUAL_HEX16_MESSAGE(qtr_seeker_target(&seeker[0]), qtr_seeker_target(&again), case_note);
    TEST_ASSERT_EQUAL_MEMORY_MESSAGE(&seeker[0].done, &again.done, sizeof again.done, case_note);
  }
}

static void cut_power(unsigned i, test_random *random) {
  if (random_chance(random, 40)) power_cut(i);
}

static void test_power_cuts_leave_nothing_out(void) {
  for (unsigned number = 0; number < random_cases(200); number++) {
    test_random random = random_case("power", number);
    make_tables("power", number);
    begin();
    for (unsigned i = 0; i < robots(); i++) save(i);
    play(&random, 50, cut_power);
    expect_rightly_ended();
    for (unsigned p = 0; p < places(); p++) TEST_ASSERT_TRUE_MESSAGE(qtr_places_has(&world.scanned, p), case_note);
  }
}

static void test_torn_and_foreign_saves_are_refused(void) {
  for (unsigned number = 0; number < random_cases(100); number++) {
    make_tables("torn", number);
    begin();
    move(0);
    const int32_t size = qtr_seeker_save(&seeker[0], world.save[0], QTR_SAVE_BYTES);
    uint8_t before[sizeof seeker[1]];
    memcpy(before, &seeker[1], sizeof before);
    for (int32_t at = 0; at < size; at++) {
      world.save[0][at] ^= (uint8_t)(1u << at % 8);
      TEST_ASSERT_EQUAL_INT(QTR_ERR_SAVE, qtr_seeker_restore(&seeker[1], &policy[0], 0, world.save[0], (uint32_t)size));
      TEST_ASSERT_EQUAL_INT(QTR_ERR_SAVE, qtr_seeker_restore(&seeker[1], &policy[0], 0, world.save[0], (uint32_t)at));
      world.save[0][at] ^= (uint8_t)(1u << at % 8);
    }
    TEST_ASSERT_EQUAL_INT(QTR_ERR_SAVE, qtr_seeker_restore(&seeker[1], &policy[0], 1, world.save[0], (uint32_t)size));
    if (memcmp(bytes[0], bytes[1], QTR_POLICY_CRC + 4) != 0)
      TEST_ASSERT_EQUAL_INT(QTR_ERR_SAVE, qtr_seeker_restore(&seeker[1], &policy[1], 0, world.save[0], (uint32_t)size));
    TEST_ASSERT_EQUAL_MEMORY(before, &seeker[1], sizeof before);
    TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_seeker_restore(&seeker[1], &policy[0], 0, world.save[0], (uint32_t)size));
  }
}

/* ---- shut doors ---- */

static void test_shut_doors_keep_their_territories_open(void) {
  for (unsigned number = 0; number < random_cases(300); number++) {
    test_random random = random_case("shut", number);
    make_tables("shut", number);
    begin();
    world.shut.word[0] = (uint32_t)random_bits(&random) & (uint32_t)random_bits(&random);
    play(&random, 50, NULL);
    expect_rightly_ended();
    for (unsigned p = 0; p < places(); p++)
      TEST_ASSERT_EQUAL_MESSAGE(!qtr_places_has(&world.shut, p), qtr_places_has(&world.scanned, p), case_note);
  }
}

static void test_a_door_that_opens_in_time_is_tried_again(void) {
  for (unsigned number = 0; number < random_cases(200); number++) {
    make_tables("opens", number);
    begin();
    for (unsigned w = 0; w < QTR_PLACE_WORDS; w++) world.shut.word[w] = 0xFFFFFFFF;
    for (unsigned p = 0; p < places() && !stands(0) && !seeker[0].last_round; p++) move(0);
    memset(&world.shut, 0, sizeof world.shut);
    while (!stands(0)) move(0);
    for (unsigned p = 0; p < places(); p++)
      TEST_ASSERT_EQUAL_MESSAGE(can_reach(0, p), qtr_places_has(&world.scanned, p), case_note);
  }
}

/* Blocked, and blocked again on the last round: no more; and not a third time. */
static void test_a_place_is_tried_twice_and_no_more(void) {
  for (unsigned number = 0; number < random_cases(200); number++) {
    unsigned tried[QTR_MAX_PLACES] = {0};
    make_tables("twice", number);
    begin();
    while (!stands(0)) {
      const uint16_t target = qtr_seeker_target(&seeker[0]);
      tried[target]++;
      qtr_seeker_blocked(&seeker[0], target);
    }
    for (unsigned p = 0; p < places(); p++) TEST_ASSERT_EQUAL_UINT(can_reach(0, p) ? 2 : 0, tried[p]);
    TEST_ASSERT_EQUAL(QTR_STANDS_BLOCKED, qtr_seeker_standing(&seeker[0]));
  }
}

/* ---- lost robots ---- */

static int told_lost = NOBODY;

static void lose(unsigned i, test_random *random) {
  unsigned alive = 0;
  for (unsigned j = 0; j < robots(); j++) alive += world.alive[j];
  if (alive > 1 && random_chance(random, 10)) world.alive[i] = false;
  if (!world.alive[i] && told_lost != NOBODY)
    for (unsigned j = 0; j < robots(); j++) qtr_seeker_lost(&seeker[j], i);
  if (told_lost != NOBODY && random_chance(random, 5)) qtr_seeker_lost(&seeker[i], random_below(random, robots() + 1));
}

static void test_lost_robots_are_taken_over_whether_anybody_is_told(void) {
  for (unsigned number = 0; number < random_cases(400); number++) {
    test_random random = random_case("lost", number);
    make_tables("lost", number);
    begin();
    told_lost = number % 2 == 0 ? NOBODY : 0;
    play(&random, 70, lose);
    expect_rightly_ended();
  }
}

/* Robot 0 has scanned all that it can reach of a territory. */
static bool is_through(unsigned territory) {
  const qtr_division *division = &seeker[0].division;
  for (unsigned m = 0; m < division->moves; m++)
    if (division->seeker[m] == territory && can_reach(0, division->place[m]) &&
        !qtr_places_has(&world.by[0], division->place[m]))
      return false;
  return true;
}

/* Told that a seeker is lost, a robot goes there right after its own. */
static void test_the_territory_of_a_lost_robot_comes_right_after_the_own(void) {
  for (unsigned number = 0; number < random_cases(300); number++) {
    test_random random = random_case("next", number);
    make_tables("next", number);
    begin();
    const unsigned lost = random_below(&random, robots());
    const unsigned when = random_below(&random, places() + 1);
    for (unsigned n = 0; !stands(0); n++) {
      const unsigned before = qtr_seeker_territory(&seeker[0]);
      if (n == when) qtr_seeker_lost(&seeker[0], lost);
      const unsigned now = qtr_seeker_territory(&seeker[0]);
      TEST_ASSERT_TRUE_MESSAGE(before != 0 || now == 0, case_note);
      TEST_ASSERT_TRUE_MESSAGE(n < when || now == 0 || now == lost || is_through(lost), case_note);
      move(0);
    }
  }
}

/* ---- robots of another search ---- */

static void deploy_otherwise(unsigned i, test_random *random) {
  const unsigned what = random_below(random, 4);
  qtr_deployment deployment;
  qtr_places cleared;
  memset(&cleared, 0, sizeof cleared);
  const qtr_policy *table = &policy[what == 1];
  if (what == 2) cleared.word[0] = (uint32_t)random_bits(random) & (uint32_t)random_bits(random);
  TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_deployment_init(&deployment, table, NULL, &cleared));
  if (what == 3) deployment.start_of[0] = deployment.start_of[robots() - 1];
  for (unsigned p = 0; p < places(); p++)
    if (qtr_places_has(&deployment.cleared, p)) qtr_places_add(&world.scanned, p); /* somebody said so */
  TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_seeker_init(&seeker[i], table, i, &deployment, random_below(random, 2)));
}

static void test_robots_of_different_searches_do_not_believe_one_another(void) {
  for (unsigned number = 0; number < random_cases(400); number++) {
    test_random random = random_case("mixed", number);
    make_tables("mixed", number);
    begin();
    for (unsigned i = 0; i < robots(); i++) deploy_otherwise(i, &random);
    play(&random, 80, NULL);
    for (unsigned i = 0; i < robots(); i++)
      for (unsigned m = 0; m < seeker[i].division.moves; m++)
        TEST_ASSERT_TRUE_MESSAGE(qtr_seeker_standing(&seeker[i]) != QTR_STANDS_DONE ||
                                     qtr_places_has(&world.scanned, seeker[i].division.place[m]),
                                 case_note);
  }
}

/* A table, a start, a cleared place or a run apart: each makes another search of it, and what is counted says so. */
static void test_what_tells_searches_apart(void) {
  qtr_deployment home, other;
  table_draw("S..1..S/...2...", 0);
  memcpy(bytes[0], table_bytes, table_size);
  TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_policy_open(&policy[0], bytes[0], table_size));
  TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_deployment_init(&home, &policy[0], NULL, NULL));
  other = home;
  TEST_ASSERT_EQUAL_HEX32(qtr_deployment_identity(&home, &policy[0]), qtr_deployment_identity(&other, &policy[0]));
  qtr_places_add(&other.cleared, 1);
  TEST_ASSERT_TRUE(qtr_deployment_identity(&home, &policy[0]) != qtr_deployment_identity(&other, &policy[0]));
  other = home;
  other.start_of[0] = home.start_of[1];
  TEST_ASSERT_TRUE(qtr_deployment_identity(&home, &policy[0]) != qtr_deployment_identity(&other, &policy[0]));
  TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_seeker_init(&seeker[0], &policy[0], 0, &home, 8));
  const uint32_t identity = qtr_deployment_identity(&home, &policy[0]);
  const qtr_signal ours = {identity, 8, QTR_SIGNAL_TERRITORY_DONE, 1};
  const qtr_signal other_run = {identity, 7, QTR_SIGNAL_FOUND, 0};
  const qtr_signal other_table = {identity ^ 0x80000000u, 8, QTR_SIGNAL_FOUND, 0};
  TEST_ASSERT_TRUE(qtr_seeker_hear(&seeker[0], &ours));
  TEST_ASSERT_FALSE(qtr_seeker_hear(&seeker[0], &other_run));
  TEST_ASSERT_FALSE(qtr_seeker_hear(&seeker[0], &other_table));
  TEST_ASSERT_EQUAL_UINT32(2, qtr_seeker_foreign(&seeker[0]));
  TEST_ASSERT_EQUAL(QTR_UNDER_WAY, qtr_seeker_standing(&seeker[0]));
}

/* ---- all at once ---- */

static void anything(unsigned i, test_random *random) {
  cut_power(i, random);
  lose(i, random);
  if (random_chance(random, 10)) world.shut.word[0] ^= 1u << random_below(random, places());
}

static void test_all_incidents_at_once(void) {
  for (unsigned number = 0; number < random_cases(400); number++) {
    test_random random = random_case("all", number);
    make_tables("all", number);
    begin();
    told_lost = 0;
    if (number % 4 == 0)
      for (unsigned i = 0; i < robots(); i++) deploy_otherwise(i, &random);
    for (unsigned i = 0; i < robots(); i++) save(i);
    play(&random, 60, anything);
  }
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_a_restart_at_any_step_changes_nothing);
  RUN_TEST(test_what_was_known_can_be_told_again_in_any_order);
  RUN_TEST(test_power_cuts_leave_nothing_out);
  RUN_TEST(test_torn_and_foreign_saves_are_refused);
  RUN_TEST(test_shut_doors_keep_their_territories_open);
  RUN_TEST(test_a_door_that_opens_in_time_is_tried_again);
  RUN_TEST(test_a_place_is_tried_twice_and_no_more);
  RUN_TEST(test_lost_robots_are_taken_over_whether_anybody_is_told);
  RUN_TEST(test_the_territory_of_a_lost_robot_comes_right_after_the_own);
  RUN_TEST(test_robots_of_different_searches_do_not_believe_one_another);
  RUN_TEST(test_what_tells_searches_apart);
  RUN_TEST(test_all_incidents_at_once);
  return UNITY_END();
}

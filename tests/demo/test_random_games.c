/* Games on random maps: what the robots were sent to do they do, whoever is lost, and in whatever order they meet. */
#include "game.h"
#include "quarter/division.h"
#include "support/tables.h"

static table t;
static arena end; /* as it was at the end; its world is gone */
static game_result result;
static fault why;

void setUp(void) {
  snprintf(case_note, sizeof case_note, "by hand");
}

void tearDown(void) {
}

/* Ground of cost 4 at most: on the slowest there is, games would take hours. */
static void random_table(test_random *random, mission_size most) {
  mission_random(&table_mission, random, most);
  for (int cell = 0; cell < table_mission.columns * table_mission.rows; cell++)
    if (table_mission.cost[cell] > 4) table_mission.cost[cell] = 4;
  table_learn(3);
  table_export();
  table_open(&t.policy);
  t.bytes.data = table_bytes;
  t.bytes.size = table_size;
}

static int keep(void *user, const arena *a, const game_result *r, fault *f) {
  (void)user;
  (void)r;
  (void)f;
  end = *a;
  return 0;
}

static void play(arena_setup setup) {
  const game_setup whole = {.t = &t, .arena = setup, .finish = keep};
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, game_play(&whole, &result, NULL, &why), why.text);
  const size_t length = strlen(case_note);
  snprintf(case_note + length, sizeof case_note - length,
           ": %d of %d scanned, %d deadlocks, found %.1f, stopped %.1f of %.1f s", result.scanned, end.places,
           result.deadlocks, result.found_at, result.all_stopped_at, result.duration);
}

/* Where somebody can go, somebody goes; who has nothing left to do stops, and so the game ends before its time. */
static void test_without_a_mine_every_place_is_scanned(void) {
  for (unsigned number = 0; number < 100; number++) {
    test_random random = random_case("every place", number);
    random_table(&random, (mission_size){8, 8, 5, 4});
    play((arena_setup){.seed = number, .mine = -2, .time_limit = 1500});
    TEST_ASSERT_EQUAL_INT_MESSAGE(end.places, result.scanned, case_note);
    TEST_ASSERT_TRUE_MESSAGE(result.all_stopped_at >= 0.0, case_note);
    TEST_ASSERT_EQUAL_INT_MESSAGE(0, result.deadlocks, case_note);
  }
}

static void test_in_clear_all_every_territory_is_announced(void) {
  for (unsigned number = 0; number < 40; number++) {
    test_random random = random_case("clear all", number);
    random_table(&random, (mission_size){8, 8, 5, 3});
    play((arena_setup){.seed = number, .clear_all = true, .mine = -1, .time_limit = 1500});
    TEST_ASSERT_EQUAL_INT_MESSAGE(end.places, result.scanned, case_note);
    for (int i = 0; i < end.robots; i++) TEST_ASSERT_TRUE_MESSAGE(end.done[i], case_note);
    TEST_ASSERT_TRUE_MESSAGE(result.found_at >= 0.0, case_note);
  }
}

static bool all_start_together(void) {
  for (int i = 1; i < table_mission.seekers; i++)
    if (table_mission.start[i] != table_mission.start[0]) return false;
  return table_mission.seekers > 1;
}

/* Robots that start together can all go everywhere. One lost robot leaves room to pass it; two abreast may plug a
 * corridor. */
static void test_with_any_one_robot_lost_anywhere_it_is_found(void) {
  for (unsigned number = 0; number < 70; number++) {
    test_random random = random_case("one robot lost", number);
    fault_script script = {0};
    do random_table(&random, (mission_size){8, 8, 5, 4});
    while (!all_start_together());
    const int lost = (int)random_below(&random, table_mission.seekers);
    faults_add(&script, (fault_event){12.0 * random_unit(&random), FAULT_LOST, lost, 0.0, 0});
    play((arena_setup){.seed = number, .mine = -1, .faults = &script, .time_limit = 1500});
    TEST_ASSERT_TRUE_MESSAGE(result.found_at >= 0.0, case_note);
    TEST_ASSERT_TRUE_MESSAGE(result.all_stopped_at >= 0.0, case_note);
  }
}

/* ---- whatever goes wrong ---- */

static qtr_cell random_free_cell(test_random *random) {
  const qtr_grid *grid = &t.policy.grid;
  for (;;) {
    const qtr_cell cell = (qtr_cell)random_below(random, qtr_grid_cells(grid));
    if (qtr_grid_cost(grid, cell) > 0) return cell;
  }
}

/* Power that fails is there again, wheels that are stuck go again; what is shut stays so. */
static void add_fault(fault_script *script, test_random *random) {
  static const int kinds[] = {FAULT_LOST, FAULT_STUCK, FAULT_SLIP, FAULT_LOSS, FAULT_SHUT, FAULT_RESET, FAULT_RESET};
  fault_event fault = {.at = 15.0 * random_unit(random), .kind = kinds[random_below(random, 7)]};
  fault.robot = (int)random_below(random, table_mission.seekers);
  fault.share = 0.8 * random_unit(random);
  fault.cell = random_bits(random) % 2 == 0 ? qtr_policy_cell(&t.policy, random_below(random, table_mission.places))
                                            : random_free_cell(random);
  faults_add(script, fault);
  if (fault.kind != FAULT_STUCK && fault.kind != FAULT_RESET) return;
  fault.kind = fault.kind == FAULT_STUCK ? FAULT_UNSTUCK : FAULT_RESTART;
  fault.at += 1.0 + 15.0 * random_unit(random);
  faults_add(script, fault);
}

static bool is_scanned_by(const qtr_division *division, int territory, double at) {
  for (unsigned i = 0; i < division->moves; i++) {
    const unsigned place = division->place[i];
    if (division->seeker[i] == territory && (end.scanned_by[place] < 0 || end.scanned_at[place] > at)) return false;
  }
  return true;
}

/* Lost, stuck, slipping, without power, deaf, before shut doors, several at once: who says that a territory is done, or
 * that the target is found, says what is so. */
static void test_whatever_goes_wrong_nobody_announces_what_nobody_has_scanned(void) {
  int announced = 0, left = 0;
  for (unsigned number = 0; number < 120; number++) {
    test_random random = random_case("several faults", number);
    fault_script script = {0};
    qtr_deployment home;
    qtr_division division;
    random_table(&random, (mission_size){8, 8, 5, 4});
    qtr_deployment_home(&home, &t.policy);
    qtr_division_begin(&division, &t.policy, &home);
    while (qtr_division_play(&division, &t.policy)) {}
    for (int faults = 0; faults < 5; faults++) add_fault(&script, &random);
    play((arena_setup){.seed = number, .clear_all = number % 4 != 0, .mine = -1, .faults = &script, .time_limit = 600});
    left += result.scanned < end.places;
    for (int i = 0; i < end.events; i++) {
      if (end.event[i].kind != EVENT_DONE) continue;
      announced++;
      TEST_ASSERT_TRUE_MESSAGE(is_scanned_by(&division, end.event[i].territory, end.event[i].at), case_note);
    }
  }
  TEST_ASSERT_GREATER_THAN_INT(60, announced);
  TEST_ASSERT_GREATER_THAN_INT(10, left);
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_without_a_mine_every_place_is_scanned);
  RUN_TEST(test_in_clear_all_every_territory_is_announced);
  RUN_TEST(test_with_any_one_robot_lost_anywhere_it_is_found);
  RUN_TEST(test_whatever_goes_wrong_nobody_announces_what_nobody_has_scanned);
  return UNITY_END();
}

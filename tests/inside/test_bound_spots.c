/* profiles: host mcu */
/* The bound of a game through spots, under either rule: never below the best that its own environment still earns, in
 * any state, found by going through all plays. */
#include <math.h>

#include "search/bound.h"
#include "support/learning.h"
#include "support/missions.h"
#include "support/random.h"
#include "support/settings.h"
#include "unity.h"

static qtr_mission mission;
static qtr_travel travel;
static qtr_game game;
static qtr_environment *spots;
static qtr_bound bound;
static double gains[QTR_GAINS_BYTES(1) / sizeof(double) + 1];
static long states, shared;
static double tightest; /* the least slack seen */

void setUp(void) {
  states = shared = 0;
  tightest = HUGE_VAL;
}

void tearDown(void) {
}

/* Two are on their way to one spot. */
static bool is_shared(const qtr_situation *situation) {
  for (unsigned i = 0; i < mission.seekers; i++)
    for (unsigned j = 0; j < i; j++)
      if (situation->joint.remaining[i] > 0 && situation->joint.remaining[j] > 0 &&
          situation->joint.node[i] == situation->joint.node[j])
        return true;
  return false;
}

static double best_from(const qtr_situation *situation);

/* What a choice brings, what it brings at once apart; each state after one is held against the bound. */
static double best_after(const qtr_situation *before, int seeker, uint16_t choice) {
  qtr_situation after = *before;
  qtr_outcome outcome;
  const double at_once = qtr_environment_choose(spots, &after, seeker, choice);
  const double upper = qtr_bound_state(&bound, &after);
  states++;
  shared += is_shared(&after);
  qtr_environment_pass(spots, &after, &outcome);
  const double best = outcome.reward + outcome.discount * best_from(&after);
  if (upper - best < tightest) tightest = upper - best;
  TEST_ASSERT_TRUE_MESSAGE(upper >= best - 1e-9 * fmax(1.0, fabs(best)), case_note);
  return at_once + best;
}

static double best_from(const qtr_situation *situation) {
  const int seeker = qtr_joint_chooser(&situation->joint, &spots->board);
  double best = -HUGE_VAL;
  qtr_places choices;
  if (seeker == QTR_NOBODY) return 0.0;
  if (qtr_joint_choices(&situation->joint, &spots->board, seeker, &choices))
    best = best_after(situation, seeker, QTR_STAND_DOWN);
  for (uint16_t target = 0; target < spots->board.places; target++)
    if (qtr_places_has(&choices, target)) best = fmax(best, best_after(situation, seeker, target));
  return best;
}

static double optimum(void) {
  qtr_situation start;
  qtr_outcome outcome;
  qtr_environment_start(spots, &start);
  qtr_environment_pass(spots, &start, &outcome);
  return outcome.reward + outcome.discount * best_from(&start);
}

static void set_up_spots(test_random *random) {
  const qtr_spots_config limits =
      spot_limits((uint8_t)random_in(random, 2, 4), (qtr_steps)random_in(random, 2, 12), 0.0);
  qtr_aggregation how = aggregation_of(&limits, NULL);
  how.rule = mission.rule;
  TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_OK, qtr_game_init(&game, &mission, &travel, NULL), case_note);
  game.board.rule = QTR_RULE_FREE;
  TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_OK, aggregate_init(&spots, &game, &how, &travel), case_note);
}

static void expect_bounded(void) {
  const double best = optimum();
  TEST_ASSERT_TRUE_MESSAGE(bound.upper >= best - 1e-9 * fmax(1.0, fabs(best)), case_note);
}

/* With the first prices and with the last. */
static void test_bound_is_never_below_what_spots_still_bring(void) {
  long both = 0;
  for (unsigned number = 0; number < 200; number++) {
    test_random random = random_case("spots", number);
    qtr_steps visit[QTR_MAX_PLACES];
    mission_random(&mission, &random, (mission_size){8, 6, 7, 3});
    set_up_spots(&random);
    if (spots->targets.count > 4) continue;
    for (unsigned place = 0; place < mission.places; place++) visit[place] = random_in(&random, 0, 20);
    qtr_bound_init(&bound, gains, spots, visit);
    expect_bounded();
    const double best = optimum();
    const double goal = best - 0.2 * fabs(best); /* as of a ground that earns less */
    for (unsigned step = 0; step < 200 && qtr_bound_improve(&bound, goal); step++) {}
    qtr_bound_settle(&bound);
    expect_bounded();
    both += mission.rule == QTR_RULE_PAPER && shared > 0;
  }
  TEST_ASSERT_GREATER_THAN(10000, states);
  TEST_ASSERT_GREATER_THAN(20, both);
  /* A bound that is always far above would prove nothing. */
  TEST_ASSERT_TRUE(tightest < 1e-6);
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_bound_is_never_below_what_spots_still_bring);
  return UNITY_END();
}

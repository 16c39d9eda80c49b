/* profiles: host mcu */
/* Games by legs, whose times need no triangle inequality: who goes by passes no third place, and what is proven holds
 * although a place may be reached sooner by way of another one. Held against all plays, and against dynamic programming
 * over sets of places. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "quarter/export.h"
#include "quarter/game.h"
#include "search/bound.h"
#include "support/brute.h"
#include "support/learning.h"
#include "support/random.h"
#include "unity.h"

enum { PLACES = 10, STARTS = 3, SEEKERS = 4 };

static qtr_mission mission;
static qtr_travel travel;
static qtr_game game;
static qtr_environment *ground;
static qtr_steps steps[(PLACES + STARTS) * PLACES], home[STARTS * PLACES];
static qtr_legs legs = {0, steps, home};

void setUp(void) {
}

void tearDown(void) {
}

/* ---- problems ---- */

static void begin(unsigned places, unsigned seekers, unsigned starts, int objective) {
  qtr_mission_default(&mission);
  mission.columns = mission.rows = 0;
  mission.aim.kind = (uint8_t)objective;
  mission.places = (uint16_t)places;
  mission.seekers = (uint8_t)seekers;
  legs.starts = starts;
  for (unsigned p = 0; p < places; p++) mission.weight[p] = 1.0;
  for (unsigned i = 0; i < seekers; i++) mission.start[i] = (qtr_cell)(i % starts);
}

static qtr_steps leg(unsigned from, unsigned to) {
  return steps[from * mission.places + to];
}

/* Half of them by chance alone, half rounded down from a plane, as tables of distances are; a few ways much longer than
 * those around. */
static void draw(test_random *random, unsigned places, unsigned seekers, int objective) {
  const unsigned starts = random_in(random, 1, STARTS);
  const bool plane = random_chance(random, 50);
  double x[PLACES + STARTS], y[PLACES + STARTS];
  begin(places, seekers, starts, objective);
  for (unsigned p = 0; p < places; p++) mission.weight[p] = random_in(random, 1, 9);
  for (unsigned node = 0; node < places + starts; node++) {
    x[node] = 30.0 * random_unit(random);
    y[node] = 30.0 * random_unit(random);
  }
  for (unsigned from = 0; from < places + starts; from++) {
    for (unsigned to = 0; to < places; to++) {
      const double apart = floor(hypot(x[from] - x[to], y[from] - y[to]));
      const qtr_steps direct = plane && !random_chance(random, 10) ? (qtr_steps)apart : random_in(random, 1, 40);
      steps[from * places + to] = direct > 0 ? direct : 1;
      if (from < starts) home[from * places + to] = random_in(random, 1, 40);
    }
  }
}

static void set_up_game(void) {
  TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_OK, qtr_game_init_legs(&game, &mission, &legs, NULL), case_note);
  TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_OK, ground_init(&ground, &game, &travel), case_note);
}

/* How many legs are longer than the way by way of a third place. */
static unsigned shortcuts(void) {
  unsigned count = 0;
  for (unsigned from = 0; from < mission.places + legs.starts; from++)
    for (unsigned to = 0; to < mission.places; to++)
      for (unsigned by = 0; by < mission.places && from != to; by++)
        count += by != from && by != to && leg(from, by) + leg(by, to) < leg(from, to);
  return count;
}

/* ---- dynamic programming over sets of places: one robot's best order for each set, then sets shared out ---- */

static double rest[1u << PLACES][PLACES + STARTS]; /* from a node on, of a set */
static double shared[SEEKERS + 1][1u << PLACES];

static double weight_of(unsigned set) {
  double all = 0.0;
  double part = 0.0;
  for (unsigned p = 0; p < mission.places; p++) {
    all += mission.weight[p];
    part += set >> p & 1u ? mission.weight[p] : 0.0;
  }
  return part / all;
}

/* What is won, counted from now, by going on to p; expected time is what is lost, below 0. */
static double by_going(unsigned set, unsigned from, unsigned p, double homeward) {
  const double way = leg(from, p);
  const double on = rest[set & ~(1u << p)][p];
  if (mission.aim.kind == QTR_TIME) return on - way * (weight_of(set) + homeward);
  return pow(mission.aim.gamma, way) * (10.0 * weight_of(1u << p) + on);
}

static void fill_rest(double homeward) {
  for (unsigned set = 0; set < 1u << mission.places; set++) {
    for (unsigned from = 0; from < mission.places + legs.starts; from++) {
      rest[set][from] = set != 0 ? -HUGE_VAL : from < mission.places ? -homeward * home[from] : 0.0;
      for (unsigned p = 0; p < mission.places; p++)
        if (set >> p & 1u) rest[set][from] = fmax(rest[set][from], by_going(set, from, p, homeward));
    }
  }
}

static double optimum_by_sets(void) {
  const double homeward = mission.aim.home_weight * weight_of(1u) / mission.weight[0];
  const unsigned all = (1u << mission.places) - 1;
  fill_rest(homeward);
  for (unsigned set = 0; set <= all; set++) shared[0][set] = set == 0 ? 0.0 : -HUGE_VAL;
  for (unsigned i = 0; i < mission.seekers; i++) {
    const unsigned start = mission.places + (unsigned)mission.start[i];
    for (unsigned set = 0; set <= all; set++) {
      shared[i + 1][set] = shared[i][set];
      for (unsigned own = set; own != 0; own = (own - 1) & set)
        shared[i + 1][set] = fmax(shared[i + 1][set], rest[own][start] + shared[i][set & ~own]);
    }
  }
  const double best = shared[mission.seekers][all];
  return mission.aim.kind == QTR_TIME ? -best : best / mission.aim.gamma;
}

/* ---- the learner ---- */

static void expect_certified_optimum(void) {
  qtr_learner_config config;
  qtr_learner *learner;
  qtr_certificate certificate;
  qtr_learner_config_default(&config);
  set_up_game();
  TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_OK, learner_init(&learner, ground, NULL, &config), case_note);
  while (qtr_learner_step(learner) == QTR_LEARNING) {}
  qtr_learner_certificate(learner, &certificate);
  const double optimum = optimum_by_sets();
  TEST_ASSERT_TRUE_MESSAGE(certificate.certified, case_note);
  TEST_ASSERT_DOUBLE_WITHIN_MESSAGE(1.1e-5 * optimum, optimum, certificate.objective, case_note);
  const double over = mission.aim.kind == QTR_TIME ? certificate.bound - optimum : optimum - certificate.bound;
  TEST_ASSERT_TRUE_MESSAGE(over <= 1e-9 * optimum, case_note);
}

static void test_learner_proves_the_optimum_of_legs_that_break_the_triangle_inequality(void) {
  unsigned broken = 0;
  for (unsigned number = 0; number < random_cases(60); number++) {
    test_random random = random_case("sets", number);
    const unsigned places = random_in(&random, 5, number % 6 == 0 ? PLACES : PLACES - 2);
    draw(&random, places, random_in(&random, 1, SEEKERS), number % 2 == 0 ? QTR_TIME : QTR_DISCOUNTED);
    broken += shortcuts() > 0;
    expect_certified_optimum();
  }
  TEST_ASSERT_GREATER_THAN_UINT(random_cases(60) / 2, broken);
}

static void test_learner_proves_the_optimum_of_legs_with_the_way_home(void) {
  for (unsigned number = 0; number < random_cases(30); number++) {
    test_random random = random_case("sets and home", number);
    draw(&random, random_in(&random, 5, PLACES - 2), 1, QTR_TIME);
    mission.aim.home_weight = 1.0;
    expect_certified_optimum();
  }
}

/* ---- the bound, in every state of small games ---- */

static brute_game brute;
static qtr_bound bound;
static long states_seen;

static void set_up_brute(void) {
  double sum = 0.0;
  memset(&brute, 0, sizeof brute);
  brute.places = mission.places;
  brute.seekers = mission.seekers;
  brute.time = mission.aim.kind == QTR_TIME;
  brute.gamma = mission.aim.gamma;
  for (unsigned p = 0; p < mission.places; p++) sum += mission.weight[p];
  for (unsigned p = 0; p < mission.places; p++) brute.probability[p] = mission.weight[p] / sum;
  for (unsigned node = 0; node < mission.places + legs.starts; node++)
    for (unsigned p = 0; p < mission.places; p++) brute.way[node][p] = node == p ? 0 : (long)leg(node, p);
  for (unsigned i = 0; i < mission.seekers; i++) brute.start[i] = mission.places + (int)mission.start[i];
}

static void situation_of(qtr_situation *situation, const brute_state *state) {
  memset(situation, 0, sizeof *situation);
  situation->joint.now = (qtr_steps)state->now;
  for (unsigned place = 0; place < mission.places; place++) {
    if (state->visited >> place & 1u) {
      qtr_places_add(&situation->joint.visited, place);
    } else {
      situation->joint.unvisited++;
      situation->unvisited += game.probability[place];
    }
    if (brute_bound(&brute, state) >> place & 1u) qtr_places_add(&situation->joint.bound, place);
  }
  for (unsigned i = 0; i < mission.seekers; i++) {
    situation->joint.node[i] = state->node[i] == BRUTE_GONE ? QTR_STAND_DOWN : (uint16_t)state->node[i];
    situation->joint.remaining[i] = (qtr_steps)state->left[i];
    situation->at[i] = situation->joint.node[i];
  }
}

static void expect_bound_above(const brute_game *played, const brute_state *after, double best) {
  qtr_situation situation;
  (void)played;
  states_seen++;
  if (best == -HUGE_VAL) return; /* places were given up: the core allows no such state */
  situation_of(&situation, after);
  const double from_now =
      brute.time ? best + (double)after->now * situation.unvisited : best / pow(mission.aim.gamma, (double)after->now);
  TEST_ASSERT_TRUE_MESSAGE(qtr_bound_state(&bound, &situation) >= from_now - 1e-9 * fmax(1.0, fabs(from_now)),
                           case_note);
}

static double look_at_all_states(void) {
  brute.look = expect_bound_above;
  const double optimum = brute_optimum(&brute);
  brute.look = NULL;
  return optimum;
}

/* Places one after another by the first seeker: a play to begin from. */
static void visit_in_turn(qtr_steps *visit) {
  qtr_steps when = leg(mission.places + (unsigned)mission.start[0], 0);
  for (unsigned p = 0; p < mission.places; p++) {
    visit[p] = when;
    if (p + 1u < mission.places) when += leg(p, p + 1);
  }
}

static void check_bound(void) {
  qtr_steps visit[PLACES];
  void *block = malloc(qtr_gains_bytes(&game));
  TEST_ASSERT_NOT_NULL(block);
  set_up_brute();
  visit_in_turn(visit);
  qtr_bound_init(&bound, block, ground, visit);
  const double optimum = look_at_all_states();
  TEST_ASSERT_TRUE_MESSAGE(bound.upper >= optimum - 1e-9 * fabs(optimum), case_note);
  for (unsigned step = 0; step < 2000 && qtr_bound_improve(&bound, optimum); step++)
    TEST_ASSERT_TRUE_MESSAGE(bound.upper >= optimum - 1e-9 * fabs(optimum), case_note);
  qtr_bound_settle(&bound);
  look_at_all_states();
  free(block);
}

static void test_bound_is_never_below_the_optimum_of_legs_in_any_state(void) {
  states_seen = 0;
  for (unsigned number = 0; number < random_cases(120); number++) {
    test_random random = random_case("states", number);
    const unsigned seekers = random_in(&random, 1, 3);
    draw(&random, random_in(&random, 3, seekers == 1 ? 6 : 5), seekers, number % 2 == 0 ? QTR_TIME : QTR_DISCOUNTED);
    set_up_game();
    check_bound();
  }
  TEST_ASSERT_GREATER_THAN_INT(1000, states_seen);
}

/* ---- what legs are ---- */

static void set_leg(unsigned from, unsigned to, qtr_steps way) {
  steps[from * mission.places + to] = way;
}

/* From 0 to 2 it takes 10 steps, by way of 1 only 2; from the start 1, 2 and 9. Who goes by way of 1 visits it. */
static void line_of_three(void) {
  begin(3, 1, 1, QTR_TIME);
  for (unsigned from = 0; from < 4; from++)
    for (unsigned to = 0; to < 3; to++) set_leg(from, to, 10);
  set_leg(0, 1, 1);
  set_leg(1, 2, 1);
  set_leg(3, 0, 1);
  set_leg(3, 1, 2);
  set_leg(3, 2, 9);
}

static void test_who_goes_by_visits_nothing_on_the_way(void) {
  static const uint16_t order[3] = {0, 2, 1};
  qtr_state state;
  qtr_outcome outcome;
  line_of_three();
  set_up_game();
  qtr_game_start(&game, &state);
  for (unsigned i = 0; i < 3; i++) {
    qtr_game_choose(&game, &state, 0, order[i]);
    qtr_game_pass(&game, &state, &outcome);
    TEST_ASSERT_EQUAL_UINT(i == 0 ? 2 : 2 - i, state.joint.unvisited);
  }
  TEST_ASSERT_EQUAL_UINT(1 + 10 + 10, state.joint.now);
}

static int init(void) {
  return qtr_game_init_legs(&game, &mission, &legs, NULL);
}

static void test_legs_of_no_length_and_terms_that_need_a_map_are_refused(void) {
  line_of_three();
  set_leg(3, 0, 0); /* a start may lie on a place */
  TEST_ASSERT_EQUAL_INT(QTR_OK, init());
  set_leg(1, 0, 0);
  TEST_ASSERT_EQUAL_INT(QTR_ERR_ARGUMENT, init());
  line_of_three();
  mission.rule = QTR_RULE_PAPER;
  TEST_ASSERT_EQUAL_INT(QTR_ERR_ARGUMENT, init());
  line_of_three();
  mission.robot_class[0].scan[1] = 1;
  TEST_ASSERT_EQUAL_INT(QTR_ERR_ARGUMENT, init());
  line_of_three();
  mission.looks[2] = 2;
  mission.detection[2] = 0.5;
  TEST_ASSERT_EQUAL_INT(QTR_ERR_ARGUMENT, init());
  line_of_three();
  mission.start[0] = 1;
  TEST_ASSERT_EQUAL_INT(QTR_ERR_ARGUMENT, init());
  line_of_three();
  mission.columns = mission.rows = 1;
  TEST_ASSERT_EQUAL_INT(QTR_ERR_ARGUMENT, init());
}

static void test_no_table_is_exported_and_nothing_aggregated_of_legs(void) {
  uint8_t byte;
  qtr_learner_config config;
  qtr_learner *learner;
  qtr_aggregation how;
  qtr_environment *aggregate;
  line_of_three();
  set_up_game();
  qtr_learner_config_default(&config);
  TEST_ASSERT_EQUAL_INT(QTR_OK, learner_init(&learner, ground, NULL, &config));
  TEST_ASSERT_EQUAL_UINT(0, qtr_export_size(learner));
  TEST_ASSERT_EQUAL_INT(QTR_ERR_ARGUMENT, qtr_export(learner, &byte, sizeof byte));
  qtr_aggregation_default(&how);
  how.by_spots = true;
  TEST_ASSERT_EQUAL_INT(QTR_ERR_ARGUMENT, aggregate_init(&aggregate, &game, &how, &travel));
  how.by_spots = false;
  how.rule = QTR_RULE_PAPER;
  TEST_ASSERT_EQUAL_INT(QTR_ERR_ARGUMENT, aggregate_init(&aggregate, &game, &how, &travel));
}

static void test_without_a_way_home_who_must_come_home_is_refused(void) {
  const qtr_legs no_home = {1, steps, NULL};
  line_of_three();
  mission.aim.home_weight = 1.0;
  TEST_ASSERT_EQUAL_INT(QTR_ERR_ARGUMENT, qtr_game_init_legs(&game, &mission, &no_home, NULL));
  TEST_ASSERT_EQUAL_INT(QTR_OK, init());
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_learner_proves_the_optimum_of_legs_that_break_the_triangle_inequality);
  RUN_TEST(test_learner_proves_the_optimum_of_legs_with_the_way_home);
  RUN_TEST(test_bound_is_never_below_the_optimum_of_legs_in_any_state);
  RUN_TEST(test_who_goes_by_visits_nothing_on_the_way);
  RUN_TEST(test_legs_of_no_length_and_terms_that_need_a_map_are_refused);
  RUN_TEST(test_no_table_is_exported_and_nothing_aggregated_of_legs);
  RUN_TEST(test_without_a_way_home_who_must_come_home_is_refused);
  return UNITY_END();
}

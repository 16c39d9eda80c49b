/* The exact solver against hand-computed games, and against a plain enumeration of whole games: no memory of states, no
 * subsets, nothing in common with the solver but the rules. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "exact.h"
#include "unity.h"

enum { MOST_SEEKERS = 4, MOST_PLACES = 24 };

static qtr_mission mission;
static qtr_steps steps[(MOST_SEEKERS + MOST_PLACES) * MOST_PLACES];
static exact_solution solution;
static fault why;

void setUp(void) {
  qtr_mission_default(&mission);
  memset(&solution, 0, sizeof solution);
  memset(&why, 0, sizeof why);
  mission.columns = 100;
  mission.rows = 1;
  mission.aim.gamma = 0.9;
}

void tearDown(void) {
}

/* ---- hand-computed games, on a corridor: cells are positions, unit steps ---- */

static void corridor(int seekers, const int *starts, int places, const int *cells, const double *weights) {
  mission.seekers = (uint8_t)seekers;
  mission.places = (uint16_t)places;
  for (int i = 0; i < seekers; i++) mission.start[i] = (qtr_cell)starts[i];
  for (int p = 0; p < places; p++) {
    mission.place[p] = (qtr_cell)cells[p];
    mission.weight[p] = weights[p];
  }
  for (int row = 0; row < seekers + places; row++) {
    const int from = row < seekers ? starts[row] : cells[row - seekers];
    for (int p = 0; p < places; p++)
      steps[row * places + p] = (qtr_steps)(from < cells[p] ? cells[p] - from : from - cells[p]);
  }
}

static void solve(void) {
  const int status = exact_solve_plain(&solution, &mission, steps, &why);
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, status, why.text);
}

static void assert_near(double expected, double actual) {
  TEST_ASSERT_TRUE_MESSAGE(fabs(expected - actual) <= 1e-12 * fmax(1, fabs(expected)), "not the value expected");
}

static void test_likely_place_is_visited_first_though_it_is_farther(void) {
  corridor(1, (int[]){10}, 2, (int[]){8, 13}, (double[]){1, 3});
  mission.aim.kind = QTR_TIME;
  solve();
  TEST_ASSERT_EQUAL_INT(2, solution.length[0]);
  TEST_ASSERT_EQUAL_UINT16(1, solution.route[0][0]);
  TEST_ASSERT_EQUAL_UINT16(0, solution.route[0][1]);
  TEST_ASSERT_EQUAL_UINT32(3, solution.step[0][0]);
  TEST_ASSERT_EQUAL_UINT32(8, solution.step[0][1]);
  assert_near(0.75 * 3 + 0.25 * 8, solution.expected_time);
  assert_near(10 * (0.75 * 0.81 + 0.25 * pow(0.9, 7)), solution.value);
}

static void test_objectives_may_disagree(void) {
  /* A near place and a far one: expected time heeds the weights, a strong discount the near place alone. */
  corridor(1, (int[]){50}, 2, (int[]){49, 53}, (double[]){1, 2});
  mission.aim.kind = QTR_TIME;
  solve();
  TEST_ASSERT_EQUAL_UINT16(0, solution.route[0][0]); /* (1 + 2 * 5) / 3 against (2 * 3 + 7) / 3 */
  mission.weight[1] = 4;
  solve();
  TEST_ASSERT_EQUAL_UINT16(1, solution.route[0][0]); /* (1 + 4 * 5) / 5 against (4 * 3 + 7) / 5 */
  mission.aim.kind = QTR_DISCOUNTED;
  mission.aim.gamma = 0.4;
  solve();
  TEST_ASSERT_EQUAL_UINT16(0, solution.route[0][0]); /* 1 + 4 * 0.4^4 against 4 * 0.4^2 + 0.4^6 */
  assert_near(10 * (0.2 + 0.8 * pow(0.4, 4)), solution.value);
  assert_near((1 + 4 * 5) / 5.0, solution.expected_time);
}

static void test_start_on_a_place_visits_it_at_step_zero_undiscounted(void) {
  corridor(1, (int[]){5}, 2, (int[]){5, 6}, (double[]){1, 1});
  solve();
  TEST_ASSERT_EQUAL_UINT32(0, solution.step[0][0]);
  TEST_ASSERT_EQUAL_UINT32(1, solution.step[0][1]);
  assert_near(10, solution.value);
  assert_near(0.5, solution.expected_time);
}

static void test_two_seekers_part(void) {
  corridor(2, (int[]){50, 50}, 3, (int[]){46, 53, 54}, (double[]){1, 1, 1});
  solve();
  TEST_ASSERT_EQUAL_INT(3, solution.length[0] + solution.length[1]);
  TEST_ASSERT_EQUAL_INT(1, solution.length[0] * solution.length[1] - 1); /* 1 and 2 */
  assert_near((4 + 3 + 4) / 3.0, solution.expected_time);
}

static void test_far_seeker_may_stand_down(void) {
  corridor(2, (int[]){50, 91}, 2, (int[]){49, 51}, (double[]){1, 1});
  mission.aim.kind = QTR_TIME;
  solve();
  TEST_ASSERT_EQUAL_INT(2, solution.length[0]);
  assert_near((1 + 3) / 2.0, solution.expected_time);
}

static void test_paper_rule_opens_withheld_places_when_few_are_left(void) {
  /* Seeker 1, far off, must head for one of the two. After step 1 one place is left for two seekers, so seeker 0 may
   * head for it as well, and gets there first. */
  corridor(2, (int[]){50, 91}, 2, (int[]){49, 51}, (double[]){1, 1});
  mission.aim.kind = QTR_TIME;
  mission.rule = QTR_RULE_PAPER;
  solve();
  TEST_ASSERT_EQUAL_INT(2, solution.length[0]);
  TEST_ASSERT_EQUAL_INT(0, solution.length[1]);
  assert_near((1 + 3) / 2.0, solution.expected_time);
}

static void test_paper_rule_costs_time_where_a_far_seeker_withholds_a_place(void) {
  /* Two halls without a door. In the one, seekers 0 and 1 and places 0 and 1; in the other, seeker 2 and so many places
   * that what seeker 1 is bound for stays closed to seeker 0, which is out of the game after step 1. */
  enum { PLACES = 5 };
  corridor(3, (int[]){10, 60, 1000}, PLACES, (int[]){11, 12, 1010, 1110, 1210}, (double[]){1, 1, 1, 1, 1});
  for (int row = 0; row < 3 + PLACES; row++)
    for (int p = 0; p < PLACES; p++)
      if ((row == 2 || row > 4) != (p > 1)) steps[row * PLACES + p] = QTR_NEVER;
  mission.aim.kind = QTR_TIME;
  solve();
  assert_near((1 + 2 + 10 + 110 + 210) / 5.0, solution.expected_time);
  mission.rule = QTR_RULE_PAPER;
  solve();
  TEST_ASSERT_EQUAL_INT(1, solution.length[0]);
  TEST_ASSERT_EQUAL_INT(1, solution.length[1]);
  assert_near((1 + 48 + 10 + 110 + 210) / 5.0, solution.expected_time);
}

/* ---- refusals ---- */

static void test_place_that_nobody_reaches_is_named(void) {
  corridor(1, (int[]){5}, 2, (int[]){6, 7}, (double[]){1, 1});
  steps[0 * 2 + 1] = steps[1 * 2 + 1] = QTR_NEVER;
  TEST_ASSERT_EQUAL_INT(-1, exact_solve_plain(&solution, &mission, steps, &why));
  TEST_ASSERT_NOT_NULL(strstr(why.text, "place 1"));
}

static void test_one_way_streets_without_a_route_are_refused(void) {
  corridor(1, (int[]){5}, 2, (int[]){6, 7}, (double[]){1, 1});
  steps[1 * 2 + 1] = steps[2 * 2 + 0] = QTR_NEVER; /* either can be reached, but not one after the other */
  TEST_ASSERT_EQUAL_INT(-1, exact_solve_plain(&solution, &mission, steps, &why));
  TEST_ASSERT_NOT_NULL(strstr(why.text, "no routes"));
}

static void test_too_many_places_are_refused_at_once_with_the_limit(void) {
  int starts[MOST_SEEKERS] = {0}, cells[MOST_PLACES];
  double weights[MOST_PLACES];
  for (int p = 0; p < MOST_PLACES; p++) {
    cells[p] = p + 1;
    weights[p] = 1;
  }
  corridor(2, starts, 23, cells, weights);
  TEST_ASSERT_EQUAL_INT(-1, exact_solve_plain(&solution, &mission, steps, &why));
  TEST_ASSERT_NOT_NULL(strstr(why.text, "22 places"));
  corridor(3, starts, 19, cells, weights);
  TEST_ASSERT_EQUAL_INT(-1, exact_solve_plain(&solution, &mission, steps, &why));
  TEST_ASSERT_NOT_NULL(strstr(why.text, "18 for more"));
  mission.rule = QTR_RULE_PAPER;
  corridor(2, starts, 21, cells, weights);
  TEST_ASSERT_EQUAL_INT(-1, exact_solve_plain(&solution, &mission, steps, &why));
  TEST_ASSERT_NOT_NULL(strstr(why.text, "takes 20"));
}

static void test_extreme_weights_and_discounts_stay_finite(void) {
  corridor(2, (int[]){50, 50}, 4, (int[]){10, 90, 95, 20}, (double[]){1e308, 1e308, 1e-300, 1});
  mission.aim.gamma = 1e-9;
  for (int objective = 0; objective < 2; objective++) {
    mission.aim.kind = (uint8_t)objective;
    solve();
    TEST_ASSERT_TRUE(isfinite(solution.value) && isfinite(solution.expected_time));
    assert_near(40, solution.expected_time);
  }
}

/* ---- enumeration of whole games ---- */

typedef struct {
  int visited[MOST_PLACES], at[MOST_SEEKERS], target[MOST_SEEKERS]; /* target: place, IDLE or GONE */
  int left[MOST_SEEKERS];
  int now, unvisited;
  double earned; /* so far, in the objective's unit; the time counted negative */
} trial;

enum { IDLE = -1, GONE = -2 };

static int way(int seeker, int at, int place) {
  const int row = at < 0 ? seeker : mission.seekers + at; /* at: -1 at the start */
  const qtr_steps found = steps[row * mission.places + place];
  return found == QTR_NEVER ? -1 : (int)found;
}

static double worth(int place, int now) {
  double sum = 0;
  for (int p = 0; p < mission.places; p++) sum += mission.weight[p];
  const double share = mission.weight[place] / sum;
  return mission.aim.kind == QTR_TIME ? -share * now : 10 * share * pow(mission.aim.gamma, now > 0 ? now - 1 : 0);
}

static int is_open(const trial *game, int seeker, int place) {
  if (game->visited[place] || way(seeker, game->at[seeker], place) < 0) return 0;
  if (mission.rule == QTR_RULE_PAPER && game->unvisited < mission.seekers) return 1;
  for (int i = 0; i < mission.seekers; i++)
    if (game->target[i] == place) return 0;
  return 1;
}

/* Starts rank after places, in the order in which the seekers name them. */
static int rank(const trial *game, int seeker) {
  if (game->at[seeker] >= 0) return game->at[seeker];
  int same = 0;
  while (mission.start[same] != mission.start[seeker]) same++;
  return mission.places + same;
}

static int turn(const trial *game) {
  int chooser = -1;
  for (int i = 0; i < mission.seekers; i++)
    if (game->target[i] == IDLE && (chooser < 0 || rank(game, i) < rank(game, chooser))) chooser = i;
  return chooser;
}

static void drop_those_without_choice(trial *game) {
  for (int i = 0; i < mission.seekers; i++) {
    int any = 0;
    for (int p = 0; p < mission.places; p++) any |= game->target[i] == IDLE && is_open(game, i, p);
    if (game->target[i] == IDLE && !any) game->target[i] = GONE;
  }
}

static void arrive(trial *game, int seeker) {
  const int place = game->target[seeker];
  game->at[seeker] = place;
  game->target[seeker] = IDLE;
  if (game->visited[place]) return;
  game->visited[place] = 1;
  game->unvisited--;
  game->earned += worth(place, game->now);
}

static double enumerate(trial game);

static double enumerate_choices(const trial *game, int seeker) {
  double best = -INFINITY;
  for (int p = 0; p < mission.places; p++) {
    if (!is_open(game, seeker, p)) continue;
    trial next = *game;
    next.target[seeker] = p;
    next.left[seeker] = way(seeker, game->at[seeker], p);
    if (next.left[seeker] == 0) arrive(&next, seeker);
    best = fmax(best, enumerate(next));
  }
  if (mission.rule == QTR_RULE_PAPER) return best;
  trial next = *game;
  next.target[seeker] = GONE;
  return fmax(best, enumerate(next));
}

static int time_to_arrival(const trial *game) {
  int least = 0;
  for (int i = 0; i < mission.seekers; i++)
    if (game->target[i] >= 0 && (least == 0 || game->left[i] < least)) least = game->left[i];
  return least;
}

static void pass_time(trial *game, int time) {
  int arrived[MOST_SEEKERS];
  game->now += time;
  for (int i = 0; i < mission.seekers; i++) {
    game->left[i] -= time;
    arrived[i] = game->target[i] >= 0 && game->left[i] == 0;
  }
  for (int i = 0; i < mission.seekers; i++)
    if (arrived[i]) arrive(game, i);
}

/* The best that can come of a game begun like this; minus infinity if places are left over. */
static double enumerate(trial game) {
  if (game.unvisited == 0) return game.earned;
  drop_those_without_choice(&game);
  const int chooser = turn(&game);
  if (chooser >= 0) return enumerate_choices(&game, chooser);
  const int time = time_to_arrival(&game);
  if (time == 0) return -INFINITY;
  pass_time(&game, time);
  return enumerate(game);
}

static double brute_force(void) {
  trial game = {.unvisited = mission.places};
  for (int i = 0; i < mission.seekers; i++) {
    game.at[i] = -1;
    game.target[i] = IDLE;
  }
  return enumerate(game);
}

/* ---- random games ---- */

static uint32_t random_state;

static int draw(int below) {
  random_state = random_state * 1664525u + 1013904223u;
  return (int)((random_state >> 8) % (uint32_t)below);
}

/* One in three: any travel times at all, one-way streets included. One in three: points in two halls without a door.
 * Else: points in a hall, with a slope that makes uphill slower. */
static qtr_steps random_way(int kind, const int from[2], const int to[2]) {
  if (kind == 0) return draw(8) == 0 ? QTR_NEVER : (qtr_steps)(1 + draw(9));
  if (kind == 1 && (from[0] < 4) != (to[0] < 4)) return QTR_NEVER;
  const int across = from[0] < to[0] ? to[0] - from[0] : from[0] - to[0];
  const int along = from[1] < to[1] ? 2 * (to[1] - from[1]) : from[1] - to[1];
  return (qtr_steps)(across + along);
}

static int point[MOST_SEEKERS + MOST_PLACES][2]; /* of the starts, then of the places */

/* Places lie on cells of their own. */
static void draw_points(void) {
  for (int i = 0; i < mission.seekers + mission.places; i++) {
    int cell = draw(40);
    for (int p = mission.seekers; p < i; p++) {
      if (point[p][0] != cell % 8 || point[p][1] != cell / 8) continue;
      cell = (cell + 1) % 40;
      p = mission.seekers - 1;
    }
    point[i][0] = cell % 8;
    point[i][1] = cell / 8;
  }
}

/* Often an earlier seeker's start, sometimes a place. */
static void draw_starts(void) {
  for (int i = 0; i < mission.seekers; i++) {
    const int same = draw(i + 1);
    const int on_place = draw(4) == 0 && same == i;
    const int from = on_place ? mission.seekers + draw(mission.places) : same;
    point[i][0] = point[from][0];
    point[i][1] = point[from][1];
    mission.start[i] = same < i ? mission.start[same] : (qtr_cell)i;
  }
}

static void draw_ways(int kind) {
  const int seekers = mission.seekers, places = mission.places;
  for (int row = 0; row < seekers + places; row++)
    for (int p = 0; p < places; p++)
      steps[row * places + p] = row - seekers == p ? 0 : random_way(kind, point[row], point[seekers + p]);
  for (int i = 0; i < seekers; i++) /* seekers that share a start share its ways */
    for (int p = 0; p < places; p++) steps[i * places + p] = steps[(int)mission.start[i] * places + p];
}

static void random_game(uint32_t seed, int most) {
  random_state = seed;
  for (int i = 0; i < 8; i++) draw(2);
  mission.seekers = (uint8_t)(1 + draw(3));
  mission.places = (uint16_t)(1 + draw(most - mission.seekers / 3));
  draw_points();
  draw_starts();
  draw_ways((int)(seed % 3));
  for (int p = 0; p < mission.places; p++) mission.weight[p] = 1 + draw(5);
  mission.aim.gamma = draw(2) ? 0.9 : 0.99;
}

/* Every place once, at the step stated; both figures follow from the routes. Under the paper's rule a route may have
 * detours to places where another got first, so there steps are only a lower bound. */
static void check_routes(const char *label) {
  int seen[MOST_PLACES] = {0};
  double value = 0, time = 0;
  const int objective = mission.aim.kind;
  for (int i = 0; i < mission.seekers; i++) {
    int at = -1, now = 0;
    for (int v = 0; v < solution.length[i]; v++) {
      const int place = solution.route[i][v], step = (int)solution.step[i][v];
      now += way(i, at, place);
      if (mission.rule == QTR_RULE_FREE) TEST_ASSERT_EQUAL_INT_MESSAGE(now, step, label);
      at = place;
      now = step;
      seen[place]++;
      mission.aim.kind = QTR_DISCOUNTED;
      value += worth(place, step);
      mission.aim.kind = QTR_TIME;
      time -= worth(place, step);
    }
  }
  mission.aim.kind = (uint8_t)objective;
  for (int p = 0; p < mission.places; p++) TEST_ASSERT_EQUAL_INT_MESSAGE(1, seen[p], label);
  TEST_ASSERT_TRUE_MESSAGE(fabs(value - solution.value) < 1e-9, label);
  TEST_ASSERT_TRUE_MESSAGE(fabs(time - solution.expected_time) < 1e-9, label);
}

static void compare(uint32_t seed) {
  char label[200];
  const double best = brute_force();
  const int status = exact_solve_plain(&solution, &mission, steps, &why);
  const double found = mission.aim.kind == QTR_TIME ? -solution.expected_time : solution.value;
  snprintf(label, sizeof label, "seed %lu, %d places, %d seekers, objective %d, rule %d: enumerated %.9f, solved %.9f",
           (unsigned long)seed, mission.places, mission.seekers, mission.aim.kind, mission.rule, best, found);
  TEST_ASSERT_EQUAL_INT_MESSAGE(best == -INFINITY ? -1 : 0, status, label);
  if (status != 0) return;
  TEST_ASSERT_TRUE_MESSAGE(fabs(best - found) < 1e-9 * fmax(1, fabs(best)), label);
  check_routes(label);
}

static void test_equals_enumeration_on_random_games(void) {
  for (uint32_t seed = 1; seed <= 400; seed++) {
    for (int variant = 0; variant < 4; variant++) {
      setUp();
      random_game(seed, 6);
      mission.aim.kind = (uint8_t)(variant % 2);
      mission.rule = (uint8_t)(variant / 2);
      compare(seed);
    }
  }
}

/* ---- larger games: the solvers of the two rules against one another ---- */

/* Where every seeker reaches every place, the paper's rule costs nothing: whoever is forced on can head for the last
 * place of the route that ends last, and a place so withheld is open again by the time that it is its turn. */
static void test_both_rules_have_one_optimum_where_all_is_connected(void) {
  for (uint32_t seed = 2; seed < 150; seed += 3) { /* random_game()'s hall without a wall */
    for (int objective = 0; objective < 2; objective++) {
      char label[80];
      snprintf(label, sizeof label, "seed %lu, objective %d", (unsigned long)seed, objective);
      setUp();
      random_game(seed, 8);
      mission.aim.kind = (uint8_t)objective;
      solve();
      const double apart = objective == QTR_TIME ? solution.expected_time : solution.value;
      mission.rule = QTR_RULE_PAPER;
      solve();
      check_routes(label);
      const double together = objective == QTR_TIME ? solution.expected_time : solution.value;
      TEST_ASSERT_TRUE_MESSAGE(fabs(apart - together) < 1e-9 * fmax(1, apart), label);
    }
  }
}

static void test_more_seekers_never_do_worse(void) {
  int starts[MOST_SEEKERS] = {12, 30, 12, 12}, cells[13];
  double weights[13];
  for (int p = 0; p < 13; p++) {
    cells[p] = (p * 29 + 3) % 60;
    weights[p] = 1 + p % 4;
  }
  double before = 0;
  for (int seekers = 1; seekers <= MOST_SEEKERS; seekers++) {
    corridor(seekers, starts, 13, cells, weights);
    solve();
    check_routes("corridor");
    TEST_ASSERT_TRUE(solution.value >= before);
    before = solution.value;
  }
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_likely_place_is_visited_first_though_it_is_farther);
  RUN_TEST(test_objectives_may_disagree);
  RUN_TEST(test_start_on_a_place_visits_it_at_step_zero_undiscounted);
  RUN_TEST(test_two_seekers_part);
  RUN_TEST(test_far_seeker_may_stand_down);
  RUN_TEST(test_paper_rule_opens_withheld_places_when_few_are_left);
  RUN_TEST(test_paper_rule_costs_time_where_a_far_seeker_withholds_a_place);
  RUN_TEST(test_place_that_nobody_reaches_is_named);
  RUN_TEST(test_one_way_streets_without_a_route_are_refused);
  RUN_TEST(test_too_many_places_are_refused_at_once_with_the_limit);
  RUN_TEST(test_extreme_weights_and_discounts_stay_finite);
  RUN_TEST(test_equals_enumeration_on_random_games);
  RUN_TEST(test_both_rules_have_one_optimum_where_all_is_connected);
  RUN_TEST(test_more_seekers_never_do_worse);
  return UNITY_END();
}

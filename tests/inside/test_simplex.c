/* profiles: host mcu */
/* Linear programmes of choosing among columns, against a trial of every basis. */
#include <math.h>
#include <string.h>

#include "search/simplex.h"
#include "support/random.h"
#include "unity.h"

#define ROWS_MOST 4u
#define COLUMNS_MOST 9u
#define NEAR 1e-4 /* right-hand sides are shifted by a hundredth of that */

static struct {
  uint32_t rows, columns;
  double right[ROWS_MOST + 1], worth[COLUMNS_MOST];
  uint32_t ones[COLUMNS_MOST]; /* bit i: a one in row i */
} programme;

static qtr_simplex simplex;
static double block[400];

void setUp(void) {
}

void tearDown(void) {
}

static void draw(test_random *random) {
  programme.rows = random_in(random, 1, ROWS_MOST);
  programme.columns = random_in(random, 1, COLUMNS_MOST);
  for (uint32_t row = 0; row < programme.rows; row++) programme.right[row] = random_in(random, 1, 3);
  for (uint32_t i = 0; i < programme.columns; i++) {
    programme.ones[i] = random_in(random, 1, (1u << programme.rows) - 1);
    programme.worth[i] = 10.0 * random_unit(random) - 2.0;
  }
}

static void column_of(const void *context, int32_t number, qtr_column *column) {
  TEST_ASSERT_EQUAL_PTR(&programme, context);
  column->worth = programme.worth[number];
  column->count = 0;
  for (uint32_t row = 0; row < programme.rows; row++)
    if (programme.ones[number] >> row & 1u) column->row[column->count++] = (uint16_t)row;
}

/* ---- every basis: of the columns and, behind them, a slack a row ---- */

static double element(uint32_t row, uint32_t column) {
  if (column >= programme.columns) return column - programme.columns == row ? 1.0 : 0.0;
  return programme.ones[column] >> row & 1u ? 1.0 : 0.0;
}

typedef double tableau[ROWS_MOST + 1][ROWS_MOST + 2];

/* Column j alone has row j. False: it depends on the others. */
static bool eliminate(tableau a, uint32_t n, uint32_t j) {
  uint32_t pivot = j;
  while (pivot < n && fabs(a[pivot][j]) < 1e-9) pivot++;
  if (pivot == n) return false;
  for (uint32_t k = 0; k <= n; k++) {
    const double swapped = a[pivot][k];
    a[pivot][k] = a[j][k];
    a[j][k] = swapped;
  }
  for (uint32_t i = 0; i < n; i++) {
    const double share = i == j ? 0.0 : a[i][j] / a[j][j];
    for (uint32_t k = 0; k <= n; k++) a[i][k] -= share * a[j][k];
  }
  return true;
}

/* The worth of the basis; -HUGE_VAL if it is none, or has a level below 0. */
static double worth_of_basis(uint32_t basis) {
  tableau a;
  uint32_t of[ROWS_MOST + 1], n = 0;
  double worth = 0.0;
  for (uint32_t column = 0; column < programme.columns + programme.rows; column++)
    if (basis >> column & 1u) of[n++] = column;
  for (uint32_t i = 0; i < n; i++) {
    for (uint32_t j = 0; j < n; j++) a[i][j] = element(i, of[j]);
    a[i][n] = programme.right[i];
  }
  for (uint32_t j = 0; j < n; j++)
    if (!eliminate(a, n, j)) return -HUGE_VAL;
  for (uint32_t j = 0; j < n; j++) {
    if (a[j][n] / a[j][j] < -1e-9) return -HUGE_VAL;
    if (of[j] < programme.columns) worth += programme.worth[of[j]] * a[j][n] / a[j][j];
  }
  return worth;
}

static unsigned count_bits(uint32_t bits) {
  unsigned count = 0;
  for (; bits != 0; bits >>= 1) count += bits & 1u;
  return count;
}

static double most_of_all(void) {
  double most = -HUGE_VAL;
  for (uint32_t basis = 0; basis < 1u << (programme.columns + programme.rows); basis++)
    if (count_bits(basis) == programme.rows) most = fmax(most, worth_of_basis(basis));
  return most;
}

/* ---- the method ---- */

static bool enter_any(void) {
  uint16_t rows[ROWS_MOST + 1];
  qtr_column column = {0.0, 0, rows};
  if (qtr_simplex_enter_elastic(&simplex, 1e-9)) return true;
  for (uint32_t i = 0; i < programme.columns; i++) {
    column_of(&programme, (int32_t)i, &column);
    if (qtr_simplex_gain(&simplex, &column) > 1e-9 && qtr_simplex_enter(&simplex, (int32_t)i, &column)) return true;
  }
  return false;
}

static void solve(void) {
  unsigned steps = 0;
  do
    while (enter_any()) TEST_ASSERT_LESS_THAN_MESSAGE(10000, ++steps, case_note);
  while (qtr_simplex_widen(&simplex, NEAR / 10.0));
}

static double worth_found(void) {
  double worth = 0.0;
  for (uint32_t i = 0; i < simplex.rows; i++)
    if (simplex.basis[i] >= 0) worth += simplex.level[i] * programme.worth[simplex.basis[i]];
  return worth;
}

static void begin(test_random *random) {
  draw(random);
  TEST_ASSERT_LESS_OR_EQUAL(sizeof block, qtr_simplex_bytes(programme.rows + 1));
  qtr_simplex_init(&simplex, block, programme.rows + 1, column_of, &programme);
  for (uint32_t row = 0; row < programme.rows; row++) {
    const double least = 4.0 * random_unit(random);
    qtr_simplex_add_row(&simplex, programme.right[row], least, least + 0.1 + random_unit(random), true);
  }
  qtr_simplex_refactor(&simplex);
}

static void test_solution_is_worth_as_much_as_the_best_basis(void) {
  for (unsigned number = 0; number < random_cases(400); number++) {
    test_random random = random_case("programmes", number);
    begin(&random);
    solve();
    const double most = most_of_all();
    TEST_ASSERT_TRUE_MESSAGE(fabs(worth_found() - most) <= NEAR * fmax(1.0, fabs(most)), case_note);
  }
}

/* Right-hand sides times prices: by duality no solution is worth more than that. */
static void test_prices_prove_the_solution(void) {
  for (unsigned number = 0; number < random_cases(400); number++) {
    test_random random = random_case("prices", number);
    double proven = 0.0;
    begin(&random);
    solve();
    for (uint32_t row = 0; row < programme.rows; row++) {
      TEST_ASSERT_TRUE_MESSAGE(simplex.price[row] >= -1e-6, case_note);
      proven += programme.right[row] * simplex.price[row];
    }
    TEST_ASSERT_TRUE_MESSAGE(fabs(proven - worth_found()) <= NEAR * fmax(1.0, fabs(proven)), case_note);
  }
}

/* One row more than all columns ask for, and away with it again. */
static void test_row_with_a_slack_comes_and_goes(void) {
  unsigned removed = 0;
  for (unsigned number = 0; number < random_cases(200); number++) {
    test_random random = random_case("rows", number);
    begin(&random);
    programme.right[programme.rows] = 1000.0;
    const uint32_t row = programme.rows++;
    for (uint32_t i = 0; i < programme.columns; i++)
      if (random_chance(&random, 50)) programme.ones[i] |= 1u << row;
    qtr_simplex_add_row(&simplex, 1000.0, 0.0, 1.0, true);
    qtr_simplex_refactor(&simplex);
    solve();
    TEST_ASSERT_TRUE_MESSAGE(qtr_simplex_is_slack(&simplex, row), case_note);
    qtr_simplex_remove_row(&simplex, row);
    for (uint32_t i = 0; i < programme.columns; i++) programme.ones[i] &= (1u << row) - 1;
    programme.rows--;
    qtr_simplex_refactor(&simplex);
    solve();
    const double most = most_of_all();
    TEST_ASSERT_TRUE_MESSAGE(fabs(worth_found() - most) <= NEAR * fmax(1.0, fabs(most)), case_note);
    removed++;
  }
  TEST_ASSERT_GREATER_THAN(0, removed);
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_solution_is_worth_as_much_as_the_best_basis);
  RUN_TEST(test_prices_prove_the_solution);
  RUN_TEST(test_row_with_a_slack_comes_and_goes);
  return UNITY_END();
}

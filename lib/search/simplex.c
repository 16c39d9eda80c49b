#include "search/simplex.h"

#include <math.h>
#include <string.h>

#include "core/block.h"
#include "model/rounding.h"
#include "quarter/status.h"

#define LEAST_PIVOT 1e-7
#define PIVOTS_MOST 100u /* until the inverse is worked out anew */
#define WIDENING 3.0
#define ROOMY 1000.0 /* times the widest room that a price had at first */
#define SHIFT 1e-6   /* of right-hand sides, at most */

/* ---- elastic columns: 2 a row ---- */

static int32_t elastic_of(uint32_t row, bool is_over) {
  return -1 - (int32_t)(2 * row + (is_over ? 1 : 0));
}

static uint32_t row_of(int32_t elastic) {
  return (uint32_t)(-1 - elastic) / 2;
}

static bool is_over(int32_t elastic) {
  return (-1 - elastic) % 2 != 0;
}

static double worth_of_elastic(const qtr_simplex *simplex, int32_t elastic) {
  const uint32_t row = row_of(elastic);
  return is_over(elastic) ? -simplex->most[row] : simplex->least[row];
}

/* ---- set-up ---- */

size_t qtr_simplex_bytes(uint32_t rows) {
  const size_t doubles = (size_t)rows * rows + 7 * (size_t)rows;
  return doubles * sizeof(double) + 2 * block_piece(rows * sizeof(bool)) + 2 * block_piece(rows * sizeof(int32_t)) +
         block_piece(rows * sizeof(uint16_t));
}

void qtr_simplex_init(qtr_simplex *simplex, void *block, uint32_t rows, qtr_column_of columns, const void *context) {
  uint8_t *left = block;
  simplex->rows = simplex->pivots = 0;
  simplex->rows_most = rows;
  simplex->widest = 0.0;
  simplex->columns = columns;
  simplex->context = context;
  simplex->inverse = block_cut(&left, (size_t)rows * rows * sizeof(double));
  simplex->price = block_cut(&left, rows * sizeof(double));
  simplex->right = block_cut(&left, rows * sizeof(double));
  simplex->least = block_cut(&left, rows * sizeof(double));
  simplex->most = block_cut(&left, rows * sizeof(double));
  simplex->level = block_cut(&left, rows * sizeof(double));
  simplex->worth = block_cut(&left, rows * sizeof(double));
  simplex->change = block_cut(&left, rows * sizeof(double));
  simplex->has_slack = block_cut(&left, rows * sizeof(bool));
  simplex->taken = block_cut(&left, rows * sizeof(bool));
  simplex->basis = block_cut(&left, rows * sizeof(int32_t));
  simplex->order = block_cut(&left, rows * sizeof(int32_t));
  simplex->one = block_cut(&left, rows * sizeof(uint16_t));
}

/* Where many levels are 0, a method that follows the greatest gain can go round in circles. Each row gives a little
 * more than it should, no two of them the same. */
static double shifted(double right, uint32_t row) {
  return right + SHIFT * (double)(1u + (row * 2654435761u >> 22)) / 1024.0;
}

void qtr_simplex_add_row(qtr_simplex *simplex, double right, double least, double most, bool has_slack) {
  const uint32_t row = simplex->rows++;
  QTR_ASSERT(row < simplex->rows_most);
  simplex->right[row] = shifted(right, row);
  simplex->least[row] = has_slack && least < 0.0 ? 0.0 : least;
  simplex->most[row] = most;
  simplex->has_slack[row] = has_slack;
  if (most - simplex->least[row] > simplex->widest) simplex->widest = most - simplex->least[row];
  simplex->basis[row] = elastic_of(row, false);
}

static uint32_t position_of(const qtr_simplex *simplex, int32_t number) {
  uint32_t position = 0;
  while (position < simplex->rows && simplex->basis[position] != number) position++;
  return position;
}

bool qtr_simplex_is_slack(const qtr_simplex *simplex, uint32_t row) {
  return simplex->has_slack[row] && simplex->least[row] <= 0.0 &&
         position_of(simplex, elastic_of(row, false)) < simplex->rows;
}

void qtr_simplex_remove_row(qtr_simplex *simplex, uint32_t row) {
  const uint32_t behind = --simplex->rows - row;
  for (uint32_t i = position_of(simplex, elastic_of(row, false)); i < simplex->rows; i++)
    simplex->basis[i] = simplex->basis[i + 1];
  for (uint32_t i = 0; i < simplex->rows; i++)
    if (simplex->basis[i] < 0 && row_of(simplex->basis[i]) > row) simplex->basis[i] += 2;
  memmove(&simplex->right[row], &simplex->right[row + 1], behind * sizeof simplex->right[0]);
  memmove(&simplex->least[row], &simplex->least[row + 1], behind * sizeof simplex->least[0]);
  memmove(&simplex->most[row], &simplex->most[row + 1], behind * sizeof simplex->most[0]);
  memmove(&simplex->has_slack[row], &simplex->has_slack[row + 1], behind * sizeof simplex->has_slack[0]);
}

/* ---- pivots ---- */

static double *inverse_column(const qtr_simplex *simplex, uint32_t row) {
  return simplex->inverse + (size_t)row * simplex->rows_most;
}

static void get_column(const qtr_simplex *simplex, int32_t number, qtr_column *column) {
  column->row = simplex->one;
  simplex->columns(simplex->context, number, column);
}

/* change = inverse * column: what one of it takes from each column in the basis. */
static void find_change(qtr_simplex *simplex, const qtr_column *column) {
  memset(simplex->change, 0, simplex->rows * sizeof simplex->change[0]);
  for (uint32_t i = 0; i < column->count; i++) {
    const double *inverse = inverse_column(simplex, column->row[i]);
    for (uint32_t position = 0; position < simplex->rows; position++) simplex->change[position] += inverse[position];
  }
}

static void find_elastic_change(qtr_simplex *simplex, int32_t elastic) {
  const double *inverse = inverse_column(simplex, row_of(elastic));
  const double sign = is_over(elastic) ? -1.0 : 1.0;
  for (uint32_t position = 0; position < simplex->rows; position++)
    simplex->change[position] = sign * inverse[position];
}

/* The column that `change` is of takes the place of the one at `position`. */
static void replace(qtr_simplex *simplex, uint32_t position) {
  const double pivot = simplex->change[position];
  for (uint32_t row = 0; row < simplex->rows; row++) {
    double *inverse = inverse_column(simplex, row);
    const double share = inverse[position] / pivot;
    if (share == 0.0) continue;
    for (uint32_t i = 0; i < simplex->rows; i++) inverse[i] -= share * simplex->change[i];
    inverse[position] = share;
  }
}

/* Which column is the first to be at 0; of several the one that is left most clearly. rows: none. */
static uint32_t find_leaving(const qtr_simplex *simplex) {
  uint32_t leaving = simplex->rows;
  double least = HUGE_VAL;
  for (uint32_t i = 0; i < simplex->rows; i++) {
    if (simplex->change[i] <= LEAST_PIVOT) continue;
    const double ratio = simplex->level[i] / simplex->change[i];
    if (ratio > least || (ratio == least && simplex->change[i] <= simplex->change[leaving])) continue;
    least = ratio;
    leaving = i;
  }
  return leaving;
}

static void move_levels(qtr_simplex *simplex, uint32_t leaving) {
  const double entered = simplex->level[leaving] / simplex->change[leaving];
  for (uint32_t i = 0; i < simplex->rows; i++) {
    simplex->level[i] -= entered * simplex->change[i];
    if (simplex->level[i] < 0.0) simplex->level[i] = 0.0;
  }
  simplex->level[leaving] = entered;
}

static void move_prices(qtr_simplex *simplex, uint32_t leaving, double gain) {
  const double step = gain / simplex->change[leaving];
  for (uint32_t row = 0; row < simplex->rows; row++)
    simplex->price[row] += step * inverse_column(simplex, row)[leaving];
}

/* The column that `change` is of enters. */
static bool enter(qtr_simplex *simplex, int32_t number, double worth, double gain) {
  const uint32_t leaving = find_leaving(simplex);
  if (leaving == simplex->rows) return false;
  move_levels(simplex, leaving);
  move_prices(simplex, leaving, gain);
  replace(simplex, leaving);
  simplex->basis[leaving] = number;
  simplex->worth[leaving] = worth;
  if (++simplex->pivots >= PIVOTS_MOST) qtr_simplex_refactor(simplex);
  return true;
}

double qtr_simplex_gain(const qtr_simplex *simplex, const qtr_column *column) {
  double gain = column->worth;
  for (uint32_t i = 0; i < column->count; i++) gain -= simplex->price[column->row[i]];
  return gain;
}

bool qtr_simplex_enter(qtr_simplex *simplex, int32_t number, const qtr_column *column) {
  find_change(simplex, column);
  return enter(simplex, number, column->worth, qtr_simplex_gain(simplex, column));
}

static double gain_of_elastic(const qtr_simplex *simplex, int32_t elastic) {
  const double price = simplex->price[row_of(elastic)];
  return worth_of_elastic(simplex, elastic) + (is_over(elastic) ? price : -price);
}

static bool widen(qtr_simplex *simplex, int32_t elastic) {
  const uint32_t row = row_of(elastic);
  const double more = WIDENING * (simplex->most[row] - simplex->least[row]);
  if (is_over(elastic)) {
    simplex->most[row] += more;
    return true;
  }
  if (simplex->has_slack[row] && simplex->least[row] <= 0.0) return false;
  simplex->least[row] -= more;
  if (simplex->has_slack[row] && simplex->least[row] < 0.0) simplex->least[row] = 0.0;
  return true;
}

/* One that may grow without end, for what its row can bring, is given room as well. */
bool qtr_simplex_enter_elastic(qtr_simplex *simplex, double least) {
  int32_t best = 0;
  for (uint32_t i = 0; i < 2 * simplex->rows; i++) {
    const int32_t elastic = -1 - (int32_t)i;
    if (gain_of_elastic(simplex, elastic) <= least) continue;
    least = gain_of_elastic(simplex, elastic);
    best = elastic;
  }
  if (best == 0) return false;
  find_elastic_change(simplex, best);
  return enter(simplex, best, worth_of_elastic(simplex, best), least) || widen(simplex, best);
}

/* ---- the basis worked out anew ---- */

static void begin_inverse(qtr_simplex *simplex) {
  for (uint32_t row = 0; row < simplex->rows; row++) {
    memset(inverse_column(simplex, row), 0, simplex->rows * sizeof(double));
    inverse_column(simplex, row)[row] = 1.0;
    simplex->order[row] = simplex->basis[row];
    simplex->basis[row] = elastic_of(row, false);
  }
}

/* Where a column may come in: where no other one has, and its change is greatest. rows: it depends on the others. */
static uint32_t find_position(const qtr_simplex *simplex, const bool *taken) {
  uint32_t position = simplex->rows;
  double most = LEAST_PIVOT;
  for (uint32_t i = 0; i < simplex->rows; i++) {
    if (taken[i] || fabs(simplex->change[i]) <= most) continue;
    most = fabs(simplex->change[i]);
    position = i;
  }
  return position;
}

static void put_in(qtr_simplex *simplex, int32_t number, bool *taken) {
  qtr_column column;
  if (number < 0) {
    find_elastic_change(simplex, number);
  } else {
    get_column(simplex, number, &column);
    find_change(simplex, &column);
  }
  const uint32_t position = find_position(simplex, taken);
  if (position == simplex->rows) return;
  replace(simplex, position);
  simplex->basis[position] = number;
  taken[position] = true;
}

static void find_levels(qtr_simplex *simplex) {
  memset(simplex->level, 0, simplex->rows * sizeof simplex->level[0]);
  for (uint32_t row = 0; row < simplex->rows; row++)
    for (uint32_t i = 0; i < simplex->rows; i++)
      simplex->level[i] += inverse_column(simplex, row)[i] * simplex->right[row];
}

/* An elastic column that would be below 0 is the other one of its row. */
static void turn_elastics(qtr_simplex *simplex) {
  for (uint32_t i = 0; i < simplex->rows; i++) {
    if (simplex->level[i] >= 0.0) continue;
    if (simplex->basis[i] >= 0) {
      simplex->level[i] = 0.0;
      continue;
    }
    simplex->basis[i] = elastic_of(row_of(simplex->basis[i]), !is_over(simplex->basis[i]));
    simplex->level[i] = -simplex->level[i];
    for (uint32_t row = 0; row < simplex->rows; row++) inverse_column(simplex, row)[i] *= -1.0;
  }
}

static void find_worths(qtr_simplex *simplex) {
  for (uint32_t i = 0; i < simplex->rows; i++) {
    qtr_column column;
    if (simplex->basis[i] >= 0)
      get_column(simplex, simplex->basis[i], &column);
    else
      column.worth = worth_of_elastic(simplex, simplex->basis[i]);
    simplex->worth[i] = column.worth;
  }
}

static void find_prices(qtr_simplex *simplex) {
  for (uint32_t row = 0; row < simplex->rows; row++) {
    const double *inverse = inverse_column(simplex, row);
    double price = 0.0;
    for (uint32_t i = 0; i < simplex->rows; i++) price += simplex->worth[i] * inverse[i];
    simplex->price[row] = price;
  }
}

/* A column that has come to depend on the others is left out; an elastic one stands where it stood. */
void qtr_simplex_refactor(qtr_simplex *simplex) {
  bool *taken = simplex->taken;
  begin_inverse(simplex);
  memset(taken, 0, simplex->rows * sizeof *taken);
  for (uint32_t pass = 0; pass < 2; pass++)
    for (uint32_t i = 0; i < simplex->rows; i++)
      if ((simplex->order[i] < 0) == (pass == 0)) put_in(simplex, simplex->order[i], taken);
  find_levels(simplex);
  turn_elastics(simplex);
  find_worths(simplex);
  find_prices(simplex);
  simplex->pivots = 0;
}

/* ---- elastic columns given room ---- */

/* One at a level of next to nothing holds its price where it is, too; but where the price may be anything, there
 * must be an end to it. */
static bool is_narrow(const qtr_simplex *simplex, int32_t elastic) {
  return simplex->most[row_of(elastic)] - simplex->least[row_of(elastic)] < ROOMY * simplex->widest;
}

bool qtr_simplex_widen(qtr_simplex *simplex, double least) {
  bool widened = false;
  for (uint32_t i = 0; i < simplex->rows; i++) {
    const int32_t elastic = simplex->basis[i];
    if (elastic < 0 && (simplex->level[i] > least || is_narrow(simplex, elastic)) && widen(simplex, elastic))
      widened = true;
  }
  if (!widened) return false;
  find_worths(simplex);
  find_prices(simplex);
  return true;
}

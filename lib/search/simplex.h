/* The revised simplex method on linear programmes that are given column by column:
 *
 *   most of   sum of worth_c x_c   with   sum of a_ic x_c = right_i for each row i,   x_c >= 0.
 *
 * Columns of zeros and ones, of which the caller has too many to hand over: it looks for those that are worth more than
 * the prices of their rows, and lets them enter. Each row also has two elastic columns, +1 at a worth of `least` and -1
 * at a cost of `most`: the row's price stays between the two. They make a first basis, keep prices near where they are
 * known to be good (du Merle and others 1999: stabilized column generation), and are widened where they are still in
 * the basis at the end. One with a least of 0 for good is a row's slack.
 *
 * Prices that are a little wrong do no harm: what they prove is computed anew from all columns (search/selection.h).
 */
#ifndef QUARTER_SEARCH_SIMPLEX_H
#define QUARTER_SEARCH_SIMPLEX_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* The rows in which a column has a one, ascending. */
typedef struct {
  double worth;
  uint32_t count;
  uint16_t *row;
} qtr_column;

/* Fills in the column of that number, 0 and up. */
typedef void (*qtr_column_of)(const void *context, int32_t number, qtr_column *column);

typedef struct {
  uint32_t rows, rows_most;
  qtr_column_of columns;
  const void *context;
  double widest;   /* room that a price had at first */
  uint32_t pivots; /* since the inverse was worked out anew */
  double *inverse; /* of the basis: columns one behind the other, rows_most apart */
  double *price;   /* of each row */
  double *right;
  double *least, *most; /* of each row's price */
  bool *has_slack;      /* its least is never below 0 */
  double *level;        /* of each column in the basis */
  double *worth;
  int32_t *basis; /* 0 and up: the caller's columns; below: elastic ones */
  double *change; /* scratch: a row each */
  bool *taken;
  int32_t *order;
  uint16_t *one;
} qtr_simplex;

/* Bytes of the block for so many rows at most. */
size_t qtr_simplex_bytes(uint32_t rows);

/* No rows, in a block aligned for a double. */
void qtr_simplex_init(qtr_simplex *simplex, void *block, uint32_t rows, qtr_column_of columns, const void *context);

/* Add a row, its price between `least` and `most`, which it begins at. To be refactored before anything enters. */
void qtr_simplex_add_row(qtr_simplex *simplex, double right, double least, double most, bool has_slack);

/* Whether a row's slack is in the basis: it holds nobody back, and may go. */
bool qtr_simplex_is_slack(const qtr_simplex *simplex, uint32_t row);

/* Remove a row whose slack is in the basis; those behind it move up by one. To be refactored before anything enters. */
void qtr_simplex_remove_row(qtr_simplex *simplex, uint32_t row);

/* Work out inverse, levels and prices anew from the basis, and the worths of its columns. */
void qtr_simplex_refactor(qtr_simplex *simplex);

/* What a column is worth more than the prices of its rows. */
double qtr_simplex_gain(const qtr_simplex *simplex, const qtr_column *column);

/* Let a column of the caller's with a gain enter the basis. False: it cannot, numerically. */
bool qtr_simplex_enter(qtr_simplex *simplex, int32_t number, const qtr_column *column);

/* Let the elastic column with the greatest gain enter, or give it room. False: there is none with more than `least`. */
bool qtr_simplex_enter_elastic(qtr_simplex *simplex, double least);

/* Give room to the prices whose elastic columns are in the basis, above a level of `least` without end. False: there
 * are none, and what is in the basis solves the programme. */
bool qtr_simplex_widen(qtr_simplex *simplex, double least);

#endif

#include "search/cuts.h"

#include <stdint.h>

#include "model/rounding.h"

/* Walks that seekers could take, and what L is at least by them. */
typedef struct {
  double value;
  int visits[QTR_MAX_PLACES];
} sorties;

static unsigned targets_of(const qtr_gains *gains) {
  return gains->environment->targets.count;
}

/* L's slope is 1 - visits with each price. What a cut says of the center is `step` before what it says of the prices on
 * trial. */
static void add_cut(qtr_bundle *bundle, const qtr_gains *gains, const double *step, double value, const int *visits) {
  int16_t slope[QTR_MAX_PLACES];
  for (unsigned target = 0; target < targets_of(gains); target++) {
    /* So many visits come of absurd prices alone, and a cut that says too little of them leads away no less. */
    slope[target] = (int16_t)(visits[target] < INT16_MAX ? 1 - visits[target] : -INT16_MAX);
    value -= (double)slope[target] * step[target];
  }
  qtr_bundle_add(bundle, value, slope);
}

/* ---- seekers that start alike ---- */

static bool are_alike(const qtr_gains *gains, unsigned seeker, unsigned other) {
  const qtr_board *board = &gains->game->board;
  return board->start_of[seeker] == board->start_of[other] && gains->kind_of[seeker] == gains->kind_of[other] &&
         qtr_board_ready(board, seeker) == qtr_board_ready(board, other);
}

/* How many are like a seeker; 0 where one of them comes before it. */
static unsigned crew_of(const qtr_gains *gains, unsigned seeker) {
  unsigned alike = 0;
  for (unsigned other = 0; other < gains->game->board.seekers; other++) {
    if (!are_alike(gains, seeker, other)) continue;
    if (other < seeker) return 0;
    alike++;
  }
  return alike;
}

static unsigned largest_crew(const qtr_gains *gains) {
  unsigned largest = 0;
  for (unsigned seeker = 0; seeker < gains->game->board.seekers; seeker++) {
    const unsigned crew = crew_of(gains, seeker);
    if (crew > largest) largest = crew;
  }
  return largest;
}

/* ---- walks apart ---- */

/* All of a crew go where the first of them would, `taken` left out, which then are taken, too. */
static void send(const qtr_gains *gains, const double *price, unsigned seeker, unsigned crew, qtr_places *taken,
                 sorties *all) {
  int visits[QTR_MAX_PLACES] = {0};
  all->value += crew * qtr_gains_walk_but(gains, seeker, taken, price, visits);
  for (unsigned target = 0; target < targets_of(gains); target++) {
    all->visits[target] += (int)crew * visits[target];
    if (visits[target] > 0) qtr_places_add(taken, target);
  }
}

/* The walks of each crew's number `number`, from 0; of crews that are smaller, the best. */
static void send_all(const qtr_gains *gains, const double *price, unsigned number, qtr_places *taken, sorties *all) {
  all->value = qtr_objective_left(&gains->game->objective, 1.0);
  for (unsigned target = 0; target < targets_of(gains); target++) {
    all->value += price[target];
    all->visits[target] = 0;
  }
  for (unsigned seeker = 0; seeker < gains->game->board.seekers; seeker++) {
    const unsigned crew = crew_of(gains, seeker);
    if (crew == 0) continue;
    if (crew <= number) qtr_places_clear(&taken[seeker]);
    send(gains, price, seeker, crew, &taken[seeker], all);
  }
}

/* The last one is the best walks', which stays if there is no more room. */
void qtr_cuts_add(qtr_bundle *bundle, const qtr_gains *gains, const double *price, const double *step, double upper,
                  const int *visits) {
  qtr_places taken[QTR_MAX_SEEKERS];
  const unsigned most = largest_crew(gains);
  sorties all;
  for (unsigned seeker = 0; seeker < gains->game->board.seekers; seeker++) qtr_places_clear(&taken[seeker]);
  for (unsigned number = 0; most > 1 && number < most; number++) {
    send_all(gains, price, number, taken, &all);
    if (number > 0) add_cut(bundle, gains, step, all.value, all.visits);
  }
  add_cut(bundle, gains, step, upper, visits);
}

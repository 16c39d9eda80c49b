#include "host/table/table_check.h"

#include <float.h>
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "host/table/certificate.h"
#include "quarter/field.h"
#include "quarter/nominal.h"
#include "quarter/objective.h"
#include "quarter/status.h"

#define MEND "learn it again"
#define ROUNDING 1e-7 /* relative: what two ways to add up one value may differ by */

static unsigned nodes_of(const qtr_policy *policy) {
  return (unsigned)policy->board.places + policy->board.starts;
}

/* ---- travel times and regions against the grid ---- */

static const char *say_steps(char *text, size_t size, qtr_steps steps) {
  if (steps == QTR_NEVER)
    snprintf(text, size, "no way");
  else
    snprintf(text, size, "%" PRIu32 " steps", steps);
  return text;
}

/* Steps along the way that a robot goes. */
static qtr_steps steps_on(const qtr_policy *policy, const qtr_field *field, qtr_cell cell) {
  qtr_steps steps = 0;
  for (qtr_cell next; (next = qtr_field_next(field, &policy->grid, cell)) != cell; cell = next) {
    if (next == QTR_NO_CELL) return QTR_NEVER;
    steps += qtr_grid_cost(&policy->grid, next);
  }
  return steps;
}

static int check_times_to(const qtr_policy *policy, const qtr_field *field, unsigned place, const char *path,
                          fault *why) {
  const unsigned places = policy->board.places;
  for (unsigned node = 0; node < nodes_of(policy); node++) {
    const qtr_steps told = qtr_board_class_steps(&policy->board, 0, node, place);
    const qtr_steps true_steps = steps_on(policy, field, qtr_policy_cell(policy, node));
    char said[32], is[32];
    if (told == true_steps) continue;
    return fault_set(
        why, "%s: its travel times are not its map's: from %s %u to place %u it says %s, the map gives %s; " MEND, path,
        node < places ? "place" : "start", node < places ? node : node - places, place,
        say_steps(said, sizeof said, told), say_steps(is, sizeof is, true_steps));
  }
  return 0;
}

/* A cell's region stands in for it: what one reaches the other must. */
static int check_regions_to(const qtr_policy *policy, const qtr_field *field, unsigned place, const char *path,
                            fault *why) {
  const uint32_t cells = policy->any_start ? qtr_grid_cells(&policy->grid) : 0;
  for (uint32_t cell = 0; cell < cells; cell++) {
    if (qtr_grid_cost(&policy->grid, (qtr_cell)cell) == 0) continue;
    const unsigned start = qtr_policy_region(policy, (qtr_cell)cell);
    const qtr_steps from_start = qtr_board_class_steps(&policy->board, 0, policy->board.places + start, place);
    if ((from_start == QTR_NEVER) == (qtr_field_next(field, &policy->grid, (qtr_cell)cell) == QTR_NO_CELL)) continue;
    return fault_set(
        why, "%s: its regions are not its map's: the cell at column %u, row %u is cut off from its region; " MEND, path,
        (unsigned)(cell % policy->grid.columns), (unsigned)(cell / policy->grid.columns));
  }
  return 0;
}

static int check_grid(const qtr_policy *policy, const char *path, fault *why) {
  qtr_field *field = malloc(sizeof *field);
  int status = field != NULL ? 0 : fault_set(why, "%s: no memory to check it", path);
  for (unsigned place = 0; place < policy->board.places && status == 0; place++) {
    if (qtr_field_fill(field, &policy->grid, qtr_policy_cell(policy, place)) != QTR_OK)
      status = fault_set(why, "%s: place %u cannot be entered; " MEND, path, place);
    if (status == 0) status = check_times_to(policy, field, place, path, why);
    if (status == 0) status = check_regions_to(policy, field, place, path, why);
  }
  free(field);
  return status;
}

/* ---- the certificate against the play ---- */

/* Each place's step of first visit in the nominal game, QTR_NEVER for none. */
static void find_visits(const qtr_policy *policy, qtr_steps *visit) {
  const qtr_board *board = &policy->board;
  for (unsigned place = 0; place < board->places; place++) visit[place] = QTR_NEVER;
  for (int seeker = 0; seeker < board->seekers; seeker++) {
    unsigned node = (unsigned)board->places + board->start_of[seeker];
    qtr_joint joint;
    qtr_steps now = 0;
    uint16_t place;
    qtr_joint_start(&joint, board, NULL, NULL);
    while ((place = qtr_policy_play(policy, &joint, seeker, &now, NULL)) != QTR_STAND_DOWN) {
      const qtr_steps when = now + qtr_board_steps(board, (unsigned)seeker, node, place);
      if (when < visit[place]) visit[place] = when;
      node = place;
    }
  }
}

/* What the nominal game earns, and by how much the rounded likelihoods may make it differ. */
typedef struct {
  double value, time, value_error, time_error;
} earnings;

static earnings play(const qtr_policy *policy, double gamma) {
  qtr_steps visit[QTR_MAX_PLACES];
  earnings e = {0};
  find_visits(policy, visit);
  for (unsigned place = 0; place < policy->board.places; place++) {
    const double likelihood = qtr_policy_weight(policy, place) / 4294967296.0;
    const double worth = QTR_REWARD_SCALE * pow(gamma, visit[place] > 0 ? visit[place] - 1.0 : 0.0);
    e.value += likelihood * worth;
    e.time += likelihood * visit[place];
    e.value_error += worth / 4294967296.0;
    e.time_error += visit[place] / 4294967296.0;
  }
  e.value_error += ROUNDING * e.value;
  e.time_error += ROUNDING * e.time;
  return e;
}

static int check_certificate(const qtr_policy *policy, const char *path, fault *why) {
  const table_certificate c = table_certificate_of(policy);
  const double between = fabs(c.bound - c.figure) / c.figure;
  const earnings e = play(policy, c.gamma);
  if (c.figure >= DBL_MIN && fabs(c.gap - between) > ROUNDING * (1.0 + between))
    return fault_set(why, "%s: its gap of %.3g is not what lies between its objective %.6g and its bound %.6g; " MEND,
                     path, c.gap, c.figure, c.bound);
  if (fabs(c.value - e.value) > e.value_error)
    return fault_set(why, "%s: it says that it earns %.6g, and its routes earn %.6g; " MEND, path, c.value, e.value);
  if (fabs(c.expected_time - e.time) > e.time_error)
    return fault_set(why, "%s: it says that a find takes %.6g steps, and by its routes it takes %.6g; " MEND, path,
                     c.expected_time, e.time);
  return 0;
}

int table_check(const qtr_policy *policy, const char *path, fault *why) {
  const int status = check_grid(policy, path, why);
  return status == 0 ? check_certificate(policy, path, why) : status;
}

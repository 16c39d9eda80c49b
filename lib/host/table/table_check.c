#include "host/table/table_check.h"

#include <float.h>
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "host/table/certificate.h"
#include "quarter/claim.h"
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

/* Base steps along the way that a robot goes. */
static qtr_steps steps_on(const qtr_grid *grid, const qtr_field *field, qtr_cell cell) {
  qtr_steps steps = 0;
  for (qtr_cell next; (next = qtr_field_next(field, grid, cell)) != cell; cell = next) {
    if (next == QTR_NO_CELL) return QTR_NEVER;
    steps += qtr_grid_cost(grid, next);
  }
  return steps;
}

/* The first seeker of a class: whose ground is the class's. -1 if there is none. */
static int seeker_of(const qtr_policy *policy, unsigned of_class) {
  for (int i = 0; i < policy->board.seekers; i++)
    if (policy->board.class_of[i] == of_class) return i;
  return -1;
}

/* What a way of so many base steps takes a class, the scan at its end included. */
static qtr_steps steps_of_class(const qtr_policy *policy, unsigned of_class, qtr_steps base, qtr_steps scan) {
  if (base == QTR_NEVER || scan == QTR_NEVER) return QTR_NEVER;
  return base * qtr_claim_cell_steps(policy, of_class) + scan;
}

static int wrong_time(const qtr_policy *policy, unsigned node, unsigned place, qtr_steps told, qtr_steps is,
                      const char *path, fault *why) {
  const unsigned places = policy->board.places;
  char said[32], map[32];
  return fault_set(why,
                   "%s: its travel times are not its map's: from %s %u to place %u it says %s, the map gives %s; " MEND,
                   path, node < places ? "place" : "start", node < places ? node : node - places, place,
                   say_steps(said, sizeof said, told), say_steps(map, sizeof map, is));
}

/* Of a class nobody is of, nothing can be said: its ground is nobody's. `field` is of `grid`, the class's, to the
 * place; a place keeps the class away where it says so of the way to itself, which is its scan. */
static int check_times_to(const qtr_policy *policy, const qtr_field *field, const qtr_grid *grid, unsigned of_class,
                          unsigned place, const char *path, fault *why) {
  const qtr_steps scan = qtr_board_class_steps(&policy->board, of_class, place, place);
  for (unsigned node = 0; node < nodes_of(policy); node++) {
    const qtr_steps told = qtr_board_class_steps(&policy->board, of_class, node, place);
    const qtr_steps base = field != NULL ? steps_on(grid, field, qtr_policy_cell(policy, node)) : QTR_NEVER;
    const qtr_steps is = steps_of_class(policy, of_class, base, scan);
    if (told != is) return wrong_time(policy, node, place, told, is, path, why);
  }
  return 0;
}

/* A cell's region stands in for it: what one reaches the other must. `field` as for the times; NULL: the class reaches
 * the place from nowhere. */
static int check_regions_to(const qtr_policy *policy, const qtr_field *field, const qtr_grid *grid, unsigned of_class,
                            unsigned place, const char *path, fault *why) {
  const uint32_t cells = policy->any_start ? qtr_grid_cells(grid) : 0;
  const bool avoided = qtr_board_class_steps(&policy->board, of_class, place, place) == QTR_NEVER;
  for (uint32_t cell = 0; cell < cells; cell++) {
    if (qtr_grid_cost(&policy->grid, (qtr_cell)cell) == 0) continue;
    const unsigned start = qtr_policy_region(policy, (qtr_cell)cell);
    const qtr_steps from_start = qtr_board_class_steps(&policy->board, of_class, policy->board.places + start, place);
    const bool enters = !avoided && field != NULL && qtr_grid_cost(grid, (qtr_cell)cell) > 0;
    const bool has_way = enters && qtr_field_next(field, grid, (qtr_cell)cell) != QTR_NO_CELL;
    if ((from_start != QTR_NEVER) == has_way) continue;
    return fault_set(
        why, "%s: its regions are not its map's: the cell at column %u, row %u is cut off from its region; " MEND, path,
        (unsigned)(cell % policy->grid.columns), (unsigned)(cell / policy->grid.columns));
  }
  return 0;
}

/* A class that may not enter a place's cell has no way there. */
static int check_class(const qtr_policy *policy, qtr_field *field, unsigned of_class, unsigned place, const char *path,
                       fault *why) {
  const int seeker = seeker_of(policy, of_class);
  if (seeker < 0) return 0;
  const qtr_grid grid = qtr_policy_ground(policy, (unsigned)seeker);
  const bool enters = qtr_field_fill(field, &grid, qtr_policy_cell(policy, place)) == QTR_OK;
  const int status = check_times_to(policy, enters ? field : NULL, &grid, of_class, place, path, why);
  return status == 0 ? check_regions_to(policy, enters ? field : NULL, &grid, of_class, place, path, why) : status;
}

static int check_place(const qtr_policy *policy, qtr_field *field, unsigned place, const char *path, fault *why) {
  int status = 0;
  for (unsigned of_class = 0; of_class < qtr_board_classes(&policy->board) && status == 0; of_class++)
    status = check_class(policy, field, of_class, place, path, why);
  return status;
}

/* The ways home of a seeker, where the table has them. */
static int check_home(const qtr_policy *policy, qtr_field *field, unsigned seeker, const char *path, fault *why) {
  const qtr_board *board = &policy->board;
  const qtr_grid grid = qtr_policy_ground(policy, seeker);
  const qtr_cell start = qtr_policy_cell(policy, (unsigned)board->places + board->start_of[seeker]);
  if (qtr_field_fill(field, &grid, start) != QTR_OK)
    return fault_set(why, "%s: robot %u cannot come back to its start; " MEND, path, seeker);
  for (unsigned place = 0; place < board->places; place++) {
    const qtr_steps base = steps_on(&grid, field, qtr_policy_cell(policy, place));
    if (qtr_board_home(board, seeker, place) == steps_of_class(policy, board->class_of[seeker], base, 0)) continue;
    return fault_set(why, "%s: its way home of robot %u from place %u is not its map's; " MEND, path, seeker, place);
  }
  return 0;
}

static int check_grid(const qtr_policy *policy, const char *path, fault *why) {
  qtr_field *field = malloc(sizeof *field);
  int status = field != NULL ? 0 : fault_set(why, "%s: no memory to check it", path);
  for (unsigned place = 0; place < policy->board.places && status == 0; place++)
    status = check_place(policy, field, place, path, why);
  for (unsigned i = 0; policy->board.terms.end != NULL && i < policy->board.seekers && status == 0; i++)
    status = check_home(policy, field, i, path, why);
  free(field);
  return status;
}

/* ---- the certificate against the play ---- */

/* The nominal game as it goes: each place's step of first visit, QTR_NEVER for none, and where and when each seeker
 * ends. */
typedef struct {
  qtr_steps visit[QTR_MAX_PLACES];
  unsigned last[QTR_MAX_SEEKERS];  /* node */
  qtr_steps free[QTR_MAX_SEEKERS]; /* when */
} course;

static void follow(course *c, const qtr_policy *policy) {
  const qtr_board *board = &policy->board;
  for (unsigned place = 0; place < board->places; place++) c->visit[place] = QTR_NEVER;
  for (int seeker = 0; seeker < board->seekers; seeker++) {
    unsigned node = (unsigned)board->places + board->start_of[seeker];
    qtr_joint joint;
    qtr_steps now = 0;
    uint16_t place;
    qtr_joint_start(&joint, board, NULL, NULL);
    c->free[seeker] = qtr_board_ready(board, (unsigned)seeker);
    while ((place = qtr_policy_play(policy, &joint, seeker, &now, NULL)) != QTR_STAND_DOWN) {
      const qtr_steps when = now + qtr_board_steps(board, (unsigned)seeker, node, place);
      if (when < c->visit[place]) c->visit[place] = when;
      c->free[seeker] = when;
      node = place;
    }
    c->last[seeker] = node;
  }
}

/* Looks at a place count in the order in which they are made. */
static void sort_looks(course *c, const qtr_policy *policy) {
  for (unsigned place = 0; place < policy->board.places; place++) {
    for (unsigned before = 0; before < place; before++) {
      const qtr_steps sooner = c->visit[place];
      if (qtr_policy_place(policy, before) != qtr_policy_place(policy, place) || c->visit[before] <= sooner) continue;
      c->visit[place] = c->visit[before];
      c->visit[before] = sooner;
    }
  }
}

static qtr_steps latest_end(const qtr_policy *policy) {
  qtr_steps latest = 0;
  for (unsigned i = 0; i < policy->board.seekers; i++) {
    const qtr_steps end = qtr_board_end(&policy->board, i);
    if (end != QTR_NEVER && end > latest) latest = end;
  }
  return latest;
}

/* Steps until all seekers are home, summed up. Ways home stand in a table with ends alone. */
static double steps_home(const course *c, const qtr_policy *policy) {
  qtr_field *field = malloc(sizeof *field);
  double sum = 0.0;
  for (unsigned i = 0; field != NULL && i < policy->board.seekers; i++) {
    const qtr_grid grid = qtr_policy_ground(policy, i);
    const qtr_cell start = qtr_policy_cell(policy, (unsigned)policy->board.places + policy->board.start_of[i]);
    qtr_field_fill(field, &grid, start);
    sum += c->free[i];
    sum += steps_of_class(policy, policy->board.class_of[i],
                          steps_on(&grid, field, qtr_policy_cell(policy, c->last[i])), 0);
  }
  free(field);
  return sum;
}

/* What the nominal game earns, and by how much the rounded likelihoods may make it differ. */
typedef struct {
  double value, time, found, value_error, time_error, found_error;
} earnings;

static void add_place(earnings *e, const table_certificate *c, double likelihood, qtr_steps visit, qtr_steps end) {
  const bool in_time = visit != QTR_NEVER && (c->objective != QTR_DEADLINE || visit <= c->deadline);
  const double time = visit != QTR_NEVER ? visit : end;
  const double worth = visit != QTR_NEVER ? QTR_REWARD_SCALE * pow(c->gamma, visit > 0 ? visit - 1.0 : 0.0) : 0.0;
  e->value += c->findable * likelihood * worth;
  e->time += likelihood * time;
  e->found += in_time ? c->findable * likelihood : 0.0;
  e->value_error += worth / 4294967296.0;
  e->time_error += time / 4294967296.0;
  e->found_error += 1.0 / 4294967296.0;
}

static earnings play(const qtr_policy *policy, const table_certificate *certificate) {
  course c;
  earnings e = {0};
  follow(&c, policy);
  if (certificate->home_weight > 0.0) e.time = certificate->home_weight * steps_home(&c, policy);
  sort_looks(&c, policy);
  const qtr_steps end = latest_end(policy);
  for (unsigned place = 0; place < policy->board.places; place++)
    add_place(&e, certificate, qtr_policy_weight(policy, place) / 4294967296.0, c.visit[place], end);
  e.value_error += ROUNDING * e.value;
  e.time_error += ROUNDING * e.time;
  e.found_error += ROUNDING;
  return e;
}

static int check_certificate(const qtr_policy *policy, const char *path, fault *why) {
  const table_certificate c = table_certificate_of(policy);
  const double between = fabs(c.bound - c.figure) / c.figure;
  const earnings e = play(policy, &c);
  if (c.figure >= DBL_MIN && fabs(c.gap - between) > ROUNDING * (1.0 + between))
    return fault_set(why, "%s: its gap of %.3g is not what lies between its objective %.6g and its bound %.6g; " MEND,
                     path, c.gap, c.figure, c.bound);
  if (fabs(c.value - e.value) > e.value_error)
    return fault_set(why, "%s: it says that it earns %.6g, and its routes earn %.6g; " MEND, path, c.value, e.value);
  if (fabs(c.expected_time - e.time) > e.time_error)
    return fault_set(why, "%s: it says that a find takes %.6g steps, and by its routes it takes %.6g; " MEND, path,
                     c.expected_time, e.time);
  if (fabs(c.found - e.found) > e.found_error)
    return fault_set(why, "%s: it says that it finds with probability %.6g, and its routes find with %.6g; " MEND, path,
                     c.found, e.found);
  return 0;
}

int table_check(const qtr_policy *policy, const char *path, fault *why) {
  const int status = check_grid(policy, path, why);
  return status == 0 ? check_certificate(policy, path, why) : status;
}

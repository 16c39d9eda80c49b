#include "body.h"

#include <math.h>

#include "driver.h"

#define SECOND 1e6 /* microseconds */

static uint32_t cell_steps(const qtr_policy *policy, unsigned self) {
  return qtr_claim_cell_steps(policy, policy->board.class_of[self]);
}

static uint32_t fewest_steps(const qtr_policy *policy) {
  uint32_t fewest = cell_steps(policy, 0);
  for (unsigned i = 1; i < policy->board.seekers; i++)
    if (cell_steps(policy, i) < fewest) fewest = cell_steps(policy, i);
  return fewest;
}

double body_step_seconds(const qtr_policy *policy) {
  return 1.0 / (DRIVER_SPEED * fewest_steps(policy));
}

double body_pace(const qtr_policy *policy) {
  qtr_claim claim;
  qtr_claim_read(&claim, policy);
  return claim.step_time_us > 0 ? claim.step_time_us / SECOND / body_step_seconds(policy) : 1.0;
}

static int64_t moment(const robot_body *body, double steps) {
  return (int64_t)llround(steps * body->step);
}

static int64_t moment_beyond(const robot_body *body, double reserve) {
  const double ready = qtr_board_ready(&body->policy->board, body->self);
  const double end = qtr_board_end(&body->policy->board, body->self);
  return moment(body, end + reserve * (end - ready));
}

robot_body body_of(const qtr_policy *policy, unsigned self) {
  const qtr_board *board = &policy->board;
  robot_body body = {.policy = policy, .self = self, .step = SECOND * body_step_seconds(policy)};
  const bool ends = qtr_board_end(board, self) != QTR_NEVER;
  body.speed = DRIVER_SPEED * fewest_steps(policy) / cell_steps(policy, self);
  body.ready = moment(&body, qtr_board_ready(board, self));
  body.back_by = ends ? moment_beyond(&body, BODY_RESERVE) : BODY_TIRELESS;
  body.empty = ends ? moment_beyond(&body, 2 * BODY_RESERVE) : BODY_TIRELESS;
  return body;
}

bool body_tires(const robot_body *body) {
  return body->back_by != BODY_TIRELESS;
}

bool body_may_visit(const robot_body *body, unsigned place) {
  const qtr_board *board = &body->policy->board;
  return qtr_board_steps(board, body->self, (unsigned)board->places + board->start_of[body->self], place) != QTR_NEVER;
}

int64_t body_scan(const robot_body *body, unsigned place) {
  return moment(body, qtr_board_steps(&body->policy->board, body->self, place, place));
}

int64_t body_travel(const robot_body *body, unsigned ground_steps) {
  return (int64_t)llround(SECOND * ground_steps / body->speed);
}

bool body_lasts(const robot_body *body, int64_t utime, unsigned ground_steps, unsigned place) {
  if (!body_tires(body)) return true;
  const qtr_steps home = qtr_board_home(&body->policy->board, body->self, place);
  if (home == QTR_NEVER) return false;
  const int64_t leaves = utime > body->ready ? utime : body->ready;
  return leaves + body_travel(body, ground_steps) + body_scan(body, place) + moment(body, home) <= body->back_by;
}

#include "robot.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

#include "driver.h"

#define ARRIVED 0.11   /* cells from a place's middle */
#define EYE_RANGE 1.45 /* cells: what is seen beyond is not looked at */

/* ---- the plan's pilot ---- */

static uint16_t plan_target(void *self) {
  return qtr_seeker_target(self);
}

static void plan_visited(void *self, uint16_t place) {
  qtr_seeker_visited(self, place);
}

static void plan_hear(void *self, int signal, unsigned territory) {
  qtr_seeker_hear(self, signal, territory);
}

static bool plan_announce(void *self, uint8_t *territory) {
  return qtr_seeker_announce(self, territory);
}

robot_pilot robot_pilot_of_plan(qtr_seeker *seeker) {
  return (robot_pilot){seeker, plan_target, plan_visited, plan_hear, plan_announce};
}

/* ---- what it hears ---- */

void robot_init(robot *r, const qtr_policy *policy, int self, bool clear_all, robot_pilot pilot, robot_voice voice) {
  memset(r, 0, offsetof(robot, way));
  r->policy = policy;
  r->g = ground_of(policy);
  r->self = self;
  r->clear_all = clear_all;
  r->pilot = pilot;
  r->voice = voice;
}

void robot_hear_pose(robot *r, const message_pose *m) {
  r->pose = *m;
  r->placed = true;
}

static void learn(robot *r, int signal, int territory) {
  if (signal == QTR_SIGNAL_FOUND && r->clear_all) return;
  if (gossip_learn(&r->known, signal, territory)) r->pilot.hear(r->pilot.self, signal, (unsigned)territory);
}

void robot_hear_terminate(robot *r, const message_terminate *m) {
  if (m->sender != r->self) learn(r, m->signal, m->signal == QTR_SIGNAL_FOUND ? 0 : m->territory);
}

/* ---- what it says ---- */

static void say_signal(void *user, int signal, int territory) {
  const robot *r = user;
  const message_terminate m = {r->utime, r->self, signal, territory};
  r->voice.terminate(r->voice.user, &m);
}

static void say_wheels(const robot *r, driver_wheels wheels) {
  const message_command m = {r->utime, r->self, wheels.left * r->g.cell_size, wheels.right * r->g.cell_size};
  r->voice.command(r->voice.user, &m);
}

/* ---- what it does ---- */

bool robot_stopped(const robot *r) {
  return r->known.found || r->pilot.target(r->pilot.self) == QTR_STAND_DOWN;
}

static point position(const robot *r) {
  return ground_point(&r->g, r->pose.x, r->pose.y);
}

/* Only where pose and scan are of one moment: or, with messages lost, a place might count as scanned that was not. */
static bool arrived(const robot *r, uint16_t target) {
  if (r->pose.utime != r->utime || target == QTR_STAND_DOWN) return false;
  const point at = position(r);
  const point goal = ground_centre(&r->g, qtr_policy_cell(r->policy, target));
  return hypot(goal.x - at.x, goal.y - at.y) < ARRIVED;
}

static void take_announcements(robot *r) {
  uint8_t territory;
  while (r->pilot.announce(r->pilot.self, &territory)) gossip_learn(&r->known, QTR_SIGNAL_TERRITORY_DONE, territory);
}

static driver_wheels drive(robot *r, const message_scan *m, uint16_t target) {
  const qtr_cell goal = qtr_policy_cell(r->policy, target);
  float range[MESSAGE_RAYS];
  if (!r->way_known || target != r->target) {
    qtr_field_fill(&r->way, &r->policy->grid, goal);
    r->target = target;
    r->way_known = true;
  }
  for (int ray = 0; ray < MESSAGE_RAYS; ray++) range[ray] = (float)((double)m->range[ray] / r->g.cell_size);
  const driver_view view = {position(r), r->pose.heading, MESSAGE_RAYS, range, EYE_RANGE};
  return driver_steer(&view, driver_aim(&r->g, &r->way, goal, view.at));
}

void robot_hear_scan(robot *r, const message_scan *m) {
  driver_wheels wheels = {0.0, 0.0};
  r->utime = m->utime;
  if (!r->placed) {
    gossip_repeat(&r->known, r->utime, say_signal, r);
    return;
  }
  if (m->mine) learn(r, QTR_SIGNAL_FOUND, 0);
  uint16_t target = r->pilot.target(r->pilot.self);
  if (!robot_stopped(r) && arrived(r, target)) r->pilot.visited(r->pilot.self, target);
  take_announcements(r);
  target = r->pilot.target(r->pilot.self);
  if (!robot_stopped(r)) wheels = drive(r, m, target);
  say_wheels(r, wheels);
  gossip_repeat(&r->known, r->utime, say_signal, r);
}

#include "robot.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

#include "driver.h"

#define NEAR 0.16         /* cells from a place's middle at which the mine sensor is read */
#define IN_RANGE 0.33     /* cells at which it is read where something stands on the place */
#define MADE_WAY 0.5      /* cells */
#define PATIENCE 2500000  /* microseconds without making way after which it tries the other side */
#define KEEP_LEFT 3000000 /* microseconds for which it does at least */
#define PI 3.14159265358979323846

/* ---- the plan's pilot ---- */

static uint16_t plan_target(void *self) {
  return qtr_seeker_target(self);
}

static void plan_visited(void *self, uint16_t place) {
  qtr_seeker_visited(self, place);
}

static void plan_blocked(void *self, uint16_t place) {
  qtr_seeker_blocked(self, place);
}

static void plan_found(void *self) {
  qtr_seeker_found(self);
}

static bool plan_hear(void *self, const qtr_signal *signal) {
  return qtr_seeker_hear(self, signal);
}

static bool plan_announce(void *self, qtr_signal *signal) {
  return qtr_seeker_announce(self, signal);
}

static bool plan_known(void *self, unsigned index, qtr_signal *signal) {
  return qtr_seeker_known(self, index, signal);
}

robot_pilot robot_pilot_of_plan(qtr_seeker *seeker) {
  return (robot_pilot){seeker,       seeker->identity, seeker->run, plan_target,   plan_visited,
                       plan_blocked, plan_found,       plan_hear,   plan_announce, plan_known};
}

void robot_init(robot *r, const qtr_policy *policy, int self, bool clear_all, robot_pilot pilot, robot_voice voice) {
  memset(r, 0, offsetof(robot, way));
  r->policy = policy;
  r->g = ground_of(policy);
  r->self = self;
  r->clear_all = clear_all;
  r->pilot = pilot;
  r->voice = voice;
  r->asked = QTR_STAND_DOWN;
  qtr_signal signal;
  for (unsigned i = 0; pilot.known(pilot.self, i, &signal); i++) gossip_learn(&r->known, signal.kind, signal.territory);
}

bool robot_stopped(const robot *r) {
  return r->known.found || r->pilot.target(r->pilot.self) == QTR_STAND_DOWN;
}

/* ---- what it says ---- */

static void say_signal(void *user, int signal, int territory) {
  const robot *r = user;
  const message_terminate m = {r->utime, r->self, signal, territory, r->pilot.identity, r->pilot.run};
  r->voice.terminate(r->voice.user, &m);
}

static void say_command(const robot *r, driver_wheels wheels) {
  const message_command m = {r->utime, r->self, wheels.left * r->g.cell_size, wheels.right * r->g.cell_size,
                             r->asked != QTR_STAND_DOWN};
  r->voice.command(r->voice.user, &m);
}

/* ---- what it hears ---- */

/* Who has stopped says so whenever it hears anything: its standing order may have been lost. */
static void rest(robot *r) {
  const driver_wheels none = {0.0, 0.0};
  r->asked = QTR_STAND_DOWN;
  say_command(r, none);
  gossip_repeat(&r->known, r->utime, say_signal, r);
}

/* A signal as the message has it. False for one that says nothing which a robot could say. */
static bool signal_of(qtr_signal *signal, const message_terminate *m) {
  const bool is_found = m->signal == QTR_SIGNAL_FOUND;
  if (!is_found && m->signal != QTR_SIGNAL_TERRITORY_DONE) return false;
  if (!is_found && (m->territory < 0 || m->territory >= DEMO_MOST_ROBOTS)) return false;
  *signal = (qtr_signal){m->identity, m->run, (uint8_t)m->signal, (uint8_t)(is_found ? 0 : m->territory)};
  return true;
}

void robot_hear_pose(robot *r, const message_pose *m) {
  if (r->off) return;
  r->pose = *m;
  r->poses++;
  if (!robot_stopped(r)) return;
  r->utime = m->utime;
  rest(r);
}

void robot_hear_terminate(robot *r, const message_terminate *m) {
  qtr_signal signal;
  if (r->off || m->sender == r->self || !signal_of(&signal, m)) return;
  if (signal.kind == QTR_SIGNAL_FOUND && r->clear_all) return;
  if (r->pilot.hear(r->pilot.self, &signal)) gossip_learn(&r->known, signal.kind, signal.territory);
  if (r->known.news && robot_stopped(r)) rest(r);
}

/* ---- what it does ---- */

static point position(const robot *r) {
  return ground_point(&r->g, r->pose.x, r->pose.y);
}

/* Against the grid. */
static double heading_of(const robot *r) {
  return r->pose.heading - r->g.turn;
}

/* The nearest thing in the direction of a point, in cells. */
static double nearest_towards(const robot *r, const message_scan *m, point goal) {
  const point at = position(r);
  const double turn = remainder(atan2(goal.y - at.y, goal.x - at.x) - heading_of(r), 2 * PI) / (2 * PI);
  const int ray = (int)lround(turn * DEMO_RAYS);
  double nearest = DEMO_EYE_TRUST;
  for (int beside = -1; beside <= 1; beside++) {
    const double range = (double)m->range[((ray + beside) % DEMO_RAYS + DEMO_RAYS) % DEMO_RAYS] / r->g.cell_size;
    if (range < nearest) nearest = range;
  }
  return nearest;
}

/* Distance from a place, in cells. What was measured where is known only if pose and scan are of one moment: with
 * messages lost, a place might count as scanned that was not. */
static double away_from(const robot *r, const message_scan *m, uint16_t place) {
  const point at = position(r);
  const point goal = ground_centre(&r->g, qtr_policy_cell(r->policy, place));
  return r->pose.utime == m->utime ? hypot(goal.x - at.x, goal.y - at.y) : HUGE_VAL;
}

/* Near enough to read the mine sensor: a robot that was lost on the place keeps others from standing there. */
static bool is_near(const robot *r, const message_scan *m, uint16_t target) {
  const double away = away_from(r, m, target);
  const point goal = ground_centre(&r->g, qtr_policy_cell(r->policy, target));
  return away < NEAR || (away < IN_RANGE && nearest_towards(r, m, goal) < away);
}

/* The sensor was read over the target: it is there, or the robot goes on to the next. */
static void heed_reading(robot *r, const message_scan *m) {
  if (!m->read) return;
  if (m->mine && !r->clear_all) {
    r->pilot.found(r->pilot.self);
    gossip_learn(&r->known, QTR_SIGNAL_FOUND, 0);
  }
  if (r->asked == QTR_STAND_DOWN || r->known.found || away_from(r, m, r->asked) > IN_RANGE) return;
  r->pilot.visited(r->pilot.self, r->asked);
}

static void take_announcements(robot *r) {
  qtr_signal signal;
  while (r->pilot.announce(r->pilot.self, &signal)) gossip_learn(&r->known, signal.kind, signal.territory);
}

/* Who makes no way tries the other side of the road: a lost robot may lie just where one would turn. On slow ground all
 * takes longer. */
static double choose_lane(robot *r) {
  const point at = position(r);
  const int64_t slowness = ground_slowness(&r->g, at);
  if (hypot(at.x - r->anchor.x, at.y - r->anchor.y) > MADE_WAY) {
    r->anchor = at;
    r->anchored = r->utime;
    if (r->left && r->utime - r->switched > slowness * KEEP_LEFT) r->left = false;
  } else if (r->utime - r->anchored > slowness * PATIENCE) {
    r->anchored = r->utime;
    r->switched = r->utime;
    r->left = !r->left;
  }
  return r->left ? -DEMO_LANE : DEMO_LANE;
}

static driver_wheels drive(robot *r, const message_scan *m, uint16_t target) {
  const qtr_cell goal = qtr_policy_cell(r->policy, target);
  float range[DEMO_RAYS];
  if (!r->way_known || target != r->target) {
    qtr_field_fill(&r->way, &r->policy->grid, goal);
    r->target = target;
    r->way_known = true;
    hope_begin(&r->hope, r->utime);
  }
  if (!hope_left(&r->hope, &r->way, &r->g, position(r), r->utime)) {
    r->pilot.blocked(r->pilot.self, target);
    r->way_known = false;
  }
  for (int ray = 0; ray < DEMO_RAYS; ray++) range[ray] = (float)((double)m->range[ray] / r->g.cell_size);
  const driver_view view = {position(r), heading_of(r), DEMO_RAYS, range, DEMO_EYE_TRUST};
  return driver_steer(&view, driver_aim(&r->g, &r->way, goal, view.at, choose_lane(r)));
}

void robot_hear_scan(robot *r, const message_scan *m) {
  driver_wheels wheels = {0.0, 0.0};
  if (r->off) return;
  r->utime = m->utime;
  if (r->poses > 0) {
    heed_reading(r, m);
    take_announcements(r);
    const uint16_t target = r->pilot.target(r->pilot.self);
    const bool drives = !robot_stopped(r);
    r->asked = drives && is_near(r, m, target) ? target : QTR_STAND_DOWN;
    if (drives) wheels = drive(r, m, target);
    say_command(r, wheels);
  }
  gossip_repeat(&r->known, r->utime, say_signal, r);
}

#include "robot.h"

#include <limits.h>
#include <math.h>
#include <stddef.h>
#include <string.h>

#include "driver.h"

#define NEAR 0.16         /* cells from a place's middle at which the mine sensor is read */
#define IN_RANGE 0.33     /* cells at which it is read where something stands on the place */
#define AT_HOME 0.45      /* cells from its start's middle at which it is home */
#define BY_HOME 1.2       /* cells at which it is where something stands in between: others are home already */
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
  r->self = self;
  robot_embody(r, policy);
  r->clear_all = clear_all;
  r->pilot = pilot;
  r->voice = voice;
  r->asked = QTR_STAND_DOWN;
  qtr_signal signal;
  for (unsigned i = 0; pilot.known(pilot.self, i, &signal); i++) gossip_learn(&r->known, signal.kind, signal.territory);
}

void robot_embody(robot *r, const qtr_policy *policy) {
  r->body = body_of(policy, (unsigned)r->self);
  r->g = ground_of(policy);
  r->g.grid = qtr_policy_ground(policy, (unsigned)r->self);
}

bool robot_stopped(const robot *r) {
  if (r->known.found) return true;
  return (r->home || !body_tires(&r->body)) && r->pilot.target(r->pilot.self) == QTR_STAND_DOWN;
}

/* ---- what it says ---- */

static void say_signal(void *user, int signal, int territory) {
  const robot *r = user;
  const message_terminate m = {r->utime, r->self, signal, territory, r->pilot.identity, r->pilot.run};
  r->voice.terminate(r->voice.user, &m);
}

static const driver_wheels standing = {0.0, 0.0};

static void say_command(const robot *r, driver_wheels wheels, enum message_intent intent) {
  const message_command m = {
      r->utime, r->self, wheels.left * r->g.cell_size, wheels.right * r->g.cell_size, r->asked != QTR_STAND_DOWN,
      intent};
  r->voice.command(r->voice.user, &m);
}

/* ---- what it hears ---- */

/* Who has stopped says so whenever it hears anything: its standing order may have been lost. */
static void rest(robot *r) {
  r->asked = QTR_STAND_DOWN;
  say_command(r, standing, INTENT_SEARCH);
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

/* Distance from a cell's middle, in cells. What was measured where is known only if pose and scan are of one moment:
 * with messages lost, a place might count as scanned that was not. */
static double away_from(const robot *r, const message_scan *m, qtr_cell cell) {
  const point at = position(r);
  const point goal = ground_centre(&r->g, cell);
  return r->pose.utime == m->utime ? hypot(goal.x - at.x, goal.y - at.y) : HUGE_VAL;
}

/* Near enough to read the mine sensor: a robot that was lost on the place keeps others from standing there. */
static bool is_near(const robot *r, const message_scan *m, uint16_t target) {
  const qtr_cell cell = qtr_policy_cell(r->policy, target);
  const double away = away_from(r, m, cell);
  return away < NEAR || (away < IN_RANGE && nearest_towards(r, m, ground_centre(&r->g, cell)) < away);
}

/* The sensor was read over the target: it is there, or the robot goes on to the next. */
static void heed_reading(robot *r, const message_scan *m) {
  if (!m->read) return;
  if (m->mine && !r->clear_all) {
    r->pilot.found(r->pilot.self);
    gossip_learn(&r->known, QTR_SIGNAL_FOUND, 0);
  }
  if (r->asked == QTR_STAND_DOWN || r->known.found || away_from(r, m, qtr_policy_cell(r->policy, r->asked)) > IN_RANGE)
    return;
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
  const double slowness = ground_slowness(&r->g, at) / r->body.speed;
  if (hypot(at.x - r->anchor.x, at.y - r->anchor.y) > MADE_WAY) {
    r->anchor = at;
    r->anchored = r->utime;
    if (r->left && (double)(r->utime - r->switched) > slowness * KEEP_LEFT) r->left = false;
  } else if ((double)(r->utime - r->anchored) > slowness * PATIENCE) {
    r->anchored = r->utime;
    r->switched = r->utime;
    r->left = !r->left;
  }
  return r->left ? -DEMO_LANE : DEMO_LANE;
}

static qtr_cell start_of(const robot *r) {
  const qtr_board *board = &r->policy->board;
  return qtr_policy_cell(r->policy, (unsigned)board->places + board->start_of[r->self]);
}

/* To a place, or home. */
static qtr_cell goal_of(const robot *r, uint16_t target) {
  return target != QTR_STAND_DOWN ? qtr_policy_cell(r->policy, target) : start_of(r);
}

static void find_way(robot *r, uint16_t target) {
  if (r->way_known && target == r->target) return;
  qtr_field_fill(&r->way, &r->g.grid, goal_of(r, target));
  r->target = target;
  r->way_known = true;
  hope_begin(&r->hope, r->utime);
}

static void give_up(robot *r, uint16_t target) {
  r->pilot.blocked(r->pilot.self, target);
  r->way_known = false;
}

static driver_wheels steer(robot *r, const message_scan *m) {
  const qtr_cell goal = goal_of(r, r->target);
  float range[DEMO_RAYS];
  for (int ray = 0; ray < DEMO_RAYS; ray++) range[ray] = (float)((double)m->range[ray] / r->g.cell_size);
  const driver_view view = {position(r), heading_of(r), DEMO_RAYS, range, DEMO_EYE_TRUST, r->body.speed};
  return driver_steer(&view, driver_aim(&r->g, &r->way, goal, view.at, choose_lane(r)));
}

static driver_wheels drive(robot *r, const message_scan *m, uint16_t target) {
  find_way(r, target);
  if (!hope_left(&r->hope, &r->way, &r->g, position(r), r->body.speed, r->utime)) give_up(r, target);
  return steer(r, m);
}

/* ---- what it can do ---- */

/* Pushed into a wall it cannot say: it will see when it is out again. */
static bool has_battery_for(const robot *r, uint16_t target) {
  const qtr_cell here = ground_cell(&r->g, position(r));
  if (here == QTR_NO_CELL || qtr_grid_cost(&r->g.grid, here) == 0) return true;
  const unsigned steps = hope_steps(&r->way, &r->g.grid, here);
  return steps == UINT_MAX || body_lasts(&r->body, r->utime, steps, target);
}

/* A look that has begun is brought to its end: there was battery for it. */
static bool can_make(robot *r, uint16_t target) {
  if (!body_may_visit(&r->body, target)) return false;
  if (!body_tires(&r->body) || r->asked == target) return true;
  find_way(r, target);
  if (has_battery_for(r, target)) return true;
  r->tired = true;
  return false;
}

/* What it cannot make is as good as blocked: it takes the next, and in the end none. Ends, for each time round a place
 * is given up, and each is so twice at most. */
static uint16_t choose_target(robot *r) {
  for (;;) {
    const uint16_t target = r->pilot.target(r->pilot.self);
    if (target == QTR_STAND_DOWN || r->known.found || can_make(r, target)) return target;
    give_up(r, target);
  }
}

/* Where a look takes time it stands for it, and is not given up for that. */
static void search(robot *r, const message_scan *m, uint16_t target) {
  const bool takes_time = body_scan(&r->body, target) > 0;
  const bool looks_on = takes_time && r->asked == target && away_from(r, m, goal_of(r, target)) < IN_RANGE;
  r->home = false;
  r->asked = looks_on || is_near(r, m, target) ? target : QTR_STAND_DOWN;
  if (!takes_time || r->asked == QTR_STAND_DOWN) {
    say_command(r, drive(r, m, target), INTENT_SEARCH);
    return;
  }
  r->anchored = r->utime;
  hope_begin(&r->hope, r->utime);
  say_command(r, standing, INTENT_SEARCH);
}

static bool is_home(const robot *r, const message_scan *m) {
  const double away = away_from(r, m, start_of(r));
  return away < AT_HOME || (away < BY_HOME && nearest_towards(r, m, ground_centre(&r->g, start_of(r))) < away);
}

static void go_home(robot *r, const message_scan *m) {
  r->asked = QTR_STAND_DOWN;
  r->home = is_home(r, m);
  find_way(r, QTR_STAND_DOWN);
  say_command(r, r->home ? standing : steer(r, m), r->tired ? INTENT_TIRED : INTENT_HOME);
}

static void act(robot *r, const message_scan *m) {
  const uint16_t target = choose_target(r);
  if (robot_stopped(r) || r->utime < r->body.ready) {
    r->asked = QTR_STAND_DOWN;
    say_command(r, standing, robot_stopped(r) ? INTENT_SEARCH : INTENT_WAIT);
  } else if (target == QTR_STAND_DOWN) {
    go_home(r, m);
  } else {
    search(r, m, target);
  }
}

void robot_hear_scan(robot *r, const message_scan *m) {
  if (r->off) return;
  r->utime = m->utime;
  if (r->poses > 0) {
    heed_reading(r, m);
    take_announcements(r);
    act(r, m);
  }
  gossip_repeat(&r->known, r->utime, say_signal, r);
}

#include "follow.h"

#include <stdio.h>
#include <string.h>

#include "bus.h"
#include "live.h"
#include "quarter/seeker.h"

#define BEHIND 1000000 /* microseconds: an older message came late, one older than that is of another game */

/* What was seen so far: from what is new in a message the events are made. */
typedef struct {
  const plan *p;
  ground g;
  live *view;
  int robots;
  world_pose pose[DEMO_MOST_ROBOTS];
  int64_t tick; /* utime of the last pose; below 0: none came */
  message_status last;
  bool done[DEMO_MOST_ROBOTS];
  bool warned; /* of another mission's game */
  uint32_t identity;
} follower;

static double seconds(int64_t utime) {
  return (double)utime / 1e6;
}

static void tell(follower *f, int64_t utime, int kind, int robot, int place, int territory) {
  const arena_event e = {.at = seconds(utime), .kind = kind, .robot = robot, .place = place, .territory = territory};
  live_event(f->view, f->p, &e);
}

/* A frame is whole when the next moment's poses begin to come: of a robot that is lost there are none. */
static void hear_pose(void *user, const message_pose *m) {
  follower *f = user;
  if (f->tick >= 0 && m->utime != f->tick) live_frame(f->view, seconds(f->tick), f->robots, f->g.grid.rows, f->pose);
  f->tick = m->utime;
  f->pose[m->robot] = (world_pose){ground_point(&f->g, m->x, m->y), m->heading - f->g.turn};
}

static void hear_terminate(void *user, const message_terminate *m) {
  follower *f = user;
  if (m->identity != f->identity || m->signal != QTR_SIGNAL_TERRITORY_DONE || m->territory >= f->robots ||
      m->sender >= f->robots)
    return;
  if (!f->done[m->territory]) tell(f, m->utime, EVENT_DONE, m->sender, -1, m->territory);
  f->done[m->territory] = true;
}

static void compare_places(follower *f, const message_status *m) {
  for (int place = 0; place < m->places; place++)
    if (m->scanned_by[place] >= 0 && f->last.scanned_by[place] < 0)
      tell(f, m->utime, m->found[place] ? EVENT_FOUND : EVENT_SCANNED, m->scanned_by[place], place, -1);
}

static void compare_robots(follower *f, const message_status *m) {
  static const int kinds[] = {
      [STATE_ALIVE] = EVENT_UNSTUCK, [STATE_STOPPED] = EVENT_STOPPED, [STATE_LOST] = EVENT_LOST,
      [STATE_STUCK] = EVENT_STUCK,   [STATE_OFF] = EVENT_RESET,       [STATE_TIRED] = EVENT_TIRED};
  for (int i = 0; i < m->robots; i++) {
    if (m->state[i] == f->last.state[i]) continue;
    const bool back = m->state[i] == STATE_ALIVE && f->last.state[i] == STATE_OFF;
    tell(f, m->utime, back ? EVENT_RESTARTED : kinds[m->state[i]], i, -1, -1);
  }
}

static point start_of(const follower *f, int robot) {
  const qtr_policy *policy = &f->p->t.policy;
  return ground_centre(&f->g, qtr_policy_cell(policy, (unsigned)policy->board.places + policy->board.start_of[robot]));
}

static void forget(follower *f) {
  memset(&f->last, 0, sizeof f->last);
  memset(f->last.scanned_by, -1, sizeof f->last.scanned_by);
  memset(f->done, 0, sizeof f->done);
  for (int i = 0; i < f->robots; i++) f->pose[i] = (world_pose){start_of(f, i), 0.0};
  f->tick = -1;
  live_restart(f->view);
}

static bool is_ours(follower *f, const message_status *m) {
  const int places = f->p->places;
  if (m->robots == f->robots && m->places == places) return true;
  if (!f->warned)
    fprintf(stderr, "quarter-demo: a game of %d robots and %d places is on this bus, not of %s; it is not shown\n",
            m->robots, m->places, f->p->name);
  f->warned = true;
  return false;
}

static void hear_status(void *user, const message_status *m) {
  follower *f = user;
  if (!is_ours(f, m)) return;
  if (m->utime < f->last.utime) {
    if (f->last.utime - m->utime <= BEHIND) return;
    forget(f);
  }
  compare_places(f, m);
  compare_robots(f, m);
  f->last = *m;
}

int follow(const settings *s, const plan *p, const volatile int *interrupted, fault *why) {
  bus *b;
  follower f = {.p = p, .g = ground_of(&p->t.policy), .robots = p->t.policy.board.seekers};
  qtr_deployment home;
  qtr_deployment_init(&home, &p->t.policy, NULL, NULL);
  f.identity = qtr_deployment_identity(&home, &p->t.policy);
  if (bus_open_sealed(&b, s->lcm_url, s->key, why) != 0) return -1;
  int status = live_open(&f.view, s->port, why);
  if (status == 0) {
    forget(&f);
    live_hello(f.view, p, &(record_head){s->seed, s->clear_all, -1});
    for (int i = 0; i < f.robots; i++) bus_hear_pose(b, i, hear_pose, &f);
    bus_hear_terminate(b, hear_terminate, &f);
    bus_hear_status(b, hear_status, &f);
    fprintf(stderr, "Following the bus until Ctrl-C.\n");
    while (*interrupted == 0) bus_wait(b, 100);
  }
  live_close(f.view);
  bus_close(b);
  return status;
}

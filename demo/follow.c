#include "follow.h"

#include <stdio.h>
#include <string.h>

#include "bus.h"
#include "live.h"
#include "quarter/seeker.h"

/* What was seen so far: from what is new in a message the events are made. */
typedef struct {
  const plan *p;
  ground g;
  live *view;
  int robots;
  world_pose pose[WORLD_MOST_ROBOTS];
  message_status last;
  bool known; /* `last` holds something */
  bool done[WORLD_MOST_ROBOTS];
} follower;

static double seconds(int64_t utime) {
  return (double)utime / 1e6;
}

static void tell(follower *f, int64_t utime, int kind, int robot, int place, int territory) {
  const arena_event e = {seconds(utime), kind, robot, place, territory, 0.0};
  live_event(f->view, &e);
}

static void hear_pose(void *user, const message_pose *m) {
  follower *f = user;
  f->pose[m->robot] = (world_pose){ground_point(&f->g, m->x, m->y), m->heading};
  if (m->robot == f->robots - 1) live_frame(f->view, seconds(m->utime), f->robots, f->g.grid.rows, f->pose);
}

static void hear_terminate(void *user, const message_terminate *m) {
  follower *f = user;
  if (m->signal != QTR_SIGNAL_TERRITORY_DONE || m->territory < 0 || m->territory >= f->robots) return;
  if (!f->done[m->territory]) tell(f, m->utime, EVENT_DONE, m->sender, -1, m->territory);
  f->done[m->territory] = true;
}

static void compare_places(follower *f, const message_status *m) {
  const int places = f->p->t.policy.board.places;
  for (int place = 0; place < m->places && place < places; place++)
    if (m->scanned_by[place] >= 0 && f->last.scanned_by[place] < 0)
      tell(f, m->utime, m->found[place] ? EVENT_FOUND : EVENT_SCANNED, m->scanned_by[place], place, -1);
}

static void compare_robots(follower *f, const message_status *m) {
  static const int kinds[] = {[STATE_ALIVE] = EVENT_UNSTUCK,
                              [STATE_STOPPED] = EVENT_STOPPED,
                              [STATE_LOST] = EVENT_LOST,
                              [STATE_STUCK] = EVENT_STUCK};
  for (int i = 0; i < m->robots && i < f->robots; i++) {
    if (m->state[i] == f->last.state[i] || m->state[i] < STATE_ALIVE || m->state[i] > STATE_STUCK) continue;
    tell(f, m->utime, kinds[m->state[i]], i, -1, -1);
  }
}

/* A clock that goes back is another game. */
static void hear_status(void *user, const message_status *m) {
  follower *f = user;
  if (!f->known || m->utime < f->last.utime) {
    memset(&f->last, 0, sizeof f->last);
    memset(f->last.scanned_by, -1, sizeof f->last.scanned_by);
    memset(f->done, 0, sizeof f->done);
  }
  compare_places(f, m);
  compare_robots(f, m);
  f->last = *m;
  f->known = true;
}

int follow(const settings *s, const plan *p, const volatile int *interrupted, fault *why) {
  bus *b;
  follower f = {.p = p, .g = ground_of(&p->t.policy), .robots = p->t.policy.board.seekers};
  if (bus_open(&b, s->lcm_url, why) != 0) return -1;
  int status = live_open(&f.view, s->port, why);
  if (status == 0) {
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

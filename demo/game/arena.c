#include "arena.h"

#include <math.h>
#include <string.h>

#include "looks.h"
#include "quarter/seeker.h"
#include "rng.h"

#define STEPS 3 /* of the world in a tick */
#define STATUS_TICKS 4
#define WATCHDOG 500000 /* microseconds without a command after which wheels stand */
#define STILL 0.5       /* seconds of standing orders after which a robot counts as stopped */
#define LINGER 1.0      /* seconds for which the game goes on after the last one stopped */
#define NEAR_HOME 1.4   /* cells from its start at which a robot that went home is there */
#define MOVED 0.3       /* cells that count as making way */
#define DEADLOCK 20.0   /* seconds without, on good ground */

static int64_t utime_of(const arena *a) {
  return (int64_t)llround(1e6 * a->now);
}

/* The last one that there is room for says that there is no more. */
static void note(arena *a, arena_event event) {
  if (a->events == ARENA_EVENTS) return;
  if (a->events == ARENA_EVENTS - 1)
    event = (arena_event){.kind = EVENT_MORE, .robot = -1, .place = -1, .territory = -1};
  event.at = a->now;
  a->event[a->events++] = event;
}

/* ---- what it hears ---- */

/* What a command says of its robot's intent that viewers would hear of; EVENT_MORE: nothing. */
static int news_of(const arena_robot *r, const message_command *m) {
  if (m->intent == r->intent || r->state == STATE_LOST) return EVENT_MORE;
  if (m->intent == INTENT_HOME) return EVENT_HOMEWARD;
  if (m->intent == INTENT_TIRED) return EVENT_TIRED;
  return r->intent == INTENT_WAIT ? EVENT_READY : EVENT_MORE;
}

/* Who goes says where to; who stands has arrived, or was never on its way. */
static void heed_intent(arena *a, const message_command *m) {
  arena_robot *r = &a->robot[m->robot];
  if (m->left != 0.0 || m->right != 0.0) {
    const int news = news_of(r, m);
    if (news != EVENT_MORE) note(a, (arena_event){.kind = news, .robot = m->robot, .place = -1, .territory = -1});
    r->homeward = m->intent >= INTENT_HOME;
  }
  r->intent = m->intent;
}

static void hear_command(void *user, const message_command *m) {
  arena *a = user;
  if (m->robot >= a->robots) return;
  a->commands++;
  arena_robot *r = &a->robot[m->robot];
  if (r->off) return; /* said before its power failed */
  const bool still = m->left == 0.0 && m->right == 0.0 && !m->read && m->intent != INTENT_WAIT;
  if (still && !r->still) r->still_since = a->now;
  r->still = still;
  heed_intent(a, m);
  r->read = m->read;
  r->heard = true;
  r->commanded = utime_of(a);
  if (r->state == STATE_LOST) return;
  world_drive(a->w, m->robot, m->left / a->g.cell_size, m->right / a->g.cell_size);
}

/* The world is no robot: it listens in for the viewers' sake. */
static void hear_terminate(void *user, const message_terminate *m) {
  arena *a = user;
  a->signals++;
  if (m->sender >= a->robots) return;
  if (m->identity != a->identity || m->run != a->setup.run) {
    a->stranger = m->sender;
    return;
  }
  if (m->signal != QTR_SIGNAL_TERRITORY_DONE || m->territory >= a->robots) return;
  if (a->done[m->territory]) return;
  a->done[m->territory] = true;
  note(a, (arena_event){.kind = EVENT_DONE, .robot = m->sender, .place = -1, .territory = m->territory});
}

/* ---- setting up ---- */

static int draw_mine(const arena *a, rng *dice) {
  double left = rng_unit(dice);
  for (int place = 0; place < a->places - 1; place++) {
    left -= a->setup.truth != NULL ? a->setup.truth->likelihood[place] : table_probability(a->t, (unsigned)place);
    if (left < 0.0) return place;
  }
  return a->places - 1;
}

/* Whether a place of the table is one of the mission's own, and no later look at one: those come behind. */
static bool is_own(const arena *a, int place) {
  return (int)qtr_policy_place(&a->t->policy, (unsigned)place) == place;
}

static void count_owed(arena *a) {
  const qtr_policy *policy = &a->t->policy;
  for (int place = 0; place < a->places; place++) a->scanned_by[place] = -1;
  for (unsigned look = 0; look < policy->board.places; look++) a->owed[qtr_policy_place(policy, look)]++;
}

int arena_open(arena *a, const table *t, bus *b, const arena_setup *setup, fault *why) {
  rng dice;
  qtr_deployment home;
  memset(a, 0, sizeof *a);
  a->t = t;
  a->b = b;
  a->setup = *setup;
  a->g = ground_of(&t->policy);
  a->robots = t->policy.board.seekers;
  while (a->places < t->policy.board.places && is_own(a, a->places)) a->places++;
  if (a->robots > DEMO_MOST_ROBOTS || a->places > DEMO_MOST_PLACES)
    return fault_set(why, "the demo holds %d robots and %d places at most; this table has %d and %d", DEMO_MOST_ROBOTS,
                     DEMO_MOST_PLACES, a->robots, a->places);
  qtr_deployment_init(&home, &t->policy, NULL, NULL);
  a->identity = qtr_deployment_identity(&home, &t->policy);
  a->stranger = -1;
  rng_seed(&dice, setup->seed);
  a->mine = setup->mine == -1 ? draw_mine(a, &dice) : setup->mine;
  a->w = world_new(&t->policy, rng_next(&dice));
  if (a->w == NULL) return fault_set(why, "no memory for the world");
  a->found_at = -1.0;
  count_owed(a);
  for (int i = 0; i < a->robots; i++) {
    a->robot[i].body = body_of(&t->policy, (unsigned)i);
    a->robot[i].look.place = -1;
    a->robot[i].stopped_at = -1.0;
    a->robot[i].anchor = world_pose_of(a->w, i).at;
    bus_hear_command(b, i, hear_command, a);
  }
  bus_hear_terminate(b, hear_terminate, a);
  return 0;
}

void arena_close(arena *a) {
  world_free(a->w);
  a->w = NULL;
}

/* ---- sensing ---- */

static bool over_place(const arena *a, point at, int place) {
  const point middle = ground_centre(&a->g, qtr_policy_cell(&a->t->policy, (unsigned)place));
  return hypot(middle.x - at.x, middle.y - at.y) < DEMO_MINE_RANGE;
}

/* The place under a robot's sensor; -1: none. */
static int place_under(const arena *a, point at) {
  for (int place = 0; place < a->places; place++)
    if (over_place(a, at, place)) return place;
  return -1;
}

static double detection_of(const arena *a, int place) {
  return a->setup.truth != NULL ? a->setup.truth->detection[place] : 1.0;
}

/* What a look is to viewers; EVENT_MORE: nothing that they would hear of. */
static int kind_of_look(const arena *a, int place, bool saw) {
  if (a->found_at < 0.0 && saw) return EVENT_FOUND;
  if (a->found_at < 0.0 && place == a->mine) return EVENT_MISSED;
  if (a->looks[place] > a->owed[place]) return EVENT_MORE;
  return a->looks[place] == 1 ? EVENT_SCANNED : EVENT_LOOKED;
}

static void note_look(arena *a, int robot, int place, bool saw) {
  const int kind = kind_of_look(a, place, saw);
  if (kind == EVENT_FOUND) a->found_at = a->now;
  if (kind != EVENT_MORE) note(a, (arena_event){.kind = kind, .robot = robot, .place = place, .territory = -1});
  if (a->looks[place] > a->owed[place]) {
    a->duplicates++;
    return;
  }
  a->look_place[a->counted] = (uint16_t)place;
  a->look_at[a->counted++] = a->now;
}

/* A look has ended: whether it saw a mine. */
static bool end_look(arena *a, int robot, int place) {
  a->looks[place]++;
  qtr_places_add(&a->robot[robot].scanned, (unsigned)place);
  if (a->scanned_by[place] < 0) {
    a->scanned_by[place] = (int8_t)robot;
    a->scanned_at[place] = a->now;
  }
  const bool saw = place == a->mine && looks_find(a->setup.seed, a->looks[place], detection_of(a, place));
  note_look(a, robot, place, saw);
  return saw;
}

/* Read a robot's mine sensor, as it asks. Whether a look has ended, and in *mine what it saw. Where looks take no time
 * there is one for as long as it stays, for its answer may be lost on the way; and what was found is marked. */
static bool sense_mine(arena *a, int robot, point at, bool *mine) {
  arena_robot *r = &a->robot[robot];
  const int place = r->read ? place_under(a, at) : -1;
  if (place != r->look.place) r->look = (arena_look){.place = place, .since = a->now};
  *mine = place >= 0 && place == a->mine && a->found_at >= 0.0 && !a->setup.clear_all;
  if (place < 0 || *mine) return r->read;
  const double takes = (double)body_scan(&r->body, (unsigned)place) / 1e6;
  if (!r->look.ended) {
    if (a->now + 1e-9 < r->look.since + takes) return false;
    r->look.saw = end_look(a, robot, place);
    r->look.ended = takes <= 0.0;
    r->look.since = a->now;
  }
  *mine = r->look.saw;
  return true;
}

static bool is_looking(const arena_robot *r) {
  return r->look.place >= 0 && !r->look.ended;
}

static void publish_robot(arena *a, int robot) {
  const world_pose pose = world_pose_of(a->w, robot);
  const message_pose where = {utime_of(a), robot, ground_x_m(&a->g, pose.at), ground_y_m(&a->g, pose.at),
                              pose.heading + a->g.turn};
  message_scan scan = {.utime = where.utime, .robot = robot};
  scan.read = sense_mine(a, robot, pose.at, &scan.mine);
  world_look(a->w, robot, scan.range, DEMO_RAYS);
  for (int ray = 0; ray < DEMO_RAYS; ray++) scan.range[ray] *= (float)a->g.cell_size;
  bus_send_pose(a->b, &where);
  bus_send_scan(a->b, &scan);
}

static void publish_status(const arena *a) {
  message_status m = {
      .utime = utime_of(a), .robots = a->robots, .places = a->places, .mines_found = a->found_at >= 0.0};
  for (int i = 0; i < a->robots; i++) {
    const arena_robot *r = &a->robot[i];
    m.state[i] = (int8_t)(r->state == STATE_ALIVE && r->intent == INTENT_TIRED ? STATE_TIRED : r->state);
  }
  for (int place = 0; place < a->places; place++) {
    m.scanned_by[place] = a->scanned_by[place];
    m.found[place] = a->found_at >= 0.0 && place == a->mine;
  }
  bus_send_status(a->b, &m);
}

void arena_publish(arena *a) {
  for (int robot = 0; robot < a->robots; robot++)
    if (a->robot[robot].state != STATE_LOST && !a->robot[robot].off) publish_robot(a, robot);
  if (a->ticks % STATUS_TICKS == 0) publish_status(a);
}

/* ---- faults ---- */

/* Its wheels, and what viewers see of it. */
static void settle(arena *a, int robot) {
  arena_robot *r = &a->robot[robot];
  world_stop_wheels(a->w, robot, r->stuck || r->off || r->state == STATE_LOST);
  if (r->state != STATE_LOST) r->state = r->off ? STATE_OFF : r->stuck ? STATE_STUCK : STATE_ALIVE;
}

/* With its power a robot's standing orders are gone; when it is there again, its program has as long as any to
 * answer. */
static void switch_power(arena *a, int robot, bool off) {
  arena_robot *r = &a->robot[robot];
  r->off = off;
  r->read = r->still = false;
  r->stopped_at = -1.0;
  r->commanded = utime_of(a);
  world_drive(a->w, robot, 0.0, 0.0);
}

static void strike(arena *a, const fault_event *f, int robot) {
  static const int kinds[] = {
      [FAULT_LOST] = EVENT_LOST, [FAULT_STUCK] = EVENT_STUCK, [FAULT_UNSTUCK] = EVENT_UNSTUCK,
      [FAULT_SLIP] = EVENT_SLIP, [FAULT_RESET] = EVENT_RESET, [FAULT_RESTART] = EVENT_RESTARTED};
  arena_robot *r = &a->robot[robot];
  if (r->state == STATE_LOST) return;
  switch (f->kind) {
  case FAULT_LOST: r->state = STATE_LOST; break;
  case FAULT_STUCK:
  case FAULT_UNSTUCK: r->stuck = f->kind == FAULT_STUCK; break;
  case FAULT_RESET:
  case FAULT_RESTART: switch_power(a, robot, f->kind == FAULT_RESET); break;
  default: world_slip(a->w, robot, f->share);
  }
  if (f->kind != FAULT_SLIP) settle(a, robot);
  r->anchored = a->now;
  note(a, (arena_event){.kind = kinds[f->kind], .robot = robot, .place = -1, .territory = -1, .share = f->share});
}

static int place_at(const arena *a, qtr_cell cell) {
  for (int place = 0; place < a->places; place++)
    if (qtr_policy_cell(&a->t->policy, (unsigned)place) == cell) return place;
  return -1;
}

/* A door shuts as soon as nobody is in it. */
static void shut_what_is_due(arena *a) {
  const fault_script *script = a->setup.faults;
  for (int i = 0; script != NULL && i < script->count; i++) {
    const fault_event *f = &script->event[i];
    if (f->kind != FAULT_SHUT || f->at > a->now || a->closed[i] || !world_shut(a->w, f->cell)) continue;
    const point middle = ground_centre(&a->g, f->cell);
    a->closed[i] = true;
    note(a, (arena_event){.kind = EVENT_SHUT,
                          .robot = -1,
                          .place = place_at(a, f->cell),
                          .territory = -1,
                          .middle = {middle.x, a->g.grid.rows - middle.y}});
  }
}

static void strike_what_is_due(arena *a) {
  const fault_script *script = a->setup.faults;
  while (script != NULL && a->next_fault < script->count && script->event[a->next_fault].at <= a->now) {
    const fault_event *f = &script->event[a->next_fault++];
    if (f->kind == FAULT_SHUT) continue;
    if (f->kind == FAULT_LOSS) {
      bus_lose(a->b, f->share, a->setup.seed + 1);
      note(a, (arena_event){.kind = EVENT_LOSS, .robot = -1, .place = -1, .territory = -1, .share = f->share});
      continue;
    }
    for (int robot = 0; robot < a->robots; robot++)
      if (f->robot < 0 || f->robot == robot) strike(a, f, robot);
  }
  shut_what_is_due(a);
}

/* ---- time ---- */

static void watch_silence(arena *a, int robot) {
  static const fault_event lost = {.kind = FAULT_LOST};
  arena_robot *r = &a->robot[robot];
  if (r->state == STATE_LOST || r->off || !r->heard || a->now - (double)r->commanded / 1e6 <= ARENA_SILENCE) return;
  r->silent = true;
  strike(a, &lost, robot);
}

/* It went home, and was not stopped on the way there. */
static bool is_home(const arena *a, int robot) {
  const qtr_policy *policy = &a->t->policy;
  const point home =
      ground_centre(&a->g, qtr_policy_cell(policy, (unsigned)policy->board.places + policy->board.start_of[robot]));
  const point at = world_pose_of(a->w, robot).at;
  return a->robot[robot].homeward && hypot(at.x - home.x, at.y - home.y) < NEAR_HOME;
}

/* Its battery has ended on the way. */
static void watch_battery(arena *a, int robot) {
  arena_robot *r = &a->robot[robot];
  if (r->state == STATE_LOST || r->stopped_at >= 0.0 || utime_of(a) < r->body.empty) return;
  r->state = STATE_LOST;
  settle(a, robot);
  note(a, (arena_event){.kind = EVENT_EMPTY, .robot = robot, .place = -1, .territory = -1});
}

static void note_stop(arena *a, int robot) {
  const int kind = is_home(a, robot) ? EVENT_HOME : EVENT_STOPPED;
  a->robot[robot].stopped_at = a->robot[robot].still_since;
  note(a, (arena_event){.kind = kind, .robot = robot, .place = -1, .territory = -1});
}

static void watch_stop(arena *a, int robot) {
  arena_robot *r = &a->robot[robot];
  if (r->state == STATE_LOST || r->off) return;
  if (!r->still || !r->heard) {
    r->stopped_at = -1.0;
    if (r->state == STATE_STOPPED) r->state = STATE_ALIVE;
  } else if (r->stopped_at < 0.0 && a->now - r->still_since >= STILL) {
    note_stop(a, robot);
  }
  /* Now, or when it is no longer stuck. */
  if (r->stopped_at >= 0.0 && r->state == STATE_ALIVE) r->state = STATE_STOPPED;
}

static void watch_deadlock(arena *a, int robot) {
  arena_robot *r = &a->robot[robot];
  const point at = world_pose_of(a->w, robot).at;
  const double patience = DEADLOCK * ground_slowness(&a->g, at) / r->body.speed;
  const bool waits = is_looking(r) || r->intent == INTENT_WAIT;
  if (r->state != STATE_ALIVE || waits || hypot(at.x - r->anchor.x, at.y - r->anchor.y) > MOVED) {
    r->anchor = at;
    r->anchored = a->now;
    r->deadlocked = false;
  } else if (!r->deadlocked && a->now - r->anchored > patience) {
    r->deadlocked = true;
    a->deadlocks++;
    note(a, (arena_event){.kind = EVENT_DEADLOCK, .robot = robot, .place = -1, .territory = -1});
  }
}

void arena_advance(arena *a) {
  strike_what_is_due(a);
  for (int robot = 0; robot < a->robots; robot++)
    if (utime_of(a) - a->robot[robot].commanded > WATCHDOG) world_drive(a->w, robot, 0.0, 0.0);
  for (int step = 0; step < STEPS; step++) world_step(a->w);
  a->ticks++;
  a->now = (double)a->ticks * ARENA_TICK;
  for (int robot = 0; robot < a->robots; robot++) {
    watch_silence(a, robot);
    watch_stop(a, robot);
    watch_battery(a, robot);
    watch_deadlock(a, robot);
  }
}

static int count_lost(const arena *a) {
  int lost = 0;
  for (int robot = 0; robot < a->robots; robot++) lost += a->robot[robot].state == STATE_LOST;
  return lost;
}

int arena_silent(const arena *a) {
  int silent = 0;
  for (int robot = 0; robot < a->robots; robot++) silent += a->robot[robot].silent;
  return silent;
}

bool arena_abandoned(const arena *a) {
  return arena_silent(a) > 0 && count_lost(a) == a->robots;
}

double arena_all_stopped_at(const arena *a) {
  double last = -1.0;
  for (int robot = 0; robot < a->robots; robot++) {
    const arena_robot *r = &a->robot[robot];
    if (r->state == STATE_LOST) continue;
    if (r->stopped_at < 0.0) return -1.0;
    if (r->stopped_at > last) last = r->stopped_at;
  }
  return last;
}

bool arena_over(const arena *a) {
  const double stopped = arena_all_stopped_at(a);
  if (a->now >= a->setup.time_limit || count_lost(a) == a->robots) return true;
  return stopped >= 0.0 && a->now >= stopped + STILL + LINGER;
}

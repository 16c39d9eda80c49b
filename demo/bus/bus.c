#include "bus.h"

#include <lcm/eventlog.h>
#include <lcm/lcm.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "channels.h"
#include "quarter_command.h"
#include "quarter_pose.h"
#include "quarter_scan.h"
#include "quarter_status.h"
#include "quarter_terminate.h"
#include "rng.h"

#define LATEST (INT64_MAX / 2) /* microseconds: moments up to here can be subtracted from one another */
#define QUEUE 1000             /* messages that a subscription holds: LCM's own 30 are too few for a burst */
#define LONGEST 65536u /* bytes of a message; LCM's count is far beyond if a packet ends within the channel's name */

/* One subscription: whose messages go where. */
typedef struct listener {
  bus *b;
  int kind;  /* enum message_kind */
  int robot; /* -1: any */
  void (*hear)(void);
  void *user;
  struct listener *next;
} listener;

struct bus {
  lcm_t *lcm;
  lcm_eventlog_t *log;
  listener *listeners;
  bus_counts counts;
  double loss;
  rng dice;
};

/* ---- opening ---- */

static const char *address(const char *url) {
  if (url != NULL) return url;
  const char *set = getenv("LCM_DEFAULT_URL");
  return set != NULL && set[0] != '\0' ? set : "udpm://239.255.76.67:7667?ttl=0";
}

int bus_open(bus **b, const char *url, fault *why) {
  *b = calloc(1, sizeof **b);
  if (*b == NULL) return fault_set(why, "no memory for the bus");
  (*b)->lcm = lcm_create(address(url));
  if ((*b)->lcm != NULL) return 0;
  free(*b);
  *b = NULL;
  return fault_set(why,
                   "%s: this bus cannot be opened; a udpm bus on one machine needs multicast on the loopback: "
                   "'ip link set lo multicast on' and 'ip route add 224.0.0.0/4 dev lo'",
                   address(url));
}

void bus_close(bus *b) {
  if (b == NULL) return;
  lcm_destroy(b->lcm);
  if (b->log != NULL) lcm_eventlog_destroy(b->log);
  for (listener *at = b->listeners, *next; at != NULL; at = next) {
    next = at->next;
    free(at);
  }
  free(b);
}

void bus_lose(bus *b, double share, uint64_t seed) {
  b->loss = share;
  rng_seed(&b->dice, seed);
}

bus_counts bus_count(const bus *b) {
  return b->counts;
}

/* ---- the log ---- */

/* Every message begins, behind its type's 8-byte mark, with the world's time: that is the event's. */
static int64_t utime_of(const lcm_recv_buf_t *packet) {
  int64_t utime = 0;
  if (packet->data_size < 16) return packet->recv_utime;
  for (int i = 8; i < 16; i++) utime = (int64_t)((uint64_t)utime << 8 | ((const uint8_t *)packet->data)[i]);
  return utime;
}

static void log_event(const lcm_recv_buf_t *packet, const char *channel, void *user) {
  bus *b = user;
  if (packet->data_size > LONGEST) return;
  lcm_eventlog_event_t event = {.timestamp = utime_of(packet),
                                .channellen = (int32_t)strlen(channel),
                                .datalen = (int32_t)packet->data_size,
                                .channel = (char *)(uintptr_t)channel,
                                .data = packet->data};
  lcm_eventlog_write_event(b->log, &event);
}

int bus_record(bus *b, const char *path, fault *why) {
  b->log = lcm_eventlog_create(path, "w");
  if (b->log == NULL) return fault_set(why, "%s: the log cannot be written; make its folder first", path);
  lcm_subscription_set_queue_capacity(lcm_subscribe(b->lcm, CHANNEL_PREFIX ".*", log_event, b), 10 * QUEUE);
  return 0;
}

/* ---- sending ---- */

static const char *channel_of(char name[CHANNEL_SIZE], int kind, int robot) {
  switch (kind) {
  case KIND_POSE: snprintf(name, CHANNEL_SIZE, CHANNEL_POSE, robot); break;
  case KIND_SCAN: snprintf(name, CHANNEL_SIZE, CHANNEL_SCAN, robot); break;
  case KIND_COMMAND: snprintf(name, CHANNEL_SIZE, CHANNEL_COMMAND, robot); break;
  case KIND_TERMINATE: snprintf(name, CHANNEL_SIZE, CHANNEL_TERMINATE); break;
  default: snprintf(name, CHANNEL_SIZE, CHANNEL_STATUS);
  }
  return name;
}

void bus_send_pose(bus *b, const message_pose *m) {
  char name[CHANNEL_SIZE];
  const quarter_pose wire = {m->utime, m->robot, m->x, m->y, m->heading};
  quarter_pose_publish(b->lcm, channel_of(name, KIND_POSE, m->robot), &wire);
  b->counts.sent[KIND_POSE]++;
}

void bus_send_scan(bus *b, const message_scan *m) {
  char name[CHANNEL_SIZE];
  quarter_scan wire = {.utime = m->utime, .robot = m->robot, .read = m->read, .mine = m->mine};
  memcpy(wire.range, m->range, sizeof wire.range);
  quarter_scan_publish(b->lcm, channel_of(name, KIND_SCAN, m->robot), &wire);
  b->counts.sent[KIND_SCAN]++;
}

void bus_send_command(bus *b, const message_command *m) {
  char name[CHANNEL_SIZE];
  const quarter_command wire = {m->utime, m->robot, m->left, m->right, m->read};
  quarter_command_publish(b->lcm, channel_of(name, KIND_COMMAND, m->robot), &wire);
  b->counts.sent[KIND_COMMAND]++;
}

void bus_send_terminate(bus *b, const message_terminate *m) {
  const quarter_terminate wire = {m->utime, m->sender, m->signal, m->territory};
  quarter_terminate_publish(b->lcm, CHANNEL_TERMINATE, &wire);
  b->counts.sent[KIND_TERMINATE]++;
}

void bus_send_status(bus *b, const message_status *m) {
  quarter_status wire = {.utime = m->utime, .robots = m->robots, .places = m->places, .mines_found = m->mines_found};
  memcpy(wire.state, m->state, sizeof wire.state);
  memcpy(wire.scanned_by, m->scanned_by, sizeof wire.scanned_by);
  memcpy(wire.found, m->found, sizeof wire.found);
  quarter_status_publish(b->lcm, CHANNEL_STATUS, &wire);
  b->counts.sent[KIND_STATUS]++;
}

/* ---- hearing: bytes from outside, decoded, checked, and ignored if they are not sound ---- */

static bool sound_robot(const listener *l, int robot) {
  return robot >= 0 && robot < MESSAGE_MOST_ROBOTS && (l->robot < 0 || robot == l->robot);
}

static bool take_pose(const listener *l, const lcm_recv_buf_t *packet) {
  quarter_pose wire;
  if (quarter_pose_decode(packet->data, 0, (int)packet->data_size, &wire) < 0) return false;
  if (!sound_robot(l, wire.robot) || !isfinite(wire.x) || !isfinite(wire.y) || !isfinite(wire.heading)) return false;
  const message_pose m = {wire.utime, wire.robot, wire.x, wire.y, wire.heading};
  ((void (*)(void *, const message_pose *))l->hear)(l->user, &m);
  return true;
}

static bool take_scan(const listener *l, const lcm_recv_buf_t *packet) {
  quarter_scan wire;
  message_scan m;
  if (quarter_scan_decode(packet->data, 0, (int)packet->data_size, &wire) < 0 || !sound_robot(l, wire.robot))
    return false;
  for (int ray = 0; ray < MESSAGE_RAYS; ray++)
    if (!isfinite(wire.range[ray]) || wire.range[ray] < 0.0f) return false;
  m = (message_scan){.utime = wire.utime, .robot = wire.robot, .read = wire.read != 0, .mine = wire.mine != 0};
  memcpy(m.range, wire.range, sizeof m.range);
  ((void (*)(void *, const message_scan *))l->hear)(l->user, &m);
  return true;
}

static bool take_command(const listener *l, const lcm_recv_buf_t *packet) {
  quarter_command wire;
  if (quarter_command_decode(packet->data, 0, (int)packet->data_size, &wire) < 0) return false;
  if (!sound_robot(l, wire.robot) || !isfinite(wire.left) || !isfinite(wire.right)) return false;
  const message_command m = {wire.utime, wire.robot, wire.left, wire.right, wire.read != 0};
  ((void (*)(void *, const message_command *))l->hear)(l->user, &m);
  return true;
}

static bool take_terminate(const listener *l, const lcm_recv_buf_t *packet) {
  quarter_terminate wire;
  if (quarter_terminate_decode(packet->data, 0, (int)packet->data_size, &wire) < 0) return false;
  if (wire.sender < 0 || wire.sender >= MESSAGE_MOST_ROBOTS) return false;
  const message_terminate m = {wire.utime, wire.sender, wire.signal, wire.territory};
  ((void (*)(void *, const message_terminate *))l->hear)(l->user, &m);
  return true;
}

static bool take_status(const listener *l, const lcm_recv_buf_t *packet) {
  quarter_status wire;
  message_status m;
  if (quarter_status_decode(packet->data, 0, (int)packet->data_size, &wire) < 0) return false;
  if (wire.robots < 0 || wire.robots > MESSAGE_MOST_ROBOTS || wire.places < 0 || wire.places > MESSAGE_MOST_PLACES)
    return false;
  m = (message_status){
      .utime = wire.utime, .robots = wire.robots, .places = wire.places, .mines_found = wire.mines_found};
  memcpy(m.state, wire.state, sizeof m.state);
  memcpy(m.scanned_by, wire.scanned_by, sizeof m.scanned_by);
  memcpy(m.found, wire.found, sizeof m.found);
  ((void (*)(void *, const message_status *))l->hear)(l->user, &m);
  return true;
}

static bool sound_frame(const lcm_recv_buf_t *packet) {
  if (packet->data_size > LONGEST) return false;
  const int64_t utime = utime_of(packet);
  return utime >= 0 && utime <= LATEST;
}

static void take(const lcm_recv_buf_t *packet, const char *channel, void *user) {
  static bool (*const takers[KINDS])(const listener *, const lcm_recv_buf_t *) = {take_pose, take_scan, take_command,
                                                                                  take_terminate, take_status};
  const listener *l = user;
  (void)channel;
  if (l->kind == KIND_TERMINATE && l->b->loss > 0.0 && rng_unit(&l->b->dice) < l->b->loss) {
    l->b->counts.lost++;
    return;
  }
  if (!sound_frame(packet) || !takers[l->kind](l, packet)) l->b->counts.ignored++;
}

static void subscribe(bus *b, int kind, int robot, void (*hear)(void), void *user) {
  char name[CHANNEL_SIZE];
  listener *l = malloc(sizeof *l);
  if (l == NULL) abort();
  *l = (listener){b, kind, robot, hear, user, b->listeners};
  b->listeners = l;
  lcm_subscription_set_queue_capacity(lcm_subscribe(b->lcm, channel_of(name, kind, robot), take, l), QUEUE);
}

void bus_hear_pose(bus *b, int robot, void (*hear)(void *user, const message_pose *m), void *user) {
  subscribe(b, KIND_POSE, robot, (void (*)(void))hear, user);
}

void bus_hear_scan(bus *b, int robot, void (*hear)(void *user, const message_scan *m), void *user) {
  subscribe(b, KIND_SCAN, robot, (void (*)(void))hear, user);
}

void bus_hear_command(bus *b, int robot, void (*hear)(void *user, const message_command *m), void *user) {
  subscribe(b, KIND_COMMAND, robot, (void (*)(void))hear, user);
}

void bus_hear_terminate(bus *b, void (*hear)(void *user, const message_terminate *m), void *user) {
  subscribe(b, KIND_TERMINATE, -1, (void (*)(void))hear, user);
}

void bus_hear_status(bus *b, void (*hear)(void *user, const message_status *m), void *user) {
  subscribe(b, KIND_STATUS, -1, (void (*)(void))hear, user);
}

int bus_drain(bus *b) {
  int handled = 0;
  int status;
  while ((status = lcm_handle_timeout(b->lcm, 0)) > 0) handled++;
  return status < 0 ? -1 : handled;
}

bool bus_wait(bus *b, int milliseconds) {
  return lcm_handle_timeout(b->lcm, milliseconds) > 0;
}

#include "bus.h"

#include <errno.h>
#include <lcm/eventlog.h>
#include <lcm/lcm.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "channels.h"
#include "quarter_command.h"
#include "quarter_pose.h"
#include "quarter_scan.h"
#include "quarter_status.h"
#include "quarter_terminate.h"
#include "rng.h"

_Static_assert(DEMO_MOST_ROBOTS == QUARTER_STATUS_MOST_ROBOTS, "as lcmtypes/status.lcm has it");
_Static_assert(DEMO_MOST_PLACES == QUARTER_STATUS_MOST_PLACES, "as lcmtypes/status.lcm has it");
_Static_assert(SEAL_TAG == QUARTER_TERMINATE_TAG, "as lcmtypes/terminate.lcm has it");
_Static_assert(DEMO_RAYS == QUARTER_SCAN_RAYS, "as lcmtypes/scan.lcm has it");

#define LATEST (INT64_MAX / 2) /* microseconds: moments up to here can be subtracted from one another */
#define LOG_LEAP 60000000      /* microseconds: no robot answers later than that */
#define QUEUE 1000             /* messages that a subscription holds: LCM's own 30 are too few for a burst */
#define DRAUGHT (4 * QUEUE)    /* messages handled at once: who sends without end must not hold up the clock */
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
  const char *log_path;
  int log_error; /* errno of the first write that failed; 0: none did */
  listener *listeners;
  bus_counts counts;
  int64_t now; /* utime of what was sent last */
  double loss;
  rng dice;
  bool sealed;
  seal seal;
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
  fault unheard;
  bus_end_log(b, &unheard);
  lcm_destroy(b->lcm);
  for (listener *at = b->listeners, *next; at != NULL; at = next) {
    next = at->next;
    free(at);
  }
  seal_wipe(&b->seal);
  free(b);
}

int bus_open_sealed(bus **b, const char *url, const char *key, fault *why) {
  seal team;
  if (key == NULL) return bus_open(b, url, why);
  if (seal_read(&team, key, why) != 0) return -1;
  const int status = bus_open(b, url, why);
  if (status == 0) bus_seal(*b, &team);
  seal_wipe(&team);
  return status;
}

void bus_seal(bus *b, const seal *s) {
  b->sealed = true;
  b->seal = *s;
}

void bus_lose(bus *b, double share, uint64_t seed) {
  b->loss = share;
  rng_seed(&b->dice, seed);
}

bus_counts bus_count(const bus *b) {
  return b->counts;
}

/* ---- the log ---- */

/* Every message begins, behind its type's 8-byte mark, with the world's time; 0 if it is too short for that. */
static int64_t utime_of(const lcm_recv_buf_t *packet) {
  int64_t utime = 0;
  if (packet->data_size < 16) return 0;
  for (int i = 8; i < 16; i++) utime = (int64_t)((uint64_t)utime << 8 | ((const uint8_t *)packet->data)[i]);
  return utime;
}

/* The message's own time. A stranger's may lie anywhere, and who plays the log would wait for it: it gets the
 * world's. */
static int64_t log_time_of(const bus *b, const lcm_recv_buf_t *packet) {
  const int64_t utime = utime_of(packet);
  return utime >= 0 && utime <= LATEST && llabs(utime - b->now) <= LOG_LEAP ? utime : b->now;
}

static void log_event(const lcm_recv_buf_t *packet, const char *channel, void *user) {
  bus *b = user;
  if (b->log == NULL || b->log_error != 0 || packet->data_size > LONGEST) return;
  lcm_eventlog_event_t event = {.timestamp = log_time_of(b, packet),
                                .channellen = (int32_t)strlen(channel),
                                .datalen = (int32_t)packet->data_size,
                                .channel = (char *)(uintptr_t)channel,
                                .data = packet->data};
  errno = 0;
  if (lcm_eventlog_write_event(b->log, &event) != 0) b->log_error = errno != 0 ? errno : EIO;
}

int bus_record(bus *b, const char *path, fault *why) {
  b->log = lcm_eventlog_create(path, "w");
  b->log_path = path;
  if (b->log == NULL) return fault_set(why, "%s: the log cannot be written: %s; name another", path, strerror(errno));
  lcm_subscription_set_queue_capacity(lcm_subscribe(b->lcm, CHANNEL_PREFIX ".*", log_event, b), 10 * QUEUE);
  return 0;
}

bool bus_log_failed(const bus *b) {
  return b->log_error != 0;
}

/* All that was buffered to the disk; a device or a pipe has none behind it. */
static int flush_log(FILE *file) {
  if (fflush(file) != 0) return errno;
  if (fsync(fileno(file)) != 0 && errno != EINVAL && errno != ENOTSUP && errno != EROFS) return errno;
  return 0;
}

int bus_end_log(bus *b, fault *why) {
  struct stat about;
  if (b->log == NULL) return 0;
  const int error = b->log_error != 0 ? b->log_error : flush_log(b->log->f);
  const bool plain = fstat(fileno(b->log->f), &about) == 0 && S_ISREG(about.st_mode);
  lcm_eventlog_destroy(b->log);
  b->log = NULL;
  if (error == 0) return 0;
  if (plain) unlink(b->log_path);
  return fault_set(why, "%s: the log cannot be written: %s; free some space or write elsewhere", b->log_path,
                   strerror(error));
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

static void note_sent(bus *b, int kind, int64_t utime) {
  b->counts.sent[kind]++;
  b->now = utime;
}

void bus_send_pose(bus *b, const message_pose *m) {
  char name[CHANNEL_SIZE];
  const quarter_pose wire = {m->utime, m->robot, m->x, m->y, m->heading};
  quarter_pose_publish(b->lcm, channel_of(name, KIND_POSE, m->robot), &wire);
  note_sent(b, KIND_POSE, m->utime);
}

void bus_send_scan(bus *b, const message_scan *m) {
  char name[CHANNEL_SIZE];
  quarter_scan wire = {.utime = m->utime, .robot = m->robot, .read = m->read, .mine = m->mine};
  memcpy(wire.range, m->range, sizeof wire.range);
  quarter_scan_publish(b->lcm, channel_of(name, KIND_SCAN, m->robot), &wire);
  note_sent(b, KIND_SCAN, m->utime);
}

void bus_send_command(bus *b, const message_command *m) {
  char name[CHANNEL_SIZE];
  const quarter_command wire = {m->utime, m->robot, m->left, m->right, m->read, (int8_t)m->intent};
  quarter_command_publish(b->lcm, channel_of(name, KIND_COMMAND, m->robot), &wire);
  note_sent(b, KIND_COMMAND, m->utime);
}

/* Its tag is a message's end. */
static void put_tag(const bus *b, quarter_terminate *wire) {
  uint8_t bytes[sizeof *wire + 8], tag[SEAL_TAG];
  const int size = quarter_terminate_encode(bytes, 0, sizeof bytes, wire);
  seal_tag(&b->seal, bytes, (size_t)size - SEAL_TAG, tag);
  memcpy(wire->tag, tag, sizeof wire->tag);
}

void bus_send_terminate(bus *b, const message_terminate *m) {
  quarter_terminate wire = {.utime = m->utime,
                            .sender = m->sender,
                            .signal = m->signal,
                            .territory = m->territory,
                            .identity = (int32_t)m->identity,
                            .run = (int32_t)m->run};
  if (b->sealed) put_tag(b, &wire);
  quarter_terminate_publish(b->lcm, CHANNEL_TERMINATE, &wire);
  note_sent(b, KIND_TERMINATE, m->utime);
}

void bus_send_status(bus *b, const message_status *m) {
  quarter_status wire = {.utime = m->utime, .robots = m->robots, .places = m->places, .mines_found = m->mines_found};
  memcpy(wire.state, m->state, sizeof wire.state);
  memcpy(wire.scanned_by, m->scanned_by, sizeof wire.scanned_by);
  memcpy(wire.found, m->found, sizeof wire.found);
  quarter_status_publish(b->lcm, CHANNEL_STATUS, &wire);
  note_sent(b, KIND_STATUS, m->utime);
}

/* ---- hearing: bytes from outside, decoded, checked field by field, and ignored if they are not sound ---- */

static bool sound_robot(const listener *l, int robot) {
  return robot >= 0 && robot < DEMO_MOST_ROBOTS && (l->robot < 0 || robot == l->robot);
}

/* False for what is not a number, too. */
static bool within(double value, double most) {
  return value >= -most && value <= most;
}

static bool is_mark(int value) {
  return value == 0 || value == 1;
}

static bool take_pose(const listener *l, const lcm_recv_buf_t *packet) {
  quarter_pose wire;
  if (quarter_pose_decode(packet->data, 0, (int)packet->data_size, &wire) < 0 || !sound_robot(l, wire.robot))
    return false;
  if (!within(wire.x, MESSAGE_FARTHEST) || !within(wire.y, MESSAGE_FARTHEST) || !within(wire.heading, MESSAGE_TURN))
    return false;
  const message_pose m = {wire.utime, wire.robot, wire.x, wire.y, wire.heading};
  ((void (*)(void *, const message_pose *))l->hear)(l->user, &m);
  return true;
}

static bool take_scan(const listener *l, const lcm_recv_buf_t *packet) {
  quarter_scan wire;
  message_scan m;
  if (quarter_scan_decode(packet->data, 0, (int)packet->data_size, &wire) < 0 || !sound_robot(l, wire.robot))
    return false;
  if (!is_mark(wire.read) || !is_mark(wire.mine)) return false;
  for (int ray = 0; ray < DEMO_RAYS; ray++)
    if (!within((double)wire.range[ray], MESSAGE_FARTHEST) || wire.range[ray] < 0.0f) return false;
  m = (message_scan){.utime = wire.utime, .robot = wire.robot, .read = wire.read != 0, .mine = wire.mine != 0};
  memcpy(m.range, wire.range, sizeof m.range);
  ((void (*)(void *, const message_scan *))l->hear)(l->user, &m);
  return true;
}

static bool take_command(const listener *l, const lcm_recv_buf_t *packet) {
  quarter_command wire;
  if (quarter_command_decode(packet->data, 0, (int)packet->data_size, &wire) < 0 || !sound_robot(l, wire.robot))
    return false;
  if (!within(wire.left, MESSAGE_FARTHEST) || !within(wire.right, MESSAGE_FARTHEST) || !is_mark(wire.read))
    return false;
  if (wire.intent < INTENT_SEARCH || wire.intent > INTENT_TIRED) return false;
  const message_command m = {wire.utime, wire.robot, wire.left, wire.right, wire.read != 0, wire.intent};
  ((void (*)(void *, const message_command *))l->hear)(l->user, &m);
  return true;
}

static bool take_terminate(const listener *l, const lcm_recv_buf_t *packet) {
  quarter_terminate wire;
  const int size = quarter_terminate_decode(packet->data, 0, (int)packet->data_size, &wire);
  if (size < 0) return false;
  if (l->b->sealed && !seal_holds(&l->b->seal, packet->data, (size_t)size - SEAL_TAG, (const uint8_t *)wire.tag)) {
    l->b->counts.unsealed++;
    return false;
  }
  if (!sound_robot(l, wire.sender) || !sound_robot(l, wire.territory)) return false;
  if (wire.signal != QUARTER_TERMINATE_FOUND && wire.signal != QUARTER_TERMINATE_TERRITORY_DONE) return false;
  const message_terminate m = {wire.utime,        wire.sender, wire.signal, wire.territory, (uint32_t)wire.identity,
                               (uint32_t)wire.run};
  ((void (*)(void *, const message_terminate *))l->hear)(l->user, &m);
  return true;
}

/* Of the robots and places that there are; what stands behind them says nothing. */
static bool sound_states(const quarter_status *wire) {
  for (int robot = 0; robot < wire->robots; robot++)
    if (wire->state[robot] < STATE_ALIVE || wire->state[robot] > STATE_TIRED) return false;
  for (int place = 0; place < wire->places; place++)
    if (wire->scanned_by[place] < -1 || wire->scanned_by[place] >= wire->robots || !is_mark(wire->found[place]))
      return false;
  return true;
}

static bool take_status(const listener *l, const lcm_recv_buf_t *packet) {
  quarter_status wire;
  message_status m;
  if (quarter_status_decode(packet->data, 0, (int)packet->data_size, &wire) < 0) return false;
  if (wire.robots < 0 || wire.robots > DEMO_MOST_ROBOTS || wire.places < 0 || wire.places > DEMO_MOST_PLACES)
    return false;
  if (wire.mines_found < 0 || wire.mines_found > wire.places || !sound_states(&wire)) return false;
  m = (message_status){
      .utime = wire.utime, .robots = wire.robots, .places = wire.places, .mines_found = wire.mines_found};
  memcpy(m.state, wire.state, sizeof m.state);
  memcpy(m.scanned_by, wire.scanned_by, sizeof m.scanned_by);
  memcpy(m.found, wire.found, sizeof m.found);
  ((void (*)(void *, const message_status *))l->hear)(l->user, &m);
  return true;
}

static bool sound_frame(const lcm_recv_buf_t *packet) {
  if (packet->data_size < 16 || packet->data_size > LONGEST) return false;
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
  int status = 0;
  while (handled < DRAUGHT && (status = lcm_handle_timeout(b->lcm, 0)) > 0) handled++;
  return status < 0 ? -1 : handled;
}

bool bus_wait(bus *b, int milliseconds) {
  return lcm_handle_timeout(b->lcm, milliseconds) > 0;
}

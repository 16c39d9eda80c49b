#include "wiring.h"

static void say_command(void *user, const message_command *m) {
  bus_send_command(user, m);
}

static void say_terminate(void *user, const message_terminate *m) {
  bus_send_terminate(user, m);
}

robot_voice wiring_voice(bus *b) {
  return (robot_voice){b, say_command, say_terminate};
}

static void hear_pose(void *user, const message_pose *m) {
  robot_hear_pose(user, m);
}

static void hear_scan(void *user, const message_scan *m) {
  robot_hear_scan(user, m);
}

static void hear_terminate(void *user, const message_terminate *m) {
  robot_hear_terminate(user, m);
}

void wiring_listen(bus *b, robot *r) {
  bus_hear_pose(b, r->self, hear_pose, r);
  bus_hear_scan(b, r->self, hear_scan, r);
  bus_hear_terminate(b, hear_terminate, r);
}

/* The bus in one process: every message arrives unchanged at whom it is for, losses are as many as the dice say, and
 * the log has the world's time. */
#include "bus.h"
#include "channels.h"
#include "lcm_log.h"
#include "support/random.h"

static bus *b;
static fault why;

/* What was heard last, and how many of each. */
static message_pose pose;
static message_scan scan;
static message_command command;
static message_terminate terminate;
static message_status status;
static int heard[KINDS];

static void hear_pose(void *user, const message_pose *m) {
  TEST_ASSERT_EQUAL_PTR(&heard, user);
  pose = *m;
  heard[KIND_POSE]++;
}

static void hear_scan(void *user, const message_scan *m) {
  (void)user;
  scan = *m;
  heard[KIND_SCAN]++;
}

static void hear_command(void *user, const message_command *m) {
  (void)user;
  command = *m;
  heard[KIND_COMMAND]++;
}

static void hear_terminate(void *user, const message_terminate *m) {
  (void)user;
  terminate = *m;
  heard[KIND_TERMINATE]++;
}

static void hear_status(void *user, const message_status *m) {
  (void)user;
  status = *m;
  heard[KIND_STATUS]++;
}

void setUp(void) {
  snprintf(case_note, sizeof case_note, "by hand");
  memset(heard, 0, sizeof heard);
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, bus_open(&b, BUS_IN_PROCESS, &why), why.text);
}

void tearDown(void) {
  bus_close(b);
  b = NULL;
}

static void listen(int robot) {
  bus_hear_pose(b, robot, hear_pose, &heard);
  bus_hear_scan(b, robot, hear_scan, &heard);
  bus_hear_command(b, robot, hear_command, &heard);
  bus_hear_terminate(b, hear_terminate, &heard);
  bus_hear_status(b, hear_status, &heard);
}

/* ---- arriving ---- */

static double random_number(test_random *random) {
  return (random_unit(random) - 0.5) * (random_chance(random, 20) ? 1e6 : 100.0);
}

static void send_pose_and_command(test_random *random, int robot) {
  const message_pose p = {(int64_t)(random_bits(random) >> 2), robot, random_number(random), random_number(random),
                          random_number(random)};
  const message_command c = {(int64_t)(random_bits(random) >> 2),
                             robot,
                             random_number(random),
                             random_number(random),
                             random_chance(random, 50),
                             (int)(random_bits(random) % (INTENT_TIRED + 1u))};
  bus_send_pose(b, &p);
  bus_send_command(b, &c);
  TEST_ASSERT_EQUAL_INT_MESSAGE(2, bus_drain(b), case_note);
  TEST_ASSERT_TRUE_MESSAGE(p.utime == pose.utime && p.robot == pose.robot, case_note);
  TEST_ASSERT_TRUE_MESSAGE(p.x == pose.x && p.y == pose.y && p.heading == pose.heading, case_note);
  TEST_ASSERT_TRUE_MESSAGE(c.utime == command.utime && c.robot == command.robot, case_note);
  TEST_ASSERT_TRUE_MESSAGE(c.left == command.left && c.right == command.right && c.read == command.read, case_note);
  TEST_ASSERT_EQUAL_INT_MESSAGE(c.intent, command.intent, case_note);
}

static void send_scan(test_random *random, int robot) {
  message_scan m = {.utime = (int64_t)(random_bits(random) >> 2),
                    .robot = robot,
                    .read = random_chance(random, 50),
                    .mine = random_chance(random, 50)};
  for (int ray = 0; ray < DEMO_RAYS; ray++) m.range[ray] = (float)random_unit(random);
  bus_send_scan(b, &m);
  TEST_ASSERT_EQUAL_INT_MESSAGE(1, bus_drain(b), case_note);
  TEST_ASSERT_TRUE_MESSAGE(m.utime == scan.utime && m.robot == scan.robot, case_note);
  TEST_ASSERT_TRUE_MESSAGE(m.read == scan.read && m.mine == scan.mine, case_note);
  TEST_ASSERT_EQUAL_MEMORY_MESSAGE(m.range, scan.range, sizeof m.range, case_note);
}

static void send_terminate(test_random *random) {
  const message_terminate m = {(int64_t)(random_bits(random) >> 2), (int)random_below(random, DEMO_MOST_ROBOTS),
                               (int)random_in(random, 1, 2),        (int)random_below(random, 16),
                               (uint32_t)random_bits(random),       (uint32_t)random_bits(random)};
  bus_send_terminate(b, &m);
  TEST_ASSERT_EQUAL_INT_MESSAGE(1, bus_drain(b), case_note);
  TEST_ASSERT_TRUE_MESSAGE(m.utime == terminate.utime && m.sender == terminate.sender, case_note);
  TEST_ASSERT_TRUE_MESSAGE(m.signal == terminate.signal && m.territory == terminate.territory, case_note);
  TEST_ASSERT_TRUE_MESSAGE(m.identity == terminate.identity && m.run == terminate.run, case_note);
}

static void send_status(test_random *random) {
  message_status m = {.utime = (int64_t)(random_bits(random) >> 2),
                      .robots = (int)random_below(random, DEMO_MOST_ROBOTS + 1),
                      .places = 1 + (int)random_below(random, DEMO_MOST_PLACES),
                      .mines_found = (int)random_below(random, 2)};
  for (int i = 0; i < DEMO_MOST_ROBOTS; i++) m.state[i] = (int8_t)random_below(random, 5);
  for (int i = 0; i < DEMO_MOST_PLACES; i++)
    m.scanned_by[i] = (int8_t)((int)random_below(random, (unsigned)m.robots + 1) - 1);
  for (int i = 0; i < DEMO_MOST_PLACES; i++) m.found[i] = (int8_t)random_below(random, 2);
  bus_send_status(b, &m);
  TEST_ASSERT_EQUAL_INT_MESSAGE(1, bus_drain(b), case_note);
  TEST_ASSERT_TRUE_MESSAGE(m.utime == status.utime && m.robots == status.robots, case_note);
  TEST_ASSERT_TRUE_MESSAGE(m.places == status.places && m.mines_found == status.mines_found, case_note);
  TEST_ASSERT_EQUAL_MEMORY_MESSAGE(m.state, status.state, sizeof m.state, case_note);
  TEST_ASSERT_EQUAL_MEMORY_MESSAGE(m.scanned_by, status.scanned_by, sizeof m.scanned_by, case_note);
  TEST_ASSERT_EQUAL_MEMORY_MESSAGE(m.found, status.found, sizeof m.found, case_note);
}

static void test_every_kind_of_message_arrives_unchanged(void) {
  for (unsigned number = 0; number < 64; number++) {
    test_random random = random_case("arrives unchanged", number);
    const int robot = (int)random_below(&random, DEMO_MOST_ROBOTS);
    tearDown();
    setUp();
    listen(robot);
    send_pose_and_command(&random, robot);
    send_scan(&random, robot);
    send_terminate(&random);
    send_status(&random);
    for (int kind = 0; kind < KINDS; kind++) TEST_ASSERT_EQUAL_INT_MESSAGE(1, heard[kind], case_note);
    for (int kind = 0; kind < KINDS; kind++) TEST_ASSERT_EQUAL_UINT64_MESSAGE(1, bus_count(b).sent[kind], case_note);
    TEST_ASSERT_EQUAL_UINT64_MESSAGE(0, bus_count(b).ignored, case_note);
  }
}

static void test_a_robots_channels_are_its_own(void) {
  listen(1);
  for (int robot = 0; robot < DEMO_MOST_ROBOTS; robot++) {
    bus_send_pose(b, &(message_pose){0, robot, 0, 0, 0});
    bus_send_scan(b, &(message_scan){.robot = robot});
    bus_send_command(b, &(message_command){.robot = robot});
  }
  bus_drain(b);
  TEST_ASSERT_EQUAL_INT(1, heard[KIND_POSE]);
  TEST_ASSERT_EQUAL_INT(1, heard[KIND_SCAN]);
  TEST_ASSERT_EQUAL_INT(1, heard[KIND_COMMAND]);
  TEST_ASSERT_EQUAL_INT(1, pose.robot);
  TEST_ASSERT_EQUAL_UINT64(0, bus_count(b).ignored);
}

static void test_a_burst_arrives_whole(void) {
  listen(0);
  for (int i = 0; i < 900; i++) bus_send_terminate(b, &(message_terminate){.utime = i, .signal = 1});
  TEST_ASSERT_EQUAL_INT(900, bus_drain(b));
  TEST_ASSERT_EQUAL_INT(900, heard[KIND_TERMINATE]);
  TEST_ASSERT_TRUE(terminate.utime == 899);
  TEST_ASSERT_EQUAL_INT(0, bus_drain(b));
}

/* ---- losing ---- */

/* The same dice, thrown here: one throw for every signal and receiver. */
static int expected_losses(double share, uint64_t seed, int throws) {
  test_random dice = {seed};
  int lost = 0;
  for (int i = 0; i < throws; i++) lost += random_unit(&dice) < share;
  return lost;
}

static void test_that_share_of_the_signals_is_lost_and_nothing_else(void) {
  for (uint64_t seed = 1; seed <= 5; seed++) {
    const double share = 0.19 * (double)seed;
    const int expected = expected_losses(share, seed, 2000);
    tearDown();
    setUp();
    listen(0);
    bus_hear_terminate(b, hear_terminate, NULL); /* a second receiver: it loses signals of its own */
    bus_lose(b, share, seed);
    for (int i = 0; i < 1000; i++) {
      bus_send_terminate(b, &(message_terminate){.utime = i, .signal = 1});
      bus_send_pose(b, &(message_pose){i, 0, 0, 0, 0});
      bus_drain(b);
    }
    TEST_ASSERT_EQUAL_UINT64(expected, bus_count(b).lost);
    TEST_ASSERT_EQUAL_INT(2000 - expected, heard[KIND_TERMINATE]);
    TEST_ASSERT_EQUAL_INT(1000, heard[KIND_POSE]);
    TEST_ASSERT_INT_WITHIN(100, 2000 * share, expected);
  }
}

static void test_without_losses_nothing_is_lost(void) {
  listen(0);
  bus_lose(b, 0.0, 1);
  for (int i = 0; i < 500; i++) bus_send_terminate(b, &(message_terminate){.utime = i, .signal = 1});
  bus_drain(b);
  TEST_ASSERT_EQUAL_INT(500, heard[KIND_TERMINATE]);
  TEST_ASSERT_EQUAL_UINT64(0, bus_count(b).lost);
}

/* ---- the log ---- */

static void test_the_log_holds_every_message_in_order_at_the_worlds_times(void) {
  static const char *const channels[] = {"QUARTER_R3_POSE", "QUARTER_R3_SCAN", "QUARTER_R3_COMMAND",
                                         "QUARTER_TERMINATE", "QUARTER_STATUS"};
  log_event e;
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, bus_record(b, "all.lcm", &why), why.text);
  for (int64_t i = 0; i < 100; i++) {
    const int64_t utime = 50000 * i; /* not the time of day, in which this takes no time at all */
    bus_send_pose(b, &(message_pose){utime, 3, 1, 2, 3});
    bus_send_scan(b, &(message_scan){.utime = utime + 1, .robot = 3});
    bus_send_command(b, &(message_command){.utime = utime + 2, .robot = 3});
    bus_send_terminate(b, &(message_terminate){.utime = utime + 3, .sender = 3, .signal = 1});
    bus_send_status(b, &(message_status){.utime = utime + 4});
    bus_drain(b);
  }
  tearDown();
  FILE *file = fopen("all.lcm", "rb");
  TEST_ASSERT_NOT_NULL(file);
  for (int i = 0; i < 500; i++) {
    TEST_ASSERT_TRUE(log_read(file, &e));
    TEST_ASSERT_EQUAL_UINT64(i, e.number);
    TEST_ASSERT_TRUE(e.time == 50000 * (i / 5) + i % 5);
    TEST_ASSERT_EQUAL_STRING(channels[i % 5], e.channel);
  }
  TEST_ASSERT_FALSE(log_read(file, &e));
  fclose(file);
}

static void test_a_log_plays_back_as_it_was(void) {
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, bus_record(b, "back.lcm", &why), why.text);
  for (int i = 0; i < 20; i++) bus_send_pose(b, &(message_pose){i, 0, i, -i, 0.5});
  bus_drain(b);
  tearDown();
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, bus_open(&b, "file://back.lcm?speed=0", &why), why.text);
  listen(0);
  bus_drain(b);
  TEST_ASSERT_EQUAL_INT(20, heard[KIND_POSE]);
  TEST_ASSERT_TRUE(pose.utime == 19 && pose.x == 19.0 && pose.y == -19.0 && pose.heading == 0.5);
}

/* ---- refusing ---- */

/* LCM has a say of its own on standard error, which is not the user's line. */
static void test_a_bus_that_is_none_is_refused(void) {
  bus *none;
  TEST_ASSERT_EQUAL_INT(-1, bus_open(&none, "carrier-pigeon://", &why));
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(why.text, "carrier-pigeon://"), why.text);
  TEST_ASSERT_NULL(strchr(why.text, '\n'));
}

static void test_a_log_that_cannot_be_written_is_refused(void) {
  TEST_ASSERT_EQUAL_INT(-1, bus_record(b, "no/such/folder/a.lcm", &why));
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(why.text, "no/such/folder/a.lcm"), why.text);
  listen(0);
  bus_send_pose(b, &(message_pose){0, 0, 0, 0, 0});
  bus_drain(b);
  TEST_ASSERT_EQUAL_INT(1, heard[KIND_POSE]);
}

/* What is buffered is lost at the end, if nobody looks; with many messages a write fails on the way. */
static void test_a_log_on_a_full_disk_fails_and_says_so(void) {
  for (int messages = 1; messages <= 1000; messages *= 1000) {
    tearDown();
    setUp();
    TEST_ASSERT_EQUAL_INT_MESSAGE(0, bus_record(b, "/dev/full", &why), why.text);
    for (int i = 0; i < messages; i++) bus_send_pose(b, &(message_pose){i, 0, 0, 0, 0});
    bus_drain(b);
    TEST_ASSERT_EQUAL_INT(messages > 1, bus_log_failed(b));
    TEST_ASSERT_EQUAL_INT(-1, bus_end_log(b, &why));
    TEST_ASSERT_NOT_NULL_MESSAGE(strstr(why.text, "/dev/full"), why.text);
    TEST_ASSERT_NOT_NULL_MESSAGE(strstr(why.text, "space"), why.text);
    TEST_ASSERT_EQUAL_INT(0, bus_end_log(b, &why)); /* told once */
  }
}

static void test_a_log_that_is_whole_ends_well(void) {
  TEST_ASSERT_EQUAL_INT(0, bus_end_log(b, &why)); /* there is none */
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, bus_record(b, "whole.lcm", &why), why.text);
  bus_send_pose(b, &(message_pose){0, 0, 0, 0, 0});
  bus_drain(b);
  TEST_ASSERT_FALSE(bus_log_failed(b));
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, bus_end_log(b, &why), why.text);
  bus_send_pose(b, &(message_pose){1, 0, 0, 0, 0}); /* what comes behind the end goes nowhere */
  TEST_ASSERT_EQUAL_INT(1, bus_drain(b));
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_every_kind_of_message_arrives_unchanged);
  RUN_TEST(test_a_robots_channels_are_its_own);
  RUN_TEST(test_a_burst_arrives_whole);
  RUN_TEST(test_that_share_of_the_signals_is_lost_and_nothing_else);
  RUN_TEST(test_without_losses_nothing_is_lost);
  RUN_TEST(test_the_log_holds_every_message_in_order_at_the_worlds_times);
  RUN_TEST(test_a_log_plays_back_as_it_was);
  RUN_TEST(test_a_bus_that_is_none_is_refused);
  RUN_TEST(test_a_log_that_cannot_be_written_is_refused);
  RUN_TEST(test_a_log_on_a_full_disk_fails_and_says_so);
  RUN_TEST(test_a_log_that_is_whole_ends_well);
  return UNITY_END();
}

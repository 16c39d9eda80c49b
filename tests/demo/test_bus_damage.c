/* Bytes that are no message, or one that makes no sense: whatever is on the bus, robots and world are told sound
 * messages only, and the rest is counted. The bytes come out of an LCM log written here, which LCM plays onto the
 * bus. */
#include <math.h>
#include <stdlib.h>

#include "bus.h"
#include "lcm_log.h"
#include "support/random.h"

enum { ME = 2, LENGTH_MOST = 400 };

static const char *const channels[KINDS] = {"QUARTER_R2_POSE", "QUARTER_R2_SCAN", "QUARTER_R2_COMMAND",
                                            "QUARTER_TERMINATE", "QUARTER_STATUS"};
static log_event sound[KINDS]; /* a true message of each kind */
static FILE *out;
static uint64_t written;
static int heard[KINDS];
static bus_counts counts;
static fault why;

static void record_sound_messages(void);

void setUp(void) {
  snprintf(case_note, sizeof case_note, "by hand");
  record_sound_messages();
  out = fopen("damage.lcm", "wb");
  TEST_ASSERT_NOT_NULL(out);
  written = 0;
  memset(heard, 0, sizeof heard);
}

void tearDown(void) {
}

/* ---- what comes through must be sound ---- */

static void hear_pose(void *user, const message_pose *m) {
  (void)user;
  TEST_ASSERT_EQUAL_INT(ME, m->robot);
  TEST_ASSERT_TRUE(isfinite(m->x) && isfinite(m->y) && isfinite(m->heading));
  heard[KIND_POSE]++;
}

static void hear_scan(void *user, const message_scan *m) {
  (void)user;
  TEST_ASSERT_EQUAL_INT(ME, m->robot);
  for (int ray = 0; ray < DEMO_RAYS; ray++) TEST_ASSERT_TRUE(isfinite(m->range[ray]) && m->range[ray] >= 0.0f);
  heard[KIND_SCAN]++;
}

static void hear_command(void *user, const message_command *m) {
  (void)user;
  TEST_ASSERT_EQUAL_INT(ME, m->robot);
  TEST_ASSERT_TRUE(isfinite(m->left) && isfinite(m->right));
  heard[KIND_COMMAND]++;
}

static void hear_terminate(void *user, const message_terminate *m) {
  (void)user;
  TEST_ASSERT_TRUE(m->sender >= 0 && m->sender < DEMO_MOST_ROBOTS);
  heard[KIND_TERMINATE]++;
}

static void hear_status(void *user, const message_status *m) {
  (void)user;
  TEST_ASSERT_TRUE(m->robots >= 0 && m->robots <= DEMO_MOST_ROBOTS);
  TEST_ASSERT_TRUE(m->places >= 0 && m->places <= DEMO_MOST_PLACES);
  heard[KIND_STATUS]++;
}

/* ---- playing bytes onto the bus ---- */

static void put(int kind, const uint8_t *data, int length) {
  log_event e = {.number = written++, .length = length};
  snprintf(e.channel, sizeof e.channel, "%s", channels[kind]);
  if (length > 0) memcpy(e.data, data, (size_t)length); /* of nothing there may be no address */
  log_write(out, &e);
}

/* Returns how many messages were heard; all others were counted as ignored. */
static int play(void) {
  bus *b;
  int sum = 0;
  fclose(out);
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, bus_open(&b, "file://damage.lcm?speed=0", &why), why.text);
  bus_hear_pose(b, ME, hear_pose, NULL);
  bus_hear_scan(b, ME, hear_scan, NULL);
  bus_hear_command(b, ME, hear_command, NULL);
  bus_hear_terminate(b, hear_terminate, NULL);
  bus_hear_status(b, hear_status, NULL);
  while (bus_drain(b) > 0) continue;
  counts = bus_count(b);
  bus_close(b);
  for (int kind = 0; kind < KINDS; kind++) sum += heard[kind];
  TEST_ASSERT_EQUAL_UINT64(written, counts.ignored + (uint64_t)sum);
  return sum;
}

/* A true message of each kind, as the bus itself writes it. */
static void record_sound_messages(void) {
  bus *b;
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, bus_open(&b, BUS_IN_PROCESS, &why), why.text);
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, bus_record(b, "sound.lcm", &why), why.text);
  bus_send_pose(b, &(message_pose){1, ME, 1.5, -2.5, 0.25});
  bus_send_scan(b, &(message_scan){.utime = 2, .robot = ME});
  bus_send_command(b, &(message_command){.utime = 3, .robot = ME, .left = 0.5, .right = -0.5});
  bus_send_terminate(b, &(message_terminate){.utime = 4, .sender = ME, .signal = 1});
  bus_send_status(b, &(message_status){.utime = 5, .robots = 4, .places = 16});
  bus_drain(b);
  bus_close(b);
  FILE *file = fopen("sound.lcm", "rb");
  TEST_ASSERT_NOT_NULL(file);
  for (int kind = 0; kind < KINDS; kind++) TEST_ASSERT_TRUE(log_read(file, &sound[kind]));
  fclose(file);
}

/* Behind its type's mark of 8 bytes and its time, a message has these fields, big-endian (lcmtypes/). */
enum { TIME = 8, ROBOT = 16, NUMBERS = 20, STATUS_PLACES = 20 };

/* The ranges end a scan. */
static int scan_range(int ray) {
  return sound[KIND_SCAN].length - 4 * (DEMO_RAYS - ray);
}

static void put_changed(int kind, int at, uint64_t value, int bytes) {
  uint8_t data[LOG_DATA_MOST];
  memcpy(data, sound[kind].data, sizeof data);
  for (int i = 0; i < bytes; i++) data[at + i] = (uint8_t)(value >> 8 * (bytes - 1 - i));
  put(kind, data, sound[kind].length);
}

static uint64_t bits_of(double value) {
  uint64_t bits;
  memcpy(&bits, &value, sizeof bits);
  return bits;
}

static uint32_t float_bits_of(float value) {
  uint32_t bits;
  memcpy(&bits, &value, sizeof bits);
  return bits;
}

/* A status tells of so many robots and places, then of each robot and each place, a byte each. */
enum {
  FOUND_FIELD = 24,
  STATES = 28,
  SCANNED_BY = STATES + DEMO_MOST_ROBOTS,
  FOUND_AT = SCANNED_BY + DEMO_MOST_PLACES
};

/* ---- tests ---- */

static void test_true_messages_come_through(void) {
  for (int kind = 0; kind < KINDS; kind++) put(kind, sound[kind].data, sound[kind].length);
  TEST_ASSERT_EQUAL_INT(KINDS, play());
  TEST_ASSERT_EQUAL_UINT64(0, counts.ignored);
}

static void test_random_bytes_of_all_lengths_are_ignored(void) {
  test_random random = random_case("random bytes", 1);
  uint8_t data[LENGTH_MOST];
  for (int length = 0; length < LENGTH_MOST; length++)
    for (int kind = 0; kind < KINDS; kind++) {
      for (int i = 0; i < length; i++) data[i] = (uint8_t)random_bits(&random);
      put(kind, data, length);
    }
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, play(), case_note);
}

/* The right mark and then anything: what comes through is checked where it is heard. */
static void test_random_bytes_behind_a_true_mark_are_told_only_if_they_are_sound(void) {
  test_random random = random_case("random bytes behind a mark", 1);
  uint8_t data[LOG_DATA_MOST];
  for (int i = 0; i < 2000; i++) {
    const int kind = (int)random_below(&random, KINDS);
    const int length = (int)random_below(&random, LENGTH_MOST);
    for (int j = 0; j < length; j++) data[j] = random_chance(&random, 50) ? 0 : (uint8_t)random_bits(&random);
    memcpy(data, sound[kind].data, 8);
    if (random_chance(&random, 50)) memcpy(data, sound[kind].data, NUMBERS);
    put(kind, data, length);
  }
  TEST_ASSERT_LESS_THAN_INT_MESSAGE(1500, play(), case_note);
}

static void test_messages_cut_off_anywhere_are_ignored(void) {
  for (int kind = 0; kind < KINDS; kind++)
    for (int length = 0; length < sound[kind].length; length++) put(kind, sound[kind].data, length);
  TEST_ASSERT_EQUAL_INT(0, play());
}

static void test_messages_of_another_kind_are_ignored(void) {
  for (int kind = 0; kind < KINDS; kind++)
    for (int other = 0; other < KINDS; other++)
      if (other != kind) put(kind, sound[other].data, sound[other].length);
  TEST_ASSERT_EQUAL_INT(0, play());
}

static void test_a_bit_flipped_is_ignored_or_leaves_the_message_sound(void) {
  for (int kind = 0; kind < KINDS; kind++)
    for (int bit = 0; bit < 8 * sound[kind].length; bit++)
      put_changed(kind, bit / 8, sound[kind].data[bit / 8] ^ (1u << bit % 8), 1);
  play();
  for (int kind = 0; kind < KINDS; kind++) /* none through whose mark is wrong */
    TEST_ASSERT_LESS_OR_EQUAL_INT(8 * (sound[kind].length - 8), heard[kind]);
}

static void test_a_flipped_bit_of_the_mark_is_ignored(void) {
  for (int kind = 0; kind < KINDS; kind++)
    for (int bit = 0; bit < 64; bit++) put_changed(kind, bit / 8, sound[kind].data[bit / 8] ^ (1u << bit % 8), 1);
  TEST_ASSERT_EQUAL_INT(0, play());
}

static void test_numbers_that_are_none_are_ignored(void) {
  static const double none[] = {NAN, -NAN, INFINITY, -INFINITY};
  for (int i = 0; i < 4; i++) {
    for (int field = 0; field < 3; field++) put_changed(KIND_POSE, NUMBERS + 8 * field, bits_of(none[i]), 8);
    for (int field = 0; field < 2; field++) put_changed(KIND_COMMAND, NUMBERS + 8 * field, bits_of(none[i]), 8);
    for (int ray = 0; ray < DEMO_RAYS; ray++) put_changed(KIND_SCAN, scan_range(ray), float_bits_of((float)none[i]), 4);
  }
  put_changed(KIND_SCAN, scan_range(0), float_bits_of(-0.5f), 4);
  TEST_ASSERT_EQUAL_INT(0, play());
}

/* Who subtracts one moment from another must be able to. */
static void test_times_before_the_beginning_and_past_all_bounds_are_ignored(void) {
  for (int kind = 0; kind < KINDS; kind++) {
    put_changed(kind, TIME, UINT64_MAX, 8);
    put_changed(kind, TIME, (uint64_t)INT64_MIN, 8);
    put_changed(kind, TIME, INT64_MAX, 8);
    put_changed(kind, TIME, INT64_MAX / 2 + 1, 8);
  }
  TEST_ASSERT_EQUAL_INT(0, play());
}

static void test_robots_and_places_out_of_range_are_ignored(void) {
  static const int32_t none[] = {-1, DEMO_MOST_ROBOTS, DEMO_MOST_ROBOTS + 1, INT32_MIN, INT32_MAX};
  for (int i = 0; i < 5; i++)
    for (int kind = KIND_POSE; kind <= KIND_TERMINATE; kind++) put_changed(kind, ROBOT, (uint32_t)none[i], 4);
  for (int kind = KIND_POSE; kind <= KIND_COMMAND; kind++)
    put_changed(kind, ROBOT, ME + 1, 4); /* another's, on my channel */
  put_changed(KIND_STATUS, ROBOT, DEMO_MOST_ROBOTS + 1, 4);
  put_changed(KIND_STATUS, ROBOT, UINT32_MAX, 4);
  put_changed(KIND_STATUS, STATUS_PLACES, DEMO_MOST_PLACES + 1, 4);
  put_changed(KIND_STATUS, STATUS_PLACES, UINT32_MAX, 4);
  TEST_ASSERT_EQUAL_INT(0, play());
}

/* How far something is, how fast a wheel turns: numbers, but no such place or speed is on earth. */
static void test_numbers_beyond_all_measure_are_ignored(void) {
  static const double far[] = {1.1e9, -1.1e9, 1e300, -1e300};
  for (int i = 0; i < 4; i++) {
    for (int field = 0; field < 3; field++) put_changed(KIND_POSE, NUMBERS + 8 * field, bits_of(far[i]), 8);
    for (int field = 0; field < 2; field++) put_changed(KIND_COMMAND, NUMBERS + 8 * field, bits_of(far[i]), 8);
  }
  put_changed(KIND_SCAN, scan_range(3), float_bits_of(1e30f), 4);
  TEST_ASSERT_EQUAL_INT(0, play());
}

static void test_marks_that_are_neither_0_nor_1_and_intents_that_are_none_are_ignored(void) {
  static const uint8_t none[] = {2, 127, 128, 255};
  static const uint8_t intents[] = {INTENT_TIRED + 1, 127, 128, 255};
  for (int i = 0; i < 4; i++) {
    put_changed(KIND_SCAN, NUMBERS, none[i], 1);
    put_changed(KIND_SCAN, NUMBERS + 1, none[i], 1);
    put_changed(KIND_COMMAND, NUMBERS + 16, none[i], 1);
    put_changed(KIND_COMMAND, NUMBERS + 17, intents[i], 1);
    put_changed(KIND_STATUS, FOUND_AT + 7, none[i], 1);
  }
  TEST_ASSERT_EQUAL_INT(0, play());
}

static void test_signals_and_territories_that_are_none_are_ignored(void) {
  static const int32_t signals[] = {0, 3, -1, INT32_MIN, INT32_MAX};
  static const int32_t territories[] = {-1, DEMO_MOST_ROBOTS, INT32_MIN, INT32_MAX};
  for (int i = 0; i < 5; i++) put_changed(KIND_TERMINATE, NUMBERS, (uint32_t)signals[i], 4);
  for (int i = 0; i < 4; i++) put_changed(KIND_TERMINATE, NUMBERS + 4, (uint32_t)territories[i], 4);
  TEST_ASSERT_EQUAL_INT(0, play());
}

/* Of the robots and places that the message says there are, 4 and 16. */
static void test_states_and_scanners_that_are_none_are_ignored(void) {
  static const int8_t states[] = {-1, STATE_TIRED + 1, INT8_MIN, INT8_MAX};
  static const int8_t scanners[] = {-2, 4, INT8_MIN, INT8_MAX};
  for (int i = 0; i < 4; i++) {
    put_changed(KIND_STATUS, STATES + 3, (uint8_t)states[i], 1);
    put_changed(KIND_STATUS, SCANNED_BY + 15, (uint8_t)scanners[i], 1);
  }
  put_changed(KIND_STATUS, FOUND_FIELD, UINT32_MAX, 4);
  put_changed(KIND_STATUS, FOUND_FIELD, 17, 4);
  TEST_ASSERT_EQUAL_INT(0, play());
}

static void test_what_stands_behind_the_last_robot_and_place_says_nothing(void) {
  put_changed(KIND_STATUS, STATES + 4, 99, 1);
  put_changed(KIND_STATUS, SCANNED_BY + 16, 99, 1);
  put_changed(KIND_STATUS, FOUND_AT + 16, 99, 1);
  TEST_ASSERT_EQUAL_INT(3, play());
}

/* Who plays a log waits as long as its times say: a stranger's time must not be among them. */
static void test_a_strangers_time_does_not_get_into_the_log(void) {
  log_event e;
  bus *b;
  int64_t last = 0;
  int events = 0;
  put_changed(KIND_POSE, TIME, INT64_MAX / 2, 8);
  put_changed(KIND_STATUS, TIME, (uint64_t)INT64_MIN, 8);
  put(KIND_TERMINATE, sound[KIND_TERMINATE].data, 9);
  put(KIND_TERMINATE, NULL, 0);
  put_changed(KIND_COMMAND, TIME, 7, 8);
  fclose(out);
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, bus_open(&b, "file://damage.lcm?speed=0", &why), why.text);
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, bus_record(b, "times.lcm", &why), why.text);
  bus_drain(b);
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, bus_end_log(b, &why), why.text);
  bus_close(b);
  FILE *file = fopen("times.lcm", "rb");
  TEST_ASSERT_NOT_NULL(file);
  for (; log_read(file, &e); events++, last = e.time) TEST_ASSERT_TRUE(e.time >= 0 && e.time <= 7);
  fclose(file);
  TEST_ASSERT_EQUAL_INT(5, events);
  TEST_ASSERT_TRUE(last == 7);
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_true_messages_come_through);
  RUN_TEST(test_random_bytes_of_all_lengths_are_ignored);
  RUN_TEST(test_random_bytes_behind_a_true_mark_are_told_only_if_they_are_sound);
  RUN_TEST(test_messages_cut_off_anywhere_are_ignored);
  RUN_TEST(test_messages_of_another_kind_are_ignored);
  RUN_TEST(test_a_bit_flipped_is_ignored_or_leaves_the_message_sound);
  RUN_TEST(test_a_flipped_bit_of_the_mark_is_ignored);
  RUN_TEST(test_numbers_that_are_none_are_ignored);
  RUN_TEST(test_times_before_the_beginning_and_past_all_bounds_are_ignored);
  RUN_TEST(test_robots_and_places_out_of_range_are_ignored);
  RUN_TEST(test_numbers_beyond_all_measure_are_ignored);
  RUN_TEST(test_marks_that_are_neither_0_nor_1_and_intents_that_are_none_are_ignored);
  RUN_TEST(test_signals_and_territories_that_are_none_are_ignored);
  RUN_TEST(test_states_and_scanners_that_are_none_are_ignored);
  RUN_TEST(test_what_stands_behind_the_last_robot_and_place_says_nothing);
  RUN_TEST(test_a_strangers_time_does_not_get_into_the_log);
  return UNITY_END();
}

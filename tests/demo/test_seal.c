/* Seals on termination signals: which tags hold, what is no key, and what a sealed bus hears. */
#include "seal.h"

#include <string.h>
#include <sys/stat.h>

#include "bus.h"
#include "support/tool_run.h"

static seal team, other;
static fault why;
static int heard;

void setUp(void) {
  memset(&why, 0, sizeof why);
  heard = 0;
}

void tearDown(void) {
}

/* Bytes 0, 1, 2, ... */
static void write_key(const char *path, int size, mode_t mode) {
  FILE *file = fopen(path, "wb");
  TEST_ASSERT_NOT_NULL(file);
  for (int i = 0; i < size; i++) fputc(i, file);
  fclose(file);
  TEST_ASSERT_EQUAL_INT(0, chmod(path, mode));
}

static void need_seals(void) {
  write_key("team.key", 32, 0600);
  write_key("other.key", 33, 0400);
  const int status = seal_read(&team, "team.key", &why);
  if (status != 0 && strstr(why.text, "without libsodium") != NULL) TEST_IGNORE_MESSAGE("libsodium is missing");
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, status, why.text);
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, seal_read(&other, "other.key", &why), why.text);
}

/* ---- tags ---- */

static const uint8_t word[] = "FOUND, says robot 3";
enum { WORD = sizeof word - 1 };

/* Python: blake2b(word, key=blake2b(bytes(range(32)), digest_size=32).digest(), digest_size=16) */
static void test_a_tag_is_keyed_blake2b(void) {
  static const uint8_t expected[SEAL_TAG] = {0xf2, 0x1b, 0x8b, 0x7d, 0x01, 0x6e, 0xfb, 0x49,
                                             0x8b, 0x99, 0xdd, 0x31, 0x04, 0x50, 0x97, 0xf7};
  uint8_t tag[SEAL_TAG];
  need_seals();
  seal_tag(&team, word, WORD, tag);
  TEST_ASSERT_EQUAL_MEMORY(expected, tag, sizeof tag);
}

static void test_a_tag_holds_for_its_bytes_and_key_alone(void) {
  uint8_t tag[SEAL_TAG], bytes[WORD];
  need_seals();
  seal_tag(&team, word, WORD, tag);
  TEST_ASSERT_TRUE(seal_holds(&team, word, WORD, tag));
  TEST_ASSERT_FALSE(seal_holds(&other, word, WORD, tag));
  TEST_ASSERT_FALSE(seal_holds(&team, word, WORD - 1, tag));
  memcpy(bytes, word, WORD);
  for (int bit = 0; bit < 8 * WORD; bit++) {
    bytes[bit / 8] ^= (uint8_t)(1 << bit % 8);
    TEST_ASSERT_FALSE(seal_holds(&team, bytes, WORD, tag));
    bytes[bit / 8] ^= (uint8_t)(1 << bit % 8);
  }
  for (int bit = 0; bit < 8 * SEAL_TAG; bit++) {
    tag[bit / 8] ^= (uint8_t)(1 << bit % 8);
    TEST_ASSERT_FALSE(seal_holds(&team, word, WORD, tag));
    tag[bit / 8] ^= (uint8_t)(1 << bit % 8);
  }
}

/* ---- keys ---- */

static void refuse(const char *path, const char *says) {
  seal none;
  TEST_ASSERT_EQUAL_INT_MESSAGE(-1, seal_read(&none, path, &why), path);
  TEST_ASSERT_NULL_MESSAGE(strchr(why.text, '\n'), why.text);
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(why.text, path), why.text);
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(why.text, says), why.text);
}

static void test_what_is_no_key_is_refused(void) {
  need_seals();
  write_key("short.key", 31, 0600);
  refuse("short.key", "32 bytes or more");
  write_key("empty.key", 0, 0600);
  refuse("empty.key", "empty");
  write_key("long.key", 4097, 0600);
  refuse("long.key", "long.key");
  write_key("group.key", 32, 0640);
  refuse("group.key", "chmod 600");
  write_key("all.key", 32, 0604);
  refuse("all.key", "chmod 600");
  refuse("no.key", "no.key");
  refuse(".", "folder");
}

static void test_of_a_wiped_key_nothing_is_left(void) {
  static const seal blank;
  need_seals();
  seal_wipe(&other);
  TEST_ASSERT_EQUAL_MEMORY(&blank, &other, sizeof blank);
}

/* ---- the bus ---- */

static void hear(void *user, const message_terminate *m) {
  (void)user;
  (void)m;
  heard++;
}

static void say(bus *b) {
  bus_send_terminate(b, &(message_terminate){.utime = 7, .sender = 1, .signal = 1, .identity = 9});
}

static void test_a_sealed_bus_hears_its_own_seal_alone_and_counts_the_rest(void) {
  bus *b;
  need_seals();
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, bus_open(&b, BUS_IN_PROCESS, &why), why.text);
  bus_hear_terminate(b, hear, NULL);
  say(b); /* not sealed, and heard by a sealed bus */
  bus_seal(b, &team);
  bus_drain(b);
  TEST_ASSERT_EQUAL_INT(0, heard);
  say(b);
  bus_drain(b);
  TEST_ASSERT_EQUAL_INT(1, heard);
  say(b); /* sealed, and heard by a bus of another key */
  bus_seal(b, &other);
  bus_drain(b);
  TEST_ASSERT_EQUAL_INT(1, heard);
  TEST_ASSERT_EQUAL_UINT64(2, bus_count(b).unsealed);
  TEST_ASSERT_EQUAL_UINT64(2, bus_count(b).ignored);
  bus_close(b);
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_a_tag_is_keyed_blake2b);
  RUN_TEST(test_a_tag_holds_for_its_bytes_and_key_alone);
  RUN_TEST(test_what_is_no_key_is_refused);
  RUN_TEST(test_of_a_wiped_key_nothing_is_left);
  RUN_TEST(test_a_sealed_bus_hears_its_own_seal_alone_and_counts_the_rest);
  return UNITY_END();
}

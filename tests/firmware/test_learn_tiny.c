/* A robot that learns by itself, under the profile QTR_PROFILE_TINY: maps of 10 x 10 cells, 8 places and 2 robots to
 * their certificates and on to a table that opens, all in 16 kB and 40 million instructions. What takes how much is
 * printed. */
#include <stdio.h>
#include <string.h>

#include "quarter/export.h"
#include "quarter/learner.h"
#include "quarter/policy.h"
#include "support/scattered.h"
#include "unity.h"

enum { SIDE = 10, PLACES = 8, SEEKERS = 2, PRICE_STEPS = 10, MAPS = 40, STACK_MOST = 6144 };

#define RAM_LIMIT 16384u
#define INSTRUCTIONS_LIMIT 40000000u

/* All that learning takes but the stack. Travel times are measured before the workspace is in use. */
static struct {
  qtr_mission mission;
  qtr_game game;
  uint64_t ground[(QTR_ENVIRONMENT_GROUND_BYTES + 7) / 8];
  union {
    uint64_t bytes[(QTR_LEARNER_BYTES + 7) / 8];
    qtr_travel travel;
  } work;
  uint32_t table[QTR_QTABLE_WORDS]; /* the Q-table; afterwards the policy table */
} ram;

static qtr_policy policy;

void setUp(void) {
}

void tearDown(void) {
}

/* ---- what is measured ---- */

/* Timer 0 of the MPS2 boards, which counts down at 25 MHz. QEMU's -icount shift=7 takes 128 ns of it for an
 * instruction. */
static volatile uint32_t *const timer = (volatile uint32_t *)0x40000000u;
enum { TIMER_CONTROL, TIMER_VALUE, TIMER_RELOAD };

static void start_counting(void) {
  timer[TIMER_CONTROL] = 0;
  timer[TIMER_RELOAD] = UINT32_MAX;
  timer[TIMER_VALUE] = UINT32_MAX;
  timer[TIMER_CONTROL] = 1;
}

static uint32_t instructions(void) {
  return (uint32_t)((uint64_t)(UINT32_MAX - timer[TIMER_VALUE]) * 40 / 128);
}

/* The stack below the caller's frame: painted, and how much of it has been used since. */
#define PAINT 0xA5u

static __attribute__((noinline)) uint8_t *stack_bottom(void) {
  return (uint8_t *)__builtin_frame_address(0) - 64;
}

static void paint_stack(uint8_t *bottom) {
  for (volatile uint8_t *at = bottom - STACK_MOST; at < bottom; at++) *at = PAINT;
}

static unsigned stack_used(const uint8_t *bottom) {
  const volatile uint8_t *at = bottom - STACK_MOST;
  while (at < bottom && *at == PAINT) at++;
  return (unsigned)(bottom - at);
}

/* ---- learning ---- */

static uint32_t learn(unsigned seed, int objective) {
  qtr_environment *ground;
  qtr_learner *learner;
  qtr_learner_config config;
  qtr_certificate certificate;
  char note[40];
  const qtr_learner_blocks blocks = {ram.work.bytes, sizeof ram.work.bytes, ram.table, QTR_QTABLE_WORDS, NULL, 0};
  snprintf(note, sizeof note, "map %u, objective %d", seed, objective);
  scattered_make(&ram.mission, &ram.game, &ram.work.travel, seed, SIDE, PLACES, SEEKERS, objective);
  qtr_learner_config_default(&config);
  config.price_steps = PRICE_STEPS;
  start_counting();
  TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_game_init(&ram.game, &ram.mission, &ram.work.travel, NULL));
  TEST_ASSERT_EQUAL_INT(
      QTR_OK, qtr_environment_init(&ground, ram.ground, sizeof ram.ground, &ram.game, NULL, &ram.work.travel));
  TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_learner_init(&learner, &blocks, ground, NULL, &config));
  while (qtr_learner_step(learner) == QTR_LEARNING) {}
  qtr_learner_certificate(learner, &certificate);
  const uint32_t taken = instructions();
  TEST_ASSERT_TRUE_MESSAGE(certificate.certified, note);
  const int32_t size = qtr_export(learner, (uint8_t *)ram.table, sizeof ram.table);
  TEST_ASSERT_GREATER_THAN_MESSAGE(0, size, note);
  TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_OK, qtr_policy_open(&policy, ram.table, (uint32_t)size), note);
  TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_OK, qtr_policy_check(&policy), note);
  return taken;
}

static void test_maps_are_learnt_to_their_certificates_in_16_kb_and_40_million_instructions(void) {
  uint32_t most = 0, all = 0;
  uint8_t *const bottom = stack_bottom();
  paint_stack(bottom);
  for (unsigned map = 0; map < 2 * MAPS; map++) {
    const uint32_t taken = learn(map / 2 + 1, map % 2 == 0 ? QTR_DISCOUNTED : QTR_TIME);
    all += taken / 1000;
    if (taken > most) most = taken;
  }
  const unsigned stack = stack_used(bottom);
  const unsigned sum = (unsigned)(sizeof ram + stack);
  printf("RAM %u: mission %u, game with its board %u, ground %u, learner %u, Q-table %u, stack %u\n", sum,
         (unsigned)sizeof ram.mission, (unsigned)sizeof ram.game, (unsigned)sizeof ram.ground,
         (unsigned)sizeof ram.work, (unsigned)sizeof ram.table, stack);
  printf("instructions to the certificate: %lu on average, %lu at most\n", (unsigned long)(all / (2 * MAPS) * 1000),
         (unsigned long)most);
  TEST_ASSERT_LESS_THAN_UINT(STACK_MOST, stack);
  TEST_ASSERT_LESS_OR_EQUAL_UINT(RAM_LIMIT, sum);
  TEST_ASSERT_GREATER_THAN_UINT32(0, most);
  TEST_ASSERT_LESS_OR_EQUAL_UINT32(INSTRUCTIONS_LIMIT, most);
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_maps_are_learnt_to_their_certificates_in_16_kb_and_40_million_instructions);
  return UNITY_END();
}

/* What a robot's build of any sizes takes of RAM, against sizeof in builds of several: on the host, and on boards. */
#include <stdio.h>

#include "host/table/robot_memory.h"
#include "support/robot_sizeof.h"
#include "unity.h"

extern const robot_sizeof sizeof_mcu, sizeof_least, sizeof_odd, sizeof_words, sizeof_wide;

void setUp(void) {
}

void tearDown(void) {
}

static void expect(const robot_sizeof *built) {
  const robot_sizes sizes = {
      {[ROBOT_CELLS] = built->cells, [ROBOT_PLACES] = built->places, [ROBOT_SEEKERS] = built->seekers}};
  const robot_processor processor = {built->pointer, built->alignment};
  const robot_memory memory = robot_memory_of(&sizes, &processor);
  char note[80];
  snprintf(note, sizeof note, "%lu cells, %lu places, %lu seekers", (unsigned long)built->cells,
           (unsigned long)built->places, (unsigned long)built->seekers);
  TEST_ASSERT_EQUAL_UINT32_MESSAGE(built->policy, (uint32_t)memory.policy, note);
  TEST_ASSERT_EQUAL_UINT32_MESSAGE(built->seeker, (uint32_t)memory.seeker, note);
  TEST_ASSERT_EQUAL_UINT32_MESSAGE(built->field, (uint32_t)memory.field, note);
}

static void test_structures_take_what_is_said_of_them(void) {
  const robot_sizeof *const builds[] = {&sizeof_mcu, &sizeof_least, &sizeof_odd, &sizeof_words, &sizeof_wide};
  for (size_t i = 0; i < sizeof builds / sizeof builds[0]; i++) expect(builds[i]);
}

static void test_the_profile_is_that_of_config_h(void) {
  TEST_ASSERT_EQUAL_UINT32(sizeof_mcu.cells, robot_sizes_mcu.of[ROBOT_CELLS]);
  TEST_ASSERT_EQUAL_UINT32(sizeof_mcu.places, robot_sizes_mcu.of[ROBOT_PLACES]);
  TEST_ASSERT_EQUAL_UINT32(sizeof_mcu.seekers, robot_sizes_mcu.of[ROBOT_SEEKERS]);
}

/* What --profile reckons with is what most of the boards here are. */
static void test_a_board_of_32_bits_is_laid_out_as_is_said(void) {
  if (sizeof_mcu.pointer != 4) TEST_IGNORE_MESSAGE("no processor of 32 bits: the boards' tests look");
  TEST_ASSERT_EQUAL_UINT8(robot_processor_32_bits.pointer, sizeof_mcu.pointer);
  TEST_ASSERT_EQUAL_UINT8(robot_processor_32_bits.alignment, sizeof_mcu.alignment);
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_structures_take_what_is_said_of_them);
  RUN_TEST(test_the_profile_is_that_of_config_h);
  RUN_TEST(test_a_board_of_32_bits_is_laid_out_as_is_said);
  return UNITY_END();
}

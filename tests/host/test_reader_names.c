#include "support/reader_scratch.h"

#define MAP "map: a.txt\n"

void setUp(void) {
  scratch_open();
  scratch_write("a.txt", "S...\n....\n");
}

void tearDown(void) {
  scratch_close();
}

static void refuse(const char *mission, const char *where, const char *what, const char *mend) {
  scratch_write("m.yaml", mission);
  scratch_refuse("m.yaml", where, what, mend);
}

static void test_places_and_robots_have_names(void) {
  scratch_write("m.yaml", MAP "robots: [{column: 0, row: 0, name: Alpha}, {column: 1, row: 0}]\n"
                              "places: [{column: 2, row: 0, name: \"Bay 3\"}, {column: 3, row: 0}, "
                              "{column: 3, row: 1, name: 17}]\n");
  scratch_read("m.yaml");
  const naming n = input_naming(&scratch_input);
  TEST_ASSERT_EQUAL_STRING("Alpha", naming_seeker(&n, 0).text);
  TEST_ASSERT_EQUAL_STRING("1", naming_seeker(&n, 1).text);
  TEST_ASSERT_EQUAL_STRING("Bay 3", naming_place(&n, 0).text);
  TEST_ASSERT_EQUAL_STRING("1", naming_place(&n, 1).text);
  TEST_ASSERT_EQUAL_STRING("17", naming_place(&n, 2).text);
}

static void test_a_name_stays_with_its_place_when_others_are_left_out(void) {
  scratch_write("a.txt", "S#..\n....\n");
  scratch_write("m.yaml", MAP "places: [{column: 1, row: 0, name: Wall}, {column: 2, row: 0, name: Bay}]\n");
  scratch_options.skip = true;
  scratch_read("m.yaml");
  const naming n = input_naming(&scratch_input);
  TEST_ASSERT_EQUAL_INT(1, n.places);
  TEST_ASSERT_EQUAL_STRING("Bay", naming_place(&n, 0).text);
}

static void test_messages_call_places_by_name(void) {
  refuse(MAP "places: [{column: 9, row: 0, name: Bay}]\n", "m.yaml:2", "place Bay: column 9, row 0 lies outside",
         "move");
  refuse(MAP "places: [{column: 1, row: 0, name: Bay}, {column: 1, row: 0, name: Dock}]\n", "m.yaml:2",
         "place Dock lies in the same cell as place Bay", "drop one");
}

static void test_a_robot_that_is_shared_lends_its_name(void) {
  scratch_write("m.yaml", MAP "robots: [{column: 0, row: 0, name: Alpha}]\nplaces: [{column: 1, row: 0}]\n");
  scratch_options.robots = 3;
  scratch_read("m.yaml");
  TEST_ASSERT_EQUAL_STRING("Alpha 1", scratch_input.names.seeker[0]);
  TEST_ASSERT_EQUAL_STRING("Alpha 3", scratch_input.names.seeker[2]);
}

static void test_names_tell_apart(void) {
  refuse(MAP "places:\n - {column: 1, row: 0, name: Bay}\n - {column: 2, row: 0, name: Bay}\n", "m.yaml:4",
         "a second place is called 'Bay', after that of ", "m.yaml:3; give it another name");
  refuse(MAP "robots:\n - {column: 1, row: 0, name: A}\n - {column: 2, row: 0, name: A}\n", "m.yaml:4",
         "a second robot is called 'A'", "another name");
}

static void test_what_is_no_name(void) {
  char text[300];
  refuse(MAP "places: [{column: 1, row: 0, name: \"\"}]\n", "m.yaml:2", "'name' has no value", "give a text");
  refuse(MAP "places: [{column: 1, row: 0, name: \"  \"}]\n", "m.yaml:2", "'name' is \"  \", which is empty",
         "63 bytes");
  refuse(MAP "places: [{column: 1, row: 0, name: \"a\\nb\"}]\n", "m.yaml:2", "has a control character", "one line");
  refuse(MAP "places: [{column: 1, row: 0, name: [a]}]\n", "m.yaml:2", "'name' is a list", "give a text");
  snprintf(text, sizeof text, MAP "places: [{column: 1, row: 0, name: %064d}]\n", 7);
  refuse(text, "m.yaml:2", "which is too long", "at most 63 bytes");
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_places_and_robots_have_names);
  RUN_TEST(test_a_name_stays_with_its_place_when_others_are_left_out);
  RUN_TEST(test_messages_call_places_by_name);
  RUN_TEST(test_a_robot_that_is_shared_lends_its_name);
  RUN_TEST(test_names_tell_apart);
  RUN_TEST(test_what_is_no_name);
  return UNITY_END();
}

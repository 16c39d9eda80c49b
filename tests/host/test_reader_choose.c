/* Which places and robots take part: cleared ones, those left out, those added. */
#include "support/reader_scratch.h"

#define MISSION                                                                                                        \
  "map: a.txt\nrobots: [{column: 0, row: 0, name: Alpha}, {column: 0, row: 1}]\n"                                      \
  "places: [{column: 1, row: 0, name: Bay}, {column: 2, row: 0}, {column: 3, row: 0, name: Dock, weight: 4}]\n"

void setUp(void) {
  scratch_open();
  scratch_write("a.txt", "S..#\n....\n");
  scratch_write("b.txt", "S...\n....\n");
}

void tearDown(void) {
  scratch_close();
}

static void write_mission(const char *more) {
  char text[600];
  snprintf(text, sizeof text, "%s%s", MISSION, more);
  memcpy(strstr(text, "a.txt"), "b.txt", 5);
  scratch_write("m.yaml", text);
}

static void expect_places(const char *wanted) {
  char text[200] = "";
  scratch_read("m.yaml");
  const naming n = input_naming(&scratch_input);
  for (int i = 0; i < n.places; i++) {
    char one[100];
    snprintf(one, sizeof one, "%s=%u ", naming_place(&n, (unsigned)i).text, n.number[i]);
    strcat(text, one);
  }
  TEST_ASSERT_EQUAL_STRING(wanted, text);
}

static void refuse_options(const char *wanted) {
  TEST_ASSERT_EQUAL_INT(-1, input_read(&scratch_input, scratch_path("m.yaml"), &scratch_options, &scratch_fault));
  scratch_expect_text(wanted);
}

static void test_cleared_places_are_left_out_and_the_others_keep_names_and_numbers(void) {
  write_mission("cleared: [Bay]\n");
  expect_places("1=1 Dock=2 ");
  TEST_ASSERT_TRUE(qtr_places_has(&scratch_input.cleared, 0));
  TEST_ASSERT_EQUAL_INT(3, scratch_input.places_stated);
  TEST_ASSERT_NOT_NULL(strstr(scratch_input.note.text[0], "cleared, and so searched by nobody: Bay"));
  write_mission("cleared: [1, Dock]\n");
  expect_places("Bay=0 ");
  TEST_ASSERT_EQUAL_DOUBLE(1.0, scratch_input.mission.weight[0]);
}

static void test_a_callers_list_adds_to_the_missions(void) {
  write_mission("cleared: [Bay]\n");
  scratch_options.clears = 1;
  scratch_options.clear[0] = "Bay, 1";
  expect_places("Dock=2 ");
}

static void test_cleared_places_may_lie_anywhere(void) {
  scratch_write("m.yaml", MISSION "cleared: [Dock]\n"); /* on an obstacle of a.txt */
  expect_places("Bay=0 1=1 ");
}

static void test_what_cannot_be_cleared(void) {
  write_mission("cleared: [Bya]\n");
  scratch_refuse("m.yaml", "m.yaml:4", "cleared: there is no place Bya", "did you mean 'Bay'?");
  write_mission("cleared: [0, 1, 2]\n");
  scratch_refuse("m.yaml", "m.yaml", "all places are cleared", "nothing left to search");
  write_mission("cleared: Bay\n");
  scratch_refuse("m.yaml", "m.yaml:4", "'cleared' is not a list", "cleared: [0]");
  write_mission("cleared: [{x: 1}]\n");
  scratch_refuse("m.yaml", "m.yaml:4", "'cleared' is a mapping", "give a text");
}

static void test_places_and_robots_are_left_out_by_name(void) {
  write_mission("");
  scratch_options.withouts = 2;
  scratch_options.without[0] = "Dock";
  scratch_options.without[1] = "Alpha";
  expect_places("Bay=0 1=1 ");
  TEST_ASSERT_EQUAL_INT(1, scratch_input.mission.seekers);
  TEST_ASSERT_EQUAL_INT(4, scratch_input.mission.start[0]);
  TEST_ASSERT_EQUAL_STRING("", scratch_input.names.seeker[0]);
  scratch_options.without[0] = "place:1";
  scratch_options.without[1] = "robot:1";
  expect_places("Bay=0 Dock=2 ");
  TEST_ASSERT_EQUAL_STRING("Alpha", scratch_input.names.seeker[0]);
}

static void test_who_cannot_be_left_out(void) {
  write_mission("");
  scratch_options.withouts = 1;
  scratch_options.without[0] = "1";
  refuse_options("there is such a place and such a robot; say place:1 or robot:1");
  scratch_options.without[0] = "Alpha, Bravo";
  refuse_options("for several give --without once for each");
  scratch_options.without[0] = "Alpa";
  refuse_options("--without: there is no robot Alpa; did you mean 'Alpha'?");
  scratch_options.without[0] = "place:Alpha";
  refuse_options("--without: there is no place Alpha");
  scratch_options.withouts = 2;
  scratch_options.without[0] = "robot:0";
  scratch_options.without[1] = "robot:1";
  refuse_options("--without: no robot is left");
}

static void test_places_are_added_behind_the_others(void) {
  write_mission("cleared: [Bay]\n");
  scratch_options.adds = 2;
  scratch_options.add[0] = "1.5,0.5,2.5,Shed, left";
  scratch_options.add[1] = "2.5,0.5,1";
  expect_places("1=1 Dock=2 Shed, left=3 4=4 ");
  TEST_ASSERT_EQUAL_DOUBLE(2.5, scratch_input.mission.weight[2]);
  TEST_ASSERT_EQUAL_INT(5, scratch_input.mission.place[2]);
}

static void test_what_cannot_be_added(void) {
  static const char *const words[][2] = {{"1.5,0.5", "say X,Y,WEIGHT or X,Y,WEIGHT,NAME"},
                                         {"1.5,0.5,", "--add:1: 'weight' has no value"},
                                         {"1.5,0.5,0", "--add:1: 'weight' is 0; give a likelihood"},
                                         {"1.5,nan,1", "--add:1: 'y' is \"nan\", which is not a finite number"},
                                         {"1.5,0.5,1,", "--add:1: 'name' has no value"},
                                         {"1.5,0.5,1,Bay", "--add:1: a second place is called 'Bay'"},
                                         {"9,9,1", "--add:1: place 3: x 9, y 9 lies outside the map"}};
  write_mission("");
  scratch_options.adds = 1;
  for (size_t i = 0; i < sizeof words / sizeof words[0]; i++) {
    scratch_options.add[0] = words[i][0];
    refuse_options(words[i][1]);
  }
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_cleared_places_are_left_out_and_the_others_keep_names_and_numbers);
  RUN_TEST(test_a_callers_list_adds_to_the_missions);
  RUN_TEST(test_cleared_places_may_lie_anywhere);
  RUN_TEST(test_what_cannot_be_cleared);
  RUN_TEST(test_places_and_robots_are_left_out_by_name);
  RUN_TEST(test_who_cannot_be_left_out);
  RUN_TEST(test_places_are_added_behind_the_others);
  RUN_TEST(test_what_cannot_be_added);
  return UNITY_END();
}

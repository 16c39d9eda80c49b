/* The field's terms as a mission states them. */
#include "support/reader_scratch.h"

#define MAP "map: a.txt\ncell_size: 2\n"
#define ROBOT "robots: [{column: 0, row: 0}]\n"
#define PLACES "places: [{column: 2, row: 0, name: Bay}, {column: 3, row: 0}]\n"

void setUp(void) {
  scratch_open();
  scratch_write("a.txt", "S...\n....\n");
}

void tearDown(void) {
  scratch_close();
}

static void read_mission(const char *mission) {
  scratch_write("m.yaml", mission);
  scratch_read("m.yaml");
}

static void refuse(const char *mission, const char *where, const char *what, const char *mend) {
  scratch_write("m.yaml", mission);
  scratch_refuse("m.yaml", where, what, mend);
}

static void test_a_missions_own_terms(void) {
  read_mission(MAP ROBOT PLACES "objective: deadline\ndeadline_seconds: 60\nspeed: 0.5\nstep_seconds: 0.25\n"
                                "scan_seconds: 3\ndetection: 0.8\nlooks: 2\n");
  const input_terms *terms = &scratch_input.terms;
  TEST_ASSERT_TRUE(terms->stated);
  TEST_ASSERT_EQUAL_INT(QTR_DEADLINE, scratch_input.mission.aim.kind);
  TEST_ASSERT_EQUAL_DOUBLE(60.0, terms->deadline_seconds);
  TEST_ASSERT_EQUAL_DOUBLE(0.5, terms->speed);
  TEST_ASSERT_EQUAL_DOUBLE(0.25, terms->step_seconds);
  TEST_ASSERT_EQUAL_DOUBLE(3.0, terms->scan_seconds);
  TEST_ASSERT_EQUAL_DOUBLE(0.8, scratch_input.mission.detection[1]);
  TEST_ASSERT_EQUAL_INT(2, scratch_input.mission.looks[1]);
  TEST_ASSERT_EQUAL_INT(1, scratch_input.mission.classes);
}

static void test_home_weight_is_in_the_places_unit(void) {
  read_mission(MAP ROBOT PLACES "objective: time\nhome_weight: 2.5\n");
  TEST_ASSERT_EQUAL_DOUBLE(2.5, scratch_input.mission.aim.home_weight);
  TEST_ASSERT_FALSE(scratch_input.terms.stated);
}

static void test_a_place_says_otherwise_than_the_mission(void) {
  read_mission(MAP ROBOT "scan_seconds: 3\ndetection: 0.8\nlooks: 2\nplaces:\n"
                         " - {column: 2, row: 0, scan_seconds: 0, detection: 1, looks: 1}\n - {column: 3, row: 0}\n");
  TEST_ASSERT_EQUAL_DOUBLE(0.0, scratch_input.terms.place_scan[0]);
  TEST_ASSERT_EQUAL_DOUBLE(1.0, scratch_input.mission.detection[0]);
  TEST_ASSERT_EQUAL_INT(1, scratch_input.mission.looks[0]);
  TEST_ASSERT_EQUAL_DOUBLE(INPUT_UNSAID, scratch_input.terms.place_scan[1]);
  TEST_ASSERT_EQUAL_DOUBLE(0.8, scratch_input.mission.detection[1]);
}

static void test_columns_of_a_csv_say_it_too(void) {
  scratch_write("p.csv", "looks,x,y,detection,scan_seconds\n3,5,1,0.5,7\n");
  read_mission(MAP ROBOT "places_csv: p.csv\n");
  TEST_ASSERT_EQUAL_INT(3, scratch_input.mission.looks[0]);
  TEST_ASSERT_EQUAL_DOUBLE(0.5, scratch_input.mission.detection[0]);
  TEST_ASSERT_EQUAL_DOUBLE(7.0, scratch_input.terms.place_scan[0]);
  TEST_ASSERT_TRUE(scratch_input.terms.stated);
}

/* An empty field leaves a place what the mission says; a weight is none of these. */
static void test_empty_fields_of_a_csv_are_the_mission_s(void) {
  scratch_write("p.csv", "x,y,weight,detection,looks,scan_seconds\n5,1,1,,,\n6,1,1,0.5,3,7\n");
  read_mission(MAP ROBOT "scan_seconds: 3\ndetection: 0.8\nlooks: 2\nplaces_csv: p.csv\n");
  TEST_ASSERT_EQUAL_DOUBLE(0.8, scratch_input.mission.detection[0]);
  TEST_ASSERT_EQUAL_UINT8(2, scratch_input.mission.looks[0]);
  TEST_ASSERT_EQUAL_DOUBLE(INPUT_UNSAID, scratch_input.terms.place_scan[0]);
  TEST_ASSERT_EQUAL_DOUBLE(0.5, scratch_input.mission.detection[1]);
  TEST_ASSERT_EQUAL_UINT8(3, scratch_input.mission.looks[1]);
  TEST_ASSERT_EQUAL_DOUBLE(7.0, scratch_input.terms.place_scan[1]);
  scratch_write("p.csv", "x,y,weight\n5,1,\n");
  refuse(MAP ROBOT "places_csv: p.csv\n", "p.csv:2:5", "'weight'", "number");
}

static void test_classes_and_who_is_of_them(void) {
  read_mission(MAP PLACES "classes:\n  drone: {speed: 5, scan_seconds: 2, endurance_seconds: 600}\n"
                          "  rover: {avoid: [Bay, 1], rough: false}\n"
                          "robots:\n - {column: 0, row: 0, class: rover}\n - {column: 1, row: 0, ready_seconds: 30}\n"
                          " - {column: 1, row: 0, class: drone}\n");
  const qtr_mission *mission = &scratch_input.mission;
  const input_terms *terms = &scratch_input.terms;
  TEST_ASSERT_EQUAL_INT(3, mission->classes);
  TEST_ASSERT_EQUAL_INT(1, mission->class_of[0]);
  TEST_ASSERT_EQUAL_INT(2, mission->class_of[1]);
  TEST_ASSERT_EQUAL_INT(0, mission->class_of[2]);
  TEST_ASSERT_EQUAL_STRING("", terms->of_class[2].name);
  TEST_ASSERT_EQUAL_DOUBLE(5.0, terms->of_class[0].speed);
  TEST_ASSERT_EQUAL_DOUBLE(600.0, terms->of_class[0].endurance_seconds);
  TEST_ASSERT_TRUE(mission->robot_class[1].smooth_only && !mission->robot_class[0].smooth_only);
  TEST_ASSERT_TRUE(qtr_places_has(&mission->robot_class[1].avoided, 0));
  TEST_ASSERT_TRUE(qtr_places_has(&mission->robot_class[1].avoided, 1));
  TEST_ASSERT_EQUAL_DOUBLE(30.0, terms->ready[1]);
}

static void test_robots_that_share_a_start_share_its_class(void) {
  scratch_options.robots = 2;
  read_mission(MAP PLACES "classes: {drone: {speed: 5}, rover: {}}\n"
                          "robots: [{column: 0, row: 0, class: rover, ready_seconds: 4}]\n");
  TEST_ASSERT_EQUAL_INT(1, scratch_input.mission.class_of[1]);
  TEST_ASSERT_EQUAL_DOUBLE(4.0, scratch_input.terms.ready[1]);
}

static void test_terms_stay_with_their_place_when_others_are_left_out(void) {
  scratch_options.skip = true;
  scratch_write("a.txt", "S#..\n....\n");
  read_mission(MAP "classes: {rover: {avoid: [Bay]}}\nrobots: [{column: 0, row: 0, class: rover}]\nplaces:\n"
                   " - {column: 1, row: 0, detection: 0.5, scan_seconds: 1}\n"
                   " - {column: 2, row: 0, name: Bay, detection: 0.7, looks: 3, scan_seconds: 2}\n");
  TEST_ASSERT_EQUAL_INT(1, scratch_input.mission.places);
  TEST_ASSERT_EQUAL_DOUBLE(0.7, scratch_input.mission.detection[0]);
  TEST_ASSERT_EQUAL_INT(3, scratch_input.mission.looks[0]);
  TEST_ASSERT_EQUAL_DOUBLE(2.0, scratch_input.terms.place_scan[0]);
  TEST_ASSERT_TRUE(qtr_places_has(&scratch_input.mission.robot_class[0].avoided, 0));
}

static void test_a_cell_size_gives_a_drawing_metres(void) {
  read_mission(MAP "robots: [{x: 1, y: 3}]\nplaces: [{x: 7.9, y: 0.1}]\n");
  TEST_ASSERT_TRUE(scratch_input.frame.metric);
  TEST_ASSERT_EQUAL_INT(0, scratch_input.mission.start[0]);
  TEST_ASSERT_EQUAL_INT(7, scratch_input.mission.place[0]);
  TEST_ASSERT_EQUAL_UINT32(2000000, scratch_input.mission.frame.cell_size_um);
  scratch_write("a.map", "type octile\nheight 1\nwidth 4\nmap\n....\n");
  read_mission("map: a.map\ncell_size: 0.5\nspeed: 1\nrobots: [{x: 0.1, y: 0.1}]\nplaces: [{x: 1.9, y: 0.4}]\n");
  TEST_ASSERT_EQUAL_INT(3, scratch_input.mission.place[0]);
}

static void test_values_out_of_range(void) {
  static const struct {
    const char *line, *what, *mend;
  } wrong[] = {
      {"detection: 0\n", "'detection' is 0", "above 0 and up to 1"},
      {"detection: 1.01\n", "'detection' is 1.01", "a probability above 0"},
      {"detection: .nan\n", "'detection' is \".nan\"", "a number"},
      {"looks: 0\n", "'looks' is 0", "from 1 to 255"},
      {"looks: 1.5\n", "'looks' is", "whole number"},
      {"scan_seconds: -1\n", "'scan_seconds' is -1 s", "seconds from 0"},
      {"scan_seconds: nan\n", "'scan_seconds' is", "a number"},
      {"speed: 0\n", "'speed' is 0 m/s", "a speed above 0"},
      {"step_seconds: 0\n", "'step_seconds' is 0 s", "from 0.001"},
      {"objective: time\nhome_weight: -1\n", "'home_weight' is -1", "0 or more"},
      {"objective: deadline\ndeadline_seconds: 0\n", "'deadline_seconds' is 0 s", "above 0"},
  };
  for (size_t i = 0; i < sizeof wrong / sizeof wrong[0]; i++) {
    char text[400], where[32];
    snprintf(text, sizeof text, MAP ROBOT PLACES "%s", wrong[i].line);
    snprintf(where, sizeof where, "m.yaml:%d", strncmp(wrong[i].line, "obj", 3) == 0 ? 6 : 5);
    refuse(text, where, wrong[i].what, wrong[i].mend);
  }
}

static void test_places_out_of_range(void) {
  refuse(MAP ROBOT "places: [{column: 2, row: 0, detection: 2}]\n", "m.yaml:4", "'detection' is 2", "above 0");
  refuse(MAP ROBOT "places: [{column: 2, row: 0, looks: 256}]\n", "m.yaml:4", "'looks' is 256", "from 1 to 255");
  scratch_write("p.csv", "x,y,detection\n5,1,0\n");
  refuse(MAP ROBOT "places_csv: p.csv\n", "p.csv:2:5", "'detection' is 0", "above 0");
}

static void test_class_faults(void) {
  const char *two = "classes: {drone: {}, rover: {}}\n";
  char text[400];
  snprintf(text, sizeof text,
           MAP PLACES "%s"
                      "robots: [{column: 0, row: 0, class: Drone}]\n",
           two);
  refuse(text, "m.yaml:5", "there is no class 'Drone'", "did you mean 'drone'?");
  snprintf(text, sizeof text,
           MAP PLACES "%s"
                      "robots: [{column: 0, row: 0, class: boat}]\n",
           two);
  refuse(text, "m.yaml:5", "there is no class 'boat'", "'classes' holds drone and rover");
  refuse(MAP PLACES "robots: [{column: 0, row: 0, class: boat}]\n", "m.yaml:4", "the mission has no 'classes'",
         "classes: {boat:");
  refuse(MAP PLACES ROBOT "classes: [drone]\n", "m.yaml:5", "'classes' holds no class", "write one");
  refuse(MAP PLACES ROBOT "classes: {}\n", "m.yaml:5", "'classes' holds no class", "write one");
  refuse(MAP PLACES ROBOT "classes: {drone: {spede: 1}}\n", "m.yaml:5", "unknown key 'spede' of class drone",
         "did you mean 'speed'?");
  refuse(MAP PLACES ROBOT "classes:\n  drone: {}\n  drone: {}\n", "m.yaml:7", "a second class is called 'drone'",
         "another name");
  refuse(MAP PLACES ROBOT "classes: {drone: {rough: maybe}}\n", "m.yaml:5", "'rough' is \"maybe\"", "false");
  refuse(MAP PLACES ROBOT "classes: {drone: {endurance_seconds: 0}}\n", "m.yaml:5", "'endurance_seconds' is 0 s",
         "above 0");
  refuse(MAP PLACES ROBOT "classes: {drone: {avoid: [Bai]}}\n", "m.yaml:5",
         "class drone avoids a place that is not there", "did you mean 'Bay'?");
  refuse(MAP PLACES ROBOT "classes: {drone: {avoid: [7]}}\n", "m.yaml:5", "there is no place 7", "places 0 to 1");
}

static void test_more_classes_than_the_build_holds(void) {
  char text[4000] = MAP PLACES ROBOT "classes:\n";
  for (int i = 0; i <= QTR_MAX_CLASSES; i++)
    snprintf(text + strlen(text), sizeof text - strlen(text), "  c%d: {}\n", i);
  refuse(text, "m.yaml:6", "the most that this build holds", "QTR_MAX_CLASSES");
  strcpy(text, MAP PLACES ROBOT "classes:\n");
  for (int i = 0; i < QTR_MAX_CLASSES; i++) snprintf(text + strlen(text), sizeof text - strlen(text), "  c%d: {}\n", i);
  refuse(text, "m.yaml:4", "a robot without a class is of one more", "name one of 'classes'");
}

static void test_metres_a_second_need_metres(void) {
  refuse("map: a.txt\nspeed: 1\n" PLACES, "m.yaml:2", "'speed' is in metres a second", "cell_size: 1");
  refuse("map: a.txt\nclasses:\n  drone:\n    speed: 1\nrobots: [{column: 0, row: 0, class: drone}]\n" PLACES,
         "m.yaml:4", "'speed' is in metres a second", "cell_size: 1");
}

static void test_an_objectives_own_keys_go_with_it(void) {
  refuse(MAP ROBOT PLACES "deadline_seconds: 5\n", "m.yaml:5", "is for \"objective: deadline\"", "delete it");
  refuse(MAP ROBOT PLACES "home_weight: 1\n", "m.yaml:5", "is for \"objective: time\"", "delete it");
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_a_missions_own_terms);
  RUN_TEST(test_home_weight_is_in_the_places_unit);
  RUN_TEST(test_a_place_says_otherwise_than_the_mission);
  RUN_TEST(test_columns_of_a_csv_say_it_too);
  RUN_TEST(test_empty_fields_of_a_csv_are_the_mission_s);
  RUN_TEST(test_classes_and_who_is_of_them);
  RUN_TEST(test_robots_that_share_a_start_share_its_class);
  RUN_TEST(test_terms_stay_with_their_place_when_others_are_left_out);
  RUN_TEST(test_a_cell_size_gives_a_drawing_metres);
  RUN_TEST(test_values_out_of_range);
  RUN_TEST(test_places_out_of_range);
  RUN_TEST(test_class_faults);
  RUN_TEST(test_more_classes_than_the_build_holds);
  RUN_TEST(test_metres_a_second_need_metres);
  RUN_TEST(test_an_objectives_own_keys_go_with_it);
  return UNITY_END();
}

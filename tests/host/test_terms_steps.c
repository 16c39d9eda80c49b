/* A mission's terms as the core plays them: in steps. */
#include "host/plan/problem.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "host/plan/power.h"
#include "host/plan/terms.h"
#include "unity.h"

#define MAP "map: terms.txt\ncell_size: 2\n"

static problem *p;
static plan_config config;
static fault why;

static void write(const char *path, const char *text) {
  FILE *file = fopen(path, "w");
  TEST_ASSERT_NOT_NULL(file);
  fputs(text, file);
  fclose(file);
}

void setUp(void) {
  p = malloc(sizeof *p);
  TEST_ASSERT_NOT_NULL(p);
  plan_config_default(&config);
  write("terms.txt", "S....\n.....\n");
}

void tearDown(void) {
  free(p);
}

static const qtr_mission *load(const char *text) {
  write("terms.yaml", text);
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, problem_load(p, "terms.yaml", &config, &why), why.text);
  return &p->in.mission;
}

static void test_without_terms_a_step_is_a_cell_and_has_no_time(void) {
  const qtr_mission *mission = load("map: terms.txt\nplaces: [{column: 2, row: 0}]\n");
  TEST_ASSERT_FALSE(terms_any(mission));
  TEST_ASSERT_EQUAL_UINT32(0, mission->step_time_us);
  TEST_ASSERT_EQUAL_UINT32(1, mission->robot_class[0].cell_steps);
  TEST_ASSERT_EQUAL_DOUBLE(0.99, mission->aim.gamma);
  TEST_ASSERT_FALSE(p->pace.stated);
}

static void test_a_speed_alone_sets_the_time_of_a_step(void) {
  const qtr_mission *mission = load(MAP "speed: 0.8\nplaces: [{column: 2, row: 0}]\n");
  TEST_ASSERT_FALSE(terms_any(mission));
  TEST_ASSERT_EQUAL_UINT32(2500000, mission->step_time_us);
  TEST_ASSERT_EQUAL_UINT32(1, mission->robot_class[0].cell_steps);
  TEST_ASSERT_EQUAL_DOUBLE(power_of(0.99, 2.5), mission->aim.gamma);
  TEST_ASSERT_EQUAL_DOUBLE(0.99, p->pace.gamma);
}

static void test_gamma_of_the_command_line_is_a_seconds_too(void) {
  config.aim.gamma = 0.9;
  TEST_ASSERT_EQUAL_DOUBLE(sqrt(0.9), load(MAP "speed: 4\nplaces: [{column: 2, row: 0}]\n")->aim.gamma);
}

/* 0.5 s a step: drones take 1 for a cell, rovers 4. */
static void test_scans_go_by_place_then_class_then_mission(void) {
  const qtr_mission *mission =
      load(MAP "scan_seconds: 10\nclasses: {drone: {speed: 4, scan_seconds: 3}, rover: {speed: "
               "1}}\nrobots: [{column: 0, row: 0, class: drone}, {column: 0, row: 1, class: "
               "rover}]\nplaces: [{column: 2, row: 0}, {column: 3, row: 0, scan_seconds: 7.1}]\n");
  TEST_ASSERT_EQUAL_UINT32(500000, mission->step_time_us);
  TEST_ASSERT_EQUAL_UINT32(1, mission->robot_class[0].cell_steps);
  TEST_ASSERT_EQUAL_UINT32(4, mission->robot_class[1].cell_steps);
  TEST_ASSERT_EQUAL_UINT32(6, mission->robot_class[0].scan[0]);
  TEST_ASSERT_EQUAL_UINT32(20, mission->robot_class[1].scan[0]);
  TEST_ASSERT_EQUAL_UINT32(15, mission->robot_class[0].scan[1]);
  TEST_ASSERT_EQUAL_UINT32(15, mission->robot_class[1].scan[1]);
}

static void test_ready_times_are_rounded_up_and_ends_down(void) {
  const qtr_mission *mission = load(
      MAP "objective: deadline\ndeadline_seconds: 9.9\nclasses: {drone: {speed: 1, endurance_seconds: 21}}\nrobots: "
          "[{column: 0, row: 0, class: drone, ready_seconds: 2.1}]\nplaces: [{column: 2, row: 0}]\n");
  TEST_ASSERT_EQUAL_UINT32(2000000, mission->step_time_us);
  TEST_ASSERT_EQUAL_UINT32(2, mission->ready[0]);
  TEST_ASSERT_EQUAL_UINT32(10, mission->robot_class[0].endurance);
  TEST_ASSERT_EQUAL_UINT32(4, mission->aim.deadline);
  TEST_ASSERT_TRUE(p->pace.end_rounding > 0.5);
  TEST_ASSERT_EQUAL_INT(1, p->in.note.count);
}

static void test_classes_of_nobody_have_no_part_in_the_step(void) {
  const qtr_mission *mission = load(MAP "classes: {jet: {speed: 37}, drone: {speed: 4}, rover: {speed: 1}}\nrobots: "
                                        "[{column: 0, row: 0, class: rover}, {column: 0, row: 1, class: rover}]\n"
                                        "places: [{column: 2, row: 0}]\n");
  TEST_ASSERT_EQUAL_INT(1, mission->classes);
  TEST_ASSERT_EQUAL_INT(0, mission->class_of[0]);
  TEST_ASSERT_EQUAL_UINT32(2000000, mission->step_time_us);
  TEST_ASSERT_EQUAL_STRING("rover", p->in.terms.of_class[0].name);
  TEST_ASSERT_EQUAL_INT(2, p->in.note.count);
}

static void test_looks_that_find_nothing_more_are_none(void) {
  const qtr_mission *mission = load(MAP "looks: 3\nplaces: [{column: 2, row: 0}, {column: 3, row: 0, detection: 0.5, "
                                        "scan_seconds: 1}]\n");
  TEST_ASSERT_EQUAL_INT(1, mission->looks[0]);
  TEST_ASSERT_EQUAL_INT(3, mission->looks[1]);
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, problem_measure(p, &config, &why), why.text);
  TEST_ASSERT_EQUAL_INT(4, p->game->board.places);
}

static void test_the_command_line_sets_objective_and_deadline_alone(void) {
  config.deadline_seconds = 12;
  const qtr_mission *mission = load(MAP "objective: time\ngamma: 0.9\nspeed: 2\nplaces: [{column: 2, row: 0}]\n");
  TEST_ASSERT_EQUAL_INT(QTR_DEADLINE, mission->aim.kind);
  TEST_ASSERT_EQUAL_UINT32(12, mission->aim.deadline);
  TEST_ASSERT_EQUAL_DOUBLE(0.9, mission->aim.gamma);
  config.deadline_seconds = 0.0;
  config.aim.kind = QTR_TIME;
  mission = load(MAP "objective: deadline\ndeadline_seconds: 30\nplaces: [{column: 2, row: 0}]\n");
  TEST_ASSERT_EQUAL_INT(QTR_TIME, mission->aim.kind);
  mission = load(MAP "objective: time\nhome_weight: 2\nplaces: [{column: 2, row: 0}]\n");
  TEST_ASSERT_EQUAL_DOUBLE(2.0, mission->aim.home_weight);
}

static void test_terms_follow_their_places_when_some_are_out_of_reach(void) {
  config.reading.skip = true;
  write("terms.txt", "S.#..\n..#..\n");
  load(MAP
       "classes: {a: {avoid: [1]}}\nrobots: [{column: 0, row: 0, class: a}, {column: 0, row: 0}]\nplaces: [{column: "
       "4, row: 0, scan_seconds: 9}, {column: 1, row: 0, scan_seconds: 5, detection: 0.5}]\n");
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, problem_measure(p, &config, &why), why.text);
  TEST_ASSERT_EQUAL_INT(1, p->in.mission.places);
  TEST_ASSERT_EQUAL_UINT32(5, p->in.mission.robot_class[0].scan[0]);
  TEST_ASSERT_EQUAL_DOUBLE(0.5, p->in.mission.detection[0]);
  TEST_ASSERT_TRUE(qtr_places_has(&p->in.mission.robot_class[0].avoided, 0));
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_without_terms_a_step_is_a_cell_and_has_no_time);
  RUN_TEST(test_a_speed_alone_sets_the_time_of_a_step);
  RUN_TEST(test_gamma_of_the_command_line_is_a_seconds_too);
  RUN_TEST(test_scans_go_by_place_then_class_then_mission);
  RUN_TEST(test_ready_times_are_rounded_up_and_ends_down);
  RUN_TEST(test_classes_of_nobody_have_no_part_in_the_step);
  RUN_TEST(test_looks_that_find_nothing_more_are_none);
  RUN_TEST(test_the_command_line_sets_objective_and_deadline_alone);
  RUN_TEST(test_terms_follow_their_places_when_some_are_out_of_reach);
  return UNITY_END();
}

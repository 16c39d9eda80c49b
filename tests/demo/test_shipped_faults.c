/* The faults that ship with the missions: all of them strike in the game that one plays without a thought, before the
 * find. */
#include "faults.h"
#include "play.h"

#define DEFAULT_SEED 1

void setUp(void) {
}

void tearDown(void) {
}

static int events_until(double end, int kind, int robot) {
  int count = 0;
  for (int i = 0; i < play_arena.events; i++) {
    const arena_event *e = &play_arena.event[i];
    count += e->kind == kind && e->robot == robot && e->at < end;
  }
  return count;
}

static void assert_strikes(const fault_event *f, double end) {
  static const int kinds[] = {
      [FAULT_LOST] = EVENT_LOST,   [FAULT_STUCK] = EVENT_STUCK,      [FAULT_UNSTUCK] = EVENT_UNSTUCK,
      [FAULT_SLIP] = EVENT_SLIP,   [FAULT_LOSS] = EVENT_LOSS,        [FAULT_SHUT] = EVENT_SHUT,
      [FAULT_RESET] = EVENT_RESET, [FAULT_RESTART] = EVENT_RESTARTED};
  const bool all = f->robot < 0 && f->kind == FAULT_SLIP;
  for (int robot = all ? 0 : f->robot; robot < (all ? play_arena.robots : f->robot + 1); robot++)
    TEST_ASSERT_GREATER_THAN_INT_MESSAGE(0, events_until(end, kinds[f->kind], robot), case_note);
}

static void play_with_faults(const char *mission) {
  static fault_script faults;
  char path[300];
  snprintf(path, sizeof path, "%s/demo/missions/%s/mission.yaml", QUARTER_SOURCE_DIR, mission);
  play_prepare(path, 0);
  snprintf(path, sizeof path, "%s/demo/missions/%s/faults.yaml", QUARTER_SOURCE_DIR, mission);
  const int status = faults_read(&faults, path, &play_plan.t, &play_why);
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, status, play_why.text);
  TEST_ASSERT_GREATER_THAN_INT(1, faults.count);
  game_setup setup = play_setup(DEFAULT_SEED);
  setup.arena.faults = &faults;
  play(setup);
  TEST_ASSERT_TRUE_MESSAGE(play_result.found_at > 0.0, case_note);
  for (int i = 0; i < faults.count; i++) assert_strikes(&faults.event[i], play_result.found_at);
}

static void test_every_shipped_fault_strikes_before_the_default_games_find(void) {
  static const char *const missions[] = {"minefield", "site", "warehouse", "turtlebot3_world", "demining", "flat"};
  for (int i = 0; i < 6; i++) {
    snprintf(case_note, sizeof case_note, "%s", missions[i]);
    play_with_faults(missions[i]);
  }
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_every_shipped_fault_strikes_before_the_default_games_find);
  return UNITY_END();
}

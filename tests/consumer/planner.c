/* A planner that learns in blocks of static storage: links the learner. */
#include <quarter/learn.h>

static qtr_mission mission;
static qtr_travel travel;
static qtr_game game;
static qtr_learner_memory memory;

/* A start between two places, four cells in a row. */
static void make_mission(void) {
  qtr_mission_default(&mission);
  mission.columns = 4;
  mission.rows = 1;
  mission.seekers = 1;
  mission.places = 2;
  mission.start[0] = 1;
  mission.place[1] = 3;
  mission.weight[0] = mission.weight[1] = 1.0;
  for (int cell = 0; cell < 4; cell++) mission.cost[cell] = 1;
}

int main(void) {
  const qtr_learner_blocks blocks = QTR_LEARNER_BLOCKS(memory);
  qtr_environment *ground;
  qtr_learner *learner;
  qtr_learner_config config;
  qtr_certificate certificate;
  qtr_learner_config_default(&config);
  make_mission();
  if (qtr_mission_check(&mission, 0) != QTR_OK || qtr_game_init(&game, &mission, &travel, 0) != QTR_OK) return 1;
  if (qtr_environment_init(&ground, memory.ground, sizeof memory.ground, &game, 0, &travel) != QTR_OK) return 1;
  if (qtr_learner_init(&learner, &blocks, ground, 0, &config) != QTR_OK) return 1;
  while (qtr_learner_step(learner) == QTR_LEARNING) {}
  qtr_learner_certificate(learner, &certificate);
  return certificate.certified && qtr_learner_best(learner)->visit[0] == 1 ? 0 : 1;
}

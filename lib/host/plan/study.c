#include "host/plan/study.h"

#include <stdlib.h>

#include "host/base/stop.h"
#include "quarter/status.h"

#define TABLE_FIRST_WORDS ((size_t)1 << 16)

study *study_take(fault *why) {
  return memory_take(sizeof(study), why);
}

void study_drop(study *s) {
  if (s == NULL) return;
  problem_give_back(&s->p);
  memory_drop(&s->ground_block);
  memory_drop(&s->aggregate_block);
  memory_drop(&s->work);
  memory_drop(&s->routes);
  memory_drop(&s->table);
  free(s->regions);
  free(s);
}

/* ---- set-up ---- */

int study_divide(study *s, const aggregate_config *how, fault *why) {
  if (s->regions == NULL) s->regions = memory_take(sizeof *s->regions, why);
  memory_block scratch = {0};
  if (s->regions == NULL ||
      memory_need(&scratch, qtr_regions_scratch_bytes(qtr_mission_cells(&s->p.in.mission)), why) != 0)
    return -1;
  const int status = aggregate_divide(s->regions, how, &s->p.in.mission, &scratch);
  memory_drop(&scratch);
  if (status == QTR_OK || status == QTR_ERR_STOPPED) return status;
  return fault_set(why, "%s: its regions: %s", s->p.in.path, qtr_strerror(status));
}

/* The ground has the mission's own rule, but under an aggregate: its policy is played on the ground by the free one,
 * whatever the rule that it was learnt by. */
static void set_ground_rule(study *s) {
  s->p.game->board.rule = s->aggregated ? QTR_RULE_FREE : s->p.in.mission.rule;
}

/* 0, -1 with *why set, or QTR_ERR_STOPPED. */
static int make_aggregate(study *s, const aggregate_config *how, fault *why) {
  const bool by_regions = aggregate_by_regions(how->way);
  memory_block *block = &s->aggregate_block;
  int status = by_regions ? study_divide(s, how, why) : QTR_OK;
  if (status != QTR_OK) return status;
  qtr_aggregation units = how->units;
  units.rule = s->p.in.mission.rule;
  units.by_spots = aggregate_by_spots(how->way);
  units.regions = by_regions ? s->regions : NULL;
  if (memory_need(block, qtr_environment_bytes(s->p.game, &units), why) != 0) return -1;
  status = qtr_environment_init(&s->aggregate, block->at, block->bytes, s->p.game, &units, s->p.travel);
  if (status == QTR_OK || status == QTR_ERR_STOPPED) return status;
  return fault_set(why, "%s: %s", s->p.in.path, qtr_strerror(status));
}

static int take_blocks(study *s, fault *why) {
  if (memory_need(&s->ground_block, qtr_environment_bytes(s->p.game, NULL), why) != 0) return -1;
  if (memory_need(&s->work, qtr_learner_bytes(s->p.game), why) != 0) return -1;
  if (memory_need(&s->table, TABLE_FIRST_WORDS * sizeof(uint32_t), why) != 0) return -1;
  memory_want(&s->routes, qtr_learner_route_bytes(s->p.game));
  return 0;
}

static int make_learner(study *s, const qtr_learner_config *config) {
  const qtr_learner_blocks blocks = {s->work.at,   s->work.bytes,  s->table.at, s->table.bytes / sizeof(uint32_t),
                                     s->routes.at, s->routes.bytes};
  s->cramped = false;
  return qtr_learner_init(&s->learner, &blocks, s->ground, s->aggregated ? s->aggregate : NULL, config);
}

int study_begin(study *s, const plan_config *config, fault *why) {
  qtr_learner_config learning = config->learner;
  learning.ground_search = !s->measuring;
  s->aggregated = config->aggregate.way != AGGREGATE_NONE;
  set_ground_rule(s);
  int status = s->aggregated ? make_aggregate(s, &config->aggregate, why) : QTR_OK;
  if (status != QTR_OK && status != QTR_ERR_STOPPED) return -1;
  /* An aggregate that was not ready in time leaves the true map. */
  s->aggregated = s->aggregated && status == QTR_OK;
  set_ground_rule(s);
  if (take_blocks(s, why) != 0) return -1;
  status = qtr_environment_init(&s->ground, s->ground_block.at, s->ground_block.bytes, s->p.game, NULL, s->p.travel);
  if (status == QTR_OK) status = make_learner(s, &learning);
  return status == QTR_OK ? 0 : fault_set(why, "%s: %s", s->p.in.path, qtr_strerror(status));
}

/* ---- learning ---- */

/* Ahead of what a step can learn. */
static void grow_table(study *s) {
  const size_t bytes = qtr_learner_table_needs(s->learner) * sizeof(uint32_t);
  if (s->cramped || bytes <= s->table.bytes) return;
  s->cramped = !memory_grow(&s->table, bytes);
  qtr_learner_move_table(s->learner, s->table.at, s->table.bytes / sizeof(uint32_t));
}

enum qtr_learning study_step(study *s) {
  grow_table(s);
  return qtr_learner_step(s->learner);
}

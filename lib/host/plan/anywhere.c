#include "host/plan/anywhere.h"

#include <float.h>
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "host/base/count.h"
#include "host/base/stop.h"
#include "host/plan/progress.h"
#include "quarter/any_start.h"
#include "quarter/policy.h"
#include "quarter/rest.h"
#include "quarter/start_regions.h"
#include "quarter/start_trials.h"
#include "quarter/status.h"

/* Where nobody says how many regions, no more than these, and than what so many visits in all games come to: some
 * minutes of learning. */
#define REGIONS_MOST 255
#define VISITS_MOST 2e5

/* Steps of the learner: a few games are proven as the mission's own is; many share the steps, and very many do with the
 * local search before them, which loses next to nothing and takes a hundredth of the time. */
#define GAMES_PROVEN 1000.0
#define STEPS_SHARED 20000.0
#define STEPS_MOST 2000
#define TRIAL_STEPS 50

/* Before the regions that are meant a half of them is learnt, and before those a quarter, as long as there are so many:
 * a stop leaves the last table that was whole. */
#define STAGES 4
#define COARSEST 4
#define GAMES_SHARE 0.8 /* of the time that is left; trials take the rest */

/* A table of some regions. */
typedef struct {
  qtr_any_start_blocks blocks;
  qtr_any_start any;
} stage;

/* The whole under work. */
typedef struct {
  study *s;
  study *alone; /* learns one start and one set of places left at a time */
  const plan_config *config;
  stage last; /* that is whole */
  qtr_any_start_blocks blocks;
  qtr_any_start any;
  int steps;  /* of the learner for a game */
  bool ended; /* by a stop, before all was learnt that was meant */
  progress shown;
} builder;

/* ---- how many regions ---- */

static double count_sets(const builder *b) {
  return b->config->any_cleared ? ldexp(1.0, b->s->p.in.mission.places) - 1.0 : 1.0;
}

/* As many as make no more games than these; one at the least. */
static uint32_t regions_for(const builder *b, double games) {
  uint32_t regions = 1;
  while (regions < REGIONS_MOST && qtr_any_start_crews_of(&b->s->p.in.mission, regions + 1) * count_sets(b) <= games)
    regions++;
  return regions;
}

/* ---- set-up ---- */

/* Bytes of the table: with no records what robots need besides, and those of the records at most. */
static double table_bytes(const builder *b) {
  qtr_certificate none;
  memset(&none, 0, sizeof none);
  const qtr_table_content content = qtr_any_start_content(&b->any, &none, 0);
  return (double)qtr_table_size(&content) + qtr_any_start_estimate(&b->any);
}

static int refuse_size(const builder *b, fault *why) {
  return fault_set(
      why, "%s: the table would take about %.3g MB for %.3g games, and --table-limit allows %.3g MB; allow more, or %s",
      b->s->p.in.path, table_bytes(b) / 1e6, qtr_any_start_count_games(&b->any), b->config->table_limit,
      b->config->any_starts ? "take fewer regions with --start-regions"
                            : "list fewer places: with --cleared any each doubles the games");
}

static int stopped(const builder *b, fault *why) {
  fault_set(why, "%s: ended (%s) after %.3g s, before the table for all starts was begun; nothing was written",
            b->s->p.in.path, stop_reason(), stop_seconds());
  why->status = EXIT_STOPPED;
  return -1;
}

static int refuse_regions(const builder *b, uint32_t most, int status, fault *why) {
  if (status == QTR_ERR_STOPPED) return stopped(b, why);
  if (status != QTR_ERR_LIMIT) return fault_set(why, "%s: its regions: %s", b->s->p.in.path, qtr_strerror(status));
  return fault_set(why, "%s: the map falls into more parts than %s; ask for more with --start-regions", b->s->p.in.path,
                   counted(most, "region").text);
}

static int divide(builder *b, uint32_t most, fault *why) {
  study *s = b->s;
  memory_block scratch = {0};
  if (s->regions == NULL) s->regions = memory_take(sizeof *s->regions, why);
  if (s->regions == NULL || memory_need(&scratch, qtr_start_regions_bytes(s->p.game, most), why) != 0) return -1;
  const int status = qtr_start_regions_build(s->regions, s->p.game, most, s->p.travel, scratch.at, scratch.bytes);
  memory_drop(&scratch);
  return status == QTR_OK ? 0 : refuse_regions(b, most, status, why);
}

static void drop(qtr_any_start_blocks *blocks) {
  free(blocks->entries);
  free(blocks->region);
  free(blocks->start);
  free(blocks->steps);
  *blocks = (qtr_any_start_blocks){0};
}

static int allocate(builder *b, const qtr_any_start_asked *asked, fault *why) {
  qtr_any_start_sizes sizes;
  const int status = qtr_any_start_needs(&sizes, asked);
  if (status == QTR_ERR_LIMIT)
    return fault_set(why, "%s: %" PRIu32 " regions are too many for a table; take fewer with --start-regions",
                     b->s->p.in.path, b->s->regions->count);
  if (status != QTR_OK) return fault_set(why, "%s: %s", b->s->p.in.path, qtr_strerror(status));
  drop(&b->blocks);
  b->blocks.start = malloc(sizes.start);
  b->blocks.steps = malloc(sizes.steps);
  if (sizes.region > 0) b->blocks.region = malloc(sizes.region);
  if (b->blocks.start != NULL && b->blocks.steps != NULL && (sizes.region == 0 || b->blocks.region != NULL)) return 0;
  return fault_set(why, "%s: no memory for a table of %d starts", b->s->p.in.path, sizes.starts);
}

static int steps_for(double games) {
  if (games > GAMES_PROVEN) return 0;
  return games * STEPS_MOST <= STEPS_SHARED ? STEPS_MOST : (int)(STEPS_SHARED / games);
}

/* A board of so many regions at most. */
static int set_up(builder *b, uint32_t most, fault *why) {
  if (b->config->any_starts && divide(b, most, why) != 0) return -1;
  const qtr_any_start_asked asked = {.game = b->s->p.game,
                                     .regions = b->config->any_starts ? b->s->regions : NULL,
                                     .any_cleared = b->config->any_cleared};
  if (allocate(b, &asked, why) != 0) return -1;
  if (stop_asked()) return stopped(b, why);
  const int status = qtr_any_start_init(&b->any, &asked, &b->blocks, b->s->p.travel);
  if (status == QTR_ERR_STOPPED) return stopped(b, why);
  if (status != QTR_OK) return fault_set(why, "%s: %s", b->s->p.in.path, qtr_strerror(status));
  b->steps = steps_for(qtr_any_start_count_games(&b->any));
  return 0;
}

/* Whether the number of regions is the host's to choose. */
static bool may_choose(const builder *b) {
  return b->config->any_starts && b->config->start_regions == 0;
}

/* As many regions as are asked for, or as the limits allow. */
static int set_up_in_limits(builder *b, fault *why) {
  const double limit = b->config->table_limit * 1e6;
  uint32_t most = b->config->start_regions;
  if (most == 0) most = regions_for(b, VISITS_MOST / b->s->p.game->board.places);
  if (set_up(b, most, why) != 0) return -1;
  while (table_bytes(b) > limit) {
    const double records = qtr_any_start_estimate(&b->any);
    const double room = limit - (table_bytes(b) - records);
    if (!may_choose(b) || most == 1 || room <= 0.0) return refuse_size(b, why);
    const uint32_t fewer = regions_for(b, qtr_any_start_count_games(&b->any) * room / records);
    most = fewer < most ? fewer : most - 1;
    if (set_up(b, most, why) != 0) return -1;
  }
  return 0;
}

/* ---- one game ---- */

/* Learn the game that is set up in `alone`. False: there was no time. */
static bool learn_game(builder *b, int most, fault *why) {
  study *alone = b->alone;
  plan_config config = *b->config;
  config.aggregate.way = AGGREGATE_NONE;
  config.learner.setting = QTR_SETTING_CERTIFIED;
  if (study_begin(alone, &config, why) != 0) return false;
  for (int steps = 0; steps < most && study_step(alone) == QTR_LEARNING; steps++) {}
  return !stop_asked();
}

static int enlarge(builder *b, fault *why) {
  const size_t room = b->blocks.entry_room > 0 ? 2 * b->blocks.entry_room : 1024 * (QTR_RECORD_BYTES + 1);
  uint8_t *more = realloc(b->blocks.entries, room);
  if (more == NULL) return fault_set(why, "%s: no memory for the table", b->s->p.in.path);
  b->blocks.entries = more;
  b->blocks.entry_room = room;
  qtr_any_start_move(&b->any, more, room);
  return 0;
}

static int add(builder *b, study *learnt, const uint16_t *number, fault *why) {
  qtr_routes routes;
  qtr_play_to_routes(qtr_learner_best(learnt->learner), learnt->p.game, &routes);
  while (qtr_any_start_add(&b->any, &routes, number) != QTR_OK)
    if (enlarge(b, why) != 0) return -1;
  return 0;
}

/* A crew that cannot play is none. */
static int add_rest(builder *b, fault *why) {
  uint16_t number[QTR_MAX_PLACES];
  study *alone = b->alone;
  why->text[0] = '\0';
  if (qtr_any_start_game(&b->any, alone->p.game, &alone->p.in.mission, number) != QTR_OK) return 0;
  if (!learn_game(b, b->steps, why)) return why->text[0] != '\0' ? -1 : 0;
  return add(b, alone, number, why);
}

/* ---- all games ---- */

/* The mission's own game is learnt already, and the certificate is that of its routes. */
static int add_all(builder *b, fault *why) {
  const double all = qtr_any_start_count_games(&b->any);
  int status = qtr_any_start_next(&b->any) ? add(b, b->s, NULL, why) : 0;
  while (status == 0 && !stop_asked() && qtr_any_start_next(&b->any)) {
    progress_count(&b->shown, "starts", (double)b->any.games, all, stop_seconds());
    status = add_rest(b, why);
  }
  progress_end(&b->shown);
  return status;
}

static bool has_table(const builder *b) {
  return b->last.blocks.start != NULL;
}

/* Keep the table under work in place of the last one: whole, or for want of any. */
static void keep(builder *b) {
  drop(&b->last.blocks);
  b->last = (stage){b->blocks, b->any};
  b->blocks = (qtr_any_start_blocks){0};
}

/* 0, or -1 with *why set. A stop is no fault where there is a table. */
static int learn_stage(builder *b, uint32_t regions, fault *why) {
  if (stop_asked() && has_table(b)) return 0;
  const int status = set_up(b, regions, why) == 0 ? add_all(b, why) : -1;
  if (status == 0 && (!stop_asked() || !has_table(b))) keep(b);
  return stop_asked() && has_table(b) ? 0 : status;
}

/* From few regions to all that are meant. A map of more parts than a stage has regions goes without that stage. */
static int learn_stages(builder *b, fault *why) {
  const uint32_t meant = b->any.inhabited;
  for (int halvings = b->config->any_starts ? STAGES - 1 : 0; halvings > 0; halvings--)
    if (meant >> halvings >= COARSEST && learn_stage(b, meant >> halvings, why) != 0 && stop_asked()) return -1;
  return learn_stage(b, meant, why);
}

/* Under a time limit some of it is left for the trials. */
static int learn_in_time(builder *b, fault *why) {
  const double left = stop_left();
  const double limit = left < DBL_MAX ? stop_seconds() + left : 0.0;
  if (limit > 0.0) stop_after(limit - (1.0 - GAMES_SHARE) * left);
  const int status = learn_stages(b, why);
  b->ended = stop_asked();
  if (limit > 0.0) stop_after(limit);
  return status;
}

static uint32_t write_table(builder *b, uint8_t **bytes, fault *why) {
  qtr_certificate certificate;
  qtr_learner_certificate(b->s->learner, &certificate);
  const qtr_table_content content = qtr_any_start_content(&b->last.any, &certificate, b->config->learner.seed);
  const uint32_t size = qtr_table_size(&content);
  *bytes = malloc(size);
  const int32_t written = *bytes != NULL ? qtr_table_write(&content, *bytes, size) : QTR_ERR_SPACE;
  if (written > 0) return (uint32_t)written;
  free(*bytes);
  *bytes = NULL;
  fault_set(why, "%s: the table cannot be written: %s", b->s->p.in.path, qtr_strerror(written));
  return 0;
}

/* Loss of the table's policy from random cells against one learnt for those cells alone. */
static void try_starts(builder *b, const uint8_t *bytes, uint32_t size, anywhere_report *report, fault *why) {
  study *alone = b->alone;
  qtr_mission *rest = &alone->p.in.mission;
  qtr_start_trials trials;
  qtr_policy policy;
  if (qtr_policy_open(&policy, bytes, size) != QTR_OK) return;
  qtr_start_trials_begin(&trials, b->config->learner.seed);
  while (!stop_asked() && qtr_start_trials_next(&trials, &policy, &b->s->p.in.mission, rest)) {
    progress_count(&b->shown, "trials", trials.count, QTR_START_TRIALS, stop_seconds());
    if (qtr_rest_game(alone->p.game, rest, alone->p.travel) == QTR_OK && learn_game(b, TRIAL_STEPS, why))
      qtr_start_trials_add(&trials, &policy, alone->p.game, qtr_learner_best(alone->learner)->score.worth);
  }
  progress_end(&b->shown);
  report->trials = trials.count;
  if (trials.count == 0) return;
  report->median_loss = trials.loss[trials.count / 2];
  report->ninety_loss = trials.loss[trials.count * 9 / 10];
  report->worst_loss = trials.loss[trials.count - 1];
}

/* ---- the whole ---- */

static uint32_t learn(builder *b, uint8_t **bytes, anywhere_report *report, fault *why) {
  if (set_up_in_limits(b, why) != 0) return 0;
  report->regions_meant = b->any.inhabited;
  if (learn_in_time(b, why) != 0) return 0;
  qtr_any_start_finish(&b->last.any);
  const uint32_t size = write_table(b, bytes, why);
  report->complete = !b->ended;
  report->games = b->last.any.games;
  report->regions = b->last.any.inhabited;
  if (size > 0 && b->last.any.regions > 0) try_starts(b, *bytes, size, report, why);
  return size;
}

uint32_t anywhere_learn(study *s, const plan_config *config, uint8_t **bytes, anywhere_report *report, fault *why) {
  builder b = {.s = s, .config = config};
  *report = (anywhere_report){0};
  progress_begin(&b.shown, config->quiet, 0.0, 0.0);
  b.alone = study_take(why);
  if (b.alone == NULL) return 0;
  memcpy(&b.alone->p.in.mission, &s->p.in.mission, offsetof(qtr_mission, cost) + qtr_mission_cells(&s->p.in.mission));
  memcpy(b.alone->p.in.path, s->p.in.path, sizeof b.alone->p.in.path); /* for what may be said of it */
  const bool has_room = problem_need_game(&b.alone->p, why) == 0;
  const uint32_t size = has_room ? learn(&b, bytes, report, why) : 0;
  study_drop(b.alone);
  drop(&b.blocks);
  drop(&b.last.blocks);
  return size;
}

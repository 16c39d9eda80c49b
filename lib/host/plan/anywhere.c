#include "host/plan/anywhere.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "host/base/stop.h"
#include "host/plan/progress.h"
#include "quarter/any_start.h"
#include "quarter/policy.h"
#include "quarter/rest.h"
#include "quarter/start_trials.h"
#include "quarter/status.h"

/* The whole table under work. */
typedef struct {
  study *s;
  study *alone; /* learns one start and one set of places left at a time */
  const plan_config *config;
  qtr_any_start_blocks blocks;
  qtr_any_start any;
} builder;

/* ---- set-up ---- */

static int check_size(const builder *b, fault *why) {
  const double bytes = qtr_any_start_estimate(&b->any);
  if (bytes <= b->config->table_limit * 1e6) return 0;
  return fault_set(
      why, "%s: the table would take about %.3g MB for %.3g games, and --table-limit allows %.3g MB; allow more, or %s",
      b->s->p.in.path, bytes / 1e6, qtr_any_start_count_games(&b->any), b->config->table_limit,
      b->config->any_starts ? "make the regions larger with --region-size and --region-diameter"
                            : "list fewer places: with --cleared any each doubles the games");
}

static int stopped(const builder *b, fault *why) {
  fault_set(why, "%s: ended (%s) after %.3g s, before the table for all starts was begun; nothing was written",
            b->s->p.in.path, stop_reason(), stop_seconds());
  why->status = EXIT_STOPPED;
  return -1;
}

static int divide(builder *b, fault *why) {
  const int status = study_divide(b->s, &b->config->aggregate, why);
  if (status == QTR_OK) return 0;
  return status == QTR_ERR_STOPPED ? stopped(b, why) : -1;
}

static int allocate(builder *b, const qtr_any_start_asked *asked, fault *why) {
  qtr_any_start_sizes sizes;
  if (qtr_any_start_needs(&sizes, asked) != QTR_OK)
    return fault_set(why,
                     "%s: %" PRIu32 " regions are too many for a table; make them larger with --region-size and "
                     "--region-diameter",
                     b->s->p.in.path, b->s->regions->count);
  b->blocks.start = malloc(sizes.start);
  b->blocks.steps = malloc(sizes.steps);
  if (sizes.region > 0) b->blocks.region = malloc(sizes.region);
  if (b->blocks.start != NULL && b->blocks.steps != NULL && (sizes.region == 0 || b->blocks.region != NULL)) return 0;
  return fault_set(why, "%s: no memory for a table of %d starts", b->s->p.in.path, sizes.starts);
}

static int set_up(builder *b, fault *why) {
  if (b->config->any_starts && divide(b, why) != 0) return -1;
  const qtr_any_start_asked asked = {.game = &b->s->p.game,
                                     .regions = b->config->any_starts ? b->s->regions : NULL,
                                     .any_cleared = b->config->any_cleared};
  if (allocate(b, &asked, why) != 0) return -1;
  if (stop_asked()) return stopped(b, why);
  const int status = qtr_any_start_init(&b->any, &asked, &b->blocks, &b->s->p.travel);
  if (status == QTR_ERR_STOPPED) return stopped(b, why);
  if (status != QTR_OK) return fault_set(why, "%s: %s", b->s->p.in.path, qtr_strerror(status));
  return check_size(b, why);
}

/* ---- one game ---- */

/* Learn the mission that stands in `alone`. False: some place is out of everybody's reach, or there was no time. */
static bool learn_rest(builder *b, fault *why) {
  study *alone = b->alone;
  plan_config config = *b->config;
  config.aggregate.way = AGGREGATE_NONE;
  config.learner.setting = QTR_SETTING_CERTIFIED;
  if (qtr_rest_game(&alone->p.game, &alone->p.in.mission, &alone->p.travel) != QTR_OK) return false;
  if (study_begin(alone, &config, why) != 0) return false;
  for (int steps = 0; steps < 2000 && study_step(alone) == QTR_LEARNING; steps++) {}
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
  qtr_play_to_routes(qtr_learner_best(learnt->learner), &learnt->p.game, &routes);
  while (qtr_any_start_add(&b->any, &routes, number) != QTR_OK)
    if (enlarge(b, why) != 0) return -1;
  return 0;
}

static int add_rest(builder *b, fault *why) {
  uint16_t number[QTR_MAX_PLACES];
  why->text[0] = '\0';
  qtr_any_start_rest(&b->any, &b->alone->p.in.mission, number);
  if (!learn_rest(b, why)) return why->text[0] != '\0' ? -1 : 0;
  return add(b, b->alone, number, why);
}

/* ---- all games ---- */

/* Once for every crew that is done. */
static void show(const builder *b, double *shown) {
  if (b->any.crews <= *shown || !progress_wanted(b->config->quiet)) return;
  *shown = b->any.crews;
  fprintf(stderr, "\r\033[Kstarts: %.0f of %.0f", *shown, qtr_any_start_count_crews(&b->any));
}

/* The mission's own game is learnt already, and the certificate is that of its routes. */
static int add_all(builder *b, fault *why) {
  double shown = 0.0;
  int status = qtr_any_start_next(&b->any) ? add(b, b->s, NULL, why) : 0;
  while (status == 0 && !stop_asked() && qtr_any_start_next(&b->any)) {
    show(b, &shown);
    status = add_rest(b, why);
  }
  if (shown > 0.0) fprintf(stderr, "\r\033[K");
  return status;
}

static uint32_t write_table(builder *b, uint8_t **bytes, fault *why) {
  qtr_certificate certificate;
  qtr_learner_certificate(b->s->learner, &certificate);
  const qtr_table_content content = qtr_any_start_content(&b->any, &certificate, b->config->learner.seed);
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
  const qtr_mission *mission = &b->s->p.in.mission;
  const study *alone = b->alone;
  qtr_start_trials trials;
  qtr_policy policy;
  if (qtr_policy_open(&policy, bytes, size) != QTR_OK) return;
  qtr_start_trials_begin(&trials, b->config->learner.seed);
  while (!stop_asked() && qtr_start_trials_next(&trials, &policy, mission, &b->alone->p.in.mission))
    if (learn_rest(b, why))
      qtr_start_trials_add(&trials, &policy, &alone->p.game, qtr_learner_best(alone->learner)->score.worth);
  report->trials = trials.count;
  if (trials.count == 0) return;
  report->median_loss = trials.loss[trials.count / 2];
  report->worst_loss = trials.loss[trials.count - 1];
}

/* ---- the whole ---- */

static uint32_t learn(builder *b, uint8_t **bytes, anywhere_report *report, fault *why) {
  uint32_t size = 0;
  if (set_up(b, why) == 0 && add_all(b, why) == 0) {
    report->complete = !stop_asked();
    qtr_any_start_finish(&b->any);
    size = write_table(b, bytes, why);
  }
  report->games = b->any.games;
  report->regions = b->any.regions;
  if (size > 0 && b->any.regions > 0) try_starts(b, *bytes, size, report, why);
  return size;
}

uint32_t anywhere_learn(study *s, const plan_config *config, uint8_t **bytes, anywhere_report *report, fault *why) {
  builder b = {.s = s, .config = config};
  *report = (anywhere_report){0};
  b.alone = study_take(why);
  if (b.alone == NULL) return 0;
  memcpy(&b.alone->p.in.mission, &s->p.in.mission, sizeof b.alone->p.in.mission);
  memcpy(b.alone->p.in.path, s->p.in.path, sizeof b.alone->p.in.path); /* for what may be said of it */
  const uint32_t size = learn(&b, bytes, report, why);
  study_drop(b.alone);
  free(b.blocks.entries);
  free(b.blocks.region);
  free(b.blocks.start);
  free(b.blocks.steps);
  return size;
}

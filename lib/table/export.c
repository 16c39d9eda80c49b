#include "quarter/export.h"

#include <stddef.h>
#include <string.h>

#include "learn/learner.h"
#include "quarter/writer.h"
#include "table/record.h"

/* Sorted by insertion: a game has few choices. */
static void insert_record(uint8_t *records, unsigned count, const uint8_t *record, const qtr_board *board) {
  const qtr_record_shape shape = record_shape_written(board);
  const uint32_t bytes = shape.bytes;
  uint8_t *at = records + count * bytes;
  while (at > records && record_compare(record, at - bytes, &shape) < 0) {
    memcpy(at, at - bytes, bytes);
    at -= bytes;
  }
  memcpy(at, record, bytes);
}

/* The states that the best game meets, each with the choice made there. */
static void collect_records(qtr_learner *learner) {
  const qtr_game *game = learner->game;
  const qtr_play *best = &learner->best;
  qtr_state state;
  qtr_outcome outcome;
  qtr_game_start(game, &state);
  qtr_game_pass(game, &state, &outcome);
  for (unsigned i = 0; i < best->choices; i++) {
    uint8_t record[QTR_RECORD_BYTES];
    qtr_record_write(record, &state.joint, &game->board, best->choice[i]);
    insert_record(learner->records, i, record, &game->board);
    qtr_game_choose(game, &state, best->seeker[i], best->choice[i]);
    qtr_game_pass(game, &state, &outcome);
  }
}

/* The mission's own board and starts, no regions. The certificate is asked anew: what it says belongs to the game that
 * is exported. */
static qtr_table_content content_of(const qtr_learner *learner, qtr_cell *start, qtr_certificate *certificate) {
  const qtr_game *game = learner->game;
  for (unsigned i = 0; i < game->board.starts; i++) start[i] = qtr_game_start_cell(game, i);
  qtr_learner_certificate(learner, certificate);
  const qtr_table_content content = {
      game->mission,         &game->board, game->probability,    start,       NULL, learner->records,
      learner->best.choices, certificate,  learner->config.seed, &game->used, NULL, &game->objective.terms};
  return content;
}

/* Sizes follow from the number of records and not from what they hold: they need not be collected for that. */
uint32_t qtr_export_size(const qtr_learner *learner) {
  qtr_cell start[QTR_MAX_SEEKERS];
  qtr_certificate certificate;
  if (learner->game->by_legs) return 0;
  const qtr_table_content content = content_of(learner, start, &certificate);
  return qtr_table_size(&content);
}

/* The best game alone is exported, whatever else was learnt: robots play in nominal time and meet no other state. */
int32_t qtr_export(qtr_learner *learner, uint8_t *bytes, uint32_t size) {
  qtr_cell start[QTR_MAX_SEEKERS];
  qtr_certificate certificate;
  if (learner->game->by_legs) return QTR_ERR_ARGUMENT;
  collect_records(learner);
  const qtr_table_content content = content_of(learner, start, &certificate);
  return qtr_table_write(&content, bytes, size);
}

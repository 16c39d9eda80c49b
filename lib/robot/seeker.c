#include "quarter/seeker.h"

#include <stddef.h>
#include <string.h>

#include "quarter/nominal.h"
#include "quarter/status.h"

static bool set_has(const qtr_seeker_set *set, unsigned seeker) {
  return (set->word[seeker / 32] >> (seeker % 32)) & 1u;
}

static void set_add(qtr_seeker_set *set, unsigned seeker) {
  set->word[seeker / 32] |= (uint32_t)1 << (seeker % 32);
}

/* Begin the current territory: its seeker's route is played from the start of the game. */
static void enter_territory(qtr_seeker *seeker) {
  seeker->missed = false;
  qtr_joint_start(&seeker->joint, &seeker->policy->board, seeker->deployment.start_of, &seeker->deployment.cleared);
}

/* Leave the current territory for the next one that nobody is known to have finished. */
static bool next_territory(qtr_seeker *seeker) {
  const unsigned seekers = seeker->policy->board.seekers;
  while (++seeker->pass < seekers) {
    seeker->territory = (uint8_t)((seeker->self + seeker->pass) % seekers);
    if (set_has(&seeker->done, seeker->territory)) continue;
    enter_territory(seeker);
    return true;
  }
  return false;
}

static bool in_reach(const qtr_seeker *seeker, uint16_t place) {
  const qtr_board *board = &seeker->policy->board;
  const unsigned start = (unsigned)board->places + seeker->deployment.start_of[seeker->self];
  return qtr_board_steps(board, seeker->self, start, place) != QTR_NEVER;
}

/* The territory's route is at its end. If this robot could not reach all of it, it is not done. */
static void finish_territory(qtr_seeker *seeker) {
  if (seeker->missed) return;
  set_add(&seeker->done, seeker->territory);
  set_add(&seeker->announce, seeker->territory);
}

static void next_target(qtr_seeker *seeker) {
  /* A territory is some seeker's route: as the passes go by, each seeker's once, the own one first. */
  QTR_ASSERT(seeker->territory == (seeker->self + seeker->pass) % seeker->policy->board.seekers);
  for (;;) {
    seeker->target = qtr_policy_play(seeker->policy, &seeker->joint, seeker->territory, NULL, &seeker->off_table);
    if (seeker->target == QTR_STAND_DOWN) {
      finish_territory(seeker);
      if (!next_territory(seeker)) return;
      continue;
    }
    if (qtr_places_has(&seeker->visited, seeker->target)) continue;
    if (in_reach(seeker, seeker->target)) return;
    seeker->missed = true;
  }
}

int qtr_seeker_init_built(qtr_seeker *seeker, const qtr_policy *policy, unsigned self, const qtr_deployment *deployment,
                          uint32_t config_id) {
  if (config_id != QTR_CONFIG_ID) return QTR_ERR_CONFIG;
  if (self >= policy->board.seekers) return QTR_ERR_ARGUMENT;
  memset(seeker, 0, sizeof *seeker);
  seeker->policy = policy;
  seeker->self = (uint8_t)self;
  seeker->territory = (uint8_t)self;
  /* At home by hand: qtr_deployment_init() would bring its search for starts into the flash of robots that have no use for
   * it. */
  memcpy(seeker->deployment.start_of, policy->board.start_of, sizeof seeker->deployment.start_of);
  if (deployment != NULL) seeker->deployment = *deployment;
  enter_territory(seeker);
  next_target(seeker);
  return QTR_OK;
}

uint16_t qtr_seeker_target(const qtr_seeker *seeker) {
  return seeker->target;
}

void qtr_seeker_visited(qtr_seeker *seeker, unsigned place) {
  if (place >= seeker->policy->board.places) return;
  qtr_places_add(&seeker->visited, place);
  if (place == seeker->target) next_target(seeker);
}

void qtr_seeker_hear(qtr_seeker *seeker, int signal, unsigned territory) {
  if (signal == QTR_SIGNAL_FOUND) {
    seeker->target = QTR_STAND_DOWN;
    seeker->pass = seeker->policy->board.seekers;
    return;
  }
  if (signal != QTR_SIGNAL_TERRITORY_DONE || territory >= seeker->policy->board.seekers) return;
  set_add(&seeker->done, territory);
  if (seeker->target == QTR_STAND_DOWN || territory != seeker->territory) return;
  seeker->target = QTR_STAND_DOWN;
  if (next_territory(seeker)) next_target(seeker);
}

bool qtr_seeker_announce(qtr_seeker *seeker, uint8_t *territory) {
  for (unsigned i = 0; i < seeker->policy->board.seekers; i++) {
    if (!set_has(&seeker->announce, i)) continue;
    seeker->announce.word[i / 32] &= ~((uint32_t)1 << (i % 32));
    *territory = (uint8_t)i;
    return true;
  }
  return false;
}

bool qtr_seeker_field(const qtr_seeker *seeker, qtr_field *field) {
  if (seeker->target == QTR_STAND_DOWN) return false;
  return qtr_field_fill(field, &seeker->policy->grid, qtr_policy_cell(seeker->policy, seeker->target)) == QTR_OK;
}

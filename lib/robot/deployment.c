#include "quarter/deployment.h"

#include <stdbool.h>
#include <stddef.h>

#include "core/bytes.h"
#include "core/crc.h"
#include "quarter/status.h"
#include "robot/bits.h"
#include "robot/layout.h"

/* The start that stands for a cell where a seeker may set out: its region's, or on a table without regions the start at
 * that cell; `starts` or more if there is none. */
static unsigned start_at(const qtr_policy *policy, qtr_cell cell) {
  unsigned start = 0;
  if (qtr_grid_cost(&policy->grid, cell) == 0u) {
    return policy->board.starts;
  }
  if (policy->any_start) {
    return qtr_policy_region(policy, cell);
  }
  while ((start < policy->board.starts) && (qtr_policy_cell(policy, policy->board.places + start) != cell)) {
    start++;
  }
  return start;
}

/* Whether a seeker can get to any place from a start: not where its region is cut off, or ground that it may not
 * enter. */
static bool is_of_use(const qtr_policy *policy, unsigned seeker, unsigned start) {
  for (unsigned place = 0; place < policy->board.places; place++) {
    if (qtr_board_steps(&policy->board, seeker, (unsigned)policy->board.places + start, place) != QTR_NEVER) {
      return true;
    }
  }
  return !policy->any_start;
}

/* Where the learner had this seeker start: nodes are the places, and behind them the starts. */
static qtr_cell home_of(const qtr_policy *policy, unsigned seeker) {
  return qtr_policy_cell(policy, (unsigned)policy->board.places + policy->board.start_of[seeker]);
}

/* All where the mission says: then they play from those very cells and not from their regions, so that what they earn
 * is what the table's certificate says. */
static bool are_home(const qtr_policy *policy, const qtr_cell *starts) {
  for (unsigned i = 0; (starts != NULL) && (i < policy->board.seekers); i++) {
    if (starts[i] != home_of(policy, i)) {
      return false;
    }
  }
  return true;
}

void qtr_deployment_home(qtr_deployment *deployment, const qtr_policy *policy) {
  qtr_places_clear(&deployment->cleared);
  bytes_copy(deployment->start_of, policy->board.start_of, (uint32_t)sizeof deployment->start_of);
  if ((policy->features & QTR_FEATURE_CLEARED) == 0) {
    return;
  }
  const uint8_t *cleared = section_of(policy, SECTION_CLEARED);
  for (unsigned place = 0; place < policy->board.places; place++) {
    if ((((unsigned)cleared[place / 8u] >> (place % 8u)) & 1u) != 0u) {
      place_put(&deployment->cleared, place);
    }
  }
}

/* Of the places that there are. */
static void clear(qtr_deployment *deployment, const qtr_policy *policy, const qtr_places *cleared) {
  qtr_places_clear(&deployment->cleared);
  for (unsigned place = 0; place < policy->board.places; place++) {
    if (qtr_places_has(cleared, place)) {
      qtr_places_add(&deployment->cleared, place);
    }
  }
}

/* All starts are looked up before one is set: what is refused has changed nothing. */
int qtr_deployment_init_built(qtr_deployment *deployment, const qtr_policy *policy, const qtr_cell *starts,
                              const qtr_places *cleared, uint32_t config_id) {
  if (config_id != QTR_CONFIG_ID) {
    return QTR_ERR_CONFIG;
  }
  const bool home = are_home(policy, starts);
  for (unsigned i = 0; !home && (i < policy->board.seekers); i++) {
    const unsigned start = start_at(policy, starts[i]);
    if ((start >= policy->board.starts) || !is_of_use(policy, i, start)) {
      return QTR_ERR_START;
    }
  }
  qtr_deployment_home(deployment, policy);
  for (unsigned i = 0; !home && (i < policy->board.seekers); i++) {
    deployment->start_of[i] = (uint16_t)start_at(policy, starts[i]);
  }
  if (cleared != NULL) {
    clear(deployment, policy, cleared);
  }
  return QTR_OK;
}

/* The table's sum goes on over starts and cleared places: whoever has one of them otherwise plays another division, and
 * gets another number but for one case in 2^32. */
uint32_t qtr_deployment_identity(const qtr_deployment *deployment, const qtr_policy *policy) {
  uint32_t crc = qtr_load32(policy->bytes + QTR_POLICY_CRC);
  for (unsigned i = 0; i < policy->board.seekers; i++) {
    crc = qtr_crc32_add_number(crc, (uint32_t)policy->board.places + deployment->start_of[i], 2);
  }
  uint32_t left = bits_size(policy->board.places);
  for (unsigned w = 0; w < QTR_PLACE_WORDS; w++) {
    const uint32_t size = (left < 4u) ? left : 4u;
    crc = qtr_crc32_add_number(crc, deployment->cleared.word[w], size);
    left -= size;
  }
  return crc;
}

#include <stddef.h>

#include "quarter/claim.h"
#include "quarter/status.h"
#include "robot/checks.h"
#include "robot/layout.h"

/* What later features need is 0 without them. In format 1 there were other bytes of 0. */
static bool spare_is_clear(const qtr_policy *policy) {
  const uint8_t *bytes = policy->bytes;
  if (is_format_1(policy->format)) {
    return (bytes[QTR_POLICY_STEP_BYTES] == 0u) && (qtr_load32(bytes + QTR_POLICY_STEP_TIME) == 0u);
  }
  const bool has_terms = (policy->features & QTR_FEATURE_TERMS) != 0;
  for (unsigned at = has_terms ? QTR_POLICY_SPARE : QTR_POLICY_FOUND; at < QTR_POLICY_HEADER_BYTES; at++) {
    if (bytes[at] != 0u) {
      return false;
    }
  }
  return true;
}

/* Words that this version has no meaning for are refused, not taken for the nearest one it knows. Those that a robot
 * plays by are refused on opening already. */
static int check_words(const qtr_policy *policy) {
  const uint8_t *bytes = policy->bytes;
  const bool known = qtr_claim_knows(bytes[QTR_POLICY_OBJECTIVE]) && (bytes[QTR_POLICY_CERTIFIED] <= 1u) &&
                     (bytes[QTR_POLICY_ANY_START] <= 1u) && (bytes[QTR_POLICY_GRID] <= QTR_GRID_BYTES);
  return (known && spare_is_clear(policy)) ? QTR_OK : QTR_ERR_CORRUPT;
}

/* Each a look at one of the mission's places, the first looks first. */
static bool looks_agree(const qtr_policy *policy, unsigned own) {
  const unsigned places = policy->board.places;
  for (unsigned place = 0; place < places; place++) {
    const unsigned at = qtr_policy_place(policy, place);
    if ((at >= own) || ((place < own) && (at != place))) {
      return false;
    }
  }
  return (own < places) == (policy->board.terms.look_of != NULL);
}

/* Words that are 0 or 1 where they are no number. */
static bool classes_agree(const qtr_policy *policy) {
  const uint8_t *of = section_of(policy, SECTION_TERMS) + QTR_TERMS_CLASS;
  for (unsigned i = 0; i < policy->bytes[QTR_POLICY_CLASSES]; i++) {
    if ((qtr_load16(of) == 0u) || (of[2] > 1u) || (of[3] != 0u)) {
      return false;
    }
    of += QTR_TERMS_CLASS_BYTES;
  }
  return policy->bytes[QTR_POLICY_CLASSES] > 0u;
}

static int check_terms(const qtr_policy *policy) {
  if ((policy->features & (unsigned)QTR_FEATURE_TERMS) == 0u) {
    return QTR_OK;
  }
  const unsigned own = (unsigned)qtr_load16(policy->bytes + QTR_POLICY_OWN_PLACES);
  const bool agree = (policy->terms <= 31u) && looks_agree(policy, own) && classes_agree(policy);
  return agree ? QTR_OK : QTR_ERR_CORRUPT;
}

/* The grid lies somewhere, and on its map. */
static int check_place_in_world(const qtr_policy *policy) {
  const uint8_t *bytes = policy->bytes;
  const qtr_frame frame = qtr_policy_frame(policy);
  if (!qtr_frame_is_one(&frame)) {
    return QTR_ERR_CORRUPT;
  }
  if (is_format_1(policy->format)) {
    return QTR_OK;
  }
  const uint32_t right = qtr_load16(bytes + QTR_POLICY_LEFT) + policy->grid.columns;
  const uint32_t bottom = qtr_load16(bytes + QTR_POLICY_TOP) + policy->grid.rows;
  const bool is_on_map =
      (right <= qtr_load16(bytes + QTR_POLICY_MAP_COLUMNS)) && (bottom <= qtr_load16(bytes + QTR_POLICY_MAP_ROWS));
  return is_on_map ? QTR_OK : QTR_ERR_CORRUPT;
}

/* Bytes that mean nothing are 0: what fills up the seats before the cells (format 1), and the bits behind the last
 * cell. */
static int check_padding(const qtr_policy *policy) {
  const uint32_t cells = qtr_grid_cells(&policy->grid);
  if (is_format_1(policy->format) && ((policy->board.seekers % 2u) == 1u) &&
      (qtr_load16(section_of(policy, SECTION_CELLS) - 2u) != 0u)) {
    return QTR_ERR_CORRUPT;
  }
  const unsigned places = policy->board.places;
  if (((policy->features & QTR_FEATURE_CLEARED) != 0) && ((places % 8u) != 0u) &&
      ((section_of(policy, SECTION_CLEARED)[places / 8u] >> (places % 8u)) != 0u)) {
    return QTR_ERR_CORRUPT;
  }
  if ((policy->grid.encoding != QTR_GRID_BITS) || ((cells % 8u) == 0u)) {
    return QTR_OK;
  }
  return ((policy->grid.cells[cells / 8u] >> (cells % 8u)) == 0u) ? QTR_OK : QTR_ERR_CORRUPT;
}

/* Robots drive to free cells. One that is off the grid costs nothing, as a blocked one. */
static int check_free(const qtr_policy *policy) {
  for (unsigned node = 0; node < qtr_board_nodes(&policy->board); node++) {
    if (qtr_grid_cost(&policy->grid, qtr_policy_cell(policy, node)) == 0u) {
      return QTR_ERR_CORRUPT;
    }
  }
  return QTR_OK;
}

/* Likelihoods of sum 1, each rounded, and none below 1. */
static int check_weights(const qtr_policy *policy) {
  const uint64_t one = (uint64_t)1 << 32;
  const unsigned places = policy->board.places;
  uint64_t sum = 0;
  for (unsigned place = 0; place < places; place++) {
    if (qtr_policy_weight(policy, place) == 0u) {
      return QTR_ERR_CORRUPT;
    }
    sum += qtr_policy_weight(policy, place);
  }
  return (((sum + places) >= one) && (sum <= (one + places))) ? QTR_OK : QTR_ERR_CORRUPT;
}

/* Every free cell belongs to a region, whose start lies in it; blocked cells belong to none. */
static int check_regions(const qtr_policy *policy) {
  const uint32_t cells = qtr_grid_cells(&policy->grid);
  for (uint32_t cell = 0; policy->any_start && (cell < cells); cell++) {
    const bool is_free = qtr_grid_cost(&policy->grid, (qtr_cell)cell) > 0u;
    const unsigned region = qtr_policy_region(policy, (qtr_cell)cell);
    if ((region == QTR_POLICY_NO_REGION) == is_free) {
      return QTR_ERR_CORRUPT;
    }
    const qtr_cell start = qtr_policy_cell(policy, policy->board.places + region);
    if (is_free && (qtr_policy_region(policy, start) != region)) {
      return QTR_ERR_CORRUPT;
    }
  }
  return QTR_OK;
}

/* Sorted by key, each key once. */
static int check_records(const qtr_policy *policy) {
  const qtr_record_shape *shape = &policy->records_shape;
  const uint8_t *record = section_of(policy, SECTION_RECORDS);
  for (uint32_t r = 0; r < policy->records; r++, record += shape->bytes) {
    if ((r > 0u) && (record_compare(record, record - shape->bytes, shape) <= 0)) {
      return QTR_ERR_CORRUPT;
    }
    const uint16_t choice = record_choice(record, shape);
    for (unsigned spare = (unsigned)shape->key_bytes + shape->choice_bytes; spare < shape->bytes; spare++) {
      if (record[spare] != 0u) {
        return QTR_ERR_CORRUPT;
      }
    }
    if ((choice >= policy->board.places) && (choice != QTR_STAND_DOWN)) {
      return QTR_ERR_CORRUPT;
    }
  }
  return QTR_OK;
}

/* In this order, for each rests on those before: a region is looked up by its start, which must be a free cell. */
int qtr_check_sections(const qtr_policy *policy) {
  static int (*const checks[])(const qtr_policy *) = {check_words, check_terms,   check_place_in_world, check_padding,
                                                      check_free,  check_weights, check_regions,        check_records};
  int status = QTR_OK;
  for (unsigned i = 0; (i < (sizeof checks / sizeof(checks[0]))) && (status == QTR_OK); i++) {
    status = checks[i](policy);
  }
  return status;
}

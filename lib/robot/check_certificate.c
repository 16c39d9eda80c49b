#include <stdbool.h>

#include "quarter/claim.h"
#include "quarter/status.h"
#include "robot/checks.h"

/* By the bits of its doubles: a robot has no floating point. */

#define DOUBLE_ONE ((int64_t)0x3FF0000000000000)
#define DOUBLE_NORMAL ((int64_t)0x0010000000000000) /* the least that has all its digits */
#define DOUBLE_INFINITE ((int64_t)0x7FF0000000000000)

/* A number that is ordered as the doubles are, with one 0; beyond DOUBLE_INFINITE are those that are none. */
static int64_t rank_of(qtr_double_bits bits) {
  const int64_t magnitude = (int64_t)(bits & 0x7FFFFFFFFFFFFFFFu);
  return ((bits >> 63) != 0u) ? -magnitude : magnitude;
}

static bool is_finite(int64_t rank) {
  return (rank > -DOUBLE_INFINITE) && (rank < DOUBLE_INFINITE);
}

/* Open where, and only where, value and bound differ. Of values so small that they lose digits little is known. */
static bool gap_agrees(int64_t gap, int64_t objective, int64_t bound, bool is_certified) {
  if ((gap < 0) || (gap > DOUBLE_INFINITE) || (is_certified && !is_finite(gap))) {
    return false;
  }
  if (objective < DOUBLE_NORMAL) {
    return true;
  }
  return is_finite(gap) && ((gap == 0) == (objective == bound));
}

static bool is_amount(int64_t rank) {
  return (rank >= 0) && is_finite(rank);
}

/* A probability, but for what adding up may make it too great by. */
static bool is_probability(qtr_double_bits bits) {
  const int64_t rank = rank_of(bits);
  return (rank >= 0) && (rank <= (DOUBLE_ONE + 16));
}

/* Without terms all is found. */
static bool terms_agree(const qtr_claim *claim) {
  return is_probability(claim->found) && is_probability(claim->findable) && (rank_of(claim->findable) > 0) &&
         is_amount(rank_of(claim->home_weight));
}

static bool is_discount(int64_t rank) {
  return (rank > 0) && (rank < DOUBLE_ONE);
}

/* Expected time's bound may lie below 0: stopped early, it may say nothing. */
int qtr_check_certificate(const qtr_policy *policy) {
  qtr_claim claim;
  qtr_claim_read(&claim, policy);
  const int64_t figure = rank_of(claim.figure);
  const int64_t bound = rank_of(claim.bound);
  if (!is_discount(rank_of(claim.gamma)) || !is_amount(rank_of(claim.value)) || !is_finite(bound) ||
      !is_amount(rank_of(claim.expected_time)) || !terms_agree(&claim)) {
    return QTR_ERR_CERTIFICATE;
  }
  if (claim.less_is_better ? (bound > figure) : (bound < figure)) {
    return QTR_ERR_CERTIFICATE;
  }
  const bool agrees = gap_agrees(rank_of(claim.gap), figure, bound, claim.certified);
  return agrees ? QTR_OK : QTR_ERR_CERTIFICATE;
}

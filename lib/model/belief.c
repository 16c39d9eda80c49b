#include "quarter/belief.h"

#include <float.h>
#include <stdbool.h>
#include <stddef.h>
#include <string.h>

#include "core/bytes.h"
#include "core/crc.h"
#include "model/doubles.h"
#include "model/rounding.h"
#include "quarter/status.h"

static const uint8_t magic[4] = {'Q', 'T', 'R', 'B'};

/* ---- over the games ---- */

/* Where targets are is a distribution theta over the places, itself unknown: Dirichlet with parameters prior + found,
 * whose mean is (prior_p + found_p) / sum of both. `strength` is the sum of the priors: so many finds weigh as much. */
static int check_start(unsigned places, double strength, double keep) {
  if (places > QTR_MAX_PLACES) return QTR_ERR_LIMIT;
  if (places == 0 || !(strength > 0.0 && strength <= QTR_BELIEF_MOST)) return QTR_ERR_ARGUMENT;
  return keep > 0.0 && keep <= 1.0 ? QTR_OK : QTR_ERR_ARGUMENT;
}

/* Divided by the greatest, or the sum might be more than a double holds. */
static int divide_prior(qtr_belief *belief, const double *weights, double strength) {
  double greatest = 0.0;
  double sum = 0.0;
  for (unsigned p = 0; p < belief->places; p++) {
    if (!(weights[p] > 0.0 && weights[p] <= DBL_MAX)) return QTR_ERR_WEIGHT;
    if (weights[p] > greatest) greatest = weights[p];
  }
  for (unsigned p = 0; p < belief->places; p++) sum += weights[p] / greatest;
  for (unsigned p = 0; p < belief->places; p++) {
    belief->prior[p] = strength * (weights[p] / greatest / sum);
    if (!(belief->prior[p] >= QTR_BELIEF_LEAST)) return QTR_ERR_WEIGHT;
  }
  return QTR_OK;
}

/* Without weights all places are alike. Either way each prior is above QTR_BELIEF_LEAST: a place that counts for
 * nothing could never be learnt of. */
int qtr_belief_init_sized(qtr_belief *belief, unsigned places, const double *weights, double strength, double keep,
                          uint32_t config_id) {
  if (config_id != QTR_CONFIG_ID) return QTR_ERR_CONFIG;
  const int status = check_start(places, strength, keep);
  if (status != QTR_OK) return status;
  memset(belief, 0, sizeof *belief);
  belief->places = (uint16_t)places;
  belief->keep = keep;
  if (weights != NULL) return divide_prior(belief, weights, strength);
  for (unsigned p = 0; p < places; p++) belief->prior[p] = strength / places;
  return belief->prior[0] >= QTR_BELIEF_LEAST ? QTR_OK : QTR_ERR_ARGUMENT;
}

/* found <- keep found: a find of n games ago counts keep^n, so that a distribution that drifts is followed. */
void qtr_belief_begin_game(qtr_belief *belief) {
  if (belief->games < UINT32_MAX) belief->games++;
  for (unsigned p = 0; p < belief->places; p++) belief->found[p] *= belief->keep;
}

/* Up to where one more still shows: a double holds whole numbers up to 2^53, about 9e15. */
int qtr_belief_found(qtr_belief *belief, unsigned place) {
  if (place >= belief->places) return QTR_ERR_ARGUMENT;
  if (belief->found[place] > QTR_BELIEF_MOST - 1.0) return QTR_ERR_LIMIT;
  belief->found[place] += 1.0;
  return QTR_OK;
}

/* The mean of the Dirichlet distribution: E theta_p = (prior_p + found_p) / sum over q of (prior_q + found_q). */
void qtr_belief_estimate(const qtr_belief *belief, double *estimate) {
  double sum = 0.0;
  for (unsigned p = 0; p < belief->places; p++) sum += belief->prior[p] + belief->found[p];
  /* A Dirichlet distribution's parameters are above 0, or it has no mean. */
  QTR_ASSERT(sum > 0.0);
  for (unsigned p = 0; p < belief->places; p++) estimate[p] = (belief->prior[p] + belief->found[p]) / sum;
}

/* ---- within a game ---- */

/* P(nothing seen | target at p) is the product of 1 - detection over the searches of p: looks fail independently. */
void qtr_search_begin(qtr_search *search, const qtr_belief *belief) {
  search->places = belief->places;
  for (unsigned p = 0; p < search->places; p++) search->missed[p] = 1.0;
}

int qtr_search_empty(qtr_search *search, unsigned place, double detection) {
  if (place >= search->places || !(detection >= 0.0 && detection <= 1.0)) return QTR_ERR_ARGUMENT;
  search->missed[place] *= 1.0 - detection;
  return QTR_OK;
}

/* What a place counts for, its search taken into account. */
static double weight_of(const qtr_search *search, const qtr_belief *belief, unsigned place) {
  return (belief->prior[place] + belief->found[place]) * search->missed[place];
}

/* The sum of it. 0 where a sensor would have had to fail so often that it is as good as never. */
static double weigh(const qtr_search *search, const qtr_belief *belief) {
  double sum = 0.0;
  /* Bayes' rule takes prior and likelihood over the same places. */
  QTR_ASSERT(search->places == belief->places);
  for (unsigned p = 0; p < belief->places; p++) sum += weight_of(search, belief, p);
  return sum < DBL_MIN ? 0.0 : sum;
}

/* P(p | nothing seen) = P(p) P(nothing seen | p) / sum over q of the same (Bayes), and that sum over the sum of P is
 * how likely it was to see nothing. */
double qtr_search_posterior(const qtr_search *search, const qtr_belief *belief, double *posterior) {
  const double seen = weigh(search, belief);
  double all = 0.0;
  for (unsigned p = 0; p < belief->places; p++) {
    all += belief->prior[p] + belief->found[p];
    posterior[p] = seen > 0.0 ? weight_of(search, belief, p) / seen : 0.0;
  }
  return seen / all;
}

/* theta given that nothing was seen is a mixture over p, by the posterior, of Dirichlets with one find more at p. The
 * mean of component p is (alpha + e_p) / (A + 1), so the mixture's is (alpha + posterior) / (A + 1): the posterior
 * counts as one find. */
int qtr_belief_not_found(qtr_belief *belief, const qtr_search *search) {
  const double seen = weigh(search, belief);
  if (!(seen > 0.0)) return QTR_ERR_ARGUMENT;
  for (unsigned p = 0; p < belief->places; p++) {
    belief->found[p] += weight_of(search, belief, p) / seen;
    if (belief->found[p] > QTR_BELIEF_MOST) belief->found[p] = QTR_BELIEF_MOST;
  }
  return QTR_OK;
}

/* ---- as bytes ---- */

int qtr_belief_save(const qtr_belief *belief, void *bytes, uint32_t room) {
  const uint32_t size = QTR_BELIEF_BYTES((uint32_t)belief->places);
  uint8_t *const out = bytes;
  if (room < size) return QTR_ERR_SPACE;
  memset(out, 0, QTR_BELIEF_HEADER_BYTES);
  memcpy(out + QTR_BELIEF_MAGIC, magic, sizeof magic);
  qtr_store16(out + QTR_BELIEF_VERSION, QTR_BELIEF_FORMAT);
  qtr_store16(out + QTR_BELIEF_HEADER, QTR_BELIEF_HEADER_BYTES);
  qtr_store32(out + QTR_BELIEF_SIZE, size);
  qtr_store16(out + QTR_BELIEF_PLACES, belief->places);
  qtr_store32(out + QTR_BELIEF_ABOUT, belief->about);
  qtr_store32(out + QTR_BELIEF_GAMES, belief->games);
  store_double(out + QTR_BELIEF_KEEP, belief->keep);
  uint8_t *at = out + QTR_BELIEF_HEADER_BYTES;
  for (unsigned p = 0; p < belief->places; p++, at += 8) store_double(at, belief->prior[p]);
  for (unsigned p = 0; p < belief->places; p++, at += 8) store_double(at, belief->found[p]);
  qtr_store32(out + QTR_BELIEF_CRC, qtr_crc32_add(0, out + QTR_BELIEF_PLACES, size - QTR_BELIEF_PLACES));
  return (int)size;
}

/* Bytes from outside: size, format and checksum before any number is looked at. */
static int check_frame(const uint8_t *bytes, uint32_t size) {
  if (size < sizeof magic) return QTR_ERR_TRUNCATED;
  if (memcmp(bytes, magic, sizeof magic) != 0) return QTR_ERR_MAGIC;
  if (size < QTR_BELIEF_HEADER_BYTES) return QTR_ERR_TRUNCATED;
  if (qtr_load16(bytes + QTR_BELIEF_VERSION) != QTR_BELIEF_FORMAT) return QTR_ERR_FORMAT;
  if (qtr_load16(bytes + QTR_BELIEF_HEADER) != QTR_BELIEF_HEADER_BYTES) return QTR_ERR_CORRUPT;
  const uint32_t whole = qtr_load32(bytes + QTR_BELIEF_SIZE);
  if (whole > size) return QTR_ERR_TRUNCATED;
  if (whole != size) return QTR_ERR_CORRUPT;
  const uint32_t crc = qtr_crc32_add(0, bytes + QTR_BELIEF_PLACES, size - QTR_BELIEF_PLACES);
  return crc == qtr_load32(bytes + QTR_BELIEF_CRC) ? QTR_OK : QTR_ERR_CHECKSUM;
}

/* Bytes that mean nothing are 0, so that a later version may give them a meaning that this one refuses. */
static int check_header(const uint8_t *bytes, uint32_t size) {
  const uint32_t places = qtr_load16(bytes + QTR_BELIEF_PLACES);
  const double keep = load_double(bytes + QTR_BELIEF_KEEP);
  if (places == 0 || size != QTR_BELIEF_BYTES(places)) return QTR_ERR_CORRUPT;
  if (qtr_load16(bytes + QTR_BELIEF_PLACES + 2) != 0 || qtr_load32(bytes + QTR_BELIEF_GAMES + 4) != 0)
    return QTR_ERR_CORRUPT;
  if (!(keep > 0.0 && keep <= 1.0)) return QTR_ERR_CORRUPT;
  return places > QTR_MAX_PLACES ? QTR_ERR_LIMIT : QTR_OK;
}

/* A prior of 0 would keep a place from ever being learnt of; NaN is within no limits. */
static bool are_within(const uint8_t *bytes, unsigned count, double least) {
  for (unsigned i = 0; i < count; i++) {
    const double value = load_double(bytes + 8u * i);
    if (!(value >= least && value <= QTR_BELIEF_MOST)) return false;
  }
  return true;
}

int qtr_belief_load_sized(qtr_belief *belief, const void *bytes, uint32_t size, uint32_t config_id) {
  const uint8_t *const in = bytes;
  if (config_id != QTR_CONFIG_ID) return QTR_ERR_CONFIG;
  int status = check_frame(in, size);
  if (status == QTR_OK) status = check_header(in, size);
  if (status != QTR_OK) return status;
  const unsigned places = qtr_load16(in + QTR_BELIEF_PLACES);
  const uint8_t *const prior = in + QTR_BELIEF_HEADER_BYTES;
  const uint8_t *const found = prior + 8u * places;
  if (!are_within(prior, places, QTR_BELIEF_LEAST) || !are_within(found, places, 0.0)) return QTR_ERR_CORRUPT;
  memset(belief, 0, sizeof *belief);
  belief->places = (uint16_t)places;
  belief->about = qtr_load32(in + QTR_BELIEF_ABOUT);
  belief->games = qtr_load32(in + QTR_BELIEF_GAMES);
  belief->keep = load_double(in + QTR_BELIEF_KEEP);
  for (unsigned p = 0; p < places; p++) {
    belief->prior[p] = load_double(prior + 8u * p);
    belief->found[p] = load_double(found + 8u * p);
  }
  return QTR_OK;
}

/* The third level (paper, section 6): where targets are, learnt from where they were found.
 *
 * What is known about the places is a Dirichlet distribution: for each place a count of targets found there, on top of
 * a prior that counts as so many finds. Its mean is the estimate, and serves as a mission's weights. Within a game the
 * places found empty shift it by Bayes' rule.
 */
#ifndef QUARTER_BELIEF_H
#define QUARTER_BELIEF_H

#include <stdint.h>

#include "quarter/config.h"

QTR_C_BEGIN

/* The prior of a place at least: below it the estimate could become 0, which is no weight. */
#define QTR_BELIEF_LEAST 1e-100
/* Prior or finds of a place at most: beyond it one more find would be lost in rounding. */
#define QTR_BELIEF_MOST 1e15

typedef struct {
  uint16_t places;              /* 1..QTR_MAX_PLACES */
  uint32_t about;               /* whose places these are: a mark of the caller's, 0 at first; saved and loaded only */
  uint32_t games;               /* begun so far; stays at its greatest */
  double keep;                  /* what a find still counts for after one more game, above 0; 1: nothing is forgotten */
  double prior[QTR_MAX_PLACES]; /* pseudo-finds of each place */
  double found[QTR_MAX_PLACES]; /* finds, faded; parts of a find where a game ended without one */
} qtr_belief;

/* Begin with a prior of `strength` pseudo-finds in all, divided among the places by `weights` (above 0, any unit), or
 * evenly if it is NULL. A great strength holds on to the prior, a small one follows the first finds; half a find a
 * place (strength = places / 2) is Jeffreys' choice. `keep` below 1 follows a hider that changes its ways: finds n
 * games ago count keep^n, and where nothing was found for long the estimate goes back to the prior. QTR_OK;
 * QTR_ERR_LIMIT for more places than the build holds; QTR_ERR_ARGUMENT for no place, a keep out of (0, 1] or a strength
 * out of (0, 1e15]; QTR_ERR_WEIGHT for a weight that is not a finite number above 0, or whose share of the strength is
 * below QTR_BELIEF_LEAST; QTR_ERR_CONFIG if the caller was built under other sizes. */
#define qtr_belief_init(belief, places, weights, strength, keep)                                                       \
  qtr_belief_init_sized(belief, places, weights, strength, keep, QTR_CONFIG_ID)
int qtr_belief_init_sized(qtr_belief *belief, unsigned places, const double *weights, double strength, double keep,
                          uint32_t config_id);

/* A game begins: the finds so far fade by `keep`. */
void qtr_belief_begin_game(qtr_belief *belief);

/* A target was found at a place; a game may have several. QTR_OK; QTR_ERR_ARGUMENT for no such place; QTR_ERR_LIMIT
 * when its count is full, which leaves it as it is. */
int qtr_belief_found(qtr_belief *belief, unsigned place);

/* The mean: of each place (prior + found) / sum of both over all. All above 0, sum 1: weights for a mission. */
void qtr_belief_estimate(const qtr_belief *belief, double *estimate);

/* ---- within a game ---- */

/* What a game has seen so far: of each place the likelihood of having seen nothing there although the target is
 * there. */
typedef struct {
  uint16_t places;
  double missed[QTR_MAX_PLACES];
} qtr_search;

/* Nothing was searched yet, of the belief's places. */
void qtr_search_begin(qtr_search *search, const qtr_belief *belief);

/* A place was searched and nothing was seen, by a sensor that sees a target there with probability `detection`, 0..1;
 * again for each further search. QTR_OK, or QTR_ERR_ARGUMENT for no such place or probability. */
int qtr_search_empty(qtr_search *search, unsigned place, double detection);

/* Where the target is, given what the game has seen (Bayes): estimate * missed, brought to sum 1. Returns how likely it
 * was to see nothing so far. 0: the target is at none of the places, and the posterior is 0 everywhere. */
double qtr_search_posterior(const qtr_search *search, const qtr_belief *belief, double *posterior);

/* The game ended without a find. Its target counts as parts of a find, divided by the posterior: the mean is then
 * exactly that of the true distribution, a mixture of Dirichlets, which is replaced by the one Dirichlet of that mean.
 * QTR_OK, or QTR_ERR_ARGUMENT with nothing changed if the target was at none of the places: such a game tells nothing
 * of where it is. */
int qtr_belief_not_found(qtr_belief *belief, const qtr_search *search);

/* ---- as bytes: little-endian, doubles IEEE 754 ---- */

#define QTR_BELIEF_FORMAT 1 /* raised when the bytes change their meaning; apart from the library's version */

/* Byte offsets. */
enum {
  QTR_BELIEF_MAGIC = 0,        /* "QTRB" */
  QTR_BELIEF_VERSION = 4,      /* u16, QTR_BELIEF_FORMAT */
  QTR_BELIEF_HEADER = 6,       /* u16, bytes of the header */
  QTR_BELIEF_SIZE = 8,         /* u32, bytes in all */
  QTR_BELIEF_CRC = 12,         /* u32, CRC-32 of all that follows */
  QTR_BELIEF_PLACES = 16,      /* u16; then 2 of 0 */
  QTR_BELIEF_ABOUT = 20,       /* u32 */
  QTR_BELIEF_GAMES = 24,       /* u32; then 4 of 0 */
  QTR_BELIEF_KEEP = 32,        /* double */
  QTR_BELIEF_HEADER_BYTES = 40 /* then the prior and after it the finds of every place, doubles */
};

#define QTR_BELIEF_BYTES(places) (QTR_BELIEF_HEADER_BYTES + 16u * (places))

/* Save to `bytes`, which has room for `room`. Returns the size, QTR_BELIEF_BYTES(places), or QTR_ERR_SPACE. */
int qtr_belief_save(const qtr_belief *belief, void *bytes, uint32_t room);

/* Load `size` bytes from anywhere. QTR_OK; or with the belief left as it was QTR_ERR_TRUNCATED, QTR_ERR_MAGIC,
 * QTR_ERR_FORMAT, QTR_ERR_CHECKSUM, QTR_ERR_CORRUPT for a number out of its range or bytes too many, QTR_ERR_LIMIT for
 * more places than the build holds, QTR_ERR_CONFIG if the caller was built under other sizes. */
#define qtr_belief_load(belief, bytes, size) qtr_belief_load_sized(belief, bytes, size, QTR_CONFIG_ID)
int qtr_belief_load_sized(qtr_belief *belief, const void *bytes, uint32_t size, uint32_t config_id);

QTR_C_END

#endif

/* Who visits what in which order: the division of the ground that a table makes of a deployment.
 *
 * It is the nominal game, played once from the start by the table. Every robot plays it by itself and comes to the
 * same. A seeker's places in it, in their order, are its territory.
 */
#ifndef QUARTER_DIVISION_H
#define QUARTER_DIVISION_H

#include <stdbool.h>
#include <stdint.h>

#include "quarter/config.h"
#include "quarter/deployment.h"
#include "quarter/joint.h"
#include "quarter/policy.h"

QTR_C_BEGIN

/* Each place is chosen once. Under the paper's rule seekers follow others where no place is left for them alone: then
 * no more places than seekers are left, and each seeker goes to each of them at most once. */
#define QTR_MAX_MOVES (QTR_MAX_PLACES + (QTR_MAX_SEEKERS * QTR_MAX_SEEKERS))

/* A place's number, in no more bytes than it takes. */
#if QTR_MAX_PLACES <= 256
typedef uint8_t qtr_place_number;
#else
typedef uint16_t qtr_place_number;
#endif

typedef struct {
  uint16_t moves;                        /* so far */
  qtr_place_number place[QTR_MAX_MOVES]; /* in the order in which they are chosen */
  uint8_t seeker[QTR_MAX_MOVES];         /* by whom */
  uint32_t off_table;                    /* choices so far that the table had no record of */
  qtr_joint joint;                       /* the nominal game, as far as it is played */
} qtr_division;

/* Begin with no moves. */
void qtr_division_begin(qtr_division *division, const qtr_policy *policy, const qtr_deployment *deployment);

/* Play one choice more. False, with nothing done: the division is complete. */
bool qtr_division_play(qtr_division *division, const qtr_policy *policy);

QTR_C_END

#endif

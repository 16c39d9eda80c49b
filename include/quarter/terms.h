/* The field's terms, as the joint game knows them: seekers of classes, ready at their time, home before their end, and
 * places that are looked at more than once. All of them optional.
 *
 * Interchangeable are seekers of one kind: of one class, and where each has a home to come back to (QTR_BY_HOME), of
 * one start and one ready time. Two alike robots with different homes are not: a state that one of them cannot finish
 * would pass for one that it can.
 */
#ifndef QUARTER_TERMS_H
#define QUARTER_TERMS_H

#include <stdint.h>

#include "quarter/config.h"

QTR_C_BEGIN

/* Rules, a bit each, as in a table. */
enum {
  QTR_BY_HOME = 1,         /* seekers of other starts or ready times are of other kinds */
  QTR_ANYONE_MAY_LEAVE = 2 /* a seeker may stand down though nobody else can visit what it leaves over */
};

/* Numbers little-endian, as in a table; all must outlive the board. All 0: there are no such terms. */
typedef struct {
  const uint8_t *ready;   /* u32 a seeker: the step from which it is in the game. NULL: all from the first */
  const uint8_t *end;     /* u32 a seeker: the step by which it must be home; all ones: never. NULL: never, for all */
  const uint8_t *home;    /* with `end`: steps from each place to the seeker's start, as wide as the board's, a row of
                             places a seeker; all ones: no way */
  const uint8_t *look_of; /* u16 for each place of the board: the place in whose cell it lies, itself for a first look.
                             NULL: every place is looked at once */
  qtr_steps clock;        /* the greatest step that matters: later moments are alike. 0: what is allowed, and what it is
                             worth, is the same at any time */
  uint8_t rules;          /* QTR_BY_HOME, QTR_ANYONE_MAY_LEAVE */
} qtr_terms;

QTR_C_END

#endif

/* The key of a state of the joint game: the places visited and the sorted (node, remaining) pairs of the seekers as one
 * exact integer. Equal keys are equal states.
 *
 * The integer is in mixed radix, grown digit by digit (docs/policy-format.md), so that a key takes no more words than
 * the states of its game need.
 */
#ifndef QUARTER_KEY_H
#define QUARTER_KEY_H

#include <stdint.h>

#include "quarter/config.h"
#include "quarter/places.h"

QTR_C_BEGIN

/* Words that hold the key of any state of any board of this build: visited places, the clock where there are terms, and
 * a node and a time a seeker. */
#define QTR_KEY_WORDS (QTR_PLACE_WORDS + (QTR_TERMS ? 1 : 0) + (((QTR_MAX_SEEKERS * 48) + 31) / 32))

/* What the numbers in a game's keys range over, and so how long keys are. Fill what qtr_key_measure() does not set,
 * then call it. */
typedef struct {
  uint8_t seekers;   /* 1..QTR_MAX_SEEKERS */
  uint8_t node_bits; /* set by qtr_key_measure(), as the three below and `bits` */
  uint8_t remaining_bits;
  uint8_t clock_bits;
  uint8_t words;                 /* of a key, 1..QTR_KEY_WORDS */
  uint8_t kind[QTR_MAX_SEEKERS]; /* of each seeker: those of one kind are interchangeable, no others */
  uint16_t bits;                 /* of a key */
  uint16_t places;               /* 1..QTR_MAX_PLACES */
  uint16_t nodes;                /* a node of this number or above stands for a seeker that has stood down */
  qtr_steps longest;             /* the greatest time remaining */
  qtr_steps clock; /* the greatest number of the clock; 0: time plays no part, and the key has no bits for it */
} qtr_key_shape;

/* The least significant word first. Words beyond the shape's are not written. */
typedef struct {
  uint32_t word[QTR_KEY_WORDS];
} qtr_key;

/* Derive the size of the keys from the rest, which must be in its ranges. */
void qtr_key_measure(qtr_key_shape *shape);

QTR_C_END

#endif

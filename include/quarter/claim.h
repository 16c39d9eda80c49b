/* What the learner said of a policy when it wrote its table. A robot only checks that it could be true. */
#ifndef QUARTER_CLAIM_H
#define QUARTER_CLAIM_H

#include <stdbool.h>
#include <stdint.h>

#include "quarter/policy.h"

QTR_C_BEGIN

/* The bits of an IEEE 754 double: a robot has no floating point. */
typedef uint64_t qtr_double_bits;

typedef struct {
  uint8_t objective;             /* enum qtr_objective_kind of the learner's side */
  bool less_is_better;           /* of the objective's figure */
  bool certified;                /* the gap is within what was asked for */
  uint8_t version[3];            /* of the library that wrote the table: major, minor, patch */
  uint64_t seed;                 /* of the learner's random choices */
  qtr_double_bits gamma;         /* discount a step */
  qtr_double_bits value;         /* discounted */
  qtr_double_bits expected_time; /* steps */
  qtr_double_bits found;         /* probability of a find, by the deadline where that is the objective */
  qtr_double_bits findable;      /* probability of what can be found at all, by all looks */
  qtr_double_bits home_weight;   /* what a step until a seeker is home counts, as a likelihood */
  qtr_steps deadline;            /* 0: none */
  uint16_t own_places;           /* of the mission: the table's others are later looks at them */
  qtr_double_bits figure;        /* whichever of value, time and found the objective asks for */
  qtr_double_bits bound;         /* of the figure: no policy does better */
  qtr_double_bits gap;           /* between the two, relative */
  uint32_t step_time_us;         /* microseconds a step; 0: not said */
  uint16_t map_columns;          /* of the map that it was learnt on */
  uint16_t map_rows;
  uint16_t left; /* column and row of that map at which the table's grid begins */
  uint16_t top;
  const uint8_t *numbers; /* of the places in the input, 2 bytes each (qtr_claim_number()); NULL: as in the table */
} qtr_claim;

/* Whether a table's objective is one that there is. */
bool qtr_claim_knows(uint8_t objective);

/* The number that the input gave a place; of one that is none, the number itself. */
unsigned qtr_claim_number(const qtr_claim *claim, const qtr_policy *policy, unsigned place);

/* Steps that a class of seekers takes for a cell of cost 1; 0 for a class that is none. */
uint32_t qtr_claim_cell_steps(const qtr_policy *policy, unsigned of_class);

/* The policy is open, or its words have been checked. */
void qtr_claim_read(qtr_claim *claim, const qtr_policy *policy);

QTR_C_END

#endif

/* What a mixture of routes is taken apart by: of two places, that they are on one route, or are not (Ryan and Foster
 * 1981: An integer programming approach to scheduling); of a place, that it is some seekers', or is not. A game does
 * the one or the other. Where a mixture does neither by halves, its routes are a game's.
 */
#ifndef QUARTER_SEARCH_BRANCH_H
#define QUARTER_SEARCH_BRANCH_H

#include <stdbool.h>
#include <stdint.h>

#include "search/triples.h"

/* Places a and b are on one route, or place a is on one of squad b's; or else they are not. */
typedef struct {
  uint16_t a, b;
  bool of_squad, holds;
  bool last;    /* the other side has been looked at */
  double upper; /* on all games, before it */
} qtr_branch;

/* Whether a route is in no game of this side of a branch. */
bool qtr_branch_rules_out(const qtr_branch *branch, const qtr_label *route);

/* The branch that a mixture does most nearly by halves, the side where it holds. False: there is none that it does by
 * more than `least` and less than all but that. */
bool qtr_branch_find(const qtr_mixture *mixture, unsigned places, unsigned squads, double least, qtr_branch *branch);

#endif

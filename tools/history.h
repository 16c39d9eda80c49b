/* The history of past games, a CSV file that names where targets were found.
 *
 * A header, then a row for each place that is told of. The columns, in any order:
 * - the place: `place` (its number, as the tool shows it), or `column,row`, or `x,y` in metres in the map frame;
 * - `found`, optional: 1 (yes, true) if a target was found there, 0 (no, false) if the place was searched and
 *   nothing was seen. Without it every row is a find. A header of `found` alone is one of `place` alone;
 * - `looks`, optional: how many looks at the place the row tells of, 1 without it; only a find's last one found;
 * - `game`, optional: any word; rows of one game stand together. Without it every row is a game of its own.
 * A place may be named by a look at it, as reports do ("Bay 3 (look 2)"). A game without a find is told by the places
 * that were searched. Commas only; spaces around a field, quotes around it,
 * \r\n and a byte order mark are allowed, empty lines and lines that start with # skipped.
 */
#ifndef QUARTER_TOOLS_HISTORY_H
#define QUARTER_TOOLS_HISTORY_H

#include <stdint.h>

#include "host/base/fault.h"
#include "host/input/input.h"
#include "quarter/belief.h"

/* What a history holds. */
typedef struct {
  uint32_t games;
  uint32_t without; /* games without a find */
  uint32_t finds;
  uint32_t found[QTR_MAX_PLACES]; /* finds of each place */
  uint32_t vain[QTR_MAX_PLACES];  /* looks at it that found nothing, in games without a find or before one */
} history_tally;

#define HISTORY_OF_PLACES (-1.0) /* of detection */

/* Read the file `path` and count its games in `belief`, whose places are the input's. `detection` is the probability
 * that a look sees a target which is there, or HISTORY_OF_PLACES: the mission's, place by place.
 * 0, or -1 with *why set; the belief is worthless then. */
int history_read(history_tally *tally, qtr_belief *belief, const input *in, const char *path, double detection,
                 fault *why);

#endif

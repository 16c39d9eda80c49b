/* The joint game of k seekers (paper, section 4.2.2): its state, the choices allowed, a choice made, time advanced.
 *
 * Learner and robot both play by this one module, so that they cannot disagree about a state's successor. A seeker is
 * idle at a node, bound for a place, not yet ready, or stood down for the rest of the game.
 *
 * A choice is allowed that the seeker can end in time: it arrives, scans, and is home by its end, if it has one. Of the
 * looks at one place any free one may be chosen, but alone in the game only the lowest: then nobody else can come
 * between, and the order of looks is that of their worths.
 *
 * Idle seekers choose one after another with no time passing, the one at the lowest node first (on a tie the one of the
 * lower kind, then the lower seeker). The order does not depend on which seeker of a kind is where, so states that
 * differ only by who is who are one state.
 */
#ifndef QUARTER_JOINT_H
#define QUARTER_JOINT_H

#include <stdbool.h>
#include <stdint.h>

#include "quarter/board.h"
#include "quarter/config.h"
#include "quarter/key.h"
#include "quarter/places.h"

QTR_C_BEGIN

#define QTR_NOBODY (-1)

typedef struct {
  uint16_t node[QTR_MAX_SEEKERS];
  qtr_steps remaining[QTR_MAX_SEEKERS]; /* 0 unless bound for node[i], or not yet ready there */
  qtr_places visited;
  qtr_places bound;   /* places that some seeker is bound for */
  uint16_t unvisited; /* how many places are left to visit */
  qtr_steps now;      /* since the first state */
} qtr_joint;

/* The first state: every seeker idle, or not yet ready, at its start of `start_of` (NULL: the board's own), `cleared`
 * (NULL for none) visited. */
void qtr_joint_start(qtr_joint *joint, const qtr_board *board, const uint16_t *start_of, const qtr_places *cleared);

/* The seeker whose turn it is to choose, or QTR_NOBODY: then time advances, or the game is over. Seekers with nothing
 * left to choose have been stood down already. */
int qtr_joint_chooser(const qtr_joint *joint, const qtr_board *board);

/* What `seeker`, whose turn it is, may choose: the places, one or more, and (returned) whether it may stand down. The
 * last seeker that can visit a place left over may not, unless the board says that anyone may: every place that can be
 * is visited in the end. A seeker that is none, or is
 * not idle, may choose nothing: no place, and false. */
bool qtr_joint_choices(const qtr_joint *joint, const qtr_board *board, int seeker, qtr_places *choices);

/* Make an allowed choice. A place at no distance is visited at once. True if it was. Nothing happens, and false, for a
 * seeker that is none or is not idle, or a place that is none, is visited or is out of its reach. */
bool qtr_joint_choose(qtr_joint *joint, const qtr_board *board, int seeker, uint16_t choice);

/* Nobody is to choose: let the least remaining travel time pass. Returns it, and adds to `arrived` (may be NULL) each
 * place now visited for the first time. 0 with nothing changed: the game is over. */
qtr_steps qtr_joint_advance(qtr_joint *joint, const qtr_board *board, qtr_places *arrived);

/* The key of a state, in a shape such as the board's. */
void qtr_joint_key(qtr_key *key, const qtr_joint *joint, const qtr_key_shape *shape);

QTR_C_END

#endif

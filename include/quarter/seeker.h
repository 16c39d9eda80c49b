/* The executor: what one robot does, from the table and its own sensors alone.
 *
 * Every robot plays the whole joint game forward in nominal time from what all know: the table and the deployment
 * (starts, places cleared beforehand). Its own choices in that game are its territory, so nothing that it does depends
 * on another's real progress. When its territory is finished and no termination was heard, it goes on with its
 * neighbours' (seeker i + 1, then i + 2, ... mod k), every second one from its last place backwards, so that two who
 * take over for one that is lost come from both ends. Any survivor thus scans every place that it can reach.
 *
 * A robot announces a territory when it has scanned every place of it itself, and only then: whatever is late, lost,
 * shut, restarted or flashed wrongly, nothing is announced that nobody has scanned.
 *
 *   qtr_seeker_init(&seeker, &policy, self, NULL, run), or qtr_seeker_restore() after a reset;
 *   qtr_seeker_announce() until false, say each; go to qtr_seeker_target(); there: qtr_seeker_visited(), or _found();
 *   where there is no way: qtr_seeker_blocked(); whatever is heard: qtr_seeker_hear().
 *
 * No function of this module may interrupt another one that works on the same seeker: keep a signal that an interrupt
 * receives, and hear it between two calls.
 */
#ifndef QUARTER_SEEKER_H
#define QUARTER_SEEKER_H

#include <stdbool.h>
#include <stdint.h>

#include "quarter/config.h"
#include "quarter/deployment.h"
#include "quarter/division.h"
#include "quarter/field.h"
#include "quarter/places.h"
#include "quarter/policy.h"
#include "quarter/signal.h"

QTR_C_BEGIN

/* One bit for each seeker. */
typedef struct {
  uint32_t word[(QTR_MAX_SEEKERS + 31) / 32];
} qtr_seeker_set;

/* Why a robot stands, or that it does not. */
enum qtr_standing {
  QTR_UNDER_WAY = 0, /* it has a target */
  QTR_STANDS_FOUND = 1,
  QTR_STANDS_DONE = 2,   /* every territory is known to be done */
  QTR_STANDS_BLOCKED = 3 /* what is left it cannot reach, or found blocked twice */
};

/* A handle: read it by the functions below. What is asked for most comes first, where small processors reach it in one
 * instruction. */
typedef struct {
  const qtr_policy *policy;
  uint16_t target;   /* QTR_STAND_DOWN: none */
  uint8_t territory; /* that the target is in */
  uint8_t self;
  bool divided;    /* the division is complete */
  bool settled;    /* target and territory are those of what is known */
  bool last_round; /* only what was blocked before is tried, once more */
  bool found;
  bool found_unsaid;     /* by this robot, and not yet announced */
  qtr_seeker_set done;   /* territories known to be finished */
  qtr_seeker_set unsaid; /* finished here and not yet announced */
  qtr_seeker_set lost;   /* seekers that are known to be lost */
  qtr_places visited;    /* where this robot has been itself, without a find */
  qtr_places blocked;    /* where it found no way; on the last round also all but `retry` */
  qtr_places retry;      /* on the last round: what was blocked before */
  uint32_t identity;
  uint32_t run;
  uint32_t foreign; /* signals heard that are of another search */
  qtr_division division;
  qtr_deployment deployment;
} qtr_seeker;

/* Robot `self` (0..seekers-1) at its start. `deployment` (copied) and `run` are the same on every robot; NULL: the
 * mission's own starts, nothing cleared. `run` tells searches by one table apart, so that a late signal of the last one
 * does not count: 0 where nobody numbers them. The open policy must outlive the seeker. QTR_OK; with nothing written
 * QTR_ERR_ARGUMENT for a robot that is none, QTR_ERR_CONFIG if the caller was built under other sizes. */
#define qtr_seeker_init(seeker, policy, self, deployment, run)                                                         \
  qtr_seeker_init_built(seeker, policy, self, deployment, run, QTR_CONFIG_ID)
int qtr_seeker_init_built(qtr_seeker *seeker, const qtr_policy *policy, unsigned self, const qtr_deployment *deployment,
                          uint32_t run, uint32_t config_id);

/* Work out one choice more of the division; false when all of it is known. The first question below works out what is
 * left: who cannot wait that long calls this in its idle time. A call takes what one choice takes, however long the
 * game is. */
bool qtr_seeker_plan(qtr_seeker *seeker);

/* The place to go to now (where places are looked at more than once: the look, at qtr_policy_place());
 * QTR_STAND_DOWN: stay, there is nothing to do (qtr_seeker_standing() says why). */
uint16_t qtr_seeker_target(qtr_seeker *seeker);

/* Fill `field` with the way to the target, for qtr_field_next() from the cell where the robot is. A place that its cell
 * has no way to, by a table that does not fit its map, is blocked, and the next one is taken. False if there is no
 * target, or, with no place blocked and nothing written, for a cell that is no free one or a caller built under other
 * sizes. */
#define qtr_seeker_field(seeker, field, here) qtr_seeker_field_built(seeker, field, here, QTR_CONFIG_ID)
bool qtr_seeker_field_built(qtr_seeker *seeker, qtr_field *field, qtr_cell here, uint32_t config_id);

/* The robot stands on `place` and has scanned it without a find; any place, the target or one in passing. Where places
 * are looked at more than once each call is a look. A place out of range is ignored. */
void qtr_seeker_visited(qtr_seeker *seeker, unsigned place);

/* There is no way to `place`: a door is shut, a path is blocked. It is left out, and tried once more when all else is
 * done; if it is blocked then too, it stays out, and its territory is not announced. One visited, or out of range, is
 * ignored. */
void qtr_seeker_blocked(qtr_seeker *seeker, unsigned place);

/* The target of the search is found here: the robot stops, and tells the others. */
void qtr_seeker_found(qtr_seeker *seeker);

/* A signal was heard. False if it is of another search (it is counted), or is none: it must not be passed on. */
bool qtr_seeker_hear(qtr_seeker *seeker, const qtr_signal *signal);

/* Seeker `who` is known to be lost, by an operator or a time-out: its territory is taken over right after the own one,
 * before the others'. Only the order changes, so that it does not matter who is told, or whether it is true. */
void qtr_seeker_lost(qtr_seeker *seeker, unsigned who);

/* Take a signal that this robot must send: FOUND, or a territory that it has scanned whole. False if there is none:
 * call until then, after init and after each visit. */
bool qtr_seeker_announce(qtr_seeker *seeker, qtr_signal *signal);

/* The signals that this robot knows of, own and heard, one by one: what to repeat where radios lose messages. False
 * from the first `index` on that there is none. */
bool qtr_seeker_known(const qtr_seeker *seeker, unsigned index, qtr_signal *signal);

/* Whether it stands, and why. */
enum qtr_standing qtr_seeker_standing(qtr_seeker *seeker);

/* Whose territory the target is in; the robot's own where there is no target. */
unsigned qtr_seeker_territory(qtr_seeker *seeker);

/* How many places this robot has not scanned, of territories that are not known to be done; they are put into `left`
 * (may be NULL). */
unsigned qtr_seeker_left(qtr_seeker *seeker, qtr_places *left);

/* Signals heard so far that were of another search: another table, other starts or cleared places, another run. */
uint32_t qtr_seeker_foreign(const qtr_seeker *seeker);

/* ---- after a reset ---- */

/* Bytes of a save at most, under this build's sizes. */
#define QTR_SAVE_BYTES                                                                                                 \
  (20 + (2 * QTR_MAX_SEEKERS) + (3 * ((QTR_MAX_PLACES + 7) / 8)) + (2 * ((QTR_MAX_SEEKERS + 7) / 8)))

/* What must outlast a reset, for memory that does: after each place and each signal. Returns the bytes written, or
 * QTR_ERR_SPACE if `size` is too small. */
int32_t qtr_seeker_save(const qtr_seeker *seeker, uint8_t *bytes, uint32_t size);

/* Go on from a save: as qtr_seeker_init() with the starts, cleared places and run of then, and told again what was
 * known. What this robot has finished it announces once more. QTR_OK; QTR_ERR_SAVE, with nothing written, for bytes
 * that are torn, or of another robot, table or format: then begin anew. A save is of its run: erase it when a new
 * search begins. */
#define qtr_seeker_restore(seeker, policy, self, bytes, size)                                                          \
  qtr_seeker_restore_built(seeker, policy, self, bytes, size, QTR_CONFIG_ID)
int qtr_seeker_restore_built(qtr_seeker *seeker, const qtr_policy *policy, unsigned self, const uint8_t *bytes,
                             uint32_t size, uint32_t config_id);

QTR_C_END

#endif

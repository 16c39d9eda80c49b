/* The only words between robots, and of which search they are.
 *
 * A signal counts for those alone who play the same division: the same table, starts and cleared places (`identity`),
 * in the same run of it. So a robot that was not flashed anew, one that was told other starts, and a packet of
 * yesterday's search are not believed. That keeps mistakes out, not enemies: a radio that strangers reach carries a
 * keyed tag beside these bytes, checked before qtr_seeker_hear() (docs/security.md).
 */
#ifndef QUARTER_SIGNAL_H
#define QUARTER_SIGNAL_H

#include <stdbool.h>
#include <stdint.h>

#include "quarter/config.h"

QTR_C_BEGIN

enum qtr_signal_kind {
  QTR_SIGNAL_FOUND = 1,         /* the target is found: everyone stops */
  QTR_SIGNAL_TERRITORY_DONE = 2 /* every place of a territory has been scanned: nobody need go there any more */
};

typedef struct {
  uint32_t identity; /* of the division: qtr_deployment_identity() */
  uint32_t run;      /* which search by it: the operator's number, the same on every robot */
  uint8_t kind;      /* enum qtr_signal_kind */
  uint8_t territory; /* of TERRITORY_DONE: 0..seekers-1; else 0 */
} qtr_signal;

/* As bytes, for a radio: identity, run (little-endian), kind, territory. A radio's own check sum is relied on. */
#define QTR_SIGNAL_BYTES 10
void qtr_signal_write(const qtr_signal *signal, uint8_t *bytes);
/* False, with nothing written, if that many bytes are no signal. */
bool qtr_signal_read(qtr_signal *signal, const uint8_t *bytes, uint32_t size);

QTR_C_END

#endif

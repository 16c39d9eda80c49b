/* A way to end long work early. The core has no clock: it asks whether to go on, again and again, and the caller
 * decides by a clock, a signal, a button. The place to feed a watchdog, too.
 */
#ifndef QUARTER_WATCH_H
#define QUARTER_WATCH_H

#include <stdbool.h>
#include <stddef.h>

#include "quarter/config.h"

QTR_C_BEGIN

/* Asked after at most some 100,000 operations; only the travel times to one place and the doubling of the Q-table are
 * never broken off. Who says no must go on saying no until the function that was called has returned. What comes of a
 * stop each function says. Asking changes nothing else: a run that is not stopped repeats bit for bit, watched or
 * not. */
typedef struct {
  bool (*go_on)(void *context); /* NULL: never stop */
  void *context;                /* handed to it */
} qtr_watch;

static inline bool qtr_watch_go_on(const qtr_watch *watch) {
  return watch->go_on == NULL || watch->go_on(watch->context);
}

QTR_C_END

#endif

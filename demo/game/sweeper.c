#include "sweeper.h"

#include <string.h>

static int looks_worth(const sweeper *s, unsigned place) {
  int looks = 0;
  for (unsigned look = 0; look < s->whole->board.places; look++) looks += qtr_policy_place(s->whole, look) == place;
  return looks;
}

/* Everywhere again where another look is worth something. */
static void begin_sweep(sweeper *s) {
  s->sweep++;
  qtr_seeker_init(&s->seeker, s->plain, (unsigned)s->self, NULL, s->run);
  for (unsigned place = 0; place < s->plain->board.places; place++)
    if (looks_worth(s, place) < s->sweep) qtr_seeker_visited(&s->seeker, place);
}

static uint16_t target(void *self) {
  sweeper *s = self;
  while (qtr_seeker_target(&s->seeker) == QTR_STAND_DOWN && !s->seeker.found && s->sweep < s->sweeps) {
    if (s->sweep == 1) s->first = s->seeker;
    begin_sweep(s);
  }
  return qtr_seeker_target(&s->seeker);
}

static void visited(void *self, uint16_t place) {
  sweeper *s = self;
  qtr_seeker_visited(&s->seeker, place);
}

static void blocked(void *self, uint16_t place) {
  sweeper *s = self;
  qtr_seeker_blocked(&s->seeker, place);
}

static void found(void *self) {
  sweeper *s = self;
  qtr_seeker_found(&s->seeker);
}

/* Territories are those of the first sweep; a find ends any. */
static bool hear(void *self, const qtr_signal *signal) {
  sweeper *s = self;
  if (s->sweep > 1 && signal->kind != QTR_SIGNAL_FOUND) return qtr_seeker_hear(&s->first, signal);
  return qtr_seeker_hear(&s->seeker, signal);
}

/* What is announced is never taken back: the first sweep's last words may come when the second has begun. */
static bool announce(void *self, qtr_signal *signal) {
  sweeper *s = self;
  if (s->sweep == 1) return qtr_seeker_announce(&s->seeker, signal);
  if (qtr_seeker_announce(&s->first, signal)) return true;
  while (qtr_seeker_announce(&s->seeker, signal))
    if (signal->kind == QTR_SIGNAL_FOUND) return true;
  return false;
}

static bool known(void *self, unsigned index, qtr_signal *signal) {
  const sweeper *s = self;
  return qtr_seeker_known(s->sweep == 1 ? &s->seeker : &s->first, index, signal);
}

void sweeper_init(sweeper *s, const qtr_policy *plain, const qtr_policy *whole, int self, uint32_t run) {
  memset(s, 0, sizeof *s);
  s->plain = plain;
  s->whole = whole;
  s->self = self;
  s->run = run;
  begin_sweep(s);
  for (unsigned place = 0; place < plain->board.places; place++)
    if (looks_worth(s, place) > s->sweeps) s->sweeps = looks_worth(s, place);
}

robot_pilot sweeper_pilot(sweeper *s) {
  return (robot_pilot){s, s->seeker.identity, s->run, target, visited, blocked, found, hear, announce, known};
}

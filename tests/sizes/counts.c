/* Calls of the library by instructions, on QEMU's MPS2 boards under -icount shift=7: the timer goes at 25 MHz and an
 * instruction takes 128 ns, which is 3.2 ticks. Prints a line a measure. */
#include <stdio.h>
#include <string.h>

#include "quarter/robot.h"

extern const uint8_t large[], sixteen[], twenty_six[];
extern const uint32_t large_size, sixteen_size, twenty_six_size;

enum { TIMER_ON = 1, PART = 50 };
#define TIMER ((volatile uint32_t *)0x40000000u) /* its control, its value, its reload */

static uint32_t began, empty;

static void __attribute__((noinline)) begin(void) {
  began = TIMER[1];
}

static uint32_t __attribute__((noinline)) end(void) {
  const uint32_t ticks = began - TIMER[1];
  return (uint32_t)(((uint64_t)ticks * 5 + 8) / 16) - empty;
}

static void start_timer(void) {
  TIMER[2] = 0xFFFFFFFFu;
  TIMER[1] = 0xFFFFFFFFu;
  TIMER[0] = TIMER_ON;
  begin();
  empty = end();
}

/* ---- the worst of each kind ---- */

enum { INIT, PLAN, TARGET, ASKED, VISITED, BLOCKED, HEAR, LOST, ANNOUNCE, KNOWN, STANDING, LEFT, SAVE, RESTORE, KINDS };
static const char *const name[KINDS] = {"init", "plan",     "target", "asked",    "visited", "blocked", "hear",
                                        "lost", "announce", "known",  "standing", "left",    "save",    "restore"};
static uint32_t worst[KINDS];

static void take(unsigned kind, uint32_t count) {
  if (count > worst[kind]) worst[kind] = count;
}

#define COUNT(kind, call) (begin(), (void)(call), take(kind, end()))

/* ---- one robot of a mission, whatever it hears and meets ---- */

static qtr_policy policy;
static qtr_seeker seeker;
static qtr_field field;

static void ask(void) {
  qtr_signal signal;
  COUNT(TARGET, qtr_seeker_target(&seeker));
  COUNT(STANDING, qtr_seeker_standing(&seeker));
  COUNT(LEFT, qtr_seeker_left(&seeker, NULL));
  for (unsigned index = 0; index <= policy.board.seekers; index++)
    COUNT(KNOWN, qtr_seeker_known(&seeker, index, &signal));
  for (bool more = true; more;) {
    begin();
    more = qtr_seeker_announce(&seeker, &signal);
    take(ANNOUNCE, end());
  }
}

static void restart(unsigned self) {
  uint8_t bytes[QTR_SAVE_BYTES];
  static qtr_seeker again;
  begin();
  const int32_t size = qtr_seeker_save(&seeker, bytes, sizeof bytes);
  take(SAVE, end());
  COUNT(RESTORE, qtr_seeker_restore(&again, &policy, self, bytes, (uint32_t)size));
  COUNT(ASKED, qtr_seeker_target(&again));
}

static void begin_game(unsigned self) {
  COUNT(INIT, qtr_seeker_init(&seeker, &policy, self, NULL, 1));
  for (bool more = true; more;) {
    begin();
    more = qtr_seeker_plan(&seeker);
    take(PLAN, end());
  }
}

/* Each place is scanned when its turn comes, but for every `shut`th one, until that is tried again. */
static void play_in_turn(unsigned self, unsigned shut) {
  begin_game(self);
  for (unsigned turn = 1; qtr_seeker_target(&seeker) != QTR_STAND_DOWN; turn++) {
    const unsigned place = qtr_seeker_target(&seeker);
    if (turn % shut == 0)
      COUNT(BLOCKED, qtr_seeker_blocked(&seeker, place));
    else
      COUNT(VISITED, qtr_seeker_visited(&seeker, place));
    ask();
    restart(self);
  }
}

/* Places are scanned in passing, in no order of theirs; a neighbour is lost, and what others finish is heard. */
static void play_in_passing(unsigned self, unsigned stride) {
  begin_game(self);
  const unsigned places = policy.board.places;
  const qtr_signal signal = {.kind = QTR_SIGNAL_TERRITORY_DONE,
                             .territory = (uint8_t)((self + 1) % policy.board.seekers),
                             .identity = seeker.identity,
                             .run = 1};
  for (unsigned turn = 0; turn < places; turn++) {
    if (turn == places / 3) COUNT(LOST, qtr_seeker_lost(&seeker, (self + 2) % policy.board.seekers));
    if (turn == places / 2) COUNT(HEAR, qtr_seeker_hear(&seeker, &signal));
    COUNT(VISITED, qtr_seeker_visited(&seeker, turn * stride % places));
    ask();
  }
}

static void count_mission(void) {
  for (unsigned self = 0; self < policy.board.seekers; self++) {
    play_in_turn(self, 1000);
    play_in_turn(self, 3);
    play_in_passing(self, 1);
    play_in_passing(self, 7);
  }
  for (unsigned kind = 0; kind < KINDS; kind++) printf("%s %lu\n", name[kind], (unsigned long)worst[kind]);
}

/* ---- the way to each place ---- */

static void count_field(qtr_cell target, uint32_t *most_begin, uint32_t *most_part, uint32_t *most_whole) {
  uint32_t count, whole;
  bool more = true;
  begin();
  qtr_field_begin(&field, &policy.grid, target);
  whole = end();
  if (whole > *most_begin) *most_begin = whole;
  while (more) {
    begin();
    more = qtr_field_work(&field, &policy.grid, PART);
    count = end();
    whole += count;
    if (count > *most_part) *most_part = count;
  }
  if (whole > *most_whole) *most_whole = whole;
}

static void count_fields(void) {
  uint32_t most_begin = 0, part = 0, whole = 0;
  for (unsigned place = 0; place < policy.board.places; place++)
    count_field(qtr_policy_cell(&policy, place), &most_begin, &part, &whole);
  printf("field_begin %lu\nfield_part %lu\nfield_whole %lu\n", (unsigned long)most_begin, (unsigned long)part,
         (unsigned long)whole);
}

static void count_opening(const char *what, const uint8_t *bytes, uint32_t size) {
  begin();
  const int status = qtr_policy_open(&policy, bytes, size);
  const uint32_t count = end();
  printf("%s %lu\n%s_bytes %lu\n", what, (unsigned long)count, what, (unsigned long)size);
  if (status != QTR_OK) printf("not opened: %d\n", status);
}

int main(void) {
  start_timer();
  count_opening("open_large", large, large_size);
  count_opening("open_sixteen", sixteen, sixteen_size);
  count_opening("open_twenty_six", twenty_six, twenty_six_size);
  count_mission();
  count_fields();
  return 0;
}

/* A robot's firmware, whole: start, self-test, walk, resume after a reset, terminate. No heap, no floating point; the
 * table is a constant, learnt from a mission while this was built. */
#include <stdio.h>

#include "board.h"

extern const uint8_t patrol[];
extern const uint32_t patrol_size;

enum { MY_NUMBER = 0, RUN = 1 }; /* which robot of the mission; which search, a number that is new for each */

static qtr_policy policy;
static qtr_seeker seeker;
static qtr_field field;

/* Opening checks every number of the table, and plays the whole game once to see that this build plays it as the
 * learner did. */
static bool self_test(void) {
  const int status = qtr_version() == QTR_VERSION ? qtr_policy_open(&policy, patrol, patrol_size) : QTR_ERR_CONFIG;
  printf("self-test: %s\n", qtr_strerror(status));
  return status == QTR_OK;
}

/* After a reset the save says what is done already; where there is none, or it is of another search, we begin. */
static bool start(void) {
  if (!board_is_new() && qtr_seeker_restore(&seeker, &policy, MY_NUMBER, board_memory(), QTR_SAVE_BYTES) == QTR_OK) {
    printf("resumed: %u places left\n", qtr_seeker_left(&seeker, NULL));
    return true;
  }
  return qtr_seeker_init(&seeker, &policy, MY_NUMBER, NULL, RUN) == QTR_OK;
}

static void say_what_is_new(void) {
  qtr_signal signal;
  while (qtr_seeker_announce(&seeker, &signal)) board_send(&signal);
  qtr_seeker_save(&seeker, board_memory(), QTR_SAVE_BYTES);
}

static void hear_what_is_new(void) {
  qtr_signal signal;
  while (board_receive(&signal)) qtr_seeker_hear(&seeker, &signal);
}

/* False: there is no way. What is heard on the way may change the target, or end the search. */
static bool walk_to(uint16_t target) {
  while (qtr_seeker_target(&seeker) == target && board_cell() != qtr_policy_cell(&policy, target)) {
    if (!board_drive(qtr_field_next(&field, &policy.grid, board_cell()))) return false;
    hear_what_is_new();
  }
  return true;
}

static void visit(uint16_t target) {
  if (!walk_to(target)) {
    printf("no way to place %u: later\n", target);
    qtr_seeker_blocked(&seeker, target);
  } else if (qtr_seeker_target(&seeker) != target) {
    printf("place %u is not ours any more\n", target);
  } else if (board_scan()) {
    printf("place %u: found\n", target);
    qtr_seeker_found(&seeker);
  } else {
    printf("place %u: nothing\n", target);
    qtr_seeker_visited(&seeker, target);
  }
}

int main(void) {
  static const char *const why[] = {"under way", "it is found", "all is searched", "what is left cannot be reached"};
  if (!self_test()) return 1;
  board_begin(&policy, MY_NUMBER);
  if (!start()) return 1;
  for (;;) {
    say_what_is_new();
    if (!qtr_seeker_field(&seeker, &field, board_cell())) break;
    visit(qtr_seeker_target(&seeker));
  }
  printf("we stand: %s\n", why[qtr_seeker_standing(&seeker)]);
  /* A robot in the field goes on hearing and repeating what it knows (qtr_seeker_known()) until it is switched off. */
  return qtr_seeker_standing(&seeker) == QTR_STANDS_BLOCKED;
}

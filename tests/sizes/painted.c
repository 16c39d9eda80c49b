/* README.md's robot loop over a painted stack: how deep it went. The robot is alone, and a door is shut once. */
#include <stdio.h>
#include <string.h>

#include "firmware.h"

enum { PAINT = 0xA5, PAINTED = 4096 };

const unsigned my_number = 0;
const uint32_t run_number = 1;
static qtr_policy known;
static qtr_cell here;
static unsigned tries, announced;
static uint8_t memory[QTR_SAVE_BYTES];

void halt(void) {
  for (;;) {}
}

uint8_t *memory_that_lasts(void) {
  return memory;
}

qtr_cell my_cell(void) {
  return here;
}

void broadcast(const qtr_signal *signal) {
  (void)signal;
  announced++;
}

bool receive(qtr_signal *signal) {
  (void)signal;
  return false;
}

bool drive_to(qtr_cell cell) {
  if (++tries == 20) return false;
  here = cell;
  return true;
}

bool scan_finds_it(void) {
  return false;
}

static uint8_t *stack_pointer(void) {
  uint8_t *at;
#ifdef __riscv
  __asm__ volatile("mv %0, sp" : "=r"(at));
#else
  __asm__ volatile("mov %0, sp" : "=r"(at));
#endif
  return at;
}

/* All below this function's own frame is painted, byte by byte: a call of memset() would stand in it. */
static unsigned __attribute__((noinline)) depth_of(void (*run)(void)) {
  uint8_t *const top = stack_pointer();
  volatile uint8_t *at = top - PAINTED;
  while (at < top) *at++ = PAINT;
  run();
  for (at = top - PAINTED; at < top && *at == PAINT;) at++;
  return (unsigned)(top - at);
}

int main(void) {
  if (qtr_policy_open(&known, patrol, patrol_size) != QTR_OK) return 1;
  here = qtr_policy_cell(&known, (unsigned)known.board.places + known.board.start_of[my_number]);
  printf("painted %u\n", depth_of(loop));
  return announced == known.board.seekers ? 0 : 1;
}

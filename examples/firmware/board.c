#include "board.h"

#include <stdio.h>

enum { POWER_FAILS = 15, SHUT_TRIES = 3, OTHER_DONE = 40, OTHER = 1, SHUT_PLACE = 12, TARGET_PLACE = 12 };

/* Kept through a reset: by picolibc's linker script, and by whatever the world is. */
#define PRESERVED __attribute__((section(".preserve")))

static PRESERVED struct {
  uint32_t awake; /* AWAKE once the power has been on */
  uint32_t now;   /* steps */
  uint32_t cell;
  bool has_failed, has_heard;
  unsigned tries; /* at the door */
  uint8_t memory[QTR_SAVE_BYTES];
} world;

#define AWAKE 0x51545242u

static const qtr_policy *map;
static bool is_new;

void board_begin(const qtr_policy *policy, unsigned my_number) {
  map = policy;
  is_new = world.awake != AWAKE;
  if (!is_new) return;
  world.awake = AWAKE;
  world.now = 0;
  world.cell = qtr_policy_cell(policy, (unsigned)policy->board.places + policy->board.start_of[my_number]);
  world.has_failed = world.has_heard = false;
  world.tries = 0;
  for (unsigned i = 0; i < QTR_SAVE_BYTES; i++) world.memory[i] = 0;
}

uint8_t *board_memory(void) {
  return world.memory;
}

bool board_is_new(void) {
  return is_new;
}

qtr_cell board_cell(void) {
  return (qtr_cell)world.cell;
}

/* A true reset: of the RAM only what is preserved stays. */
static void reset(void) {
#if defined(__arm__)
  *(volatile uint32_t *)0xE000ED0Cu = 0x05FA0004u; /* AIRCR: SYSRESETREQ */
#elif defined(__riscv)
  *(volatile uint32_t *)0x00100000u = 0x7777u; /* QEMU virt's test device */
#endif
  for (;;) {}
}

bool board_drive(qtr_cell cell) {
  if (cell == qtr_policy_cell(map, SHUT_PLACE) && world.tries++ < SHUT_TRIES) return false;
  world.now += qtr_grid_cost(&map->grid, cell);
  world.cell = cell;
  if (world.now >= POWER_FAILS && !world.has_failed) {
    world.has_failed = true;
    printf("step %lu: the power fails\n", (unsigned long)world.now);
    reset();
  }
  return true;
}

bool board_scan(void) {
  return world.cell == qtr_policy_cell(map, TARGET_PLACE);
}

void board_send(const qtr_signal *signal) {
  if (signal->kind == QTR_SIGNAL_FOUND)
    printf("step %lu: we say FOUND\n", (unsigned long)world.now);
  else
    printf("step %lu: we say TERRITORY_DONE %u\n", (unsigned long)world.now, signal->territory);
}

bool board_receive(qtr_signal *signal) {
  if (world.now < OTHER_DONE || world.has_heard) return false;
  world.has_heard = true;
  qtr_deployment deployment;
  qtr_deployment_home(&deployment, map);
  *signal = (qtr_signal){qtr_deployment_identity(&deployment, map), 1, QTR_SIGNAL_TERRITORY_DONE, OTHER};
  printf("step %lu: robot %d says that it is done\n", (unsigned long)world.now, OTHER);
  return true;
}

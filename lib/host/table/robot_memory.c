#include "host/table/robot_memory.h"

#include "quarter/grid.h"
#include "quarter/policy.h"

const robot_processor robot_processor_32_bits = {.pointer = 4, .alignment = 8};

/* A structure under way: members are put behind one another, each at a multiple of its alignment. tests/host holds what
 * comes of it against sizeof, under several sizes, and tests/firmware on the boards' own compilers. */
typedef struct {
  const robot_processor *processor;
  uint64_t end;
  unsigned alignment; /* the greatest of its members */
} layout;

static uint64_t rounded_up(uint64_t bytes, unsigned alignment) {
  return (bytes + alignment - 1) / alignment * alignment;
}

static void put_aligned(layout *l, uint64_t bytes, unsigned alignment) {
  l->end = rounded_up(l->end, alignment) + bytes;
  if (alignment > l->alignment) l->alignment = alignment;
}

/* So many numbers of 1, 2, 4 or 8 bytes. */
static void put(layout *l, uint64_t count, unsigned bytes) {
  put_aligned(l, count * bytes, bytes < l->processor->alignment ? bytes : l->processor->alignment);
}

static void put_pointers(layout *l, unsigned count) {
  put(l, count, l->processor->pointer);
}

static layout begin(const robot_processor *processor) {
  return (layout){processor, 0, 1};
}

static uint64_t size_of(const layout *l) {
  return rounded_up(l->end, l->alignment);
}

static void put_struct(layout *l, layout inner) {
  put_aligned(l, size_of(&inner), inner.alignment);
}

/* ---- in the order of the public headers ---- */

static uint64_t words(uint64_t bits) {
  return (bits + 31) / 32;
}

static layout grid_of(const robot_processor *processor) {
  layout l = begin(processor);
  put(&l, 2, 2); /* columns, rows */
  put(&l, 1, 1); /* encoding */
  put_pointers(&l, 1);
  return l;
}

static layout key_shape_of(const robot_sizes *sizes, const robot_processor *processor) {
  layout l = begin(processor);
  put(&l, 5, 1); /* seekers, node_bits, remaining_bits, clock_bits, words */
  put(&l, sizes->of[ROBOT_SEEKERS], 1);
  put(&l, 3, 2); /* bits, places, nodes */
  put(&l, 2, 4); /* longest, clock */
  return l;
}

static layout terms_of(const robot_processor *processor) {
  layout l = begin(processor);
  put_pointers(&l, 4); /* ready, end, home, look_of */
  put(&l, 1, 4);       /* clock */
  put(&l, 1, 1);       /* rules */
  return l;
}

static layout board_of(const robot_sizes *sizes, const robot_processor *processor) {
  layout l = begin(processor);
  put(&l, 2, 2); /* places, starts */
  put(&l, 4, 1); /* seekers, rule, step_bytes, classes */
  put(&l, sizes->of[ROBOT_SEEKERS], 2);
  put(&l, sizes->of[ROBOT_SEEKERS], 1);
  put_pointers(&l, 1);
  put_struct(&l, key_shape_of(sizes, processor));
  put_struct(&l, terms_of(processor));
  return l;
}

static layout record_shape_of(const robot_processor *processor) {
  layout l = begin(processor);
  put(&l, 2, 2); /* bytes, key_bytes */
  put(&l, 1, 1); /* choice_bytes */
  return l;
}

static layout policy_of(const robot_sizes *sizes, const robot_processor *processor) {
  layout l = begin(processor);
  put_pointers(&l, 1);
  put(&l, 1, 4); /* size */
  put(&l, 4, 1); /* format, features, terms, any_start */
  put_struct(&l, record_shape_of(processor));
  put_struct(&l, board_of(sizes, processor));
  put(&l, 1, 4); /* records */
  put(&l, QTR_POLICY_SECTIONS, 4);
  put_struct(&l, grid_of(processor));
  return l;
}

static layout deployment_of(const robot_sizes *sizes, const robot_processor *processor) {
  layout l = begin(processor);
  put(&l, sizes->of[ROBOT_SEEKERS], 2);
  put(&l, words(sizes->of[ROBOT_PLACES]), 4);
  return l;
}

static layout joint_of(const robot_sizes *sizes, const robot_processor *processor) {
  layout l = begin(processor);
  put(&l, sizes->of[ROBOT_SEEKERS], 2);
  put(&l, sizes->of[ROBOT_SEEKERS], 4);
  put(&l, 2 * words(sizes->of[ROBOT_PLACES]), 4);
  put(&l, 1, 2); /* unvisited */
  put(&l, 1, 4); /* now */
  return l;
}

static layout division_of(const robot_sizes *sizes, const robot_processor *processor) {
  const uint64_t seekers = sizes->of[ROBOT_SEEKERS], moves = sizes->of[ROBOT_PLACES] + seekers * seekers;
  layout l = begin(processor);
  put(&l, 1, 2); /* moves */
  put(&l, moves, sizes->of[ROBOT_PLACES] <= 256 ? 1 : 2);
  put(&l, moves, 1);
  put(&l, 1, 4); /* off_table */
  put_struct(&l, joint_of(sizes, processor));
  return l;
}

static layout seeker_of(const robot_sizes *sizes, const robot_processor *processor) {
  layout l = begin(processor);
  put_pointers(&l, 1);
  put(&l, 1, 2);                                   /* target */
  put(&l, 2, 1);                                   /* territory, self */
  put(&l, 5, 1);                                   /* what holds and what does not */
  put(&l, 3 * words(sizes->of[ROBOT_SEEKERS]), 4); /* done, unsaid, lost */
  put(&l, 3 * words(sizes->of[ROBOT_PLACES]), 4);  /* visited, blocked, retry */
  put(&l, 3, 4);                                   /* identity, run, foreign */
  put_struct(&l, division_of(sizes, processor));
  put_struct(&l, deployment_of(sizes, processor));
  return l;
}

static layout field_of(const robot_sizes *sizes, const robot_processor *processor) {
  const unsigned cell = sizes->of[ROBOT_CELLS] <= 65535 ? 2 : 4;
  layout l = begin(processor);
  put(&l, 2, 1);    /* now, direction */
  put(&l, 1, 2);    /* empty */
  put(&l, 2, cell); /* first, at */
  put(&l, 1, 4);    /* cells */
  put(&l, QTR_TRAVEL_RING, cell);
  put(&l, sizes->of[ROBOT_CELLS], sizes->of[ROBOT_CELLS] < 4096 ? 2 : 4);
  return l;
}

robot_memory robot_memory_of(const robot_sizes *sizes, const robot_processor *processor) {
  const layout policy = policy_of(sizes, processor), seeker = seeker_of(sizes, processor);
  const layout field = field_of(sizes, processor);
  robot_memory memory = {.policy = size_of(&policy), .seeker = size_of(&seeker), .field = size_of(&field)};
  memory.all = memory.policy + memory.seeker + memory.field;
  return memory;
}

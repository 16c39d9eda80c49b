#include "search/near.h"

#include <string.h>

#include "quarter/status.h"
#include "robot/bits.h"

void qtr_near_init(qtr_near *near, qtr_memory *bit, const qtr_looks *looks) {
  const size_t targets = looks->count;
  near->targets = looks->count;
  near->looks = looks;
  near->bit = bit;
  memset(near->count, 0, targets * sizeof near->count[0]);
  memset(bit, 0, targets * targets * sizeof *bit);
}

void qtr_near_add(qtr_near *near, unsigned target, unsigned neighbour) {
  const unsigned i = near->count[target];
  /* A walk does not stay where it is: what is remembered is where else it has been, each place by one bit. */
  QTR_ASSERT(i < QTR_NEAR_MOST && target != neighbour && qtr_near_bit(near, target, neighbour) == 0);
  near->near[target][i] = (uint16_t)neighbour;
  near->bit[(size_t)target * near->targets + neighbour] = (qtr_memory)(1u << i);
  near->count[target]++;
}

qtr_memory qtr_near_of(const qtr_near *near, unsigned target, const qtr_places *been, const qtr_places *or_been) {
  qtr_memory memory = 0;
  for (unsigned i = 0; i < near->count[target]; i++)
    if (place_is_in(been, near->near[target][i]) || place_is_in(or_been, near->near[target][i]))
      memory |= (qtr_memory)(1u << i);
  return memory;
}

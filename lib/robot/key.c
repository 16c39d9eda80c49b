#include "quarter/key.h"

#include "quarter/status.h"

/* That numbers of 0 up to this one take. */
static uint8_t bits_of(uint32_t greatest) {
  uint8_t bits = 0;
  for (; greatest > 0u; greatest >>= 1) {
    bits++;
  }
  return bits;
}

/* Without a clock there are no bits for it, and keys are as long as if there were no such thing. */
void qtr_key_measure(qtr_key_shape *shape) {
  QTR_ASSERT(shape->places > 0u); /* no game is without places, and no key without words */
  shape->node_bits = bits_of(shape->nodes);
  shape->remaining_bits = bits_of(shape->longest);
  shape->clock_bits = QTR_TERMS ? bits_of(shape->clock) : 0u;
  shape->bits = (uint16_t)(shape->places + shape->clock_bits +
                           (shape->seekers * ((unsigned)shape->node_bits + shape->remaining_bits)));
  shape->words = (uint8_t)((shape->bits + 31u) / 32u);
}

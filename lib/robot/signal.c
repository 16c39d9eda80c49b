#include "quarter/signal.h"

#include "core/bytes.h"

/* Byte by byte: robots of other makes read the same. */
void qtr_signal_write(const qtr_signal *signal, uint8_t *bytes) {
  qtr_store32(bytes, signal->identity);
  qtr_store32(bytes + 4u, signal->run);
  bytes[8] = signal->kind;
  bytes[9] = signal->territory;
}

/* Bytes of another length or kind are a later version's, or no signal: nothing is guessed of them. Whose territory it
 * is the seeker checks, who knows how many there are. */
bool qtr_signal_read(qtr_signal *signal, const uint8_t *bytes, uint32_t size) {
  if (size != QTR_SIGNAL_BYTES) {
    return false;
  }
  if ((bytes[8] != QTR_SIGNAL_FOUND) && (bytes[8] != QTR_SIGNAL_TERRITORY_DONE)) {
    return false;
  }
  signal->identity = qtr_load32(bytes);
  signal->run = qtr_load32(bytes + 4u);
  signal->kind = bytes[8];
  signal->territory = bytes[9];
  return true;
}

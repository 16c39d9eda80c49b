/* An application and the library that a framework's build made of our manifest: built under one set of sizes, a
 * robot's. */
#include <quarter/robot.h>
#include <stdio.h>

static qtr_policy policy;
static qtr_field field;

int main(void) {
  static const uint8_t no_table[4] = {'Q', 'T', 'R', 'P'};
  const int status = qtr_policy_open(&policy, no_table, sizeof no_table);
  printf("%u cells, %u bytes of a field: %s\n", (unsigned)QTR_MAX_CELLS, (unsigned)sizeof field, qtr_strerror(status));
  return status == QTR_ERR_TRUNCATED && QTR_MAX_CELLS == 1024 && QTR_MAX_PLACES == 16 ? 0 : 1;
}

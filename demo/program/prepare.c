#include "prepare.h"

#include "host/base/stop.h"
#include "outputs.h"

int prepare(plan *p, const settings *s, fault *why) {
  if (outputs_check(s, why) != 0) return EXIT_BAD_INPUT;
  stop_begin();
  if (plan_read(s->mission, s->robots, why) == 0 && outputs_spare_read(s, why) == 0 &&
      plan_make(p, s->table, s->learn_limit, s->save, why) == 0)
    return 0;
  return why->status == EXIT_STOPPED ? 128 + stop_signal() : EXIT_BAD_INPUT;
}

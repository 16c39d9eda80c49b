/* README.md's robot loop, word for word, with nothing around it. */
#include "firmware.h"

#ifdef WITHOUT_RESTART
#undef qtr_seeker_restore
#define qtr_seeker_restore(seeker, policy, self, bytes, size) QTR_ERR_SAVE
#define qtr_seeker_save(seeker, bytes, size) ((void)(bytes))
#define qtr_seeker_blocked(seeker, place) ((void)(place))
#define qtr_seeker_lost(seeker, who) ((void)(seeker))
#endif

void loop(void) {
#include "readme_loop.inc"
  qtr_seeker_lost(&seeker, my_number);
}

/* README.md's robot loop, word for word, with nothing around it. */
#include "quarter/robot.h"

void halt(void);
uint8_t *memory_that_lasts(void);
qtr_cell my_cell(void);
void broadcast(const qtr_signal *signal);
bool receive(qtr_signal *signal);
bool drive_to(qtr_cell cell);
bool scan_finds_it(void);
void loop(void);

extern const unsigned my_number;
extern const uint32_t run_number, patrol_size;
extern const uint8_t patrol[];

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

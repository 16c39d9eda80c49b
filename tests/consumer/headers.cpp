// The headers in C++: what is declared by their macros there.
extern "C" {
#include <quarter/learn.h>
}

static qtr_learner_memory memory;

qtr_learner_blocks blocks_of_any_mission() {
  const qtr_learner_blocks blocks = QTR_LEARNER_BLOCKS(memory);
  return blocks;
}

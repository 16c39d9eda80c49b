// The headers in C++: what is declared by their macros there, and that it links.
#include <quarter/learn.h>

static qtr_learner_memory memory;

qtr_learner_blocks blocks_of_any_mission() {
  const qtr_learner_blocks blocks = QTR_LEARNER_BLOCKS(memory);
  return blocks;
}

int main() {
  return qtr_version() == QTR_VERSION ? 0 : 1;
}

/* A host program that links the learner. */
#include <quarter/learn.h>

int main(void) {
  static qtr_mission mission;
  qtr_mission_default(&mission);
  return qtr_mission_check(&mission, 0) == QTR_OK ? 1 : 0; /* an empty mission is refused */
}

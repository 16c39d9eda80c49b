/* A robot's firmware in small: links the robot side alone. */
#include <quarter/robot.h>

#ifdef HAS_POLICY
extern const uint8_t corridor[];
extern const uint32_t corridor_size;
#endif

/* Fails if the library was built under other sizes than the target tells those who link it. */
static int way_is_found(void) {
  static const uint8_t cells[1] = {0x3}; /* two free cells side by side */
  static qtr_field field;
  const qtr_grid grid = {2, 1, QTR_GRID_BITS, cells};
  return qtr_field_fill(&field, &grid, 1) == QTR_OK && qtr_field_next(&field, &grid, 0) == 1;
}

static int policy_opens(void) {
#ifdef HAS_POLICY
  static qtr_policy policy;
  return qtr_policy_open(&policy, corridor, corridor_size) == QTR_OK && policy.board.places == 2;
#else
  return 1;
#endif
}

int main(void) {
  return way_is_found() && policy_opens() && qtr_strerror(QTR_ERR_CONFIG)[0] != '\0' ? 0 : 1;
}

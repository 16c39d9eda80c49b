/* A robot's firmware in small: links the robot side alone. */
#include <quarter/robot.h>

int main(void) {
  static const uint8_t cells[1] = {0x3}; /* two free cells side by side */
  static qtr_field field;
  const qtr_grid grid = {2, 1, QTR_GRID_BITS, cells};
  qtr_field_fill(&field, &grid, 1);
  return qtr_field_next(&field, &grid, 0) == 1 && qtr_strerror(QTR_ERR_CONFIG)[0] != '\0' ? 0 : 1;
}

/* Where text and squares find room: each takes the first of its positions that nothing drawn before stands on. */
#include <math.h>

#include "draw_parts.h"

static double overlap(const draw_box *a, const draw_box *b) {
  const double wide = fmin(a->x + a->width, b->x + b->width) - fmax(a->x, b->x);
  const double high = fmin(a->y + a->height, b->y + b->height) - fmax(a->y, b->y);
  return wide > 0 && high > 0 ? wide * high : 0;
}

/* How much of a box stands on others, or off the map. */
static double clash(const draw_page *page, const draw_box *box) {
  const draw_box map = {page->x, page->y, page->width, page->height};
  double sum = box->width * box->height - overlap(box, &map);
  for (int i = 0; i < page->boxes; i++) sum += overlap(box, &page->box[i]);
  return sum;
}

void draw_take(draw_page *page, const draw_box *box) {
  if (page->boxes < DRAW_BOXES) page->box[page->boxes++] = *box;
}

/* A box in one of eight directions from a point, `away` from it: those that lie above a line first. */
static draw_box beside(draw_point point, double away, int direction, double width, double height) {
  static const double across[] = {0.7, -0.7, 0.7, -0.7, 0, 0, 1, -1}, down[] = {-0.7, -0.7, 0.7, 0.7, -1, 1, 0, 0};
  const double right = across[direction] < 0 ? 1 : across[direction] > 0 ? 0 : 0.5; /* of the box, left of the point */
  const double low = down[direction] < 0 ? 1 : down[direction] > 0 ? 0 : 0.5;       /* and above it */
  return (draw_box){point.x + across[direction] * away - right * width, point.y + down[direction] * away - low * height,
                    width, height};
}

bool draw_find_room(const draw_page *page, draw_point point, double nearest, double width, double height,
                    draw_box *found) {
  double least = HUGE_VAL;
  for (int ring = 0; ring < 4 && least > 0; ring++) {
    for (int direction = 0; direction < 8 && least > 0; direction++) {
      const draw_box box = beside(point, nearest + 5 * ring, direction, width, height);
      const double sum = clash(page, &box);
      if (sum >= least - 1e-9) continue;
      least = sum;
      *found = box;
    }
  }
  return least < 1e-9;
}

bool draw_is_clear(const draw_page *page, const draw_box *box) {
  return clash(page, box) < 1e-9;
}

/* profiles: host mcu */
/* Steps of a bundle: the nearest point that the cuts allow, and with them the least of a convex function. */
#include <math.h>
#include <string.h>

#include "search/bundle.h"
#include "support/random.h"
#include "unity.h"

#define SIZE_MOST 5u
#define PLANES_MOST 12u

static qtr_bundle bundle;

void setUp(void) {
}

void tearDown(void) {
}

/* The greatest of a few planes: convex, and with slopes that add up to nothing it has a least value. */
typedef struct {
  unsigned size, planes;
  double value[PLANES_MOST];
  int16_t slope[PLANES_MOST][QTR_MAX_PLACES];
} hull;

static void hull_random(hull *h, test_random *random) {
  memset(h, 0, sizeof *h);
  h->size = random_in(random, 1, QTR_MAX_PLACES < SIZE_MOST ? QTR_MAX_PLACES : SIZE_MOST);
  h->planes = random_in(random, 2, PLANES_MOST);
  for (unsigned p = 0; p + 1 < h->planes; p++) {
    h->value[p] = 10.0 * random_unit(random);
    for (unsigned k = 0; k < h->size; k++) {
      h->slope[p][k] = (int16_t)(random_in(random, 0, 8) - 4);
      h->slope[h->planes - 1][k] = (int16_t)(h->slope[h->planes - 1][k] - h->slope[p][k]);
    }
  }
}

static double height(const hull *h, unsigned plane, const double *x) {
  double sum = h->value[plane];
  for (unsigned k = 0; k < h->size; k++) sum += (double)h->slope[plane][k] * x[k];
  return sum;
}

static unsigned highest(const hull *h, const double *x) {
  unsigned best = 0;
  for (unsigned p = 1; p < h->planes; p++)
    if (height(h, p, x) > height(h, best, x)) best = p;
  return best;
}

static void add_plane(const hull *h, unsigned plane, const double *center) {
  qtr_bundle_add(&bundle, height(h, plane, center), h->slope[plane]);
}

static void test_one_cut_gives_polyaks_step(void) {
  const int16_t slope[QTR_MAX_PLACES] = {3, -4};
  double step[QTR_MAX_PLACES];
  qtr_bundle_init(&bundle, 2);
  qtr_bundle_add(&bundle, 7.0, slope);
  TEST_ASSERT_TRUE(qtr_bundle_step(&bundle, 2.0, 1e-12, step));
  /* (value - level) / |slope|^2 against the slope */
  TEST_ASSERT_TRUE(fabs(step[0] + 5.0 / 25.0 * 3.0) < 1e-9);
  TEST_ASSERT_TRUE(fabs(step[1] - 5.0 / 25.0 * 4.0) < 1e-9);
}

static void test_a_level_that_all_cuts_are_below_asks_for_no_step(void) {
  const int16_t slope[QTR_MAX_PLACES] = {1};
  double step[QTR_MAX_PLACES];
  qtr_bundle_init(&bundle, 1);
  qtr_bundle_add(&bundle, 1.0, slope);
  TEST_ASSERT_TRUE(qtr_bundle_step(&bundle, 2.0, 1e-12, step));
  TEST_ASSERT_TRUE(step[0] == 0.0);
}

static void test_a_level_below_what_two_cuts_allow_is_refused(void) {
  const int16_t up[QTR_MAX_PLACES] = {1};
  const int16_t down[QTR_MAX_PLACES] = {-1};
  double step[QTR_MAX_PLACES];
  qtr_bundle_init(&bundle, 1);
  qtr_bundle_add(&bundle, 1.0, up);
  qtr_bundle_add(&bundle, 1.0, down);
  TEST_ASSERT_FALSE(qtr_bundle_step(&bundle, 0.5, 1e-3, step));
}

static double square_of(const hull *h, const double *x) {
  double sum = 0.0;
  for (unsigned k = 0; k < h->size; k++) sum += x[k] * x[k];
  return sum;
}

/* No nearer point of many around the step is below the level. */
static void expect_none_nearer(const hull *h, test_random *random, const double *step, double level) {
  for (unsigned n = 0; n < 200; n++) {
    double other[QTR_MAX_PLACES];
    for (unsigned k = 0; k < h->size; k++) other[k] = step[k] + (random_unit(random) - 0.5) * (n % 2 == 0 ? 0.1 : 2.0);
    const bool is_nearer = square_of(h, other) < square_of(h, step) - 1e-3;
    TEST_ASSERT_TRUE_MESSAGE(!is_nearer || height(h, highest(h, other), other) > level, case_note);
  }
}

static void test_a_step_is_the_shortest_to_the_level(void) {
  unsigned stepped = 0;
  for (unsigned number = 0; number < 600; number++) {
    test_random random = random_case("hulls", number);
    hull h;
    double center[QTR_MAX_PLACES] = {0.0}, step[QTR_MAX_PLACES];
    hull_random(&h, &random);
    if (h.planes > h.size + 1) continue; /* as many cuts as coordinates are kept */
    qtr_bundle_init(&bundle, h.size);
    for (unsigned p = 0; p < h.planes; p++) add_plane(&h, p, center);
    const double level = height(&h, highest(&h, center), center) - random_unit(&random);
    if (!qtr_bundle_step(&bundle, level, 1e-6, step)) continue;
    stepped++;
    TEST_ASSERT_TRUE_MESSAGE(height(&h, highest(&h, step), step) <= level + 1e-5, case_note);
    expect_none_nearer(&h, &random, step, level);
  }
  TEST_ASSERT_GREATER_THAN(50, stepped);
}

/* Steps half the way to a goal that is the least value itself come near to it, whatever cuts had to
 * make room for others. */
static void test_steps_lead_to_the_least_value(void) {
  for (unsigned number = 0; number < 100; number++) {
    test_random random = random_case("least values", number);
    hull h;
    double center[QTR_MAX_PLACES] = {0.0}, step[QTR_MAX_PLACES];
    hull_random(&h, &random);
    /* Each plane goes through one height at a point drawn; their slopes add up to nothing, so nowhere is less. */
    for (unsigned p = 0; p < h.planes; p++) {
      h.value[p] = 1.0;
      for (unsigned k = 0; k < h.size; k++) h.value[p] -= (double)h.slope[p][k] * (double)(k + 1);
    }
    qtr_bundle_init(&bundle, h.size);
    double best = height(&h, highest(&h, center), center);
    add_plane(&h, highest(&h, center), center);
    for (unsigned n = 0; n < 300 && best > 1.0 + 1e-6; n++) {
      double trial[QTR_MAX_PLACES];
      qtr_bundle_step(&bundle, 0.5 * (best + 1.0), 1e-3 * (best - 1.0), step);
      for (unsigned k = 0; k < h.size; k++) trial[k] = center[k] + step[k];
      const unsigned top = highest(&h, trial);
      add_plane(&h, top, center);
      if (height(&h, top, trial) >= best) continue;
      best = height(&h, top, trial);
      memcpy(center, trial, sizeof center);
      qtr_bundle_move(&bundle, step);
    }
    TEST_ASSERT_TRUE_MESSAGE(best < 1.0 + 1e-2 && best >= 1.0 - 1e-9, case_note);
  }
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_one_cut_gives_polyaks_step);
  RUN_TEST(test_a_level_that_all_cuts_are_below_asks_for_no_step);
  RUN_TEST(test_a_level_below_what_two_cuts_allow_is_refused);
  RUN_TEST(test_a_step_is_the_shortest_to_the_level);
  RUN_TEST(test_steps_lead_to_the_least_value);
  return UNITY_END();
}

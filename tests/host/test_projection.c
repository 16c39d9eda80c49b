/* Degrees against geodesics of geographiclib 2.0 (Karney), a library that shares nothing with PROJ's projections. */
#include "host/geo/projection.h"

#include <string.h>

#include "host/base/library.h"
#include "unity.h"

static fault why;

void setUp(void) {
}

void tearDown(void) {
}

typedef struct {
  double latitude, longitude; /* of the origin */
  double east, north;
  double there_latitude, there_longitude;
} known;

static const known cases[] = {
    {52.5163, 13.3777, 1000, 0, 52.516299083298, 13.392430769467},
    {52.5163, 13.3777, -300, 400, 52.519894545039, 13.373280408431},
    {-33.8568, 151.2153, 12000, -5000, -33.901809180789, 151.345042445816},
    {0.0000, 179.9999, 100, 0, 0.000000000000, -179.999201684716},
    {90.0000, 0.0000, 30, -40, 89.999552348298, 36.869897645844},
};

static qtr_geo origin_of(const known *k) {
  return (qtr_geo){true, (int64_t)(k->latitude * 1e9 + (k->latitude < 0 ? -0.5 : 0.5)),
                   (int64_t)(k->longitude * 1e9 + 0.5), 0};
}

static projection *open_at(const known *k) {
  const qtr_geo origin = origin_of(k);
  projection *p = projection_open(&origin, &why);
#ifndef QUARTER_PROJ
  TEST_ASSERT_NULL(p);
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(why.text, "libproj-dev"), why.text);
  TEST_IGNORE_MESSAGE("PROJ was not there when Quarter was built (libproj-dev)");
#endif
  TEST_ASSERT_NOT_NULL_MESSAGE(p, why.text);
  return p;
}

static void test_degrees_are_those_of_geodesics(void) {
  for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
    double latitude, longitude;
    projection *p = open_at(&cases[i]);
    TEST_ASSERT_EQUAL_INT(0, projection_to_degrees(p, cases[i].east, cases[i].north, &latitude, &longitude));
    TEST_ASSERT_DOUBLE_WITHIN(1e-9, cases[i].there_latitude, latitude);
    TEST_ASSERT_DOUBLE_WITHIN(1e-9, cases[i].there_longitude, longitude);
    projection_close(p);
  }
}

static void test_metres_come_back(void) {
  for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
    double east, north;
    projection *p = open_at(&cases[i]);
    TEST_ASSERT_EQUAL_INT(0, projection_to_metres(p, cases[i].there_latitude, cases[i].there_longitude, &east, &north));
    TEST_ASSERT_DOUBLE_WITHIN(1e-3, cases[i].east, east);
    TEST_ASSERT_DOUBLE_WITHIN(1e-3, cases[i].north, north);
    projection_close(p);
  }
}

static void test_what_is_not_there_is_said_with_what_to_install(void) {
  int (*nothing)(void) = NULL;
  const library_function some[] = {{"quarter_is_not_here", &nothing}, {NULL, NULL}};
  TEST_ASSERT_EQUAL_INT(-1, library_load("libquarter_nowhere.so.9", some, "this takes that (package x)", &why));
  TEST_ASSERT_EQUAL_STRING("this takes that (package x), and libquarter_nowhere.so.9 is not on this machine", why.text);
  TEST_ASSERT_EQUAL_INT(-1, library_load("libm.so.6", some, "this takes that (package x)", &why));
  TEST_ASSERT_EQUAL_STRING("this takes that (package x), and libm.so.6 has no quarter_is_not_here", why.text);
  TEST_ASSERT_NULL(nothing);
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_degrees_are_those_of_geodesics);
  RUN_TEST(test_metres_come_back);
  RUN_TEST(test_what_is_not_there_is_said_with_what_to_install);
  return UNITY_END();
}

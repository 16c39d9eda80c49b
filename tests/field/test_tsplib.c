/* TSPLIB files: each kind of distance by hand, each shape of a matrix, and what is wrong with a file in one line. */
#include <stdio.h>
#include <string.h>

#include "field/tsplib.h"
#include "unity.h"

static tsplib instance;
static fault why;

void setUp(void) {
  why.text[0] = '\0';
}

void tearDown(void) {
  tsplib_free(&instance);
}

static void write_file(const char *text) {
  FILE *file = fopen("x.tsp", "w");
  TEST_ASSERT_NOT_NULL(file);
  TEST_ASSERT_TRUE(fputs(text, file) >= 0);
  TEST_ASSERT_EQUAL_INT(0, fclose(file));
}

static void read_text(const char *text) {
  write_file(text);
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, tsplib_read(&instance, "x.tsp", &why), why.text);
}

static unsigned distance(unsigned from, unsigned to) {
  return instance.distance[(from - 1) * instance.towns + to - 1];
}

#define HEAD "NAME: x\nTYPE: TSP\nCOMMENT: a: b\nDIMENSION: 3\n"

/* ---- distances ---- */

/* Towns at (0,0), (3,4) and (1,1): 5, sqrt 2 = 1.41 and sqrt 13 = 3.61. */
static void test_euclidean_distances_are_rounded_to_the_nearest(void) {
  read_text(HEAD "EDGE_WEIGHT_TYPE: EUC_2D\nNODE_COORD_SECTION\n1 0 0\n2 3.0 4.0\n3 1e0 1\nEOF\n");
  TEST_ASSERT_EQUAL_STRING("x", instance.name);
  TEST_ASSERT_EQUAL_UINT(3, instance.towns);
  TEST_ASSERT_EQUAL_UINT(5, distance(1, 2));
  TEST_ASSERT_EQUAL_UINT(1, distance(1, 3));
  TEST_ASSERT_EQUAL_UINT(4, distance(2, 3));
  TEST_ASSERT_EQUAL_UINT(4, distance(3, 2));
  TEST_ASSERT_EQUAL_UINT(0, distance(2, 2));
}

static void test_ceiled_distances_are_rounded_up(void) {
  read_text(HEAD "EDGE_WEIGHT_TYPE : CEIL_2D\nNODE_COORD_SECTION\n3 1 1\n1 0 0\n2 3 4\n");
  TEST_ASSERT_EQUAL_UINT(5, distance(1, 2));
  TEST_ASSERT_EQUAL_UINT(2, distance(1, 3));
  TEST_ASSERT_EQUAL_UINT(4, distance(2, 3));
}

/* sqrt(100 / 10) = 3.16 is rounded to 3, which is less: 4. sqrt(1000 / 10) = 10. sqrt(200 / 10) = 4.47: 5. */
static void test_pseudo_euclidean_distances_are_never_less_than_they_are(void) {
  read_text(HEAD "EDGE_WEIGHT_TYPE: ATT\nNODE_COORD_SECTION\n1 0 0\n2 10 0\n3 10 30\n");
  TEST_ASSERT_EQUAL_UINT(4, distance(1, 2));
  TEST_ASSERT_EQUAL_UINT(10, distance(1, 3));
  TEST_ASSERT_EQUAL_UINT(10, distance(2, 3)); /* sqrt(900 / 10) = 9.49 */
}

/* The first towns of ulysses16, whose table is well known: 509, 501, 126. */
static void test_geographical_distances_are_in_kilometres(void) {
  read_text(HEAD "EDGE_WEIGHT_TYPE: GEO\nNODE_COORD_SECTION\n1 38.24 20.42\n2 39.57 26.15\n3 40.56 25.32\n");
  TEST_ASSERT_EQUAL_UINT(509, distance(1, 2));
  TEST_ASSERT_EQUAL_UINT(501, distance(1, 3));
  TEST_ASSERT_EQUAL_UINT(126, distance(2, 3));
}

/* ---- matrices: 1-2: 7, 1-3: 8, 2-3: 9 ---- */

static void expect_matrix(const char *shape, const char *numbers) {
  char text[512];
  snprintf(text, sizeof text,
           HEAD "EDGE_WEIGHT_TYPE: EXPLICIT\nEDGE_WEIGHT_FORMAT: %s \nEDGE_WEIGHT_SECTION\n%s\nEOF\n", shape, numbers);
  read_text(text);
  TEST_ASSERT_EQUAL_UINT_MESSAGE(7, distance(1, 2), shape);
  TEST_ASSERT_EQUAL_UINT_MESSAGE(8, distance(1, 3), shape);
  TEST_ASSERT_EQUAL_UINT_MESSAGE(9, distance(2, 3), shape);
  TEST_ASSERT_EQUAL_UINT_MESSAGE(9, distance(3, 2), shape);
  tsplib_free(&instance);
}

static void test_triangles_are_read_by_rows_and_columns(void) {
  expect_matrix("UPPER_ROW", "7 8\n9");
  expect_matrix("LOWER_ROW", "7\n8 9");
  expect_matrix("UPPER_DIAG_ROW", "0 7 8\n0 9\n0");
  expect_matrix("LOWER_DIAG_ROW", "0 7 0 8\n\n9 0");
  expect_matrix("UPPER_COL", "7 8 9");
  expect_matrix("LOWER_COL", "7 8 9");
  expect_matrix("UPPER_DIAG_COL", "0 7 0 8 9 0");
  expect_matrix("LOWER_DIAG_COL", "0 7 8 0 9 0");
  expect_matrix("FULL_MATRIX", "0 7 8 7 0 9 8 9 0");
}

static void test_full_matrix_may_be_of_one_way_streets(void) {
  read_text("NAME: x\nTYPE: ATSP\nDIMENSION: 2\nEDGE_WEIGHT_TYPE: EXPLICIT\nEDGE_WEIGHT_FORMAT: FULL_MATRIX\n"
            "DISPLAY_DATA_TYPE: TWOD_DISPLAY\nEDGE_WEIGHT_SECTION\n9999 1 2 9999\nDISPLAY_DATA_SECTION\n1 1 1\n2 2 2\n"
            "EOF\n");
  TEST_ASSERT_EQUAL_UINT(1, distance(1, 2));
  TEST_ASSERT_EQUAL_UINT(2, distance(2, 1));
}

/* ---- what is wrong ---- */

static void expect_fault(const char *text, const char *line) {
  write_file(text);
  TEST_ASSERT_EQUAL_INT(-1, tsplib_read(&instance, "x.tsp", &why));
  TEST_ASSERT_EQUAL_STRING(line, why.text);
  TEST_ASSERT_EQUAL_INT(EXIT_BAD_INPUT, why.status);
  TEST_ASSERT_NULL(instance.distance);
}

#define EUC HEAD "EDGE_WEIGHT_TYPE: EUC_2D\n"
#define MATRIX HEAD "EDGE_WEIGHT_TYPE: EXPLICIT\nEDGE_WEIGHT_FORMAT: UPPER_ROW\nEDGE_WEIGHT_SECTION\n"

static void test_what_a_file_says_of_itself_is_held_against_what_is_read(void) {
  expect_fault("TYPE: CVRP\n", "x.tsp:1: TYPE: of the types TSP and ATSP alone are read");
  expect_fault("DIMENSION: 1\n", "x.tsp:1: DIMENSION: is not a number of towns from 2 to 5000");
  expect_fault("\nEDGE_WEIGHT_TYPE: MAN_3D\n",
               "x.tsp:2: EDGE_WEIGHT_TYPE: is none of EUC_2D, CEIL_2D, ATT, GEO and EXPLICIT");
  expect_fault("EDGE_WEIGHT_FORMAT: FUNCTION\n",
               "x.tsp:1: EDGE_WEIGHT_FORMAT: is no full matrix, and no triangle by rows or columns");
  expect_fault("TOUR_SECTION\n", "x.tsp:1: the first word is no keyword of a TSP that is read");
  expect_fault("NODE_COORD_SECTION\n", "x.tsp:1: NODE_COORD_SECTION comes before DIMENSION");
  expect_fault("DIMENSION: 2\nNODE_COORD_SECTION\n", "x.tsp:2: NODE_COORD_SECTION comes before EDGE_WEIGHT_TYPE");
  expect_fault(HEAD "EOF\n", "x.tsp:5: the file gives no distances");
}

static void test_what_is_wrong_with_coordinates_is_told_by_line(void) {
  expect_fault(EUC "NODE_COORD_SECTION\n1 0 0\n4 1 1\n",
               "x.tsp:8: NODE_COORD_SECTION: is not a town's number, 1 to DIMENSION");
  expect_fault(EUC "NODE_COORD_SECTION\n1 0 0\n1 1 1\n", "x.tsp:8: NODE_COORD_SECTION: tells of a town once more");
  expect_fault(EUC "NODE_COORD_SECTION\n1 0 zero\n", "x.tsp:7: NODE_COORD_SECTION: a coordinate is not a number");
  expect_fault(EUC "NODE_COORD_SECTION\n1 0\n", "x.tsp:7: NODE_COORD_SECTION: a coordinate is missing");
  expect_fault(EUC "NODE_COORD_SECTION\n1 0 1e9\n", "x.tsp:7: NODE_COORD_SECTION: a coordinate is beyond 1e8");
  expect_fault(EUC "NODE_COORD_SECTION\n1 0 0 0\n",
               "x.tsp:7: NODE_COORD_SECTION: has more than a number and two coordinates");
  expect_fault(EUC "NODE_COORD_SECTION\n1 0 0\n",
               "x.tsp:7: NODE_COORD_SECTION: ends before all towns have coordinates");
}

static void test_what_is_wrong_with_a_matrix_is_told_by_line(void) {
  expect_fault(MATRIX "7 8\n", "x.tsp:8: EDGE_WEIGHT_SECTION: ends before all distances are there");
  expect_fault(MATRIX "7 x\n", "x.tsp:8: EDGE_WEIGHT_SECTION: holds what is no whole number of at most 9 digits");
  expect_fault(MATRIX "7\n-8\n", "x.tsp:9: EDGE_WEIGHT_SECTION: holds a distance below 0");
  expect_fault(MATRIX "7 8 9 1\n", "x.tsp:8: EDGE_WEIGHT_SECTION: holds more distances than DIMENSION tells of");
  expect_fault(HEAD "EDGE_WEIGHT_TYPE: EXPLICIT\nEDGE_WEIGHT_SECTION\n",
               "x.tsp:6: EDGE_WEIGHT_SECTION comes before EDGE_WEIGHT_FORMAT");
}

static void test_file_that_is_not_there_is_named(void) {
  TEST_ASSERT_EQUAL_INT(-1, tsplib_read(&instance, "none.tsp", &why));
  TEST_ASSERT_EQUAL_STRING_LEN("none.tsp", why.text, 8);
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_euclidean_distances_are_rounded_to_the_nearest);
  RUN_TEST(test_ceiled_distances_are_rounded_up);
  RUN_TEST(test_pseudo_euclidean_distances_are_never_less_than_they_are);
  RUN_TEST(test_geographical_distances_are_in_kilometres);
  RUN_TEST(test_triangles_are_read_by_rows_and_columns);
  RUN_TEST(test_full_matrix_may_be_of_one_way_streets);
  RUN_TEST(test_what_a_file_says_of_itself_is_held_against_what_is_read);
  RUN_TEST(test_what_is_wrong_with_coordinates_is_told_by_line);
  RUN_TEST(test_what_is_wrong_with_a_matrix_is_told_by_line);
  RUN_TEST(test_file_that_is_not_there_is_named);
  return UNITY_END();
}

/* Pictures: well-formed, complete, safe with any text, the same bytes every time, small for large maps. */
#include <ctype.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "draw_parts.h"
#include "draw_svg.h"
#include "support/random.h"
#include "unity.h"

enum { COLUMNS = 6, ROWS = 4 };

static uint8_t cost[COLUMNS * ROWS];
static qtr_cell places[3] = {3, 12, 17};
static double likelihood[3] = {0.5, 0.25, 0.25};
static const qtr_cell trail0[] = {0, 1, 2, 3}, trail1[] = {0, 6, 12};
static uint16_t route0[] = {0}, route1[] = {1};
static qtr_steps step0[] = {3}, step1[] = {2};
static drawing_seeker seekers[2];
static drawing d;
static char *text;
static size_t size;

void setUp(void) {
  memset(cost, 1, sizeof cost);
  cost[8] = 0;
  cost[10] = 4;
  seekers[0] = (drawing_seeker){0, trail0, 4, 1, route0, step0};
  seekers[1] = (drawing_seeker){0, trail1, 3, 1, route1, step1};
  d = (drawing){.title = "Plan",
                .columns = COLUMNS,
                .rows = ROWS,
                .cost = cost,
                .places = 3,
                .place = places,
                .likelihood = likelihood,
                .seekers = 2,
                .seeker = seekers};
  text = NULL;
}

void tearDown(void) {
  free(text);
}

static void draw(void) {
  free(text);
  FILE *out = open_memstream(&text, &size);
  TEST_ASSERT_NOT_NULL(out);
  TEST_ASSERT_EQUAL_INT(0, draw_svg(out, &d));
  fclose(out);
}

static int count(const char *what) {
  int found = 0;
  for (const char *at = text; (at = strstr(at, what)) != NULL; at++) found++;
  return found;
}

/* ---- a reader of XML that knows just what a picture may hold ---- */

static const char *skip_entity(const char *at) {
  static const char *const known[] = {"&lt;", "&gt;", "&amp;", "&quot;"};
  for (size_t k = 0; k < sizeof known / sizeof *known; k++)
    if (strncmp(at, known[k], strlen(known[k])) == 0) return at + strlen(known[k]);
  TEST_FAIL_MESSAGE("a & that begins no entity");
  return at + 1;
}

/* One attribute, name="value"; returns what follows. */
static const char *skip_attribute(const char *at) {
  TEST_ASSERT_TRUE_MESSAGE(isalpha((unsigned char)*at), at);
  while (isalnum((unsigned char)*at) || *at == '-') at++;
  TEST_ASSERT_EQUAL_STRING_LEN("=\"", at, 2);
  for (at += 2; *at != '"'; at++) TEST_ASSERT_TRUE_MESSAGE(*at >= 0x20 && *at != '<' && *at != '&', at);
  return at + 1;
}

/* A tag from its '<' on; the open elements' names are kept on a stack. */
static const char *skip_tag(const char *at, char stack[][16], int *depth) {
  const bool ends = at[1] == '/';
  const char *name = at + 1 + ends;
  const size_t length = strcspn(name, " />\n");
  TEST_ASSERT_TRUE(length > 0 && length < 16);
  at = name + length;
  while (*at == ' ') at = skip_attribute(at + 1);
  if (ends) {
    TEST_ASSERT_EQUAL_STRING_LEN(stack[--*depth], name, length);
  } else if (*at != '/') {
    TEST_ASSERT_LESS_THAN_INT(8, *depth);
    snprintf(stack[(*depth)++], 16, "%.*s", (int)length, name);
  }
  at += *at == '/';
  TEST_ASSERT_EQUAL_CHAR('>', *at);
  return at + 1;
}

static void assert_well_formed(void) {
  char stack[8][16];
  int depth = 0;
  const char *at = text;
  while (*at != '\0') {
    if (*at == '<') {
      at = skip_tag(at, stack, &depth);
      TEST_ASSERT_TRUE(depth > 0 || strcmp(at, "\n") == 0);
    } else if (*at == '&') {
      at = skip_entity(at);
    } else {
      TEST_ASSERT_TRUE_MESSAGE((unsigned char)*at >= 0x20 || *at == '\n', "a control character");
      at++;
    }
  }
  TEST_ASSERT_EQUAL_INT(0, depth);
}

/* ---- */

static void test_picture_holds_every_place_start_and_trajectory(void) {
  draw();
  assert_well_formed();
  TEST_ASSERT_EQUAL_INT(3, count("<g class=\"place\">"));
  TEST_ASSERT_EQUAL_INT(2, count("class=\"trajectory\""));
  TEST_ASSERT_EQUAL_INT(2, count("class=\"territory\""));
  TEST_ASSERT_EQUAL_INT(4, count("rx=\"3\"")); /* two starts, and two in the legend */
  TEST_ASSERT_EQUAL_INT(1, count("place 0, likelihood 0.5, seeker 0, visit 1, step 3"));
  TEST_ASSERT_EQUAL_INT(1, count("place 2, likelihood 0.25<")); /* nobody visits it */
  TEST_ASSERT_EQUAL_INT(1, count("Seeker 1 visits place 1 at step 2."));
  TEST_ASSERT_EQUAL_INT(1, count("up to 4 steps a cell"));
}

/* Among the numbers inside the places. */
static int count_numbers(const char *what) {
  char *end = strstr(text, "id=\"labels\"");
  const char kept = *end;
  int found = 0;
  *end = '\0';
  for (const char *at = strstr(text, "id=\"numbers\""); (at = strstr(at, what)) != NULL; at++) found++;
  *end = kept;
  return found;
}

static void test_places_bear_the_numbers_that_they_are_given(void) {
  static const uint16_t numbers[] = {4, 7, 8};
  draw();
  for (int p = 0; p < 3; p++) TEST_ASSERT_EQUAL_INT(1, count_numbers((const char *const[]){">0<", ">1<", ">2<"}[p]));
  TEST_ASSERT_EQUAL_INT(2, count(">1st</text>")); /* places 0 and 1, each its seeker's first */
  d.number = numbers;
  draw();
  assert_well_formed();
  for (int p = 0; p < 3; p++) TEST_ASSERT_EQUAL_INT(1, count_numbers((const char *const[]){">4<", ">7<", ">8<"}[p]));
  TEST_ASSERT_EQUAL_INT(1, count("<title>place 7, "));
  TEST_ASSERT_EQUAL_INT(1, count("Seeker 1 visits place 7 at step 2."));
}

static void expect_ordinal(const char *expected, int number) {
  char ordinal[16];
  draw_ordinal(ordinal, number);
  TEST_ASSERT_EQUAL_STRING(expected, ordinal);
}

static void test_visits_are_counted_as_in_speech(void) {
  expect_ordinal("1st", 1);
  expect_ordinal("2nd", 2);
  expect_ordinal("3rd", 3);
  expect_ordinal("4th", 4);
  expect_ordinal("10th", 10);
  expect_ordinal("11th", 11);
  expect_ordinal("12th", 12);
  expect_ordinal("13th", 13);
  expect_ordinal("21st", 21);
  expect_ordinal("112th", 112);
  expect_ordinal("122nd", 122);
}

/* The circles of the places and the squares of the starts. */
static int read_boxes(draw_box *box, const char *from, const char *to) {
  int boxes = 0;
  for (const char *at = from; at < to; at++) {
    double x, y, w, h;
    if (sscanf(at, "<circle cx=\"%lf\" cy=\"%lf\" r=\"%lf\"", &x, &y, &w) == 3)
      box[boxes++] = (draw_box){x - w, y - w, 2 * w, 2 * w};
    else if (sscanf(at, "<rect x=\"%lf\" y=\"%lf\" width=\"%lf\" height=\"%lf\"", &x, &y, &w, &h) == 4)
      box[boxes++] = (draw_box){x, y, w, h};
  }
  return boxes;
}

static bool overlap(const draw_box *a, const draw_box *b) {
  return a->x + a->width > b->x + 0.1 && b->x + b->width > a->x + 0.1 && a->y + a->height > b->y + 0.1 &&
         b->y + b->height > a->y + 0.1;
}

static void test_a_place_on_a_start_does_not_hide_it(void) {
  draw_box place[3], start[2];
  seekers[0].start = seekers[1].start = places[0];
  draw();
  TEST_ASSERT_EQUAL_INT(3, read_boxes(place, strstr(text, "id=\"places\""), strstr(text, "id=\"starts\"")));
  char *leader = strstr(strstr(text, "id=\"starts\""), "<circle");
  TEST_ASSERT_NOT_NULL(leader); /* the start itself is dotted, its squares stand beside the place */
  TEST_ASSERT_EQUAL_INT(2, read_boxes(start, strstr(leader, "<rect"), strstr(text, "id=\"numbers\"")));
  for (int i = 0; i < 2; i++)
    for (int p = 0; p < 3; p++) TEST_ASSERT_FALSE(overlap(&start[i], &place[p]));
}

/* The labels beside the places, as wide as their text is taken to be. */
static int read_labels(draw_box *box) {
  int boxes = 0;
  for (const char *at = strstr(text, "id=\"labels\""); (at = strstr(at, "<text")) != NULL; at++) {
    char shown[40] = "";
    double x, y;
    if (strstr(at, "<g id=\"legend\"") == NULL) break;
    TEST_ASSERT_EQUAL_INT(2, sscanf(at, "<text x=\"%lf\" y=\"%lf\"", &x, &y));
    for (const char *c = strchr(at, '>') + 1; strncmp(c, "</text>", 7) != 0; c++) {
      if (*c == '<')
        c = strchr(c, '>');
      else
        strncat(shown, c, 1);
    }
    box[boxes++] = (draw_box){x, y - 8, draw_text_width(shown, 10.5), 9};
  }
  return boxes;
}

static void test_labels_stand_clear_of_one_another_and_of_the_places(void) {
  enum { SIDE = 30, MANY = 16 };
  static uint8_t open[SIDE * SIDE];
  static qtr_cell cell[MANY];
  static double weight[MANY];
  static uint16_t route[2][MANY];
  static qtr_steps step[MANY];
  static draw_box label[3 * MANY], place[MANY];
  memset(open, 1, sizeof open);
  for (unsigned i = 0; i < 40; i++) {
    test_random random = random_case("labels", i);
    for (unsigned p = 0; p < MANY; p++) {
      cell[p] = (qtr_cell)(p * SIDE * SIDE / MANY + random_below(&random, SIDE * SIDE / MANY));
      weight[p] = random_in(&random, 1, 9);
      route[p % 2][p / 2] = (uint16_t)p;
    }
    for (int s = 0; s < 2; s++) seekers[s] = (drawing_seeker){0, NULL, 0, MANY / 2, route[s], step};
    d = (drawing){.columns = SIDE,
                  .rows = SIDE,
                  .cost = open,
                  .places = MANY,
                  .place = cell,
                  .likelihood = weight,
                  .seekers = 2,
                  .seeker = seekers};
    draw();
    assert_well_formed();
    read_boxes(place, strstr(text, "id=\"places\""), strstr(text, "id=\"starts\""));
    const int labels = read_labels(label);
    TEST_ASSERT_EQUAL_INT_MESSAGE(MANY, labels, case_note);
    for (int a = 0; a < labels; a++) {
      for (int b = 0; b < a; b++) TEST_ASSERT_FALSE_MESSAGE(overlap(&label[a], &label[b]), case_note);
      for (int p = 0; p < MANY; p++) TEST_ASSERT_FALSE_MESSAGE(overlap(&label[a], &place[p]), case_note);
    }
  }
}

static void test_likelihood_is_the_area(void) {
  double large = 0, small = 0;
  draw();
  sscanf(strstr(strstr(text, "place 0,"), " r="), " r=\"%lf", &large);
  sscanf(strstr(strstr(text, "place 1,"), " r="), " r=\"%lf", &small);
  TEST_ASSERT_TRUE(large * large > 1.99 * small * small && large * large < 2.01 * small * small);
}

static void test_same_drawing_gives_the_same_bytes(void) {
  draw();
  char *first = strdup(text);
  const size_t length = size;
  draw();
  TEST_ASSERT_EQUAL_size_t(length, size);
  TEST_ASSERT_EQUAL_MEMORY(first, text, size);
  free(first);
}

static void test_text_of_any_kind_is_escaped(void) {
  const char *const lines[] = {"<script>&\"'", "bound\t1 < 2", "\xFF\x01\xC3\xA9\xEF\xBF\xBE"};
  d.title = "a <b> & \"c\" \x1b[31m";
  d.lines = 3;
  d.line = lines;
  draw();
  assert_well_formed();
  TEST_ASSERT_EQUAL_INT(0, count("<script>"));
  TEST_ASSERT_EQUAL_INT(1, count("&lt;script&gt;&amp;&quot;'"));
  TEST_ASSERT_EQUAL_INT(2, count("a &lt;b&gt; &amp; &quot;c&quot; \xEF\xBF\xBD[31m"));
  TEST_ASSERT_EQUAL_INT(1, count(">1 &lt; 2<"));
  TEST_ASSERT_EQUAL_INT(1, count("\xEF\xBF\xBD\xEF\xBF\xBD\xC3\xA9\xEF\xBF\xBD"));
}

static void test_long_text_is_cut_between_characters(void) {
  static char title[3001];
  for (int c = 0; c < 1500; c++) memcpy(title + 2 * c, "\xC3\xA9", 2);
  d.title = title;
  draw();
  assert_well_formed();
  TEST_ASSERT_EQUAL_INT(2, count("\xC3\xA9\xE2\x80\xA6<"));
}

static void test_wide_margins_of_nothing_are_cropped(void) {
  static uint8_t wide[200 * 300];
  memset(wide, 0, sizeof wide);
  for (unsigned row = 100; row < 104; row++) memset(wide + row * 200 + 50, 1, 6);
  qtr_cell place = 101 * 200 + 52;
  d = (drawing){.columns = 200, .rows = 300, .cost = wide, .places = 1, .place = &place, .likelihood = likelihood};
  draw();
  assert_well_formed();
  TEST_ASSERT_EQUAL_INT(
      2, count("width=\"512.00\" height=\"384.00\"")); /* ground and frame: (6 + 2) x (4 + 2) cells of 64 pixels */
}

static void test_overlapping_trajectories_run_side_by_side(void) {
  const qtr_cell same[] = {0, 1, 2, 3};
  char first[400] = "", second[400] = "";
  seekers[1].trail = same;
  seekers[1].trail_length = 4;
  draw();
  const char *at = strstr(text, "class=\"trajectory\"");
  sscanf(strstr(at, " d="), " d=\"%399[^\"]", first);
  sscanf(strstr(strstr(at + 1, "class=\"trajectory\""), " d="), " d=\"%399[^\"]", second);
  TEST_ASSERT_TRUE(first[0] == 'M' && second[0] == 'M' && strcmp(first, second) != 0);
}

static void test_large_map_stays_a_small_file(void) {
  enum { SIDE = 1024 };
  uint8_t *large = malloc(SIDE * SIDE);
  uint32_t state = 1;
  for (int c = 0; c < SIDE * SIDE; c++) {
    state = state * 1664525u + 1013904223u;
    large[c] = (state >> 24) >= 64; /* a quarter blocked at random: the worst there is */
  }
  for (int p = 0; p < 3; p++) large[places[p]] = 1;
  d.columns = d.rows = SIDE;
  d.cost = large;
  seekers[0].trail = seekers[1].trail = NULL;
  draw();
  free(large);
  TEST_ASSERT_LESS_THAN_size_t(4 * SIDE * SIDE, size);
  TEST_ASSERT_LESS_THAN_INT(20, count("<rect"));
}

static void test_drawing_without_seekers_or_places_is_a_map(void) {
  d.seekers = d.places = 0;
  d.title = NULL;
  draw();
  assert_well_formed();
  d.places = 3; /* a mission that is not solved yet */
  draw();
  assert_well_formed();
  TEST_ASSERT_EQUAL_INT(3, count("<g class=\"place\">"));
  memset(cost, 0, sizeof cost);
  draw();
  assert_well_formed();
}

static void test_regions_are_dotted_where_their_representatives_are(void) {
  static const qtr_cell representative[2] = {COLUMNS + 1, COLUMNS + 4};
  uint16_t region[COLUMNS * ROWS];
  for (int c = 0; c < COLUMNS * ROWS; c++) region[c] = c % COLUMNS >= 3;
  d.region = region;
  d.regions = 2;
  d.representative = representative;
  draw();
  TEST_ASSERT_EQUAL_INT(2, count("r=\"0.16\""));
}

static void test_places_of_a_spot_wear_one_letter(void) {
  uint16_t spot[QTR_MAX_PLACES];
  for (int p = 0; p < QTR_MAX_PLACES; p++) spot[p] = p == 0 ? 1 : 0;
  d.spot = spot;
  draw();
  TEST_ASSERT_EQUAL_INT(1, count(">B</text>"));
  TEST_ASSERT_EQUAL_INT(d.places - 1, count(">A</text>"));
}

static void test_metres_give_a_scale_and_regions_their_borders(void) {
  uint16_t region[COLUMNS * ROWS];
  for (int c = 0; c < COLUMNS * ROWS; c++) region[c] = c % COLUMNS < 3;
  d.region = region;
  d.cell_size = 0.25;
  draw();
  assert_well_formed();
  TEST_ASSERT_EQUAL_INT(1, count(">0.2 m<"));
  TEST_ASSERT_EQUAL_INT(1, count("class=\"regions\""));
  TEST_ASSERT_EQUAL_INT(1, count("d=\"M3 0v1M3 2v1M3 3v1\"")); /* not at the blocked cell */
}

/* The numbers of an axis, left to right or from the top, as they are written. */
static void expect_ticks(const char *name, const char *expected) {
  char found[400] = "";
  char *axes = strdup(strstr(text, "id=\"axes\""));
  strstr(axes, name)[1] = '\0';
  const char *from = strstr(axes, ">column<") != NULL ? strstr(axes, ">column<") : strstr(axes, ">x, metres<");
  for (const char *at = from != NULL ? from : axes; (at = strstr(at, "<text")) != NULL; at++) {
    char number[20];
    if (sscanf(strchr(at, '>') + 1, "%19[-0-9.]<", number) == 1) strcat(strcat(found, number), " ");
  }
  free(axes);
  TEST_ASSERT_EQUAL_STRING(expected, found);
}

static void test_axes_count_columns_and_rows_where_there_are_no_metres(void) {
  draw();
  assert_well_formed();
  expect_ticks(">column<", "0 1 2 3 4 5 ");
  expect_ticks(">row<", "0 1 2 3 ");
  d.cell_size = 0.5;
  d.turned = true;
  draw();
  expect_ticks(">column<", "0 1 2 3 4 5 ");
}

static void test_axes_are_in_metres_of_the_map_frame(void) {
  d.cell_size = 0.5;
  d.x = -1.25;
  d.y = 7;
  draw();
  assert_well_formed();
  expect_ticks(">x, metres<", "-1 -0.5 0 0.5 1 1.5 ");
  expect_ticks(">y, metres<", "7 7.5 8 8.5 9 ");
}

static void test_ground_that_no_robot_gets_to_is_marked_and_explained(void) {
  draw();
  TEST_ASSERT_EQUAL_INT(0, count("class=\"pocket\""));
  TEST_ASSERT_EQUAL_INT(0, count("no robot gets there"));
  for (int row = 0; row < ROWS; row++) cost[row * COLUMNS + 4] = 0;
  draw();
  assert_well_formed();
  TEST_ASSERT_EQUAL_INT(1, count("class=\"pocket\""));
  TEST_ASSERT_EQUAL_INT(1, count("d=\"M5 0h1v4h-1z\""));
  TEST_ASSERT_EQUAL_INT(1, count("no robot gets there"));
  TEST_ASSERT_EQUAL_INT(1, count(">blocked<"));
  d.reached_alone = true;
  draw();
  TEST_ASSERT_EQUAL_INT(1, count(">blocked, or out of reach<"));
}

static void test_many_seekers_have_colours_and_lanes_of_their_own(void) {
  static drawing_seeker many[QTR_MAX_SEEKERS];
  for (int i = 0; i < QTR_MAX_SEEKERS; i++) many[i] = (drawing_seeker){0, trail0, 4, 0, NULL, NULL};
  d.seekers = QTR_MAX_SEEKERS;
  d.seeker = many;
  draw();
  assert_well_formed();
  TEST_ASSERT_EQUAL_INT(QTR_MAX_SEEKERS, count("stands down"));
  char before[200] = "";
  for (const char *at = text; (at = strstr(at, "class=\"trajectory\"")) != NULL; at++) {
    char way[200];
    sscanf(strstr(at, " d="), " d=\"%199[^\"]", way);
    TEST_ASSERT_TRUE(strcmp(before, way) != 0);
    strcpy(before, way);
  }
}

static void test_cells_off_the_map_are_refused(void) {
  FILE *out = fopen("/dev/null", "w");
  seekers[0].start = COLUMNS * ROWS;
  TEST_ASSERT_EQUAL_INT(-1, draw_svg(out, &d));
  setUp();
  places[2] = COLUMNS * ROWS;
  TEST_ASSERT_EQUAL_INT(-1, draw_svg(out, &d));
  places[2] = 17;
  route1[0] = 3;
  TEST_ASSERT_EQUAL_INT(-1, draw_svg(out, &d));
  route1[0] = 1;
  TEST_ASSERT_EQUAL_INT(0, draw_svg(out, &d));
  fclose(out);
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_picture_holds_every_place_start_and_trajectory);
  RUN_TEST(test_places_bear_the_numbers_that_they_are_given);
  RUN_TEST(test_visits_are_counted_as_in_speech);
  RUN_TEST(test_a_place_on_a_start_does_not_hide_it);
  RUN_TEST(test_labels_stand_clear_of_one_another_and_of_the_places);
  RUN_TEST(test_likelihood_is_the_area);
  RUN_TEST(test_same_drawing_gives_the_same_bytes);
  RUN_TEST(test_text_of_any_kind_is_escaped);
  RUN_TEST(test_long_text_is_cut_between_characters);
  RUN_TEST(test_wide_margins_of_nothing_are_cropped);
  RUN_TEST(test_overlapping_trajectories_run_side_by_side);
  RUN_TEST(test_large_map_stays_a_small_file);
  RUN_TEST(test_drawing_without_seekers_or_places_is_a_map);
  RUN_TEST(test_metres_give_a_scale_and_regions_their_borders);
  RUN_TEST(test_regions_are_dotted_where_their_representatives_are);
  RUN_TEST(test_places_of_a_spot_wear_one_letter);
  RUN_TEST(test_axes_count_columns_and_rows_where_there_are_no_metres);
  RUN_TEST(test_axes_are_in_metres_of_the_map_frame);
  RUN_TEST(test_ground_that_no_robot_gets_to_is_marked_and_explained);
  RUN_TEST(test_many_seekers_have_colours_and_lanes_of_their_own);
  RUN_TEST(test_cells_off_the_map_are_refused);
  return UNITY_END();
}

/* profiles: host mcu */
/* Every public function of the robot side with any integers at all: what is out of range is answered as its header
 * says, and nothing is read or written out of bounds (the sanitizers tell). */
#include <stdlib.h>
#include <string.h>

#include "quarter/robot.h"
#include "support/ranges.h"

__extension__ typedef __int128 wide;

/* ---- sets of places ---- */

static void test_set_holds_the_places_of_the_build_and_no_others(void) {
  qtr_places set[3]; /* the one in the middle is used: the others show a write beside it */
  for (unsigned number = 0; number < 8000; number++) {
    test_random random = random_case("sets", number);
    const unsigned place = any_number(&random, QTR_MAX_PLACES);
    memset(set, 0, sizeof set);
    qtr_places_clear(&set[1]);
    qtr_places_add(&set[1], place);
    TEST_ASSERT_EQUAL_MESSAGE(place < QTR_MAX_PLACES, qtr_places_has(&set[1], place), case_note);
    memset(set, 0xFF, sizeof set);
    qtr_places_remove(&set[1], place);
    TEST_ASSERT_FALSE_MESSAGE(qtr_places_has(&set[1], place), case_note);
    for (unsigned w = 0; w < QTR_PLACE_WORDS; w++) {
      TEST_ASSERT_EQUAL_HEX32_MESSAGE(UINT32_MAX, set[0].word[w], case_note);
      TEST_ASSERT_EQUAL_HEX32_MESSAGE(UINT32_MAX, set[2].word[w], case_note);
    }
  }
}

/* ---- cells ---- */

static bool is_outside(const qtr_grid *grid, qtr_cell cell) {
  return cell >= (uint32_t)grid->columns * grid->rows;
}

static void test_cell_outside_is_blocked_and_leads_nowhere(void) {
  for (unsigned number = 0; number < 120; number++) {
    test_random random;
    open_random("cells", number, &random);
    const qtr_grid *grid = &policy.grid;
    TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_field_fill(&table_field, grid, qtr_policy_cell(&policy, 0)));
    for (unsigned tries = 0; tries < 100; tries++) {
      const qtr_cell cell = (qtr_cell)any_number(&random, qtr_grid_cells(grid));
      const qtr_cell next = qtr_grid_neighbour(grid, cell, (enum qtr_direction)random_below(&random, 6));
      const qtr_cell way = qtr_field_next(&table_field, grid, cell);
      TEST_ASSERT_TRUE_MESSAGE(next == QTR_NO_CELL || !is_outside(grid, next), case_note);
      TEST_ASSERT_TRUE_MESSAGE(way == QTR_NO_CELL || !is_outside(grid, way), case_note);
      TEST_ASSERT_LESS_THAN_MESSAGE(256, qtr_grid_cost(grid, cell), case_note);
      if (!is_outside(grid, cell)) continue;
      TEST_ASSERT_EQUAL_MESSAGE(0, qtr_grid_cost(grid, cell), case_note);
      TEST_ASSERT_EQUAL_UINT32_MESSAGE(QTR_NO_CELL, next, case_note);
      TEST_ASSERT_EQUAL_UINT32_MESSAGE(QTR_NO_CELL, way, case_note);
    }
  }
}

static void test_target_that_cannot_be_entered_is_in_reach_of_nothing(void) {
  for (unsigned number = 0; number < 120; number++) {
    test_random random;
    open_random("targets", number, &random);
    const qtr_cell target = (qtr_cell)any_number(&random, qtr_grid_cells(&policy.grid));
    const bool is_free = !is_outside(&policy.grid, target) && qtr_grid_cost(&policy.grid, target) > 0;
    memset(&table_field, 0, sizeof table_field);
    TEST_ASSERT_EQUAL_INT_MESSAGE(is_free ? QTR_OK : QTR_ERR_ARGUMENT,
                                  qtr_field_fill(&table_field, &policy.grid, target), case_note);
    for (unsigned cell = 0; cell < qtr_grid_cells(&policy.grid) && !is_free; cell++)
      TEST_ASSERT_EQUAL_UINT32_MESSAGE(QTR_NO_CELL, qtr_field_next(&table_field, &policy.grid, (qtr_cell)cell),
                                       case_note);
  }
}

/* In parts of any size, the next step from a cell is none or the one that the whole search gives. */
static void test_field_in_parts_is_the_whole(void) {
  static qtr_field whole;
  for (unsigned number = 0; number < 120; number++) {
    test_random random;
    open_random("parts", number, &random);
    const qtr_cell target = qtr_policy_cell(&policy, random_below(&random, policy.board.places));
    TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_field_fill(&whole, &policy.grid, target));
    TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_field_begin(&table_field, &policy.grid, target));
    for (bool more = true; more;) {
      more = qtr_field_work(&table_field, &policy.grid, random_in(&random, 1, 40));
      for (unsigned cell = 0; cell < qtr_grid_cells(&policy.grid); cell++) {
        const qtr_cell next = qtr_field_next(&table_field, &policy.grid, (qtr_cell)cell);
        const qtr_cell wanted = qtr_field_next(&whole, &policy.grid, (qtr_cell)cell);
        TEST_ASSERT_TRUE_MESSAGE(next == wanted || (more && next == QTR_NO_CELL), case_note);
      }
    }
    TEST_ASSERT_FALSE(qtr_field_work(&table_field, &policy.grid, 1));
  }
}

static void test_grid_larger_than_the_build_is_not_searched(void) {
  const uint8_t cell = 1;
  const qtr_grid grid = {65535, 65535, QTR_GRID_BYTES, &cell};
  TEST_ASSERT_EQUAL_INT(QTR_ERR_LIMIT, qtr_field_fill(&table_field, &grid, 0));
  TEST_ASSERT_EQUAL_UINT32(QTR_NO_CELL, qtr_field_next(&table_field, &grid, 0));
  TEST_ASSERT_EQUAL_UINT32(QTR_NO_CELL, qtr_field_next(&table_field, &grid, QTR_NO_CELL));
}

static void test_grid_of_no_cells_has_none(void) {
  const qtr_grid grid = {0, 0, QTR_GRID_BITS, NULL};
  const qtr_frame frame = {1, 0, 0, 0, 0};
  TEST_ASSERT_EQUAL(0, qtr_grid_cost(&grid, 0));
  TEST_ASSERT_EQUAL_UINT32(QTR_NO_CELL, qtr_grid_neighbour(&grid, 0, QTR_EAST));
  TEST_ASSERT_EQUAL_UINT32(QTR_NO_CELL, qtr_frame_cell(&frame, &grid, 0, 0));
}

static void test_size_of_a_grid_does_not_overflow(void) {
  TEST_ASSERT_EQUAL_UINT32(0, qtr_grid_size(0, QTR_GRID_BITS));
  TEST_ASSERT_EQUAL_UINT32(536870912, qtr_grid_size(UINT32_MAX, QTR_GRID_BITS));
  TEST_ASSERT_EQUAL_UINT32(536870912, qtr_grid_size(UINT32_MAX - 6, QTR_GRID_BITS));
  TEST_ASSERT_EQUAL_UINT32(536870911, qtr_grid_size(UINT32_MAX - 7, QTR_GRID_BITS));
  TEST_ASSERT_EQUAL_UINT32(UINT32_MAX, qtr_grid_size(UINT32_MAX, QTR_GRID_BYTES));
}

/* ---- poses ---- */

static int64_t any_coordinate(test_random *random, int64_t origin, uint32_t side) {
  const int64_t telling[] = {0,
                             -1,
                             1,
                             INT64_MAX,
                             INT64_MIN,
                             INT64_MAX - 1,
                             INT64_MIN + 1,
                             QTR_FRAME_LIMIT_UM,
                             -QTR_FRAME_LIMIT_UM,
                             QTR_FRAME_LIMIT_UM - 1,
                             1 - QTR_FRAME_LIMIT_UM};
  const unsigned kind = random_below(random, 4);
  const bool is_near = origin > -QTR_FRAME_LIMIT_UM && origin < QTR_FRAME_LIMIT_UM;
  if (kind == 0) return (int64_t)random_bits(random);
  if (kind == 1) return telling[random_below(random, sizeof telling / sizeof telling[0])];
  if (kind == 2) return is_near ? origin + (int64_t)random_below(random, 12) * side - random_below(random, 3) : origin;
  return (int64_t)(random_bits(random) >> random_below(random, 64));
}

static qtr_frame any_frame(test_random *random) {
  const uint32_t sides[] = {0, 1, 50000, 1000000, UINT32_MAX, (uint32_t)random_bits(random)};
  qtr_frame frame = {sides[random_below(random, 6)], 0, 0, 0, 0};
  frame.origin_x_um = any_coordinate(random, 0, 50000);
  frame.origin_y_um = any_coordinate(random, 0, 50000);
  return frame;
}

static bool is_usable(const qtr_frame *frame) {
  const wide limit = QTR_FRAME_LIMIT_UM;
  return frame->cell_size_um > 0 && frame->origin_x_um > -limit && frame->origin_x_um < limit &&
         frame->origin_y_um > -limit && frame->origin_y_um < limit;
}

/* In numbers twice as wide. */
static qtr_cell cell_of(const qtr_frame *frame, const qtr_grid *grid, int64_t x, int64_t y) {
  const wide limit = QTR_FRAME_LIMIT_UM;
  if (!is_usable(frame) || x <= -limit || x >= limit || y <= -limit || y >= limit) return QTR_NO_CELL;
  const wide across = (wide)x - frame->origin_x_um;
  const wide up = (wide)y - frame->origin_y_um;
  if (across < 0 || across >= (wide)frame->cell_size_um * grid->columns) return QTR_NO_CELL;
  if (up < 0 || up >= (wide)frame->cell_size_um * grid->rows) return QTR_NO_CELL;
  return (qtr_cell)((grid->rows - 1 - up / frame->cell_size_um) * grid->columns + across / frame->cell_size_um);
}

static void test_pose_gone_astray_is_in_no_cell(void) {
  unsigned inside = 0;
  for (unsigned number = 0; number < 15000; number++) {
    test_random random = random_case("poses", number);
    const qtr_frame frame = any_frame(&random);
    const qtr_grid grid = {(uint16_t)random_in(&random, 1, 32), (uint16_t)random_in(&random, 1, 32), QTR_GRID_BITS,
                           NULL};
    const int64_t x = any_coordinate(&random, frame.origin_x_um, frame.cell_size_um);
    const int64_t y = any_coordinate(&random, frame.origin_y_um, frame.cell_size_um);
    const qtr_cell cell = qtr_frame_cell(&frame, &grid, x, y);
    TEST_ASSERT_EQUAL_UINT32_MESSAGE(cell_of(&frame, &grid, x, y), cell, case_note);
    inside += cell != QTR_NO_CELL;
  }
  TEST_ASSERT_GREATER_THAN(200, inside);
}

static void test_cell_outside_has_no_middle(void) {
  for (unsigned number = 0; number < 15000; number++) {
    test_random random = random_case("middles", number);
    const qtr_frame frame = any_frame(&random);
    const qtr_grid grid = {(uint16_t)random_in(&random, 1, 32), (uint16_t)random_in(&random, 1, 32), QTR_GRID_BITS,
                           NULL};
    const qtr_cell cell = (qtr_cell)any_number(&random, qtr_grid_cells(&grid));
    int64_t x = 77;
    int64_t y = 78;
    const bool has_one = qtr_frame_centre(&frame, &grid, cell, &x, &y);
    TEST_ASSERT_EQUAL_MESSAGE(is_usable(&frame) && !is_outside(&grid, cell), has_one, case_note);
    if (has_one) continue;
    TEST_ASSERT_EQUAL_INT64_MESSAGE(77, x, case_note);
    TEST_ASSERT_EQUAL_INT64_MESSAGE(78, y, case_note);
  }
}

/* ---- nodes, places and seekers ---- */

static void test_node_or_place_that_is_none_has_no_cell_weight_or_way(void) {
  for (unsigned number = 0; number < 120; number++) {
    test_random random;
    open_random("nodes", number, &random);
    const unsigned places = policy.board.places;
    const unsigned nodes = places + policy.board.starts;
    for (unsigned tries = 0; tries < 200; tries++) {
      const unsigned node = any_number(&random, nodes);
      const unsigned place = any_number(&random, places);
      TEST_ASSERT_EQUAL_MESSAGE(node >= nodes, qtr_policy_cell(&policy, node) == QTR_NO_CELL, case_note);
      TEST_ASSERT_EQUAL_MESSAGE(place >= places, qtr_policy_weight(&policy, place) == 0, case_note);
      const unsigned seeker = any_number(&random, policy.board.seekers);
      const qtr_cell cell = (qtr_cell)any_number(&random, qtr_grid_cells(&policy.grid));
      const qtr_steps steps = qtr_board_steps(&policy.board, seeker, node, place);
      TEST_ASSERT_EQUAL_MESSAGE(QTR_POLICY_NO_REGION, qtr_policy_region(&policy, cell), case_note);
      const bool nobody = seeker >= policy.board.seekers;
      if (node >= nodes || place >= places || nobody) TEST_ASSERT_EQUAL_UINT32_MESSAGE(QTR_NEVER, steps, case_note);
      if (!nobody) TEST_ASSERT_EQUAL_UINT32_MESSAGE(0, qtr_board_ready(&policy.board, seeker), case_note);
      if (!nobody) TEST_ASSERT_EQUAL_UINT32_MESSAGE(QTR_NEVER, qtr_board_end(&policy.board, seeker), case_note);
      TEST_ASSERT_EQUAL_UINT_MESSAGE(place, qtr_policy_place(&policy, place), case_note);
      TEST_ASSERT_EQUAL_UINT8_MESSAGE(policy.grid.encoding, qtr_policy_ground(&policy, seeker).encoding, case_note);
      const unsigned of_class = any_number(&random, qtr_board_classes(&policy.board));
      const uint32_t cell_steps = qtr_claim_cell_steps(&policy, of_class);
      TEST_ASSERT_EQUAL_UINT32_MESSAGE(of_class < qtr_board_classes(&policy.board), cell_steps, case_note);
      const qtr_steps times = qtr_board_class_steps(&policy.board, of_class, node, place);
      if (of_class >= qtr_board_classes(&policy.board)) TEST_ASSERT_EQUAL_UINT32_MESSAGE(QTR_NEVER, times, case_note);
    }
  }
}

static bool may_choose(const qtr_joint *joint, int seeker, uint16_t choice) {
  if (seeker < 0 || seeker >= policy.board.seekers) return false;
  if (joint->node[seeker] == QTR_STAND_DOWN || joint->remaining[seeker] > 0) return false;
  if (choice == QTR_STAND_DOWN) return true;
  return choice < policy.board.places && !qtr_places_has(&joint->visited, choice) &&
         qtr_board_steps(&policy.board, (unsigned)seeker, joint->node[seeker], choice) != QTR_NEVER;
}

/* Ask and choose for a seeker and a place that may be none. */
static void meddle(const qtr_joint *state, test_random *random) {
  qtr_joint joint = *state;
  qtr_places choices;
  uint16_t choice = 0;
  bool off_table = false;
  qtr_steps now = 0;
  uint32_t off = 0;
  const int seeker = (int)any_number(random, policy.board.seekers);
  const bool is_one = seeker >= 0 && seeker < policy.board.seekers;
  const bool may_stand_down = qtr_joint_choices(&joint, &policy.board, seeker, &choices);
  if (!may_choose(&joint, seeker, QTR_STAND_DOWN)) {
    TEST_ASSERT_FALSE_MESSAGE(may_stand_down, case_note);
    for (unsigned w = 0; w < QTR_PLACE_WORDS; w++) TEST_ASSERT_EQUAL_HEX32_MESSAGE(0, choices.word[w], case_note);
    TEST_ASSERT_EQUAL_HEX16_MESSAGE(QTR_STAND_DOWN, qtr_policy_choose(&policy, &joint, seeker, &off_table), case_note);
  }
  qtr_policy_lookup(&policy, &joint, &choice);
  choice = (uint16_t)any_number(random, policy.board.places);
  const bool is_allowed = may_choose(&joint, seeker, choice);
  const bool at_once = qtr_joint_choose(&joint, &policy.board, seeker, choice);
  if (!is_allowed) {
    TEST_ASSERT_FALSE_MESSAGE(at_once, case_note);
    TEST_ASSERT_EQUAL_MEMORY_MESSAGE(state, &joint, sizeof joint, case_note);
  }
  if (!is_one) TEST_ASSERT_EQUAL_HEX16(QTR_STAND_DOWN, qtr_policy_play(&policy, &joint, seeker, &now, &off));
}

static void test_seeker_or_choice_that_is_none_changes_nothing(void) {
  for (unsigned number = 0; number < 160; number++) {
    test_random random;
    qtr_joint joint;
    qtr_places cleared;
    qtr_key key;
    qtr_move move;
    open_random("seekers", number, &random);
    for (unsigned w = 0; w < QTR_PLACE_WORDS; w++) cleared.word[w] = (uint32_t)random_bits(&random);
    memset(&joint, 0, sizeof joint);
    qtr_joint_start(&joint, &policy.board, NULL, number % 2 == 0 ? &cleared : NULL);
    for (bool on = true; on;) {
      const int chooser = qtr_joint_chooser(&joint, &policy.board);
      qtr_joint_key(&key, &joint, &policy.board.keys);
      for (unsigned tries = 0; tries < 20; tries++) meddle(&joint, &random);
      if (chooser == QTR_NOBODY) {
        on = qtr_joint_advance(&joint, &policy.board, NULL) > 0;
        continue;
      }
      const uint16_t choice = qtr_policy_choose(&policy, &joint, chooser, NULL);
      qtr_joint moved = joint;
      qtr_joint_choose(&joint, &policy.board, chooser, choice);
      TEST_ASSERT_TRUE_MESSAGE(qtr_policy_move(&policy, &moved, &move), case_note);
      TEST_ASSERT_EQUAL_INT_MESSAGE(chooser, move.seeker, case_note);
      TEST_ASSERT_EQUAL_HEX16_MESSAGE(choice, move.choice, case_note);
      TEST_ASSERT_EQUAL_UINT32_MESSAGE(joint.now, moved.now, case_note);
      TEST_ASSERT_EQUAL_MEMORY_MESSAGE(&joint, &moved, sizeof joint, case_note);
    }
  }
}

static void test_starts_that_are_none_are_refused(void) {
  qtr_deployment deployment;
  qtr_claim claim;
  for (unsigned number = 0; number < 120; number++) {
    test_random random;
    open_random("starts", number, &random);
    for (unsigned tries = 0; tries < 50; tries++) {
      qtr_cell starts[QTR_MAX_SEEKERS];
      bool all = true;
      for (unsigned i = 0; i < policy.board.seekers; i++) {
        starts[i] = (qtr_cell)any_number(&random, qtr_grid_cells(&policy.grid));
        bool known = false;
        for (unsigned s = 0; s < policy.board.starts; s++)
          known = known || qtr_policy_cell(&policy, policy.board.places + s) == starts[i];
        all = all && known;
      }
      TEST_ASSERT_EQUAL_INT_MESSAGE(all ? QTR_OK : QTR_ERR_START,
                                    qtr_deployment_init(&deployment, &policy, starts, NULL), case_note);
    }
    TEST_ASSERT_NOT_EQUAL(0, qtr_policy_digest(&policy));
    qtr_claim_read(&claim, &policy);
    TEST_ASSERT_EQUAL_UINT8(QTR_VERSION_MINOR, claim.version[1]);
  }
}

/* The ways home stand as the travel times do, in as many bytes. */
static void test_ways_home_are_read_by_seeker_and_place(void) {
  static const uint8_t home[4] = {3, 0xFF, 5, 7}, end[8] = {9, 0, 0, 0, 0xFF, 0xFF, 0xFF, 0xFF};
  const qtr_board board = {
      .places = 2, .starts = 1, .seekers = 2, .step_bytes = 1, .terms = {.end = end, .home = home}};
  TEST_ASSERT_EQUAL_UINT32(3, qtr_board_home(&board, 0, 0));
  TEST_ASSERT_EQUAL_UINT32(QTR_NEVER, qtr_board_home(&board, 0, 1));
  TEST_ASSERT_EQUAL_UINT32(7, qtr_board_home(&board, 1, 1));
  TEST_ASSERT_EQUAL_UINT32(9, qtr_board_end(&board, 0));
  TEST_ASSERT_EQUAL_UINT32(QTR_NEVER, qtr_board_end(&board, 1));
}

/* Boards whose numbers are anything; what initialises can be measured and started. */
static void test_board_of_any_numbers_is_refused_or_playable(void) {
  static uint8_t steps[4 * (QTR_MAX_PLACES + 8) * QTR_MAX_PLACES];
  for (unsigned number = 0; number < 8000; number++) {
    test_random random = random_case("boards", number);
    qtr_board board = {.places = (uint16_t)any_number(&random, QTR_MAX_PLACES),
                       .starts = (uint16_t)any_number(&random, 8),
                       .seekers = (uint8_t)any_number(&random, QTR_MAX_SEEKERS),
                       .rule = (uint8_t)any_number(&random, 2),
                       .step_bytes = 4,
                       .steps = steps};
    qtr_joint joint;
    if (board.starts > 8 && board.starts <= QTR_MAX_STARTS) continue; /* more nodes than there are times for */
    for (unsigned i = 0; i < QTR_MAX_SEEKERS; i++) board.start_of[i] = (uint16_t)any_number(&random, 8);
    if (qtr_board_init(&board) != QTR_OK) continue;
    qtr_key_shape again = board.keys;
    qtr_key key[2] = {{{0}}, {{0}}};
    qtr_key_measure(&again);
    TEST_ASSERT_EQUAL_UINT16_MESSAGE(board.keys.bits, again.bits, case_note);
    TEST_ASSERT_LESS_OR_EQUAL_MESSAGE(QTR_KEY_WORDS, board.keys.words, case_note);
    TEST_ASSERT_EQUAL_UINT_MESSAGE(board.places + board.starts, qtr_board_nodes(&board), case_note);
    qtr_joint_start(&joint, &board, NULL, NULL);
    qtr_joint_key(&key[0], &joint, &board.keys);
    qtr_joint_key(&key[1], &joint, &again);
    TEST_ASSERT_EQUAL_MEMORY_MESSAGE(&key[0], &key[1], sizeof key[0], case_note);
  }
}

static void test_objectives_are_three(void) {
  for (unsigned number = 0; number < 1000; number++) {
    test_random random = random_case("objectives", number);
    const uint8_t objective = (uint8_t)any_number(&random, 4);
    TEST_ASSERT_EQUAL_MESSAGE(objective < 3, qtr_claim_knows(objective), case_note);
  }
}

static void test_status_of_any_number_has_a_text(void) {
  TEST_ASSERT_EQUAL_UINT32(QTR_VERSION, qtr_version());
  for (unsigned number = 0; number < 2000; number++) {
    test_random random = random_case("status", number);
    TEST_ASSERT_GREATER_THAN(0, strlen(qtr_strerror((int)any_number(&random, 20))));
    TEST_ASSERT_GREATER_THAN(0, strlen(qtr_strerror(-(int)random_below(&random, 40))));
  }
}

/* ---- nobody is left out ---- */

static char *read_text(const char *path) {
  static char text[2][200000];
  static int turn;
  char *into = text[turn++ % 2];
  FILE *file = fopen(path, "r");
  TEST_ASSERT_NOT_NULL_MESSAGE(file, path);
  into[fread(into, 1, sizeof text[0] - 1, file)] = '\0';
  fclose(file);
  return into;
}

/* Each function declared in a header of the robot side is called in this file or in test_ranges_executor.c. */
static void expect_all_called(const char *header, const char *calls) {
  char path[1000];
  unsigned count = 0;
  snprintf(path, sizeof path, QUARTER_SOURCE_DIR "/include/quarter/%s", header);
  for (char *at = read_text(path); (at = strstr(at, "qtr_")) != NULL;) {
    const size_t length = strspn(at, "abcdefghijklmnopqrstuvwxyz0123456789_");
    if (at[length] == '(' && (at[-1] == ' ' || at[-1] == '*')) {
      char name[100];
      snprintf(name, sizeof name, "%.*s(", (int)length, at);
      char *built = strstr(name, "_built(");
      if (built != NULL) memcpy(built, "(", 2);
      TEST_ASSERT_NOT_NULL_MESSAGE(strstr(calls, name), name);
      count++;
    }
    at += length;
  }
  TEST_ASSERT_GREATER_THAN_MESSAGE(0, count, header);
}

static void test_every_public_function_of_the_robot_side_is_called_here(void) {
  static const char *const headers[] = {"places.h", "grid.h",   "field.h",      "key.h",     "board.h",  "joint.h",
                                        "policy.h", "claim.h",  "deployment.h", "nominal.h", "digest.h", "division.h",
                                        "names.h",  "signal.h", "seeker.h",     "status.h"};
  static const char *const files[] = {"api/test_ranges.c", "inside/test_ranges_executor.c", "support/ranges.h"};
  static char calls[200000];
  for (unsigned i = 0; i < sizeof files / sizeof files[0]; i++) {
    char path[1000];
    snprintf(path, sizeof path, QUARTER_SOURCE_DIR "/tests/%s", files[i]);
    strcat(calls, read_text(path));
  }
  for (unsigned i = 0; i < sizeof headers / sizeof headers[0]; i++) expect_all_called(headers[i], calls);
  const char *all = read_text(QUARTER_SOURCE_DIR "/include/quarter/robot.h");
  for (const char *at = all; (at = strstr(at, "#include \"quarter/")) != NULL; at += 10) {
    bool known = strncmp(at + 18, "config.h", 8) == 0 || strncmp(at + 18, "terms.h", 7) == 0; /* no functions */
    for (unsigned i = 0; i < sizeof headers / sizeof headers[0]; i++)
      known = known || strncmp(at + 18, headers[i], strlen(headers[i])) == 0;
    TEST_ASSERT_TRUE_MESSAGE(known, at);
  }
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_set_holds_the_places_of_the_build_and_no_others);
  RUN_TEST(test_cell_outside_is_blocked_and_leads_nowhere);
  RUN_TEST(test_target_that_cannot_be_entered_is_in_reach_of_nothing);
  RUN_TEST(test_field_in_parts_is_the_whole);
  RUN_TEST(test_grid_larger_than_the_build_is_not_searched);
  RUN_TEST(test_grid_of_no_cells_has_none);
  RUN_TEST(test_size_of_a_grid_does_not_overflow);
  RUN_TEST(test_pose_gone_astray_is_in_no_cell);
  RUN_TEST(test_cell_outside_has_no_middle);
  RUN_TEST(test_node_or_place_that_is_none_has_no_cell_weight_or_way);
  RUN_TEST(test_seeker_or_choice_that_is_none_changes_nothing);
  RUN_TEST(test_starts_that_are_none_are_refused);
  RUN_TEST(test_ways_home_are_read_by_seeker_and_place);
  RUN_TEST(test_board_of_any_numbers_is_refused_or_playable);
  RUN_TEST(test_objectives_are_three);
  RUN_TEST(test_status_of_any_number_has_a_text);
  RUN_TEST(test_every_public_function_of_the_robot_side_is_called_here);
  return UNITY_END();
}

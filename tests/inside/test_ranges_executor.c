/* profiles: host mcu */
/* The executor, its signals and saves with any integers and bytes at all; the rest of the robot side is in
 * test_ranges.c. */
#include "quarter/names.h"
#include "support/forging.h"
#include "support/ranges.h"

static void disturb(qtr_seeker *seeker, test_random *random) {
  const unsigned place = any_number(random, policy.board.places);
  const unsigned territory = any_number(random, policy.board.seekers);
  const uint16_t before = qtr_seeker_target(seeker);
  qtr_seeker_visited(seeker, place);
  TEST_ASSERT_EQUAL_MESSAGE(place < policy.board.places, qtr_places_has(&seeker->visited, place), case_note);
  if (place >= policy.board.places) TEST_ASSERT_EQUAL_HEX16_MESSAGE(before, qtr_seeker_target(seeker), case_note);
  const uint16_t target = qtr_seeker_target(seeker);
  const unsigned kind = random_chance(random, 70) ? QTR_SIGNAL_TERRITORY_DONE : any_number(random, 3);
  const qtr_signal signal = {random_chance(random, 80) ? seeker->identity : (uint32_t)random_bits(random),
                             random_chance(random, 90) ? 0 : any_number(random, 1), (uint8_t)kind, (uint8_t)territory};
  if (!qtr_seeker_hear(seeker, &signal)) TEST_ASSERT_EQUAL_HEX16_MESSAGE(target, qtr_seeker_target(seeker), case_note);
  qtr_seeker_blocked(seeker, random_chance(random, 90) ? QTR_STAND_DOWN : any_number(random, policy.board.places));
  qtr_seeker_lost(seeker, any_number(random, policy.board.seekers));
}

/* A save of any bytes is refused or gives an executor that can be asked anything. */
static void disturb_save(qtr_seeker *seeker, test_random *random) {
  uint8_t save[QTR_SAVE_BYTES];
  const int32_t size = qtr_seeker_save(seeker, save, sizeof save);
  TEST_ASSERT_GREATER_THAN_MESSAGE(0, size, case_note);
  TEST_ASSERT_EQUAL_INT(QTR_ERR_SPACE, qtr_seeker_save(seeker, save, (uint32_t)size - 1));
  for (unsigned flips = random_below(random, 3); flips > 0; flips--)
    save[random_below(random, (uint32_t)size)] ^= (uint8_t)random_bits(random);
  if (random_chance(random, 50)) qtr_store32(save + size - 4, qtr_crc32_add(0, save, (uint32_t)size - 4));
  qtr_seeker again;
  const unsigned self = random_chance(random, 80) ? seeker->self : any_number(random, policy.board.seekers);
  const uint32_t given = random_chance(random, 90) ? (uint32_t)size : random_below(random, (uint32_t)size);
  const int status = qtr_seeker_restore(&again, &policy, self, save, given);
  TEST_ASSERT_TRUE_MESSAGE(status == QTR_OK || status == QTR_ERR_SAVE, case_note);
  if (status == QTR_OK) *seeker = again;
}

static void test_executor_takes_any_words(void) {
  for (unsigned number = 0; number < 160; number++) {
    test_random random;
    qtr_seeker seeker;
    qtr_signal signal;
    open_random("words", number, &random);
    const unsigned self = any_number(&random, policy.board.seekers);
    const int status = qtr_seeker_init(&seeker, &policy, self, NULL, 0);
    TEST_ASSERT_EQUAL_INT_MESSAGE(self < policy.board.seekers ? QTR_OK : QTR_ERR_ARGUMENT, status, case_note);
    for (unsigned words = 0; words < 30 && status == QTR_OK; words++) {
      disturb(&seeker, &random);
      disturb_save(&seeker, &random);
      const uint16_t target = qtr_seeker_target(&seeker);
      TEST_ASSERT_TRUE_MESSAGE(target < policy.board.places || target == QTR_STAND_DOWN, case_note);
      const qtr_cell here = (qtr_cell)any_number(&random, qtr_grid_cells(&policy.grid));
      const bool has_way = qtr_seeker_field(&seeker, &table_field, here);
      TEST_ASSERT_TRUE_MESSAGE(!has_way || qtr_seeker_standing(&seeker) == QTR_UNDER_WAY, case_note);
      TEST_ASSERT_LESS_THAN(policy.board.seekers, qtr_seeker_territory(&seeker));
      TEST_ASSERT_LESS_OR_EQUAL(policy.board.places, qtr_seeker_left(&seeker, NULL));
      while (qtr_seeker_announce(&seeker, &signal)) TEST_ASSERT_LESS_THAN(policy.board.seekers, signal.territory);
      TEST_ASSERT_FALSE(qtr_seeker_known(&seeker, policy.board.seekers + 1u, &signal));
    }
  }
}

static void test_signal_of_any_bytes(void) {
  for (unsigned number = 0; number < 500; number++) {
    test_random random = random_case("signal", number);
    uint8_t packet[QTR_SIGNAL_BYTES];
    uint8_t again[QTR_SIGNAL_BYTES];
    qtr_signal signal;
    for (unsigned i = 0; i < sizeof packet; i++) packet[i] = (uint8_t)random_bits(&random);
    if (random_chance(&random, 70)) packet[8] = (uint8_t)random_below(&random, 4);
    const bool is_one = packet[8] == QTR_SIGNAL_FOUND || packet[8] == QTR_SIGNAL_TERRITORY_DONE;
    TEST_ASSERT_EQUAL(is_one, qtr_signal_read(&signal, packet, sizeof packet));
    TEST_ASSERT_FALSE(qtr_signal_read(&signal, packet, random_below(&random, QTR_SIGNAL_BYTES)));
    if (!is_one) continue;
    qtr_signal_write(&signal, again);
    TEST_ASSERT_EQUAL_MEMORY(packet, again, sizeof packet);
  }
}

/* Step by step, a division comes to an end. */
static void test_division_of_any_deployment_ends(void) {
  for (unsigned number = 0; number < 100; number++) {
    test_random random;
    qtr_deployment deployment;
    qtr_division division;
    qtr_places cleared;
    open_random("division", number, &random);
    for (unsigned w = 0; w < QTR_PLACE_WORDS; w++) cleared.word[w] = (uint32_t)random_bits(&random);
    TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_deployment_init(&deployment, &policy, NULL, &cleared));
    for (unsigned i = 0; i < policy.board.seekers; i++)
      deployment.start_of[i] = (uint16_t)random_below(&random, policy.board.starts);
    TEST_ASSERT_EQUAL_HEX32(qtr_deployment_identity(&deployment, &policy),
                            qtr_deployment_identity(&deployment, &policy));
    qtr_division_begin(&division, &policy, &deployment);
    unsigned plays = 0;
    while (qtr_division_play(&division, &policy)) plays++;
    TEST_ASSERT_FALSE(qtr_division_play(&division, &policy));
    TEST_ASSERT_LESS_OR_EQUAL_MESSAGE(QTR_MAX_MOVES, division.moves, case_note);
    TEST_ASSERT_LESS_OR_EQUAL_MESSAGE(plays, division.moves, case_note);
    qtr_seeker seeker;
    TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_seeker_init(&seeker, &policy, 0, &deployment, 0));
    for (unsigned calls = 0; calls < plays; calls++) TEST_ASSERT_TRUE(qtr_seeker_plan(&seeker));
    TEST_ASSERT_FALSE(qtr_seeker_plan(&seeker));
    qtr_seeker_found(&seeker);
    TEST_ASSERT_EQUAL(QTR_STANDS_FOUND, qtr_seeker_standing(&seeker));
    TEST_ASSERT_EQUAL_UINT32(0, qtr_seeker_foreign(&seeker));
  }
}

static int64_t any_angle(test_random *random, int64_t most) {
  return (int64_t)random_below(random, 2u * (uint32_t)(most / QTR_GEO_ONE) + 1u) * QTR_GEO_ONE - most;
}

/* Given or not. */
static qtr_geo any_origin(test_random *random) {
  if (random_chance(random, 50)) return (qtr_geo){0};
  return (qtr_geo){true, any_angle(random, 90 * QTR_GEO_ONE), any_angle(random, 180 * QTR_GEO_ONE),
                   any_angle(random, 6 * QTR_GEO_ONE)};
}

static bool is_same_origin(const qtr_geo *a, const qtr_geo *b) {
  return a->given == b->given && a->latitude == b->latitude && a->longitude == b->longitude && a->yaw == b->yaw;
}

/* A name of any bytes, or none; with `more`, one that fills its array and so has no end. */
static void any_name(test_random *random, char *name, uint32_t room, bool more) {
  const uint32_t length = random_chance(random, 70) ? random_below(random, more ? room + 1 : room) : 0;
  memset(name, 0, room);
  for (uint32_t i = 0; i < length; i++) name[i] = (char)random_in(random, 1, 255);
}

static void any_names(test_random *random, qtr_names *names, bool more) {
  memset(names, 0, sizeof *names);
  any_name(random, names->mission, QTR_NAME_BYTES, more);
  for (unsigned i = 0; i < 3; i++) {
    const unsigned place = random_below(random, QTR_MAX_PLACES), seeker = random_below(random, QTR_MAX_SEEKERS);
    any_name(random, names->place[place], QTR_SITE_NAME_BYTES, more);
    any_name(random, names->seeker[seeker], QTR_SITE_NAME_BYTES, more);
  }
}

/* What a table keeps of the names: those that end. */
static void drop_endless(qtr_names *names) {
  if (memchr(names->mission, 0, QTR_NAME_BYTES) == NULL) memset(names->mission, 0, QTR_NAME_BYTES);
  for (unsigned i = 0; i < QTR_MAX_PLACES; i++)
    if (memchr(names->place[i], 0, QTR_SITE_NAME_BYTES) == NULL) memset(names->place[i], 0, QTR_SITE_NAME_BYTES);
  for (unsigned i = 0; i < QTR_MAX_SEEKERS; i++)
    if (memchr(names->seeker[i], 0, QTR_SITE_NAME_BYTES) == NULL) memset(names->seeker[i], 0, QTR_SITE_NAME_BYTES);
}

static void expect_ends(const qtr_names *names) {
  TEST_ASSERT_NOT_NULL(memchr(names->mission, 0, QTR_NAME_BYTES));
  for (unsigned i = 0; i < QTR_MAX_PLACES; i++) TEST_ASSERT_NOT_NULL(memchr(names->place[i], 0, QTR_SITE_NAME_BYTES));
  for (unsigned i = 0; i < QTR_MAX_SEEKERS; i++) TEST_ASSERT_NOT_NULL(memchr(names->seeker[i], 0, QTR_SITE_NAME_BYTES));
}

/* Behind the robot's part: names of any bytes and length, with an origin or without, whole and damaged. */
static void test_names_of_any_bytes(void) {
  static qtr_names names, read;
  for (unsigned number = 0; number < 2000; number++) {
    test_random random = random_case("names", number);
    uint8_t bytes[QTR_NAME_BYTES + 80 + 6 * (QTR_SITE_NAME_BYTES + 8)];
    qtr_geo geo = any_origin(&random), read_geo;
    any_names(&random, &names, random_chance(&random, 20));
    const uint32_t size = qtr_names_size(&names, &geo);
    TEST_ASSERT_LESS_OR_EQUAL_UINT(sizeof bytes, size);
    qtr_names_write(bytes, &names, &geo);
    drop_endless(&names);
    TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_names_read(&read, &read_geo, bytes, size));
    TEST_ASSERT_EQUAL_MEMORY(&names, &read, sizeof names);
    TEST_ASSERT_TRUE(is_same_origin(&geo, &read_geo));
    if (size == 0) continue;
    bytes[random_below(&random, size)] ^= (uint8_t)random_in(&random, 1, 255);
    if (random_chance(&random, 50)) qtr_store32(bytes + 12, qtr_crc32_add(0, bytes + 16, size - 16));
    const int status =
        qtr_names_read(&read, &read_geo, bytes, random_chance(&random, 80) ? size : random_in(&random, 1, size));
    TEST_ASSERT_TRUE(status == QTR_OK || status == QTR_ERR_CORRUPT);
    expect_ends(&read);
  }
}

/* Cut anywhere, or with any one bit flipped: the sum, the size, the magic or the version tells. */
static void test_names_that_are_torn_are_refused(void) {
  static qtr_names names, read;
  for (unsigned number = 0; number < 20; number++) {
    test_random random = random_case("torn names", number);
    uint8_t bytes[QTR_NAME_BYTES + 80 + 6 * (QTR_SITE_NAME_BYTES + 8)];
    qtr_geo geo = any_origin(&random), read_geo;
    any_names(&random, &names, false);
    const uint32_t size = qtr_names_size(&names, &geo);
    qtr_names_write(bytes, &names, &geo);
    for (uint32_t cut = 1; cut < size; cut++)
      TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_ERR_CORRUPT, qtr_names_read(&read, &read_geo, bytes, cut), case_note);
    for (uint32_t bit = 0; bit < 8 * size; bit++) {
      bytes[bit / 8] ^= (uint8_t)(1u << bit % 8);
      TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_ERR_CORRUPT, qtr_names_read(&read, &read_geo, bytes, size), case_note);
      bytes[bit / 8] ^= (uint8_t)(1u << bit % 8);
    }
  }
}

/* The entry of a place or a seeker that this build cannot hold, of no name, or of one too long, is damage. */
static void test_names_of_nobody_are_damage(void) {
  static const struct {
    uint16_t what, length, index;
  } entries[] = {
      {3, 3, QTR_MAX_PLACES}, {4, 3, QTR_MAX_SEEKERS}, {3, 2, 0}, {4, 1, 0}, {3, 2 + QTR_SITE_NAME_BYTES, 0}};
  static qtr_names read;
  qtr_geo geo;
  for (unsigned i = 0; i < sizeof entries / sizeof entries[0]; i++) {
    uint8_t bytes[30 + QTR_SITE_NAME_BYTES] = "QTRH";
    const uint32_t size = 16u + 4u + entries[i].length;
    memset(bytes + 20, 'x', sizeof bytes - 20);
    qtr_store16(bytes + 4, 1);
    qtr_store32(bytes + 8, size);
    qtr_store16(bytes + 16, entries[i].what);
    qtr_store16(bytes + 18, entries[i].length);
    qtr_store16(bytes + 20, entries[i].index);
    qtr_store32(bytes + 12, qtr_crc32_add(0, bytes + 16, size - 16));
    TEST_ASSERT_EQUAL_INT(QTR_ERR_CORRUPT, qtr_names_read(&read, &geo, bytes, size));
  }
}

/* An origin that lies nowhere on the globe is none, whatever its checksum says. */
static void test_origins_off_the_globe_are_damage(void) {
  static const qtr_geo off[] = {{true, 90 * QTR_GEO_ONE + 1, 0, 0},
                                {true, 0, -180 * QTR_GEO_ONE - 1, 0},
                                {true, 0, 0, QTR_GEO_TURN + 1},
                                {true, INT64_MIN, 0, 0}};
  static const qtr_geo corner = {true, -90 * QTR_GEO_ONE, 180 * QTR_GEO_ONE, QTR_GEO_TURN};
  static const qtr_names none;
  static qtr_names names;
  uint8_t bytes[64];
  qtr_geo read;
  qtr_names_write(bytes, &none, &corner);
  TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_names_read(&names, &read, bytes, qtr_names_size(&none, &corner)));
  for (unsigned i = 0; i < sizeof off / sizeof off[0]; i++) {
    qtr_names_write(bytes, &none, &off[i]);
    TEST_ASSERT_EQUAL_INT(QTR_ERR_CORRUPT, qtr_names_read(&names, &read, bytes, qtr_names_size(&none, &off[i])));
  }
}

static void test_tables_say_what_they_are_of(void) {
  for (unsigned number = 0; number < 60; number++) {
    test_random random;
    qtr_claim claim;
    qtr_deployment home;
    qtr_box box = {0, 0, 0, 0};
    open_random("claims", number, &random);
    TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_policy_check(&policy));
    qtr_claim_read(&claim, &policy);
    const unsigned place = any_number(&random, policy.board.places);
    TEST_ASSERT_EQUAL_UINT(place, qtr_claim_number(&claim, &policy, place));
    qtr_deployment_home(&home, &policy);
    for (unsigned i = 0; i < policy.board.seekers; i++)
      TEST_ASSERT_EQUAL_UINT16(policy.board.start_of[i], home.start_of[i]);
    TEST_ASSERT_EQUAL_HEX32(qtr_load32(table_bytes + QTR_POLICY_DIGEST), qtr_policy_digest(&policy));
    const qtr_frame frame = qtr_policy_frame(&policy);
    TEST_ASSERT_TRUE(qtr_frame_is_one(&frame));
    for (unsigned cells = 0; cells < 5; cells++)
      qtr_box_add(&box, &policy.grid, (qtr_cell)random_below(&random, qtr_grid_cells(&policy.grid)));
    TEST_ASSERT_TRUE(box.left < box.right && box.right <= policy.grid.columns);
    TEST_ASSERT_TRUE(box.top < box.bottom && box.bottom <= policy.grid.rows);
  }
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_executor_takes_any_words);
  RUN_TEST(test_signal_of_any_bytes);
  RUN_TEST(test_division_of_any_deployment_ends);
  RUN_TEST(test_names_of_any_bytes);
  RUN_TEST(test_names_that_are_torn_are_refused);
  RUN_TEST(test_names_of_nobody_are_damage);
  RUN_TEST(test_origins_off_the_globe_are_damage);
  RUN_TEST(test_tables_say_what_they_are_of);
  return UNITY_END();
}

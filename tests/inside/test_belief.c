/* profiles: host mcu */
/* The estimate of where targets are, against closed forms; and its bytes, whole or refused. */
#include <math.h>
#include <string.h>

#include "core/bytes.h"
#include "core/crc.h"
#include "quarter/belief.h"
#include "quarter/status.h"
#include "support/random.h"
#include "unity.h"

#define NEAR 1e-12

static qtr_belief belief, other;
static qtr_search search;
static double estimate[QTR_MAX_PLACES];
static uint8_t bytes[QTR_BELIEF_BYTES(QTR_MAX_PLACES) + 8], damaged[sizeof bytes];

void setUp(void) {
  memset(&belief, 0xA5, sizeof belief);
}

void tearDown(void) {
}

static void begin(unsigned places, const double *weights, double strength, double keep) {
  TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_belief_init(&belief, places, weights, strength, keep));
  qtr_search_begin(&search, &belief);
}

static void find(unsigned place) {
  qtr_belief_begin_game(&belief);
  TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_belief_found(&belief, place));
}

static void expect_estimate(const double *expected) {
  double sum = 0.0;
  qtr_belief_estimate(&belief, estimate);
  for (unsigned p = 0; p < belief.places; p++) {
    TEST_ASSERT_DOUBLE_WITHIN(NEAR, expected[p], estimate[p]);
    sum += estimate[p];
  }
  TEST_ASSERT_DOUBLE_WITHIN(NEAR, 1.0, sum);
}

/* ---- over the games: the mean of a Dirichlet distribution ---- */

static void test_a_prior_alone_is_the_estimate(void) {
  begin(4, NULL, 2.0, 1.0);
  expect_estimate((double[]){0.25, 0.25, 0.25, 0.25});
  begin(3, (double[]){1, 2, 5}, 100.0, 1.0);
  expect_estimate((double[]){0.125, 0.25, 0.625});
}

static void test_finds_shift_the_estimate_to_the_dirichlet_mean(void) {
  begin(3, NULL, 3.0, 1.0); /* Laplace: one pseudo-find a place */
  find(2);
  find(2);
  find(0);
  expect_estimate((double[]){2.0 / 6, 1.0 / 6, 3.0 / 6});
  TEST_ASSERT_EQUAL_UINT32(3, belief.games);
}

static void test_a_strong_prior_yields_slower_than_a_weak_one(void) {
  begin(2, (double[]){3, 1}, 96.0, 1.0);
  for (int i = 0; i < 4; i++) find(1);
  expect_estimate((double[]){0.72, 0.28}); /* (72 + 0, 24 + 4) / 100 */
  begin(2, (double[]){3, 1}, 4.0, 1.0);
  for (int i = 0; i < 4; i++) find(1);
  expect_estimate((double[]){0.375, 0.625}); /* (3, 1 + 4) / 8 */
}

static void test_a_game_with_two_targets_counts_both(void) {
  begin(2, NULL, 2.0, 1.0);
  find(0);
  TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_belief_found(&belief, 1));
  expect_estimate((double[]){0.5, 0.5});
  TEST_ASSERT_EQUAL_UINT32(1, belief.games);
}

static void test_old_finds_fade_and_the_prior_does_not(void) {
  begin(2, NULL, 2.0, 0.5);
  find(0);
  find(0);
  find(1); /* place 0: 1 -> 0.5 + 1 -> 0.75; place 1: 1 */
  expect_estimate((double[]){1.75 / 3.75, 2.0 / 3.75});
  for (int i = 0; i < 200; i++) qtr_belief_begin_game(&belief);
  expect_estimate((double[]){0.5, 0.5});
}

static void test_the_estimate_comes_to_the_true_distribution(void) {
  static const double truth[5] = {0.4, 0.3, 0.2, 0.07, 0.03};
  test_random random = random_case("a hider's habits", 1);
  begin(5, NULL, 2.5, 1.0);
  for (int game = 0; game < 20000; game++) {
    double left = random_unit(&random);
    unsigned place = 0;
    while (place < 4 && left >= truth[place]) left -= truth[place++];
    find(place);
  }
  qtr_belief_estimate(&belief, estimate);
  for (unsigned p = 0; p < 5; p++) TEST_ASSERT_DOUBLE_WITHIN_MESSAGE(0.02, truth[p], estimate[p], case_note);
}

/* ---- within a game: Bayes' rule ---- */

static void expect_posterior(double evidence, const double *expected) {
  TEST_ASSERT_DOUBLE_WITHIN(NEAR, evidence, qtr_search_posterior(&search, &belief, estimate));
  for (unsigned p = 0; p < belief.places; p++) TEST_ASSERT_DOUBLE_WITHIN(NEAR, expected[p], estimate[p]);
}

static void search_empty(unsigned place, double detection) {
  TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_search_empty(&search, place, detection));
}

static void test_before_a_search_the_posterior_is_the_estimate(void) {
  begin(2, (double[]){1, 3}, 1.0, 1.0);
  expect_posterior(1.0, (double[]){0.25, 0.75});
}

static void test_an_empty_place_leaves_its_share_to_the_others(void) {
  begin(3, (double[]){5, 3, 2}, 10.0, 1.0);
  search_empty(0, 1.0);
  expect_posterior(0.5, (double[]){0.0, 0.6, 0.4});
  search_empty(2, 1.0);
  expect_posterior(0.3, (double[]){0.0, 1.0, 0.0});
}

static void test_a_sensor_that_may_fail_leaves_some_of_it(void) {
  begin(2, (double[]){1, 1}, 2.0, 1.0);
  search_empty(0, 0.8); /* 0.5 * 0.2 against 0.5 */
  expect_posterior(0.6, (double[]){1.0 / 6, 5.0 / 6});
  search_empty(0, 0.8); /* 0.5 * 0.04 against 0.5 */
  expect_posterior(0.52, (double[]){1.0 / 26, 25.0 / 26});
  search_empty(1, 0.0); /* a blind sensor says nothing */
  expect_posterior(0.52, (double[]){1.0 / 26, 25.0 / 26});
}

static void test_all_places_empty_is_no_posterior(void) {
  begin(2, NULL, 1.0, 1.0);
  search_empty(0, 1.0);
  search_empty(1, 1.0);
  expect_posterior(0.0, (double[]){0.0, 0.0});
  other = belief;
  TEST_ASSERT_EQUAL_INT(QTR_ERR_ARGUMENT, qtr_belief_not_found(&belief, &search));
  TEST_ASSERT_EQUAL_MEMORY(&other, &belief, sizeof belief);
}

static void test_a_game_without_a_find_counts_as_its_posterior(void) {
  begin(3, (double[]){1, 1, 2}, 4.0, 1.0);
  qtr_belief_begin_game(&belief);
  search_empty(2, 1.0);
  TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_belief_not_found(&belief, &search));
  expect_estimate((double[]){1.5 / 5, 1.5 / 5, 2.0 / 5});
}

/* The mean of the mixture of Dirichlets that is the exact answer: for each place where the target may have been, the
 * distribution after a find there, weighted by how likely that is. */
static void test_the_mean_after_a_game_without_a_find_is_exact(void) {
  const double alpha[3] = {0.5, 2.0, 4.5}, missed[3] = {0.1, 1.0, 0.6};
  double weight[3], sum = 0.0, mean[3] = {0, 0, 0};
  begin(3, alpha, 7.0, 1.0);
  for (unsigned p = 0; p < 3; p++) search_empty(p, 1.0 - missed[p]);
  for (unsigned z = 0; z < 3; z++) sum += weight[z] = alpha[z] * missed[z];
  for (unsigned z = 0; z < 3; z++)
    for (unsigned p = 0; p < 3; p++) mean[p] += weight[z] / sum * (alpha[p] + (p == z)) / 8.0;
  TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_belief_not_found(&belief, &search));
  expect_estimate(mean);
}

static void test_found_and_empty_in_turn(void) {
  begin(2, NULL, 2.0, 1.0);
  find(0);
  find(0); /* 3, 1 */
  search_empty(0, 0.5);
  expect_posterior(0.625, (double[]){0.6, 0.4}); /* 1.5 : 1 */
  qtr_belief_begin_game(&belief);
  TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_belief_not_found(&belief, &search));
  expect_estimate((double[]){3.6 / 5, 1.4 / 5});
  find(1);
  expect_estimate((double[]){3.6 / 6, 2.4 / 6});
}

/* ---- against all worlds, one by one ---- */

/* A world is where each game's target is, drawn as from Polya's urn, and which of the looks saw it. */
enum { WORLD_PLACES = 3, WORLD_GAMES = 3, WORLD_LOOKS = 5 };

typedef struct {
  double alpha[WORLD_PLACES], detection[WORLD_PLACES];
  unsigned found[WORLD_GAMES];  /* where the first games' targets were found */
  unsigned looked[WORLD_LOOKS]; /* the last game's looks, all in vain */
} world_case;

static world_case make_worlds(test_random *random) {
  world_case c;
  for (unsigned p = 0; p < WORLD_PLACES; p++) {
    c.alpha[p] = 0.2 + 3.0 * random_unit(random);
    c.detection[p] = 0.1 + 0.8 * random_unit(random);
  }
  for (unsigned g = 0; g < WORLD_GAMES; g++) c.found[g] = random_below(random, WORLD_PLACES);
  for (unsigned l = 0; l < WORLD_LOOKS; l++) c.looked[l] = random_below(random, WORLD_PLACES);
  return c;
}

/* How likely it is that the urn gives the games' targets, in their order. */
static double urn_chance(const world_case *c, const unsigned *targets, unsigned games) {
  double chance = 1.0, all = 0.0, counts[WORLD_PLACES];
  for (unsigned p = 0; p < WORLD_PLACES; p++) all += counts[p] = c->alpha[p];
  for (unsigned g = 0; g < games; g++) {
    chance *= counts[targets[g]] / (all + g);
    counts[targets[g]] += 1.0;
  }
  return chance;
}

/* Of all ways that the looks may go, those in which nothing is seen. */
static double unseen_chance(const world_case *c, unsigned target) {
  double unseen = 0.0;
  for (unsigned saw = 0; saw < 1u << WORLD_LOOKS; saw++) {
    double chance = 1.0;
    for (unsigned l = 0; l < WORLD_LOOKS; l++) {
      const double sees = c->looked[l] == target ? c->detection[target] : 0.0;
      chance *= (saw >> l & 1u) != 0 ? sees : 1.0 - sees;
    }
    if (saw == 0) unseen += chance;
  }
  return unseen;
}

/* P(target of the last game), and P(target of the game after it), given all that was seen. */
static void weigh_worlds(const world_case *c, double *last, double *next) {
  double sum = 0.0;
  unsigned targets[WORLD_GAMES + 2];
  memcpy(targets, c->found, sizeof c->found);
  for (unsigned p = 0; p < WORLD_PLACES; p++) last[p] = next[p] = 0.0;
  for (unsigned hidden = 0; hidden < WORLD_PLACES; hidden++)
    for (unsigned after = 0; after < WORLD_PLACES; after++) {
      targets[WORLD_GAMES] = hidden;
      targets[WORLD_GAMES + 1] = after;
      const double chance = urn_chance(c, targets, WORLD_GAMES + 2) * unseen_chance(c, hidden);
      last[hidden] += chance;
      next[after] += chance;
      sum += chance;
    }
  for (unsigned p = 0; p < WORLD_PLACES; p++) {
    last[p] /= sum;
    next[p] /= sum;
  }
}

static void test_posterior_and_estimate_are_those_of_all_worlds_with_sensors_that_miss(void) {
  for (unsigned number = 0; number < random_cases(300); number++) {
    test_random random = random_case("worlds", number);
    const world_case c = make_worlds(&random);
    double last[WORLD_PLACES], next[WORLD_PLACES], posterior[QTR_MAX_PLACES], sum = 0.0;
    for (unsigned p = 0; p < WORLD_PLACES; p++) sum += c.alpha[p];
    begin(WORLD_PLACES, c.alpha, sum, 1.0);
    for (unsigned g = 0; g < WORLD_GAMES; g++) find(c.found[g]);
    for (unsigned l = 0; l < WORLD_LOOKS; l++) search_empty(c.looked[l], c.detection[c.looked[l]]);
    weigh_worlds(&c, last, next);
    qtr_search_posterior(&search, &belief, posterior);
    for (unsigned p = 0; p < WORLD_PLACES; p++)
      TEST_ASSERT_DOUBLE_WITHIN_MESSAGE(NEAR, last[p], posterior[p], case_note);
    qtr_belief_begin_game(&belief);
    TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_OK, qtr_belief_not_found(&belief, &search), case_note);
    expect_estimate(next);
  }
}

/* ---- refusals ---- */

static void expect_refusal(int status, unsigned places, const double *weights, double strength, double keep) {
  TEST_ASSERT_EQUAL_INT(status, qtr_belief_init(&belief, places, weights, strength, keep));
}

static void test_beginnings_out_of_range_are_refused(void) {
  expect_refusal(QTR_ERR_ARGUMENT, 0, NULL, 1.0, 1.0);
  expect_refusal(QTR_ERR_LIMIT, QTR_MAX_PLACES + 1, NULL, 1.0, 1.0);
  expect_refusal(QTR_ERR_ARGUMENT, 2, NULL, 0.0, 1.0);
  expect_refusal(QTR_ERR_ARGUMENT, 2, NULL, 2e15, 1.0);
  expect_refusal(QTR_ERR_ARGUMENT, 2, NULL, (double)NAN, 1.0);
  expect_refusal(QTR_ERR_ARGUMENT, 2, NULL, 1e-100, 1.0);
  expect_refusal(QTR_ERR_ARGUMENT, 2, NULL, 1.0, 0.0);
  expect_refusal(QTR_ERR_ARGUMENT, 2, NULL, 1.0, 1.1);
  expect_refusal(QTR_ERR_WEIGHT, 2, (double[]){1, 0}, 1.0, 1.0);
  expect_refusal(QTR_ERR_WEIGHT, 2, (double[]){1, (double)NAN}, 1.0, 1.0);
  expect_refusal(QTR_ERR_WEIGHT, 2, (double[]){1, 1e-101}, 1.0, 1.0);
  TEST_ASSERT_EQUAL_INT(QTR_ERR_CONFIG, qtr_belief_init_sized(&belief, 2, NULL, 1.0, 1.0, QTR_CONFIG_ID + 1u));
}

static void test_weights_whose_sum_is_too_large_for_a_double_still_divide(void) {
  begin(3, (double[]){1e308, 1e308, 1e308}, 3.0, 1.0);
  expect_estimate((double[]){1.0 / 3, 1.0 / 3, 1.0 / 3});
}

static void test_places_and_sensors_that_are_none_are_refused(void) {
  begin(2, NULL, 1.0, 1.0);
  TEST_ASSERT_EQUAL_INT(QTR_ERR_ARGUMENT, qtr_belief_found(&belief, 2));
  TEST_ASSERT_EQUAL_INT(QTR_ERR_ARGUMENT, qtr_search_empty(&search, 2, 1.0));
  TEST_ASSERT_EQUAL_INT(QTR_ERR_ARGUMENT, qtr_search_empty(&search, 0, 1.5));
  TEST_ASSERT_EQUAL_INT(QTR_ERR_ARGUMENT, qtr_search_empty(&search, 0, -0.5));
  TEST_ASSERT_EQUAL_INT(QTR_ERR_ARGUMENT, qtr_search_empty(&search, 0, (double)NAN));
  belief.found[1] = QTR_BELIEF_MOST;
  TEST_ASSERT_EQUAL_INT(QTR_ERR_LIMIT, qtr_belief_found(&belief, 1));
}

/* ---- bytes ---- */

static int save_some(unsigned places) {
  begin(places, NULL, 1.5, 0.875);
  belief.about = 0xCAFE1234u;
  find(0);
  find(places - 1);
  qtr_belief_begin_game(&belief);
  search_empty(0, 0.5);
  TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_belief_not_found(&belief, &search));
  const int size = qtr_belief_save(&belief, bytes, sizeof bytes);
  TEST_ASSERT_EQUAL_INT((int)QTR_BELIEF_BYTES(places), size);
  return size;
}

static void test_what_is_saved_is_loaded(void) {
  const unsigned sizes[] = {1, 3, QTR_MAX_PLACES};
  for (unsigned i = 0; i < 3; i++) {
    const int size = save_some(sizes[i]);
    memset(&other, 0x5A, sizeof other);
    TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_belief_load(&other, bytes, (uint32_t)size));
    TEST_ASSERT_EQUAL_UINT(belief.places, other.places);
    TEST_ASSERT_EQUAL_HEX32(belief.about, other.about);
    TEST_ASSERT_EQUAL_UINT32(3, other.games);
    TEST_ASSERT_EQUAL_DOUBLE(0.875, other.keep);
    TEST_ASSERT_EQUAL_MEMORY(belief.prior, other.prior, belief.places * sizeof *belief.prior);
    TEST_ASSERT_EQUAL_MEMORY(belief.found, other.found, belief.places * sizeof *belief.found);
  }
}

/* One place, one pseudo-find, one find in one game: every byte worked out by hand, the checksum apart. */
static void test_the_bytes_are_those_of_the_format(void) {
  static const uint8_t expected[56] = {'Q',  'T',  'R', 'B', 1, 0, 40, 0, 56, 0,  0, 0, 0, 0, 0, 0, 1,    0,   0,
                                       0,    4,    3,   2,   1, 1, 0,  0, 0,  0,  0, 0, 0, 0, 0, 0, 0,    0,   0,
                                       0xF0, 0x3F, 0,   0,   0, 0, 0,  0, 0,  64, 0, 0, 0, 0, 0, 0, 0xF0, 0x3F};
  begin(1, NULL, 2.0, 1.0);
  belief.about = 0x01020304u;
  find(0);
  TEST_ASSERT_EQUAL_INT(56, qtr_belief_save(&belief, bytes, sizeof bytes));
  TEST_ASSERT_EQUAL_HEX32(qtr_crc32_add(0, bytes + 16, 40), qtr_load32(bytes + 12));
  memset(bytes + 12, 0, 4);
  TEST_ASSERT_EQUAL_MEMORY(expected, bytes, sizeof expected);
}

static void test_too_little_room_to_save_is_told(void) {
  const int size = save_some(3);
  TEST_ASSERT_EQUAL_INT(size, qtr_belief_save(&belief, bytes, (uint32_t)size));
  TEST_ASSERT_EQUAL_INT(QTR_ERR_SPACE, qtr_belief_save(&belief, bytes, (uint32_t)size - 1));
}

static int load_damaged(uint32_t size) {
  other = belief;
  const int status = qtr_belief_load(&belief, damaged, size);
  if (status != QTR_OK) TEST_ASSERT_EQUAL_MEMORY_MESSAGE(&other, &belief, sizeof belief, "changed by a refused load");
  return status;
}

static void test_every_truncation_is_refused(void) {
  const int size = save_some(3);
  memcpy(damaged, bytes, sizeof bytes);
  for (int cut = 0; cut < size; cut++) TEST_ASSERT_EQUAL_INT(QTR_ERR_TRUNCATED, load_damaged((uint32_t)cut));
  TEST_ASSERT_EQUAL_INT(QTR_ERR_CORRUPT, load_damaged((uint32_t)size + 1));
  TEST_ASSERT_EQUAL_INT(QTR_OK, load_damaged((uint32_t)size));
}

static int expected_of_flip(unsigned byte) {
  if (byte < QTR_BELIEF_VERSION) return QTR_ERR_MAGIC;
  if (byte < QTR_BELIEF_HEADER) return QTR_ERR_FORMAT;
  return byte < QTR_BELIEF_SIZE ? QTR_ERR_CORRUPT : QTR_ERR_CHECKSUM;
}

static void test_every_flipped_bit_is_refused(void) {
  const int size = save_some(3);
  for (int bit = 0; bit < 8 * size; bit++) {
    const unsigned byte = (unsigned)bit / 8;
    memcpy(damaged, bytes, sizeof bytes);
    damaged[byte] ^= (uint8_t)(1u << bit % 8);
    const int status = load_damaged((uint32_t)size);
    if (byte >= QTR_BELIEF_SIZE && byte < QTR_BELIEF_CRC)
      TEST_ASSERT_TRUE(status == QTR_ERR_TRUNCATED || status == QTR_ERR_CORRUPT);
    else
      TEST_ASSERT_EQUAL_INT(expected_of_flip(byte), status);
  }
}

static void expect_forged(int status, uint32_t at, const void *value, uint32_t length) {
  const int size = save_some(2);
  memcpy(damaged, bytes, sizeof bytes);
  memcpy(damaged + at, value, length);
  qtr_store32(damaged + QTR_BELIEF_CRC,
              qtr_crc32_add(0, damaged + QTR_BELIEF_PLACES, (uint32_t)size - QTR_BELIEF_PLACES));
  TEST_ASSERT_EQUAL_INT(status, load_damaged((uint32_t)size));
}

static void expect_forged_double(uint32_t at, double value) {
  uint64_t bits;
  uint8_t stored[8];
  memcpy(&bits, &value, sizeof bits);
  qtr_store64(stored, bits);
  expect_forged(QTR_ERR_CORRUPT, at, stored, 8);
}

/* With a checksum that fits: what a faulty program might have written. */
static void test_numbers_out_of_range_are_refused(void) {
  const double wrong[] = {-1.0, 2e15, (double)NAN, (double)INFINITY};
  for (unsigned i = 0; i < 4; i++)
    for (uint32_t at = QTR_BELIEF_KEEP; at < QTR_BELIEF_BYTES(2); at += 8) expect_forged_double(at, wrong[i]);
  expect_forged_double(QTR_BELIEF_KEEP, 0.0);
  expect_forged_double(QTR_BELIEF_HEADER_BYTES, 0.0);
  expect_forged(QTR_ERR_CORRUPT, QTR_BELIEF_PLACES, "\0", 1);
  expect_forged(QTR_ERR_CORRUPT, QTR_BELIEF_PLACES, "\3", 1);
  expect_forged(QTR_ERR_CORRUPT, QTR_BELIEF_PLACES + 2, "\1", 1);
  expect_forged(QTR_ERR_CORRUPT, QTR_BELIEF_GAMES + 4, "\1", 1);
}

static void test_more_places_than_the_build_holds_are_refused(void) {
  const uint32_t size = QTR_BELIEF_BYTES(QTR_MAX_PLACES + 1u);
  static uint8_t large[QTR_BELIEF_BYTES(QTR_MAX_PLACES + 1u)];
  const double one = 1.0;
  save_some(1);
  memcpy(large, bytes, QTR_BELIEF_HEADER_BYTES);
  qtr_store32(large + QTR_BELIEF_SIZE, size);
  qtr_store16(large + QTR_BELIEF_PLACES, QTR_MAX_PLACES + 1);
  for (uint32_t at = QTR_BELIEF_HEADER_BYTES; at < size; at += 8) memcpy(large + at, &one, sizeof one);
  qtr_store32(large + QTR_BELIEF_CRC, qtr_crc32_add(0, large + QTR_BELIEF_PLACES, size - QTR_BELIEF_PLACES));
  TEST_ASSERT_EQUAL_INT(QTR_ERR_LIMIT, qtr_belief_load(&belief, large, size));
}

static void test_another_build_s_sizes_are_refused(void) {
  const int size = save_some(2);
  TEST_ASSERT_EQUAL_INT(QTR_ERR_CONFIG, qtr_belief_load_sized(&other, bytes, (uint32_t)size, QTR_CONFIG_ID + 1u));
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_a_prior_alone_is_the_estimate);
  RUN_TEST(test_finds_shift_the_estimate_to_the_dirichlet_mean);
  RUN_TEST(test_a_strong_prior_yields_slower_than_a_weak_one);
  RUN_TEST(test_a_game_with_two_targets_counts_both);
  RUN_TEST(test_old_finds_fade_and_the_prior_does_not);
  RUN_TEST(test_the_estimate_comes_to_the_true_distribution);
  RUN_TEST(test_before_a_search_the_posterior_is_the_estimate);
  RUN_TEST(test_an_empty_place_leaves_its_share_to_the_others);
  RUN_TEST(test_a_sensor_that_may_fail_leaves_some_of_it);
  RUN_TEST(test_all_places_empty_is_no_posterior);
  RUN_TEST(test_a_game_without_a_find_counts_as_its_posterior);
  RUN_TEST(test_the_mean_after_a_game_without_a_find_is_exact);
  RUN_TEST(test_found_and_empty_in_turn);
  RUN_TEST(test_posterior_and_estimate_are_those_of_all_worlds_with_sensors_that_miss);
  RUN_TEST(test_beginnings_out_of_range_are_refused);
  RUN_TEST(test_weights_whose_sum_is_too_large_for_a_double_still_divide);
  RUN_TEST(test_places_and_sensors_that_are_none_are_refused);
  RUN_TEST(test_what_is_saved_is_loaded);
  RUN_TEST(test_the_bytes_are_those_of_the_format);
  RUN_TEST(test_too_little_room_to_save_is_told);
  RUN_TEST(test_every_truncation_is_refused);
  RUN_TEST(test_every_flipped_bit_is_refused);
  RUN_TEST(test_numbers_out_of_range_are_refused);
  RUN_TEST(test_more_places_than_the_build_holds_are_refused);
  RUN_TEST(test_another_build_s_sizes_are_refused);
  return UNITY_END();
}

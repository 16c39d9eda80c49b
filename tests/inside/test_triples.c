/* Triples that a mixture of routes breaks, against a look at all triples. */
#include <stdlib.h>

#include "search/triples.h"
#include "support/random.h"
#include "unity.h"

#define PLACES 9u
#define ROUTES 12u

static qtr_label *label[ROUTES];
static const qtr_label *route[ROUTES];
static double share[ROUTES];

void setUp(void) {
  for (unsigned i = 0; i < ROUTES; i++) label[i] = calloc(1, sizeof *label[i] + sizeof label[i]->set[0]);
}

void tearDown(void) {
  for (unsigned i = 0; i < ROUTES; i++) free(label[i]);
}

static uint32_t *set_of(unsigned i) {
  return label[i]->set;
}

/* Routes in shares, no place on more than one route in all. */
static qtr_mixture draw(test_random *random) {
  double left[PLACES];
  qtr_mixture mixture = {0, route, share};
  for (unsigned place = 0; place < PLACES; place++) left[place] = 1.0;
  for (unsigned i = 0; i < ROUTES; i++) {
    double most = 0.5;
    *set_of(i) = random_in(random, 1, (1u << PLACES) - 1) & random_in(random, 1, (1u << PLACES) - 1);
    for (unsigned place = 0; place < PLACES; place++)
      if (*set_of(i) >> place & 1u && left[place] < most) most = left[place];
    for (unsigned place = 0; place < PLACES; place++)
      if (*set_of(i) >> place & 1u) left[place] -= most;
    if (most <= 0.0) continue;
    route[mixture.count] = label[i];
    share[mixture.count++] = most;
  }
  return mixture;
}

static unsigned count_of(unsigned set, const unsigned *place) {
  return (set >> place[0] & 1u) + (set >> place[1] & 1u) + (set >> place[2] & 1u);
}

static double excess_of(const qtr_mixture *mixture, const unsigned *place) {
  double sum = -1.0;
  for (unsigned i = 0; i < mixture->count; i++)
    if (count_of(mixture->route[i]->set[0], place) >= 2) sum += mixture->share[i];
  return sum;
}

static double most_excess(const qtr_mixture *mixture) {
  double most = -1.0;
  for (unsigned a = 0; a < PLACES; a++)
    for (unsigned b = a + 1; b < PLACES; b++)
      for (unsigned c = b + 1; c < PLACES; c++) {
        const double excess = excess_of(mixture, (unsigned[]){a, b, c});
        if (excess > most) most = excess;
      }
  return most;
}

static void test_the_triple_that_is_broken_most_is_found_first(void) {
  unsigned broken = 0;
  for (unsigned number = 0; number < 500; number++) {
    test_random random = random_case("mixtures", number);
    const qtr_mixture mixture = draw(&random);
    qtr_triple triple[4];
    const double most = most_excess(&mixture);
    const unsigned found = qtr_triples_broken(&mixture, PLACES, triple, 4);
    TEST_ASSERT_EQUAL_MESSAGE(most > 0.02, found > 0, case_note);
    for (unsigned i = 0; i < found; i++) {
      const unsigned place[3] = {triple[i].place[0], triple[i].place[1], triple[i].place[2]};
      TEST_ASSERT_TRUE_MESSAGE(place[0] < place[1] && place[1] < place[2] && place[2] < PLACES, case_note);
      const double excess = excess_of(&mixture, place);
      TEST_ASSERT_TRUE_MESSAGE(i > 0 ? excess > 0.02 : excess >= most - 1e-12, case_note);
      broken++;
    }
  }
  TEST_ASSERT_GREATER_THAN(50, broken);
}

/* Routes of a game, whole ones: each place is on one at most, and no triple is broken. */
static void test_no_game_breaks_any(void) {
  for (unsigned number = 0; number < 200; number++) {
    test_random random = random_case("games", number);
    qtr_mixture mixture = {3, route, share};
    qtr_triple triple[4];
    for (unsigned i = 0; i < 3; i++) {
      *set_of(i) = 0;
      route[i] = label[i];
      share[i] = 1.0;
    }
    for (unsigned place = 0; place < PLACES; place++) *set_of(random_below(&random, 3)) |= 1u << place;
    TEST_ASSERT_EQUAL_MESSAGE(0, qtr_triples_broken(&mixture, PLACES, triple, 4), case_note);
  }
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_the_triple_that_is_broken_most_is_found_first);
  RUN_TEST(test_no_game_breaks_any);
  return UNITY_END();
}

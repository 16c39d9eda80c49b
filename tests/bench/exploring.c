/* How fast the paper's setting learns, and what its table's misses of the processor's caches cost when it is large. */
#include <stdio.h>
#include <stdlib.h>

#include "bench.h"
#include "field/learn.h"
#include "host/base/memory.h"
#include "quarter/random.h"
#include "search/qtable.h"

enum { SIDE = 30, PLACES = 26, SEEKERS = 3, SMALL_ENTRIES = 10000, LARGE_ENTRIES = 10000000, LOOKUPS = 4000000 };

#define SECONDS 5.0
#define LATEST 300.0  /* seconds until the large table is to be there */
#define WINDOW 500000 /* entries */

/* In an episode every place is chosen once, and backed up. Standing down is left out of the counts, as is the game that
 * is played for the record after some of the episodes. */
#define BACKUPS_AN_EPISODE PLACES
#define LOOKUPS_AN_EPISODE (PLACES * (PLACES + 1) / 2)

/* ---- the learner ---- */

static uint64_t episodes(void) {
  qtr_certificate known;
  qtr_learner_certificate(bench_learner(), &known);
  return known.episodes;
}

/* Up to the first episode: the prices that bound it are no part of what is measured. */
static void begin(int objective) {
  qtr_learner_config config;
  qtr_learner_config_default(&config);
  config.setting = QTR_SETTING_PAPER;
  config.gap = 0.0; /* go on, whatever is proven */
  bench_learn_for(bench_map(1, SIDE, PLACES, SEEKERS, objective), &config, 0.0);
  while (episodes() == 0) qtr_learner_step(bench_learner());
}

/* Backups a second from now until the table has so many entries, or the seconds are over. */
static double learn_until(uint32_t entries, double seconds) {
  const double from = learn_clock();
  const uint64_t before = episodes();
  while (qtr_learner_entries(bench_learner()) < entries && learn_clock() - from < seconds)
    qtr_learner_step(bench_learner());
  return (double)(episodes() - before) * BACKUPS_AN_EPISODE / (learn_clock() - from);
}

static void measure_rate(int objective) {
  begin(objective);
  const double rate = learn_until(UINT32_MAX, SECONDS);
  printf("paper setting, %d places, %d seekers, %-10s  %.2f million backups a second, %u entries after %.0f s (target: "
         "0.5)\n",
         PLACES, SEEKERS, bench_objective(objective), 1e-6 * rate, qtr_learner_entries(bench_learner()), SECONDS);
}

/* The learner's rate while its table is small, and at the large size. */
static double measure_growth(void) {
  begin(QTR_TIME);
  const double small = learn_until(SMALL_ENTRIES, LATEST);
  learn_until(LARGE_ENTRIES - WINDOW, LATEST);
  const double large = learn_until(LARGE_ENTRIES, LATEST);
  printf("the same, time: %.3f million backups a second up to %d entries, %.3f at %.1f million\n", 1e-6 * small,
         SMALL_ENTRIES, 1e-6 * large, 1e-6 * qtr_learner_entries(bench_learner()));
  return large;
}

/* ---- the table alone, with keys at random ---- */

static void draw_key(qtr_key *key, const qtr_key_shape *shape, uint64_t *state) {
  const unsigned above = shape->words * 32u - shape->bits;
  for (unsigned w = 0; w < shape->words; w++) key->word[w] = (uint32_t)(qtr_splitmix_next(state) >> 32);
  key->word[shape->words - 1] >>= above;
}

/* Nanoseconds that looking entries up takes, each found, in a table of so many; drawing the keys included. */
static double time_lookups(uint32_t *words, const qtr_key_shape *shape, uint32_t entries) {
  static qtr_qtable table;
  qtr_key key = {{0}};
  double value, sum = 0.0;
  qtr_qtable_init(&table, words, QTR_QTABLE_WORDS, shape, false);
  for (uint64_t n = 0; n < entries; n++) {
    uint64_t state = n << 32;
    draw_key(&key, shape, &state);
    qtr_qtable_set(&table, &key, 1.0);
  }
  const double begin = learn_clock();
  uint64_t order = 1;
  for (uint32_t i = 0; i < LOOKUPS; i++) {
    /* Which one is next hangs on the last one's value: none begins before that one has ended. */
    uint64_t state = (uint64_t)(qtr_lcg_below(&order, entries) + (sum < 0.0)) << 32;
    draw_key(&key, shape, &state);
    if (qtr_qtable_get(&table, &key, &value)) sum += value;
  }
  const double seconds = learn_clock() - begin;
  if (sum != (double)LOOKUPS) fprintf(stderr, "bench: an entry is not found again\n");
  return 1e9 * seconds / LOOKUPS;
}

static qtr_key_shape shape_of_states(void) {
  const qtr_game *game = bench_game();
  qtr_key_shape shape = {.seekers = SEEKERS, .places = PLACES, .nodes = PLACES + game->board.starts, .longest = 200};
  qtr_key_measure(&shape);
  return shape;
}

void bench_exploring(void) {
  fault why;
  measure_rate(QTR_DISCOUNTED);
  measure_rate(QTR_TIME);
  const double rate = measure_growth();
  const qtr_key_shape shape = shape_of_states();
  uint32_t *words = memory_take(QTR_QTABLE_WORDS * sizeof *words, &why);
  if (words == NULL) return;
  const double small = time_lookups(words, &shape, SMALL_ENTRIES);
  const double large = time_lookups(words, &shape, LARGE_ENTRIES);
  const double share = 1e-9 * (large - small) * LOOKUPS_AN_EPISODE / BACKUPS_AN_EPISODE * rate;
  printf(
      "a lookup, one after another, at %d entries: %.0f ns, at %d million: %.0f ns; at %d lookups a backup that would "
      "be %.0f %% of the learner's time there, but those of a state are under way together\n",
      SMALL_ENTRIES, small, LARGE_ENTRIES / 1000000, large, LOOKUPS_AN_EPISODE / BACKUPS_AN_EPISODE, 100.0 * share);
  free(words);
}

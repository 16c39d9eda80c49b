#include "search/triples.h"

#include <string.h>

#include "model/rounding.h"

#define LEAST_EXCESS 0.02
#define TRIPLES_A_PLACE 5u /* in one go: more of them say much the same */
#define MOST_FOUND 64u

typedef struct {
  qtr_triple triple;
  double excess;
} finding;

typedef struct {
  unsigned count, most;
  finding found[MOST_FOUND]; /* most excess first */
} findings;

static double share_of(const qtr_mixture *mixture, const qtr_triple *triple) {
  double sum = 0.0;
  for (uint32_t i = 0; i < mixture->count; i++)
    if (qtr_triple_counts(triple, mixture->route[i])) sum += mixture->share[i];
  return sum;
}

static void note(findings *list, const qtr_triple *triple, double excess) {
  unsigned i;
  for (i = 0; i < list->count; i++)
    if (memcmp(&list->found[i].triple, triple, sizeof *triple) == 0) return;
  if (list->count < list->most)
    i = list->count++;
  else if (excess > list->found[list->most - 1].excess)
    i = list->most - 1;
  else
    return;
  for (; i > 0 && list->found[i - 1].excess < excess; i--) list->found[i] = list->found[i - 1];
  list->found[i] = (finding){*triple, excess};
}

static qtr_triple sorted(unsigned a, unsigned b, unsigned c) {
  const unsigned low = a < b ? (a < c ? a : c) : b < c ? b : c;
  const unsigned high = a > b ? (a > c ? a : c) : b > c ? b : c;
  return (qtr_triple){{(uint16_t)low, (uint16_t)(a + b + c - low - high), (uint16_t)high}};
}

/* Two places that are together on a part of the routes: the third is together with either on others. */
static void complete(findings *list, const qtr_mixture *mixture, unsigned places, unsigned a, unsigned b) {
  for (unsigned c = 0; c < places; c++) {
    if (c == a || c == b) continue;
    const qtr_triple triple = sorted(a, b, c);
    const double excess = share_of(mixture, &triple) - 1.0;
    if (excess > LEAST_EXCESS) note(list, &triple, excess);
  }
}

static double share_of_pair(const qtr_mixture *mixture, unsigned a, unsigned b) {
  double sum = 0.0;
  for (uint32_t i = 0; i < mixture->count; i++)
    if (qtr_label_has(mixture->route[i], a) && qtr_label_has(mixture->route[i], b)) sum += mixture->share[i];
  return sum;
}

/* A broken triple has a pair that is together on more than a third of the routes, and not on all. */
static void find(findings *list, const qtr_mixture *mixture, unsigned places) {
  for (unsigned a = 0; a < places; a++) {
    for (unsigned b = a + 1; b < places; b++) {
      const double share = share_of_pair(mixture, a, b);
      if (share > (1.0 + LEAST_EXCESS) / 3.0 && share < 1.0) complete(list, mixture, places, a, b);
    }
  }
}

unsigned qtr_triples_broken(const qtr_mixture *mixture, unsigned places, qtr_triple *triple, unsigned most) {
  findings list = {0, MOST_FOUND, {{{{0}}, 0.0}}};
  uint8_t used[QTR_MAX_PLACES] = {0};
  unsigned count = 0;
  find(&list, mixture, places);
  for (unsigned i = 0; i < list.count && count < most; i++) {
    const uint16_t *place = list.found[i].triple.place;
    if (used[place[0]] == TRIPLES_A_PLACE || used[place[1]] == TRIPLES_A_PLACE || used[place[2]] == TRIPLES_A_PLACE)
      continue;
    for (unsigned j = 0; j < 3; j++) used[place[j]]++;
    triple[count++] = list.found[i].triple;
  }
  return count;
}

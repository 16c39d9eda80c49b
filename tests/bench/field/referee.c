#include "field/referee.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "model/rounding.h"

#define NEVER_MADE UINT64_MAX

/* A case that is heard. */
typedef struct {
  const plain_problem *p;
  verdict *v;
  uint64_t *when; /* of each look: its step */
  uint64_t *made; /* scratch: those at one place */
} hearing;

static bool refuse(verdict *v, const char *what, unsigned robot, unsigned look) {
  v->legal = false;
  snprintf(v->fault, sizeof v->fault, "robot %u %s %u", robot, what, look);
  return false;
}

static bool walk(const hearing *h, unsigned robot, const unsigned *route, unsigned length) {
  const plain_problem *p = h->p;
  verdict *v = h->v;
  unsigned node = p->looks + p->start_of[robot];
  uint64_t now = 0;
  for (unsigned i = 0; i < length; i++) {
    if (route[i] >= p->looks) return refuse(v, "makes a look that there is not,", robot, route[i]);
    if (h->when[route[i]] != NEVER_MADE) return refuse(v, "makes a look once more, number", robot, route[i]);
    const uint32_t way = plain_steps(p, p->class_of[robot], node, route[i]);
    if (way == PROBLEM_NO_WAY) return refuse(v, "has no way to look", robot, route[i]);
    now += way;
    node = route[i];
    h->when[node] = now;
    v->arrivals += now;
  }
  if (p->home == NULL) return true;
  const uint64_t back = length == 0 ? 0 : now + p->home[(size_t)robot * p->looks + node];
  v->arrivals += back;
  v->expected_time += p->home_weight * (double)back; /* not yet in shares */
  return true;
}

static int earlier(const void *a, const void *b) {
  const uint64_t x = *(const uint64_t *)a;
  const uint64_t y = *(const uint64_t *)b;
  return (x > y) - (x < y);
}

/* The looks at one place count in the order in which they are made: the m-th finds what m - 1 have missed. */
static double count_place(const hearing *h, unsigned place) {
  const plain_problem *p = h->p;
  verdict *v = h->v;
  unsigned count = 0;
  double left = 1.0, found = 0.0;
  for (unsigned look = 0; look < p->looks; look++) {
    if (p->place_of[look] != place) continue;
    v->complete = v->complete && h->when[look] != NEVER_MADE;
    if (h->when[look] != NEVER_MADE) h->made[count++] = h->when[look];
  }
  qsort(h->made, count, sizeof *h->made, earlier);
  for (unsigned i = 0; i < count; i++) {
    const double share = p->weight[place] * left * p->detection[place];
    const double delay = h->made[i] > 1 ? (double)(h->made[i] - 1) : 0.0;
    v->expected_time += share * (double)h->made[i];
    v->value += 10.0 * share * pow(p->gamma, delay);
    left *= 1.0 - p->detection[place];
    found += share;
  }
  return found;
}

/* Expected time is that of the find, if looks can miss: of what can be found at all. */
static void count_all(const hearing *h) {
  double sum = 0.0, found = 0.0;
  for (unsigned place = 0; place < h->p->places; place++) {
    sum += h->p->weight[place];
    found += count_place(h, place);
  }
  h->v->value /= sum;
  h->v->expected_time /= found;
}

static void hear(const hearing *h, const plan_routes *routes) {
  const unsigned *route = routes->look;
  for (unsigned look = 0; look < h->p->looks; look++) h->when[look] = NEVER_MADE;
  for (unsigned robot = 0; robot < h->p->robots; robot++) {
    if (!walk(h, robot, route, routes->length[robot])) return;
    route += routes->length[robot];
  }
  count_all(h);
}

void referee_judge(verdict *v, const plain_problem *p, const plan_routes *routes) {
  const hearing h = {p, v, calloc(p->looks, sizeof(uint64_t)), calloc(p->looks, sizeof(uint64_t))};
  *v = (verdict){.legal = h.when != NULL && h.made != NULL, .complete = true, .fault = "no memory to judge in"};
  if (v->legal) hear(&h, routes);
  free(h.when);
  free(h.made);
}

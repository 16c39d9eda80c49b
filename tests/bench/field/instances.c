#include "field/instances.h"

#include <dirent.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "field/learn.h"
#include "field/problem.h"
#include "field/referee.h"
#include "field/tsplib.h"
#include "host/base/json.h"
#include "host/base/memory.h"
#include "quarter/objective.h"

#define INSTANCES_MOST 1000
#define GAP 1e-6 /* so that whole numbers up to a million are told apart */

typedef struct {
  char *path;
  tsplib instance;
} entry;

typedef struct {
  unsigned count;
  entry entry[INSTANCES_MOST];
} collection;

/* ---- files ---- */

static int is_instance(const struct dirent *file) {
  const size_t length = strlen(file->d_name);
  return length > 4 && strcmp(file->d_name + length - 4, ".tsp") == 0;
}

static int by_name(const struct dirent **a, const struct dirent **b) {
  return strcmp((*a)->d_name, (*b)->d_name);
}

static int add(collection *all, const char *folder, const char *name, fault *why) {
  if (all->count == INSTANCES_MOST) return fault_set(why, "%s: more than %d instances", folder, INSTANCES_MOST);
  entry *e = &all->entry[all->count];
  const size_t size = strlen(folder) + strlen(name) + 2;
  e->path = memory_take(size, why);
  if (e->path == NULL) return -1;
  all->count++;
  snprintf(e->path, size, "%s%s%s", folder, *name != '\0' ? "/" : "", name);
  return tsplib_read(&e->instance, e->path, why);
}

/* All are read before any is learnt: what is wrong is told at once. */
static int collect(collection *all, const char *path, fault *why) {
  struct stat kind;
  struct dirent **files = NULL;
  if (stat(path, &kind) == 0 && S_ISREG(kind.st_mode)) return add(all, path, "", why);
  const int count = scandir(path, &files, is_instance, by_name);
  int status = count > 0 ? 0 : fault_set(why, "%s: is no folder with files named *.tsp, and no such file", path);
  for (int i = 0; i < count; i++) {
    if (status == 0) status = add(all, path, files[i]->d_name, why);
    free(files[i]);
  }
  free(files);
  return status;
}

static void drop(collection *all) {
  for (unsigned i = 0; i < all->count; i++) {
    tsplib_free(&all->entry[i].instance);
    free(all->entry[i].path);
  }
  free(all);
}

/* ---- one instance ---- */

typedef struct {
  double sum, bound; /* over the places, of their steps, or of gamma^max(t - 1, 0) */
  bool certified;    /* by the learner's gap, or because there is no whole number between the two */
  const learn_point *end;
} outcome;

/* Whole numbers lie above the bound on a sum of whole numbers, and what adding up doubles is wrong by is far less. */
static double round_bound(double bound, double sum) {
  return fmin(sum, ceil(bound - 1e-7 * fmax(1.0, fabs(bound))));
}

static void weigh(outcome *o, const verdict *v, const learnt *l, const plain_problem *p) {
  o->end = learnt_end(l);
  o->certified = o->end->certificate.certified;
  if (p->by_time) {
    o->sum = (double)v->arrivals;
    o->bound = round_bound(o->end->certificate.bound * p->places, o->sum);
    o->certified = o->certified || o->bound == o->sum;
  } else {
    o->sum = v->value * p->places / QTR_REWARD_SCALE;
    o->bound = o->end->certificate.bound * p->places / QTR_REWARD_SCALE;
  }
}

static void print_json(json *j, const problem_case *made, const bench_asked *asked, const outcome *o) {
  json_flat_object(j, NULL);
  json_string(j, "instance", made->name);
  json_natural(j, "robots", asked->family.robots);
  json_string(j, "kind", asked->comes_home ? "return" : "open");
  json_number(j, "sum", o->sum);
  json_number(j, "bound_sum", o->bound);
  json_bool(j, "certified", o->certified);
  json_number(j, "seconds", o->end->seconds);
  json_end_object(j);
  fflush(j->out);
}

static void print_line(FILE *out, const problem_case *made, const bench_asked *asked, const outcome *o) {
  fprintf(out, "%-16s %2u robots, %-6s  sum %.10g, bound %.10g (%.2g %%), %s after %.2f s\n", made->name,
          asked->family.robots, asked->comes_home ? "return" : "open", o->sum, o->bound,
          100.0 * fabs(o->sum - o->bound) / o->sum, o->certified ? "certified" : "open", o->end->seconds);
  fflush(out);
}

/* What the learner says is not taken for granted: the referee's sum is printed, and must be what was learnt. */
static int judge(outcome *o, const problem_case *made, const learnt *l, fault *why) {
  verdict v;
  referee_judge(&v, &made->plain, &l->best);
  if (!v.legal || !v.complete)
    return fault_set(why, "%s: the plan is none: %s", made->name, v.legal ? "it leaves places out" : v.fault);
  weigh(o, &v, l, &made->plain);
  const qtr_certificate *said = &o->end->certificate;
  const double judged = made->plain.by_time ? v.expected_time : v.value;
  if (fabs(judged - said->objective) <= 1e-9 * fabs(judged)) return 0;
  return fault_set(why, "%s: the learner says %.17g, the referee %.17g", made->name, said->objective, judged);
}

static int learn_one(const entry *e, const bench_asked *asked, json *j, FILE *out, fault *why) {
  const problem_wish wish = {asked->family.robots, asked->comes_home, asked->family.objective, asked->family.gamma};
  problem_case made;
  learnt l = {0};
  outcome o = {0};
  int status = problem_of_instance(&made, &e->instance, e->path, &wish, why);
  if (status == 0) status = learn_for(&l, &made, QTR_SETTING_CERTIFIED, GAP, asked->time_limit, why);
  if (status == 0) status = judge(&o, &made, &l, why);
  if (status == 0 && asked->json) print_json(j, &made, asked, &o);
  if (status == 0 && !asked->json) print_line(out, &made, asked, &o);
  learnt_drop(&l);
  problem_drop(&made);
  return status;
}

static int learn_all(const collection *all, const bench_asked *asked, FILE *out, fault *why) {
  json j;
  int status = 0;
  json_begin(&j, out);
  if (asked->json) json_array(&j, NULL);
  for (unsigned i = 0; status == 0 && i < all->count; i++) status = learn_one(&all->entry[i], asked, &j, out, why);
  if (asked->json) json_end_array(&j);
  return status;
}

int bench_instances(FILE *out, const bench_asked *asked) {
  static fault why;
  collection *all = memory_take(sizeof *all, &why);
  int status = all != NULL ? collect(all, asked->instances, &why) : -1;
  if (status == 0) status = learn_all(all, asked, out, &why);
  if (all != NULL) drop(all);
  return status == 0 ? 0 : bench_fail(&why);
}

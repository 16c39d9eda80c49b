/* What the order is worth in which robots take over for one another: odd passes backwards, as the executor has it,
 * against all passes forward. Robots walk the grid cell by cell in nominal time and hear each other at once; the same
 * games, the same losses, both orders. Where it is the executor's own order, the executor is asked beside it and must
 * say the same. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bench.h"
#include "host/base/json.h"
#include "quarter/export.h"
#include "quarter/random.h"
#include "quarter/robot.h"

enum { GAMES = 400, SIDE = 20, PLACES_A_SEEKER = 5, LEARNT = 3, LATEST = 20000, SLOWNESS = 3, CREWS = 3 };

static const int crews[CREWS] = {3, 4, 6}; /* robots */

enum start { TOGETHER, APART, STARTS }; /* all in one corner; each anywhere */

enum order { FORWARD, BOTH_ENDS, ORDERS };

/* What happens to one robot of a game. */
enum trouble { LOST_AT_START, LOST_ON_THE_WAY, SLOW, TROUBLES, NONE };

static const char *const trouble_names[TROUBLES] = {"lost at the start", "lost on the way", "three times as slow"};
static const char *const start_names[STARTS] = {"together", "apart"};

typedef struct {
  enum trouble trouble;
  unsigned robot;
  unsigned at; /* step */
} mishap;

/* ---- one robot ---- */

typedef struct {
  unsigned self;
  qtr_cell cell;
  uint16_t target; /* that `way` leads to; QTR_STAND_DOWN: none */
  qtr_field way;
  qtr_places visited;
  qtr_seeker seeker; /* the executor, who is told the same */
} walker;

typedef struct {
  const qtr_policy *policy;
  const qtr_division *division;
  enum order order;
  walker robot[QTR_MAX_SEEKERS];
  bool done[QTR_MAX_SEEKERS]; /* territories announced */
  qtr_places scanned;         /* by anybody */
  unsigned differences;       /* times that the executor said otherwise */
} team;

static uint16_t next_on_route(const qtr_division *division, const qtr_places *visited, unsigned territory,
                              bool backwards) {
  for (unsigned n = 0; n < division->moves; n++) {
    const unsigned i = backwards ? division->moves - 1u - n : n;
    if (division->seeker[i] == territory && !qtr_places_has(visited, division->place[i])) return division->place[i];
  }
  return QTR_STAND_DOWN;
}

/* In pass p the territory of robot self + p. */
static uint16_t target_of(const team *t, const walker *w) {
  const unsigned seekers = t->policy->board.seekers;
  for (unsigned pass = 0; pass < seekers; pass++) {
    const unsigned territory = (w->self + pass) % seekers;
    if (t->done[territory]) continue;
    const bool backwards = t->order == BOTH_ENDS && pass % 2 == 1;
    const uint16_t place = next_on_route(t->division, &w->visited, territory, backwards);
    if (place != QTR_STAND_DOWN) return place;
  }
  return QTR_STAND_DOWN;
}

static void announce(team *t, walker *w) {
  qtr_signal signal;
  for (unsigned territory = 0; territory < t->policy->board.seekers; territory++)
    if (next_on_route(t->division, &w->visited, territory, false) == QTR_STAND_DOWN) t->done[territory] = true;
  while (qtr_seeker_announce(&w->seeker, &signal))
    for (unsigned i = 0; i < t->policy->board.seekers; i++) qtr_seeker_hear(&t->robot[i].seeker, &signal);
}

static void scan(team *t, walker *w) {
  while (w->target != QTR_STAND_DOWN && qtr_policy_cell(t->policy, w->target) == w->cell) {
    qtr_places_add(&w->visited, w->target);
    qtr_places_add(&t->scanned, w->target);
    qtr_seeker_visited(&w->seeker, w->target);
    announce(t, w);
    w->target = target_of(t, w);
    if (w->target != QTR_STAND_DOWN) qtr_field_fill(&w->way, &t->policy->grid, qtr_policy_cell(t->policy, w->target));
  }
}

/* Look where to go, and go one cell: all cells take one step here. */
static void walk(team *t, walker *w) {
  const uint16_t target = target_of(t, w);
  if (t->order == BOTH_ENDS) t->differences += target != qtr_seeker_target(&w->seeker);
  if (target != QTR_STAND_DOWN && target != w->target)
    qtr_field_fill(&w->way, &t->policy->grid, qtr_policy_cell(t->policy, target));
  w->target = target;
  if (target == QTR_STAND_DOWN) return;
  w->cell = qtr_field_next(&w->way, &t->policy->grid, w->cell);
  scan(t, w);
}

/* ---- one game ---- */

static void begin(team *t, const qtr_policy *policy, const qtr_division *division, enum order order) {
  memset(t, 0, sizeof *t);
  t->policy = policy;
  t->division = division;
  t->order = order;
  for (unsigned i = 0; i < policy->board.seekers; i++) {
    walker *w = &t->robot[i];
    w->self = i;
    w->cell = qtr_policy_cell(policy, (unsigned)policy->board.places + policy->board.start_of[i]);
    w->target = QTR_STAND_DOWN;
    qtr_seeker_init(&w->seeker, policy, i, NULL, 0);
  }
  for (unsigned i = 0; i < policy->board.seekers; i++) announce(t, &t->robot[i]);
}

static bool acts(const mishap *m, unsigned robot, unsigned step) {
  if (robot != m->robot || m->trouble == NONE) return true;
  return m->trouble == SLOW ? step % SLOWNESS == 0 : step < m->at;
}

static bool all_scanned(const team *t) {
  for (unsigned place = 0; place < t->policy->board.places; place++)
    if (!qtr_places_has(&t->scanned, place)) return false;
  return true;
}

/* The step at which the last place was scanned. */
static unsigned play(team *t, const mishap *m) {
  const qtr_board *board = &t->policy->board;
  for (unsigned step = 0; step < LATEST; step++) {
    if (all_scanned(t)) return step;
    for (unsigned i = 0; i < board->seekers; i++)
      if (acts(m, i, step)) walk(t, &t->robot[i]);
  }
  return LATEST;
}

/* ---- many ---- */

typedef struct {
  double sum[ORDERS];       /* of the last place's times, in times of the plan's */
  double less, less_square; /* sums of what both ends take less, as a share of forward */
} tally;

static double mean_less(const tally *t) {
  return t->less / GAMES;
}

/* Half of the 95 % confidence interval of that mean. */
static double margin(const tally *t) {
  const double variance = (t->less_square - t->less * t->less / GAMES) / (GAMES - 1);
  return 1.96 * sqrt(variance / GAMES);
}

/* Robots that start apart do so on cells that were drawn for places, for these can all be reached. */
static qtr_mission *make_mission(unsigned seed, int seekers, enum start start) {
  const int places = PLACES_A_SEEKER * seekers;
  qtr_mission *mission = bench_map(seed, SIDE, places + (start == APART ? seekers : 0), seekers, QTR_TIME);
  for (int i = 0; start == APART && i < seekers; i++) mission->start[i] = mission->place[places + i];
  mission->places = (uint16_t)places;
  return mission;
}

static bool open_table(qtr_policy *policy, qtr_division *division, uint8_t **bytes, const qtr_mission *mission) {
  qtr_learner *learner = bench_learn(mission, LEARNT);
  const uint32_t size = qtr_export_size(learner);
  qtr_deployment home;
  *bytes = malloc(size);
  const int32_t written = *bytes != NULL ? qtr_export(learner, *bytes, size) : QTR_ERR_SPACE;
  if (written < 0 || qtr_policy_open(policy, *bytes, (uint32_t)written) != QTR_OK) return false;
  qtr_deployment_init(&home, policy, NULL, NULL);
  qtr_division_begin(division, policy, &home);
  while (qtr_division_play(division, policy)) continue;
  return true;
}

static mishap draw(enum trouble trouble, uint64_t *state, int seekers, unsigned plan) {
  const unsigned robot = (unsigned)(qtr_splitmix_next(state) % (unsigned)seekers);
  const unsigned at = (unsigned)(qtr_splitmix_unit(state) * plan);
  return (mishap){trouble, robot, trouble == LOST_AT_START ? 0 : at};
}

static void add(tally *sum, double forward, double both, double plan) {
  const double less = 1.0 - both / forward;
  sum->sum[FORWARD] += forward / plan;
  sum->sum[BOTH_ENDS] += both / plan;
  sum->less += less;
  sum->less_square += less * less;
}

/* All troubles of one game. False if there was no table, or the executor walked otherwise. */
static bool play_game(tally *tallies, unsigned seed, int seekers, enum start start) {
  static const mishap none = {NONE, 0, 0};
  static qtr_policy policy;
  static qtr_division division;
  static team t;
  uint64_t state = seed;
  uint8_t *bytes = NULL;
  bool alike = open_table(&policy, &division, &bytes, make_mission(seed, seekers, start));
  if (alike) begin(&t, &policy, &division, BOTH_ENDS);
  const unsigned plan = alike ? play(&t, &none) : 1;
  for (int trouble = 0; alike && trouble < TROUBLES; trouble++) {
    const mishap m = draw((enum trouble)trouble, &state, seekers, plan);
    unsigned last[ORDERS];
    for (int order = 0; order < ORDERS; order++) {
      begin(&t, &policy, &division, (enum order)order);
      last[order] = play(&t, &m);
      alike = alike && t.differences == 0 && last[order] < LATEST;
    }
    add(&tallies[trouble], last[FORWARD], last[BOTH_ENDS], plan);
  }
  free(bytes);
  return alike;
}

/* By crew, start and trouble. */
typedef tally tally_table[CREWS][STARTS][TROUBLES];

static void tell(tally_table tallies) {
  printf("Time to the last place, in times of the undisturbed game's: means of %d random games of %dx%d cells, %d "
         "places a "
         "robot.\n\n",
         GAMES, SIDE, SIDE, PLACES_A_SEEKER);
  printf("| one robot | robots | start | all passes forward | from both ends | less by (95 %% confidence) |\n");
  printf("| --- | --- | --- | --- | --- | --- |\n");
  for (int trouble = 0; trouble < TROUBLES; trouble++)
    for (int crew = 0; crew < CREWS; crew++)
      for (int start = 0; start < STARTS; start++) {
        const tally *t = &tallies[crew][start][trouble];
        printf("| %s | %d | %s | %.2f | %.2f | %.1f %% ± %.1f |\n", trouble_names[trouble], crews[crew],
               start_names[start], t->sum[FORWARD] / GAMES, t->sum[BOTH_ENDS] / GAMES, 100 * mean_less(t),
               100 * margin(t));
      }
}

static void write_tally(json *j, const tally *t, int trouble, int crew, int start) {
  json_flat_object(j, NULL);
  json_string(j, "one_robot", trouble_names[trouble]);
  json_integer(j, "robots", crews[crew]);
  json_string(j, "start", start_names[start]);
  json_number(j, "forward", t->sum[FORWARD] / GAMES);
  json_number(j, "both_ends", t->sum[BOTH_ENDS] / GAMES);
  json_number(j, "less_by", mean_less(t));
  json_number(j, "confidence_95", margin(t));
  json_end_object(j);
}

static void write_json(tally_table tallies) {
  json j;
  json_begin(&j, stdout);
  json_object(&j, NULL);
  json_integer(&j, "games", GAMES);
  json_array(&j, "takeover");
  for (int trouble = 0; trouble < TROUBLES; trouble++)
    for (int crew = 0; crew < CREWS; crew++)
      for (int start = 0; start < STARTS; start++)
        write_tally(&j, &tallies[crew][start][trouble], trouble, crew, start);
  json_end_array(&j);
  json_end_object(&j);
}

int bench_takeover(bool as_json) {
  static tally_table tallies;
  for (int crew = 0; crew < CREWS; crew++)
    for (unsigned game = 0; game < STARTS * GAMES; game++) {
      const enum start start = (enum start)(game % STARTS);
      if (play_game(tallies[crew][start], game / STARTS + 1, crews[crew], start)) continue;
      fprintf(stderr, "bench: seed %u, %d robots: a place was left out, or the executor goes another way\n",
              game / STARTS + 1, crews[crew]);
      return 1;
    }
  if (as_json)
    write_json(tallies);
  else
    tell(tallies);
  return 0;
}

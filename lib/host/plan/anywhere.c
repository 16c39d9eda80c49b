#include "host/plan/anywhere.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "host/base/memory.h"
#include "host/base/stop.h"
#include "host/plan/progress.h"
#include "quarter/deployment.h"
#include "quarter/nominal.h"
#include "quarter/policy.h"
#include "quarter/random.h"
#include "quarter/status.h"

/* The whole table under work. */
typedef struct {
  study *s;
  const plan_config *config;
  qtr_board board;  /* its starts are the regions, if they are asked for, and then the mission's own */
  uint16_t regions; /* starts that crews are drawn from; 0: the mission's own alone */
  uint8_t *steps;   /* the board's */
  qtr_cell *start;  /* cell of each start */
  uint16_t *region; /* of each cell; NULL: none */
  uint8_t *records;
  uint64_t count, room;
  uint64_t games; /* learnt */
  uint8_t rank;   /* of the records being added: among records of one state the lowest stays */
} builder;

static study *alone; /* learns one start and one set of places left at a time */

/* ---- how large it would be ---- */

/* Ways to put the seekers into the regions; alike seekers are interchangeable. */
static double count_crews(const builder *b) {
  double crews = 1.0;
  if (b->region == NULL) return crews;
  for (unsigned i = 0; i < b->board.seekers; i++) crews *= (double)(b->regions + i) / (double)(i + 1);
  return crews;
}

static double count_games(const builder *b) {
  return count_crews(b) * (b->config->any_cleared ? ldexp(1.0, b->board.places) - 1.0 : 1.0);
}

static int check_size(const builder *b, fault *why) {
  const double states =
      count_games(b) * (b->board.places * (b->config->any_cleared ? 0.5 : 1.0) + b->board.seekers - 1);
  const double bytes = states * qtr_record_bytes(&b->board);
  if (bytes <= b->config->table_limit * 1e6) return 0;
  return fault_set(
      why, "%s: the table would take about %.3g MB for %.3g games, and --table-limit allows %.3g MB; allow more, or %s",
      b->s->p.in.path, bytes / 1e6, count_games(b), b->config->table_limit,
      b->config->any_starts ? "make the regions larger with --region-size and --region-diameter"
                            : "list fewer places: with --cleared any each doubles the games");
}

/* ---- the board of all starts ---- */

static void store_steps(builder *b, unsigned node, unsigned place, qtr_steps steps) {
  uint8_t *at = b->steps + 4 * ((size_t)node * b->board.places + place);
  for (int i = 0; i < 4; i++) at[i] = (uint8_t)(steps >> 8 * i & 0xFFu);
}

/* False: stopped. */
static bool measure(builder *b) {
  const qtr_mission *mission = &b->s->p.in.mission;
  const qtr_grid grid = qtr_mission_grid(mission);
  for (unsigned to = 0; to < mission->places; to++) {
    if (stop_asked()) return false;
    qtr_field_fill(&b->s->p.field, &grid, mission->place[to]);
    for (unsigned from = 0; from < mission->places; from++)
      store_steps(b, from, to, b->s->p.field.to_go[mission->place[from]]);
    for (unsigned start = 0; start < b->board.starts; start++)
      store_steps(b, mission->places + start, to, b->s->p.field.to_go[b->start[start]]);
  }
  return true;
}

static int stopped(const builder *b, fault *why) {
  fault_set(why, "%s: ended (%s) after %.3g s, before the table for all starts was begun; nothing was written",
            b->s->p.in.path, stop_reason(), stop_seconds());
  why->status = EXIT_STOPPED;
  return -1;
}

static int divide(builder *b, fault *why) {
  const int status = study_divide(b->s, &b->config->aggregation, why);
  if (status != QTR_OK) return status == QTR_ERR_STOPPED ? stopped(b, why) : -1;
  if (b->s->regions.count + b->s->p.game.board.starts > QTR_MAX_STARTS)
    return fault_set(why,
                     "%s: %" PRIu32 " regions are too many for a table; make them larger with --region-size and "
                     "--region-diameter",
                     b->s->p.in.path, b->s->regions.count);
  b->regions = (uint16_t)b->s->regions.count;
  return 0;
}

static int allocate(builder *b, fault *why) {
  const qtr_mission *mission = &b->s->p.in.mission;
  const size_t cells = (size_t)mission->columns * mission->rows;
  b->board.starts = (uint16_t)(b->regions + b->s->p.game.board.starts);
  b->start = malloc(b->board.starts * sizeof *b->start);
  b->steps = malloc(4u * ((size_t)mission->places + b->board.starts) * mission->places);
  if (b->regions > 0) b->region = malloc(cells * sizeof *b->region);
  if (b->start != NULL && b->steps != NULL && (b->regions == 0 || b->region != NULL)) return 0;
  return fault_set(why, "%s: no memory for a table of %d starts", b->s->p.in.path, b->board.starts);
}

static void set_starts(builder *b) {
  const qtr_mission *mission = &b->s->p.in.mission;
  const size_t cells = (size_t)mission->columns * mission->rows;
  const qtr_game *game = &b->s->p.game;
  for (unsigned region = 0; region < b->regions; region++) b->start[region] = b->s->regions.representative[region];
  for (unsigned start = 0; start < game->board.starts; start++)
    b->start[b->regions + start] = mission->start[game->first_at[start]];
  for (size_t cell = 0; b->region != NULL && cell < cells; cell++)
    b->region[cell] = mission->cost[cell] > 0 ? (uint16_t)b->s->regions.of[cell] : QTR_POLICY_NO_REGION;
  for (unsigned i = 0; i < mission->seekers; i++)
    b->board.start_of[i] = (uint16_t)(b->regions + game->board.start_of[i]);
}

static int make_board(builder *b, fault *why) {
  b->board = b->s->p.game.board;
  if ((b->config->any_starts && divide(b, why) != 0) || allocate(b, why) != 0) return -1;
  set_starts(b);
  b->board.steps = b->steps;
  if (!measure(b)) return stopped(b, why);
  const int status = qtr_board_init(&b->board);
  return status == QTR_OK ? 0 : fault_set(why, "%s: %s", b->s->p.in.path, qtr_strerror(status));
}

/* ---- one game: from these starts, with these places cleared ---- */

/* The mission that is left; `number` tells its places' numbers in the whole one. */
static void make_rest(const builder *b, const qtr_cell *starts, uint64_t cleared, uint16_t *number) {
  const qtr_mission *whole = &b->s->p.in.mission;
  qtr_mission *rest = &alone->p.in.mission;
  rest->places = 0;
  rest->objective = whole->objective;
  for (uint16_t place = 0; place < whole->places; place++) {
    if ((cleared >> place & 1u) != 0) continue;
    number[rest->places] = place;
    rest->place[rest->places] = whole->place[place];
    rest->weight[rest->places++] = whole->weight[place];
  }
  memcpy(rest->start, starts, whole->seekers * sizeof *starts);
}

/* From starts, or with places left, that are so far apart that discounting tells nothing any more, expected time does. */
static int set_up_rest(void) {
  problem *p = &alone->p;
  const int status = qtr_game_init(&p->game, &p->in.mission, &p->field, NULL);
  if (status != QTR_ERR_DISCOUNT) return status;
  p->in.mission.objective = QTR_TIME;
  return qtr_game_init(&p->game, &p->in.mission, &p->field, NULL);
}

/* Learn it. False: some place is out of everybody's reach, or there was no time. */
static bool learn_rest(const builder *b, fault *why) {
  plan_config config = *b->config;
  config.aggregation.by_regions = config.aggregation.by_spots = false;
  config.learner.setting = QTR_SETTING_CERTIFIED;
  if (set_up_rest() != QTR_OK) return false;
  if (study_begin(alone, &config, why) != 0) return false;
  for (int steps = 0; steps < 2000 && qtr_learner_step(&alone->learner) == QTR_LEARNING; steps++) {}
  return !stop_asked();
}

static int add_record(builder *b, const qtr_joint *joint, uint16_t choice, fault *why) {
  const uint32_t size = qtr_record_bytes(&b->board);
  if (b->count == b->room) {
    const uint64_t room = b->room > 0 ? 2 * b->room : 1024;
    uint8_t *more = realloc(b->records, room * size);
    if (more == NULL) return fault_set(why, "%s: no memory for the table", b->s->p.in.path);
    b->records = more;
    b->room = room;
  }
  uint8_t *record = b->records + b->count++ * size;
  qtr_record_write(record, joint, &b->board, choice);
  record[size - 1] = b->rank;
  return 0;
}

/* Play routes on the board of all starts, and record what is met. `number` tells their places' numbers. */
static int record_game(builder *b, const qtr_routes *routes, const uint16_t *start_of, uint64_t cleared,
                       const uint16_t *number, fault *why) {
  qtr_joint joint;
  qtr_places done;
  uint16_t next[QTR_MAX_SEEKERS] = {0};
  int status = 0;
  qtr_places_clear(&done);
  for (unsigned place = 0; place < b->board.places; place++)
    if ((cleared >> place & 1u) != 0) qtr_places_add(&done, place);
  qtr_joint_start(&joint, &b->board, start_of, &done);
  do {
    const int seeker = qtr_joint_chooser(&joint, &b->board);
    if (seeker == QTR_NOBODY) continue;
    const bool on = next[seeker] < routes->length[seeker];
    const uint16_t choice = on ? number[routes->place[seeker][next[seeker]++]] : QTR_STAND_DOWN;
    status = add_record(b, &joint, choice, why);
    qtr_joint_choose(&joint, &b->board, seeker, choice);
  } while (status == 0 &&
           (qtr_joint_chooser(&joint, &b->board) != QTR_NOBODY || qtr_joint_advance(&joint, &b->board, NULL) > 0));
  return status;
}

static int add_game(builder *b, const uint16_t *start_of, uint64_t cleared, fault *why) {
  qtr_cell starts[QTR_MAX_SEEKERS];
  uint16_t number[QTR_MAX_PLACES];
  for (unsigned i = 0; i < b->board.seekers; i++) starts[i] = b->start[start_of[i]];
  why->text[0] = '\0';
  make_rest(b, starts, cleared, number);
  if (!learn_rest(b, why)) return why->text[0] != '\0' ? -1 : 0;
  b->games++;
  qtr_play_to_routes(&alone->learner.best, &alone->p.game, &alone->learner.routes);
  return record_game(b, &alone->learner.routes, start_of, cleared, number, why);
}

/* The mission's own game is learnt already, and the certificate is that of its routes. */
static int add_own_game(builder *b, fault *why) {
  uint16_t number[QTR_MAX_PLACES];
  for (uint16_t place = 0; place < b->board.places; place++) number[place] = place;
  b->games++;
  qtr_play_to_routes(&b->s->learner.best, &b->s->p.game, &b->s->learner.routes);
  return record_game(b, &b->s->learner.routes, b->board.start_of, 0, number, why);
}

/* ---- all games ---- */

static int add_cleared(builder *b, const uint16_t *start_of, uint64_t first, fault *why) {
  const uint64_t sets = b->config->any_cleared ? ((uint64_t)1 << b->board.places) - 1 : 1;
  for (uint64_t cleared = first; cleared < sets && !stop_asked(); cleared++)
    if (add_game(b, start_of, cleared, why) != 0) return -1;
  return 0;
}

/* The next crew in the order of the regions, each seeker's region no lower than the one's before it. */
static bool next_crew(const builder *b, uint16_t *start_of) {
  unsigned i = b->board.seekers;
  while (i > 0 && start_of[i - 1] + 1 == b->regions) i--;
  if (i == 0) return false;
  const uint16_t region = (uint16_t)(start_of[i - 1] + 1);
  for (unsigned j = i - 1; j < b->board.seekers; j++) start_of[j] = region;
  return true;
}

static int add_all(builder *b, fault *why) {
  uint16_t start_of[QTR_MAX_SEEKERS] = {0};
  const double games = count_crews(b);
  double done = 0.0;
  /* The mission's own starts keep their records, so that the certificate is theirs. */
  if (add_own_game(b, why) != 0 || add_cleared(b, b->board.start_of, 1, why) != 0) return -1;
  b->rank = 1;
  if (b->region == NULL) return 0;
  do {
    if (add_cleared(b, start_of, 0, why) != 0) return -1;
    if (progress_wanted(b->config->quiet)) fprintf(stderr, "\r\033[Kstarts: %.0f of %.0f", ++done, games);
  } while (!stop_asked() && next_crew(b, start_of));
  if (progress_wanted(b->config->quiet)) fprintf(stderr, "\r\033[K");
  return 0;
}

/* ---- the table ---- */

static const qtr_board *sorting; /* for qsort, which passes nothing on */

static int compare_records(const void *a, const void *b) {
  const uint32_t size = qtr_record_bytes(sorting);
  const uint8_t *x = a;
  const uint8_t *y = b;
  const int order = qtr_record_compare(x, y, sorting);
  if (order != 0) return order;
  if (x[size - 1] != y[size - 1]) return x[size - 1] < y[size - 1] ? -1 : 1;
  return memcmp(x, y, size);
}

static void sort_records(builder *b) {
  const uint32_t size = qtr_record_bytes(&b->board);
  uint64_t kept = 0;
  sorting = &b->board;
  qsort(b->records, b->count, size, compare_records);
  for (uint64_t i = 0; i < b->count; i++) {
    const uint8_t *record = b->records + i * size;
    if (kept > 0 && qtr_record_compare(record, b->records + (kept - 1) * size, &b->board) == 0) continue;
    memmove(b->records + kept++ * size, record, size);
    b->records[kept * size - 1] = 0;
  }
  b->count = kept;
}

static uint32_t write_table(builder *b, uint8_t **bytes, fault *why) {
  qtr_certificate certificate;
  qtr_learner_certificate(&b->s->learner, &certificate);
  const qtr_table_content content = {
      &b->s->p.in.mission, &b->board,    b->s->p.game.probability, b->start, b->region, b->records,
      (uint32_t)b->count,  &certificate, b->config->learner.seed};
  const uint32_t size = qtr_table_size(&content);
  *bytes = malloc(size);
  const int32_t written = *bytes != NULL ? qtr_table_write(&content, *bytes, size) : QTR_ERR_SPACE;
  if (written > 0) return (uint32_t)written;
  free(*bytes);
  *bytes = NULL;
  fault_set(why, "%s: the table cannot be written: %s", b->s->p.in.path, qtr_strerror(written));
  return 0;
}

/* ---- trials ---- */

static uint64_t draws;

static uint32_t draw(uint32_t below) {
  return qtr_lcg_below(&draws, below);
}

/* What the table's routes earn when the seekers set out from these very cells. */
static double earn_on_ground(const qtr_policy *policy, const qtr_deployment *deployment, const qtr_game *game) {
  qtr_steps visit[QTR_MAX_PLACES];
  qtr_score score;
  for (unsigned place = 0; place < policy->board.places; place++) visit[place] = QTR_NEVER;
  for (int i = 0; i < policy->board.seekers; i++) {
    unsigned node = (unsigned)policy->board.places + game->board.start_of[i];
    qtr_steps now = 0;
    qtr_joint joint;
    uint16_t place;
    qtr_joint_start(&joint, &policy->board, deployment->start_of, NULL);
    while ((place = qtr_policy_play(policy, &joint, i, NULL, NULL)) != QTR_STAND_DOWN) {
      now += qtr_board_steps(&game->board, (unsigned)i, node, place);
      node = place;
      visit[node] = now;
    }
  }
  qtr_game_score(game, visit, &score);
  return score.worth;
}

static int compare_doubles(const void *a, const void *b) {
  const double x = *(const double *)a;
  const double y = *(const double *)b;
  return (x > y) - (x < y);
}

/* Loss of the table's policy from random cells against one learnt for those cells alone. */
static void try_starts(builder *b, const uint8_t *bytes, uint32_t size, anywhere_report *report, fault *why) {
  const qtr_mission *mission = &b->s->p.in.mission;
  const uint32_t cells = (uint32_t)mission->columns * mission->rows;
  double losses[ANYWHERE_TRIALS];
  uint16_t number[QTR_MAX_PLACES];
  qtr_policy policy;
  qtr_deployment deployment;
  if (qtr_policy_open(&policy, bytes, size) != QTR_OK) return;
  draws = b->config->learner.seed;
  for (int tries = 0; !stop_asked() && report->trials < ANYWHERE_TRIALS && tries < 100 * ANYWHERE_TRIALS; tries++) {
    qtr_cell starts[QTR_MAX_SEEKERS];
    for (unsigned i = 0; i < mission->seekers; i++) do
        starts[i] = (qtr_cell)draw(cells);
      while (mission->cost[starts[i]] == 0);
    make_rest(b, starts, 0, number);
    if (qtr_deployment_init(&deployment, &policy, starts, NULL) != QTR_OK || !learn_rest(b, why)) continue;
    const double worth = earn_on_ground(&policy, &deployment, &alone->p.game);
    const double best = alone->learner.best.score.worth;
    losses[report->trials++] = (best - worth) / fabs(best);
  }
  if (report->trials == 0) return;
  qsort(losses, (size_t)report->trials, sizeof *losses, compare_doubles);
  report->median_loss = losses[report->trials / 2];
  report->worst_loss = losses[report->trials - 1];
}

uint32_t anywhere_learn(study *s, const plan_config *config, uint8_t **bytes, anywhere_report *report, fault *why) {
  builder b = {.s = s, .config = config};
  uint32_t size = 0;
  bool complete = false;
  *report = (anywhere_report){0};
  alone = memory_take(sizeof *alone, why);
  if (alone == NULL) return 0;
  memcpy(&alone->p.in.mission, &s->p.in.mission, sizeof alone->p.in.mission);
  if (make_board(&b, why) == 0 && check_size(&b, why) == 0 && add_all(&b, why) == 0) {
    complete = !stop_asked();
    sort_records(&b);
    size = write_table(&b, bytes, why);
  }
  report->games = b.games;
  report->complete = complete;
  report->regions = b.regions;
  if (size > 0 && b.region != NULL) try_starts(&b, *bytes, size, report, why);
  free(alone);
  free(b.records);
  free(b.region);
  free(b.start);
  free(b.steps);
  return size;
}

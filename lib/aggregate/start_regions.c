#include "quarter/start_regions.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "core/block.h"
#include "model/matrix.h"
#include "model/rounding.h"

#define ROUNDS 8          /* of moving representatives */
#define SAMPLE_MOST 32768 /* cells that they move by */
#define WATCHED 1024      /* cells between two questions to the watch */
#define NO_WAY FLT_MAX    /* as a coordinate */
#define ELSEWHERE 1e300   /* squared distance of cells that reach other places */

/* The cells that there is a way to any place from, as points. */
typedef struct {
  const qtr_mission *mission;
  unsigned axes; /* places, for each kind of ground that robots are of */
  uint32_t count;
  qtr_cell *cell;
  float *at;       /* axes of each point */
  double *nearest; /* squared distance to its representative */
  uint32_t *of;    /* representative */
  uint32_t representatives;
  uint32_t *representative; /* points */
  double *mean;             /* axes of each representative's cluster */
  double *best;             /* squared distance to it of the member that is nearest */
  uint32_t *members;
} cloud;

/* ---- scratch ---- */

/* Kinds of ground: all of the free cells, and the smooth ones, as far as there are classes of such robots. */
static unsigned grounds_of(const qtr_mission *mission, uint8_t *encoding) {
  unsigned grounds = 0;
  for (unsigned i = 0; i < mission->classes; i++) {
    const uint8_t of_class = qtr_matrix_grid(mission, i).encoding;
    if (grounds > 0 && encoding[0] == of_class) continue;
    if (grounds > 1) break;
    encoding[grounds++] = of_class;
  }
  return grounds;
}

static uint32_t free_cells(const qtr_mission *mission) {
  uint32_t count = 0;
  for (uint32_t cell = 0; cell < qtr_mission_cells(mission); cell++) count += mission->cost[cell] > 0;
  return count;
}

static unsigned axes_of(const qtr_mission *mission) {
  uint8_t encoding[2];
  return mission->places * grounds_of(mission, encoding);
}

size_t qtr_start_regions_bytes(const qtr_game *game, uint32_t most) {
  const size_t cells = free_cells(game->mission);
  const size_t axes = axes_of(game->mission);
  return block_piece(cells * sizeof(qtr_cell)) + block_piece(cells * axes * sizeof(float)) +
         block_piece(cells * sizeof(double)) + block_piece(cells * sizeof(uint32_t)) +
         block_piece(most * sizeof(uint32_t)) + block_piece(most * axes * sizeof(double)) +
         block_piece(most * sizeof(double)) + block_piece(most * sizeof(uint32_t));
}

static void take(cloud *c, const qtr_mission *mission, uint32_t most, uint8_t *left) {
  const size_t cells = free_cells(mission);
  c->mission = mission;
  c->axes = axes_of(mission);
  c->cell = block_cut(&left, cells * sizeof(qtr_cell));
  c->at = block_cut(&left, cells * c->axes * sizeof(float));
  c->nearest = block_cut(&left, cells * sizeof(double));
  c->of = block_cut(&left, cells * sizeof(uint32_t));
  c->representative = block_cut(&left, most * sizeof(uint32_t));
  c->mean = block_cut(&left, most * c->axes * sizeof(double));
  c->best = block_cut(&left, most * sizeof(double));
  c->members = block_cut(&left, most * sizeof(uint32_t));
}

/* ---- points ---- */

static float *point_at(const cloud *c, uint32_t point) {
  return c->at + (size_t)point * c->axes;
}

/* sqrt() is rounded alike everywhere, as IEEE 754 has it. */
static float coordinate(double likelihood, qtr_steps steps) {
  return steps == QTR_NEVER ? NO_WAY : (float)sqrt(likelihood * (double)steps);
}

static bool measure(cloud *c, const qtr_game *game, qtr_travel *travel) {
  const qtr_mission *mission = c->mission;
  uint8_t encoding[2];
  const unsigned grounds = grounds_of(mission, encoding);
  for (unsigned axis = 0; axis < c->axes; axis++) {
    const unsigned place = axis / grounds;
    qtr_grid grid = qtr_mission_grid(mission);
    grid.encoding = encoding[axis % grounds];
    if (!qtr_watch_go_on(&mission->watch)) return false;
    qtr_travel_fill(travel, &grid, mission->place[place]);
    for (uint32_t i = 0; i < c->count; i++)
      point_at(c, i)[axis] = coordinate(game->probability[place], travel->to_go[c->cell[i]]);
  }
  return true;
}

static bool reaches_any(const cloud *c, uint32_t point) {
  for (unsigned axis = 0; axis < c->axes; axis++)
    if (point_at(c, point)[axis] != NO_WAY) return true;
  return false;
}

/* All free cells, and then those of them that are good for something. */
static bool make_points(cloud *c, const qtr_game *game, qtr_travel *travel) {
  c->count = 0;
  for (uint32_t cell = 0; cell < qtr_mission_cells(c->mission); cell++)
    if (c->mission->cost[cell] > 0) c->cell[c->count++] = (qtr_cell)cell;
  if (!measure(c, game, travel)) return false;
  uint32_t kept = 0;
  for (uint32_t i = 0; i < c->count; i++) {
    if (!reaches_any(c, i)) continue;
    c->cell[kept] = c->cell[i];
    memmove(point_at(c, kept++), point_at(c, i), c->axes * sizeof(float));
  }
  c->count = kept;
  return true;
}

/* Squared distance, or what is known to be more than `limit`. */
static double distance(const cloud *c, uint32_t point, uint32_t other, double limit) {
  const float *a = point_at(c, point);
  const float *b = point_at(c, other);
  double sum = 0.0;
  for (unsigned axis = 0; axis < c->axes && sum <= limit; axis++) {
    if ((a[axis] == NO_WAY) != (b[axis] == NO_WAY)) return ELSEWHERE;
    const double apart = (double)a[axis] - (double)b[axis];
    sum += apart * apart;
  }
  return sum;
}

/* ---- clusters ---- */

static bool may_go_on(const cloud *c, uint32_t point) {
  return point % WATCHED != 0 || qtr_watch_go_on(&c->mission->watch);
}

/* Let the last representative have the points that are nearer to it than to theirs; `*farthest` is the point that is
 * then farthest from its own. */
static bool claim(cloud *c, uint32_t *farthest) {
  const uint32_t last = c->representatives - 1;
  *farthest = 0;
  for (uint32_t i = 0; i < c->count; i++) {
    if (!may_go_on(c, i)) return false;
    const double apart = distance(c, i, c->representative[last], c->nearest[i]);
    if (apart < c->nearest[i]) {
      c->nearest[i] = apart;
      c->of[i] = last;
    }
    if (c->nearest[i] > c->nearest[*farthest]) *farthest = i;
  }
  return true;
}

/* Until there are enough, or no point is apart from its representative. */
static int spread(cloud *c, uint32_t most) {
  uint32_t farthest = 0;
  for (uint32_t i = 0; i < c->count; i++) c->nearest[i] = DBL_MAX;
  for (c->representatives = 0; c->representatives < most && c->nearest[farthest] > 0.0;) {
    c->representative[c->representatives++] = farthest;
    if (!claim(c, &farthest)) return QTR_ERR_STOPPED;
  }
  return c->nearest[farthest] < ELSEWHERE ? QTR_OK : QTR_ERR_LIMIT;
}

static double *mean_of(const cloud *c, uint32_t representative) {
  return c->mean + (size_t)representative * c->axes;
}

/* Of a cluster all members reach the same places: where there is no way, the mean is that, too. */
static void find_means(cloud *c, uint32_t stride) {
  for (uint32_t r = 0; r < c->representatives; r++) {
    c->members[r] = 0;
    c->best[r] = DBL_MAX;
    for (unsigned axis = 0; axis < c->axes; axis++) mean_of(c, r)[axis] = 0.0;
  }
  for (uint32_t i = 0; i < c->count; i += stride) {
    c->members[c->of[i]]++;
    for (unsigned axis = 0; axis < c->axes; axis++) mean_of(c, c->of[i])[axis] += (double)point_at(c, i)[axis];
  }
  for (uint32_t r = 0; r < c->representatives; r++)
    for (unsigned axis = 0; c->members[r] > 0 && axis < c->axes; axis++) mean_of(c, r)[axis] /= c->members[r];
}

static double distance_to_mean(const cloud *c, uint32_t point) {
  const float *at = point_at(c, point);
  const double *mean = mean_of(c, c->of[point]);
  double sum = 0.0;
  for (unsigned axis = 0; axis < c->axes; axis++) {
    if (at[axis] == NO_WAY) continue;
    const double apart = (double)at[axis] - mean[axis];
    sum += apart * apart;
  }
  return sum;
}

static void move(cloud *c, uint32_t stride) {
  find_means(c, stride);
  for (uint32_t i = 0; i < c->count; i += stride) {
    const double apart = distance_to_mean(c, i);
    if (apart >= c->best[c->of[i]]) continue;
    c->best[c->of[i]] = apart;
    c->representative[c->of[i]] = i;
  }
}

/* Each point, or every so many-th, to the nearest representative; the first of equal ones. */
static bool assign(cloud *c, uint32_t stride) {
  for (uint32_t i = 0; i < c->count; i += stride) {
    if (!may_go_on(c, i / stride)) return false;
    c->nearest[i] = DBL_MAX;
    for (uint32_t r = 0; r < c->representatives; r++) {
      const double apart = distance(c, i, c->representative[r], c->nearest[i]);
      if (apart >= c->nearest[i]) continue;
      c->nearest[i] = apart;
      c->of[i] = r;
    }
  }
  return true;
}

/* By a sample of the cells where there are many, and in the end for all of them. */
static int settle(cloud *c) {
  const uint32_t stride = 1 + c->count / SAMPLE_MOST;
  for (unsigned round = 0; round < ROUNDS; round++) {
    move(c, stride);
    if (!assign(c, stride)) return QTR_ERR_STOPPED;
  }
  return stride == 1 || assign(c, 1) ? QTR_OK : QTR_ERR_STOPPED;
}

/* ---- the whole ---- */

static void add_cell(qtr_regions *regions, qtr_cell cell, uint32_t region) {
  regions->of[cell] = (qtr_region)region;
  regions->size[region] = (uint16_t)(regions->size[region] + (regions->size[region] < UINT16_MAX));
}

/* The last region is of the free cells that are no points. */
static int write_regions(qtr_regions *regions, const cloud *c) {
  const qtr_mission *mission = c->mission;
  const bool all = free_cells(mission) == c->count;
  regions->cells = qtr_mission_cells(mission);
  regions->count = c->representatives + (all ? 0 : 1);
  if (regions->count > QTR_MAX_REGIONS) return QTR_ERR_LIMIT;
  memset(regions->size, 0, regions->count * sizeof *regions->size);
  for (uint32_t cell = 0; cell < regions->cells; cell++) regions->of[cell] = QTR_NO_REGION;
  for (uint32_t r = 0; r < c->representatives; r++) regions->representative[r] = c->cell[c->representative[r]];
  for (uint32_t i = 0; i < c->count; i++) add_cell(regions, c->cell[i], c->of[i]);
  for (uint32_t cell = regions->cells; !all && cell-- > 0;) {
    if (mission->cost[cell] == 0 || regions->of[cell] < c->representatives) continue;
    add_cell(regions, (qtr_cell)cell, c->representatives);
    regions->representative[c->representatives] = (qtr_cell)cell;
  }
  return QTR_OK;
}

int qtr_start_regions_build_built(qtr_regions *regions, const qtr_game *game, uint32_t most, qtr_travel *travel,
                                  void *scratch, size_t bytes, uint32_t config_id) {
  cloud c;
  if (config_id != QTR_CONFIG_ID) return QTR_ERR_CONFIG;
  if (most == 0) return QTR_ERR_ARGUMENT;
  if (most > QTR_MAX_REGIONS) return QTR_ERR_LIMIT;
  int status = block_check(scratch, bytes, qtr_start_regions_bytes(game, most));
  if (status != QTR_OK) return status;
  take(&c, game->mission, most, scratch);
  if (!make_points(&c, game, travel)) return QTR_ERR_STOPPED;
  status = spread(&c, most);
  if (status == QTR_OK) status = settle(&c);
  return status == QTR_OK ? write_regions(regions, &c) : status;
}

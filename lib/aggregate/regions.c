#include "quarter/regions.h"

#include <float.h>
#include <string.h>

#define WINDOW_SHARE 2 /* times max_size: the cells that a region may choose from while it grows */
#define ROUNDS 2       /* of exchanging and dissolving; a third takes a tenth longer for one region less in 500 */

/* A division under way. */
typedef struct {
  qtr_regions *regions;
  const qtr_regions_config *config;
  qtr_regions_scratch *scratch;
  qtr_nearby *nearby; /* the scratch's */
  uint32_t cells;
} division;

static bool may_go_on(const division *d) {
  return qtr_watch_go_on(&d->config->watch);
}

/* How many of a cell's neighbours are in a region. */
static int neighbours_in(const division *d, qtr_cell cell, qtr_region region) {
  qtr_cell next[4];
  const int count = qtr_nearby_neighbours(d->nearby, cell, next);
  int in = 0;
  for (int i = 0; i < count; i++) in += d->regions->of[next[i]] == region;
  return in;
}

/* List the cells of a region that are joined to `from` within it, nearest first, at most `most`. */
static void list_region(const division *d, qtr_cell from, qtr_region region, uint32_t most) {
  qtr_nearby *nearby = d->nearby;
  qtr_cell next[4];
  qtr_nearby_clear(nearby);
  qtr_nearby_list(nearby, from);
  for (uint32_t i = 0; i < nearby->listed; i++) {
    const int count = qtr_nearby_neighbours(nearby, nearby->list[i], next);
    for (int k = 0; k < count && nearby->listed < most; k++)
      if (d->regions->of[next[k]] == region) qtr_nearby_list(nearby, next[k]);
  }
}

static void list_whole(const division *d, qtr_region region) {
  list_region(d, d->regions->representative[region], region, d->regions->size[region]);
}

/* ---- distances ---- */

/* Whether the map lets two places be of one region and their likelihoods do not. */
static bool are_unlike(const qtr_regions_config *config, unsigned p, unsigned q, qtr_steps away) {
  const double a = config->weight[p];
  const double b = config->weight[q];
  return away * (1.0 + config->likelihood * ((a > b ? a / b : b / a) - 1.0)) > config->diameter;
}

/* Let the listed places that are unlike this one be too far from it; true if there are none. */
static bool keep_apart(const division *d, unsigned place) {
  qtr_nearby *nearby = d->nearby;
  bool alike = true;
  for (unsigned q = 0; q < d->config->places; q++) {
    const unsigned slot = nearby->slot[d->config->place[q]];
    if (slot == 0 || nearby->away[slot - 1] == QTR_NEVER) continue;
    if (!are_unlike(d->config, place, q, nearby->away[slot - 1])) continue;
    nearby->away[slot - 1] = QTR_NEVER;
    alike = false;
  }
  return alike;
}

/* The distances of the listed cells from `from`; true if none may not be of its region. */
static bool measure(const division *d, qtr_cell from) {
  bool near = qtr_nearby_measure(d->nearby, from, d->config->diameter);
  if (!(d->config->likelihood > 0.0)) return near;
  for (unsigned p = 0; p < d->config->places; p++)
    if (d->config->place[p] == from && !keep_apart(d, p)) near = false;
  return near;
}

/* ---- representatives ---- */

/* The sum of a listed region's distances from a member. */
static uint32_t sum_from(const division *d, qtr_cell member) {
  uint32_t sum = 0;
  measure(d, member);
  for (uint32_t i = 0; i < d->nearby->listed; i++) sum += d->nearby->away[i];
  return sum;
}

static void represent(const division *d, qtr_region region, qtr_cell member) {
  measure(d, member);
  for (uint32_t i = 0; i < d->nearby->listed; i++) {
    /* What taking the representative's time for a member's is wrong by (section 5.2.3) is within the diameter. */
    QTR_ASSERT(d->nearby->away[i] <= d->config->diameter);
    d->scratch->error[d->nearby->list[i]] = (uint16_t)d->nearby->away[i];
  }
  d->regions->representative[region] = member;
  d->scratch->changed[region] = 0;
}

static void find_median(const division *d, qtr_region region) {
  list_whole(d, region);
  /* A region is connected: all of it is found from any of its cells. */
  QTR_ASSERT(d->nearby->listed == d->regions->size[region]);
  qtr_cell median = d->nearby->list[0];
  uint32_t least = sum_from(d, median);
  for (uint32_t i = 1; i < d->nearby->listed; i++) {
    const qtr_cell member = d->nearby->list[i];
    const uint32_t sum = sum_from(d, member);
    if (sum > least || (sum == least && member > median)) continue;
    least = sum;
    median = member;
  }
  represent(d, region, median);
}

/* The member next to `cell` whose sum is least, if it is below *least; else the cell itself. */
static qtr_cell step_down(const division *d, qtr_cell cell, uint32_t *least) {
  qtr_cell next[4];
  qtr_cell best = cell;
  const int count = qtr_nearby_neighbours(d->nearby, cell, next);
  for (int i = 0; i < count; i++) {
    if (d->nearby->slot[next[i]] == 0) continue;
    uint32_t *sum = &d->scratch->sum[d->nearby->slot[next[i]] - 1];
    if (*sum == 0) *sum = sum_from(d, next[i]);
    if (*sum >= *least) continue;
    *least = *sum;
    best = next[i];
  }
  return best;
}

/* Nearly the median, step by step from the representative there was: for regions that will change again, at a fraction
 * of the searches. */
static void follow_median(const division *d, qtr_region region) {
  list_whole(d, region);
  memset(d->scratch->sum, 0, d->nearby->listed * sizeof *d->scratch->sum);
  qtr_cell at = d->regions->representative[region];
  uint32_t least = sum_from(d, at);
  for (qtr_cell from = QTR_NO_CELL; from != at;) {
    from = at;
    at = step_down(d, from, &least);
  }
  represent(d, region, at);
}

static void follow_medians(const division *d) {
  for (uint32_t region = 0; region < d->regions->count && may_go_on(d); region++)
    if (d->scratch->changed[region] && d->regions->size[region] > 0) follow_median(d, (qtr_region)region);
}

/* ---- growing ---- */

static void unlist(const division *d, uint32_t index) {
  qtr_regions_scratch *s = d->scratch;
  qtr_nearby_unlist(d->nearby, index);
  s->sum[index] = s->sum[d->nearby->listed];
  s->touching[index] = s->touching[d->nearby->listed];
}

/* Make the cell a member. It and the cells that are too far from it leave the list of those that may still join. */
static void join(const division *d, qtr_cell cell, qtr_region region) {
  qtr_nearby *nearby = d->nearby;
  qtr_cell next[4];
  d->regions->of[cell] = region;
  d->regions->size[region]++;
  unlist(d, nearby->slot[cell] - 1u);
  const int count = qtr_nearby_neighbours(nearby, cell, next);
  for (int i = 0; i < count; i++)
    if (nearby->slot[next[i]] != 0) d->scratch->touching[nearby->slot[next[i]] - 1]++;
  measure(d, cell);
  for (uint32_t i = nearby->listed; i-- > 0;) {
    if (nearby->away[i] == QTR_NEVER)
      unlist(d, i);
    else
      d->scratch->sum[i] += nearby->away[i];
  }
}

/* What a listed cell costs the region that takes it: near to the members is good, and so are few free neighbours that
 * are left over. A cell that would be left alone is taken at once. */
static uint64_t find_price(const division *d, uint32_t index, qtr_region region) {
  const int open = neighbours_in(d, d->nearby->list[index], QTR_NO_REGION);
  if (open == 0) return 0;
  return 2 * (uint64_t)d->scratch->sum[index] + (uint64_t)open * d->regions->size[region];
}

/* The best cell next to the growing region; QTR_NO_CELL if there is none. */
static qtr_cell choose(const division *d, qtr_region region) {
  uint64_t least = UINT64_MAX;
  qtr_cell best = QTR_NO_CELL;
  for (uint32_t i = 0; i < d->nearby->listed; i++) {
    if (d->scratch->touching[i] == 0) continue;
    const uint64_t price = find_price(d, i, region);
    if (price > least || (price == least && d->nearby->list[i] > best)) continue;
    least = price;
    best = d->nearby->list[i];
  }
  return best;
}

static void grow(const division *d, qtr_cell seed) {
  qtr_regions_scratch *s = d->scratch;
  const qtr_region region = (qtr_region)d->regions->count++;
  list_region(d, seed, QTR_NO_REGION, WINDOW_SHARE * d->config->max_size);
  memset(s->sum, 0, d->nearby->listed * sizeof *s->sum);
  memset(s->touching, 0, d->nearby->listed * sizeof *s->touching);
  d->regions->representative[region] = seed;
  d->regions->size[region] = 0;
  s->changed[region] = 1;
  qtr_cell cell = seed;
  while (cell != QTR_NO_CELL) {
    join(d, cell, region);
    cell = d->regions->size[region] < d->config->max_size ? choose(d, region) : QTR_NO_CELL;
  }
}

/* Let the free cells beside a region wait, each once: its error, not known yet, marks it. */
static uint32_t line_up(const division *d, qtr_region region, uint32_t waiting) {
  qtr_regions_scratch *s = d->scratch;
  qtr_cell next[4];
  list_whole(d, region);
  for (uint32_t i = 0; i < d->nearby->listed; i++) {
    const int count = qtr_nearby_neighbours(d->nearby, d->nearby->list[i], next);
    for (int k = 0; k < count; k++) {
      if (d->regions->of[next[k]] != QTR_NO_REGION || s->error[next[k]] != 0) continue;
      s->error[next[k]] = 1;
      s->waiting[waiting++] = next[k];
    }
  }
  return waiting;
}

/* The tightest corner of the ground left over near a cell, the furthest of several: a region that starts there leaves
 * fewer crumbs behind. */
static qtr_cell find_corner(const division *d, qtr_cell from) {
  qtr_cell best = from;
  int least = 4;
  list_region(d, from, QTR_NO_REGION, d->config->max_size);
  for (uint32_t i = 0; i < d->nearby->listed; i++) {
    const int open = neighbours_in(d, d->nearby->list[i], QTR_NO_REGION);
    if (open > least) continue;
    least = open;
    best = d->nearby->list[i];
  }
  return best;
}

/* Cover all ground that is joined to `start`, from the regions there are outwards. */
static int cover(const division *d, qtr_cell start) {
  const qtr_cell *waiting = d->scratch->waiting;
  uint32_t lined_up = 0;
  uint32_t at = 0;
  qtr_cell from = start;
  for (;;) {
    if (d->regions->count == QTR_MAX_REGIONS) return QTR_ERR_LIMIT;
    if (!may_go_on(d)) return QTR_ERR_STOPPED;
    grow(d, find_corner(d, from));
    lined_up = line_up(d, (qtr_region)(d->regions->count - 1), lined_up);
    while (at < lined_up && d->regions->of[waiting[at]] != QTR_NO_REGION) at++;
    if (at == lined_up) return QTR_OK;
    from = waiting[at];
  }
}

static int cover_all(const division *d) {
  for (uint32_t cell = 0; cell < d->cells; cell++) {
    if (qtr_grid_cost(d->nearby->grid, (qtr_cell)cell) == 0 || d->regions->of[cell] != QTR_NO_REGION) continue;
    const int status = cover(d, (qtr_cell)cell);
    if (status != QTR_OK) return status;
  }
  return QTR_OK;
}

/* ---- moving cells from region to region ---- */

static void move(const division *d, qtr_cell cell, qtr_region to) {
  const qtr_region from = d->regions->of[cell];
  d->regions->size[from]--;
  d->regions->size[to]++;
  d->regions->of[cell] = to;
  d->scratch->changed[from] = d->scratch->changed[to] = 1;
}

static bool has_room(const division *d, qtr_region region) {
  return d->regions->size[region] < d->config->max_size;
}

static bool is_connected(const division *d, qtr_region region) {
  list_whole(d, region);
  return d->nearby->listed == d->regions->size[region];
}

/* Whether a region is in order now that it has this cell. */
static bool holds(const division *d, qtr_region region, qtr_cell cell) {
  list_region(d, cell, region, d->regions->size[region]);
  return d->nearby->listed == d->regions->size[region] && measure(d, cell);
}

/* Move the cell if both regions stay in order. */
static bool try_move(const division *d, qtr_cell cell, qtr_region to) {
  const qtr_region from = d->regions->of[cell];
  move(d, cell, to);
  if (is_connected(d, from) && holds(d, to, cell)) return true;
  move(d, cell, from);
  return false;
}

/* ---- exchanging: cells go to the nearer of two representatives ---- */

/* The cell that a full region would best give to another one, and what its distance becomes; QTR_NO_CELL if that would
 * lose all of `gain`. */
static qtr_cell find_return(const division *d, qtr_region full, qtr_region other, qtr_steps gain, qtr_steps *away) {
  const qtr_nearby *nearby = d->nearby;
  qtr_cell best = QTR_NO_CELL;
  int64_t least = gain;
  list_whole(d, full);
  measure(d, d->regions->representative[other]);
  for (uint32_t i = 0; i < nearby->listed; i++) {
    const qtr_cell cell = nearby->list[i];
    if (nearby->away[i] == QTR_NEVER || cell == d->regions->representative[full]) continue;
    const int64_t loss = (int64_t)nearby->away[i] - d->scratch->error[cell];
    if (loss >= least || neighbours_in(d, cell, other) == 0) continue;
    least = loss;
    best = cell;
    *away = nearby->away[i];
  }
  return best;
}

/* Trade the cell for one of a full region. */
static bool try_trade(const division *d, qtr_cell cell, qtr_region full, qtr_steps gain) {
  const qtr_region other = d->regions->of[cell];
  qtr_steps away = 0;
  const qtr_cell back = find_return(d, full, other, gain, &away);
  if (back == QTR_NO_CELL) return false;
  move(d, cell, full);
  move(d, back, other);
  if (holds(d, full, cell) && holds(d, other, back)) {
    d->scratch->error[back] = (uint16_t)away;
    return true;
  }
  move(d, cell, other);
  move(d, back, full);
  return false;
}

/* Add a cell to those chosen, the greatest gain first. */
static void insert_chosen(qtr_regions_scratch *s, qtr_cell cell, qtr_steps away) {
  const uint32_t gain = s->error[cell] - away;
  uint32_t at = s->chosen_count++;
  for (; at > 0 && s->error[s->chosen[at - 1]] - s->chosen_away[at - 1] < gain; at--) {
    s->chosen[at] = s->chosen[at - 1];
    s->chosen_away[at] = s->chosen_away[at - 1];
  }
  s->chosen[at] = cell;
  s->chosen_away[at] = away;
}

/* Choose the cells beside a region that are nearer to its representative than to their own. */
static void choose_nearer(const division *d, qtr_region region) {
  qtr_nearby *nearby = d->nearby;
  qtr_cell next[4];
  list_whole(d, region);
  const uint32_t members = nearby->listed;
  for (uint32_t i = 0; i < members; i++) {
    const int count = qtr_nearby_neighbours(nearby, nearby->list[i], next);
    for (int k = 0; k < count; k++) qtr_nearby_list(nearby, next[k]);
  }
  measure(d, d->regions->representative[region]);
  d->scratch->chosen_count = 0;
  for (uint32_t i = members; i < nearby->listed; i++)
    if (nearby->away[i] < d->scratch->error[nearby->list[i]])
      insert_chosen(d->scratch, nearby->list[i], nearby->away[i]);
}

static void attract(const division *d, qtr_region region) {
  qtr_regions_scratch *s = d->scratch;
  choose_nearer(d, region);
  for (uint32_t i = 0; i < s->chosen_count; i++) {
    const qtr_cell cell = s->chosen[i];
    const qtr_steps away = s->chosen_away[i];
    const bool moved =
        has_room(d, region) ? try_move(d, cell, region) : try_trade(d, cell, region, s->error[cell] - away);
    if (moved) s->error[cell] = (uint16_t)away;
  }
}

static void exchange(const division *d) {
  for (uint32_t region = 0; region < d->regions->count && may_go_on(d); region++)
    if (d->regions->size[region] > 0) attract(d, (qtr_region)region);
  follow_medians(d);
}

/* ---- dissolving: the cells of a small region are given to its neighbours ---- */

/* Give the cell to the neighbour with the most room. */
static bool give_away(const division *d, qtr_cell cell) {
  const qtr_region from = d->regions->of[cell];
  qtr_cell next[4];
  const int count = qtr_nearby_neighbours(d->nearby, cell, next);
  qtr_region best = QTR_NO_REGION;
  for (int i = 0; i < count; i++) {
    const qtr_region to = d->regions->of[next[i]];
    if (to == from || !has_room(d, to)) continue;
    if (best != QTR_NO_REGION && d->regions->size[to] >= d->regions->size[best]) continue;
    move(d, cell, to);
    if (holds(d, to, cell)) best = to;
    move(d, cell, from);
  }
  if (best == QTR_NO_REGION) return false;
  move(d, cell, best);
  return true;
}

/* All of the region's cells are given away, or none. */
static void dissolve_one(const division *d, qtr_region region) {
  qtr_regions_scratch *s = d->scratch;
  list_whole(d, region);
  s->chosen_count = d->nearby->listed;
  memcpy(s->chosen, d->nearby->list, s->chosen_count * sizeof *s->chosen);
  for (bool moved = true; moved && d->regions->size[region] > 0;) {
    moved = false;
    for (uint32_t i = s->chosen_count; i-- > 0;)
      if (d->regions->of[s->chosen[i]] == region) moved = give_away(d, s->chosen[i]) || moved;
  }
  if (d->regions->size[region] == 0) return;
  for (uint32_t i = 0; i < s->chosen_count; i++)
    if (d->regions->of[s->chosen[i]] != region) move(d, s->chosen[i], region);
}

static void dissolve(const division *d) {
  for (uint32_t size = 1; size < d->config->max_size; size++)
    for (uint32_t region = 0; region < d->regions->count; region++)
      if (d->regions->size[region] == size && may_go_on(d)) dissolve_one(d, (qtr_region)region);
  follow_medians(d);
}

/* ---- the whole ---- */

/* Number the regions that are left by their lowest cells. */
static void number(const division *d) {
  qtr_regions *regions = d->regions;
  qtr_cell *fresh = d->scratch->waiting;         /* the new number, by the old */
  qtr_cell *representative = d->nearby->reached; /* by the old number */
  for (uint32_t region = 0; region < regions->count; region++) fresh[region] = QTR_NO_CELL;
  memcpy(representative, regions->representative, regions->count * sizeof *representative);
  regions->count = 0;
  for (uint32_t cell = 0; cell < d->cells; cell++) {
    const qtr_region old = regions->of[cell];
    /* Every free cell is in a region, and no other. */
    QTR_ASSERT((old == QTR_NO_REGION) == (qtr_grid_cost(d->nearby->grid, (qtr_cell)cell) == 0));
    if (old == QTR_NO_REGION) continue;
    if (fresh[old] == QTR_NO_CELL) {
      fresh[old] = (qtr_cell)regions->count++;
      regions->representative[fresh[old]] = representative[old];
      regions->size[fresh[old]] = 0;
    }
    regions->of[cell] = (qtr_region)fresh[old];
    regions->size[fresh[old]]++;
    /* However cells were moved, no region has more than it may. */
    QTR_ASSERT(regions->size[fresh[old]] <= d->config->max_size);
  }
}

static int check(const qtr_grid *grid, const qtr_regions_config *config) {
  if (qtr_grid_cells(grid) == 0 || config->max_size == 0 || config->diameter == 0) return QTR_ERR_ARGUMENT;
  if (qtr_grid_cells(grid) > QTR_MAX_CELLS) return QTR_ERR_LIMIT;
  if (config->max_size > QTR_MAX_REGION_SIZE || config->diameter > QTR_MAX_REGION_DIAMETER) return QTR_ERR_LIMIT;
  return QTR_OK;
}

static int check_places(const qtr_grid *grid, const qtr_regions_config *config) {
  if (!(config->likelihood >= 0.0 && config->likelihood <= DBL_MAX)) return QTR_ERR_ARGUMENT;
  if (!(config->likelihood > 0.0)) return QTR_OK;
  if (config->places > QTR_MAX_PLACES) return QTR_ERR_LIMIT;
  for (unsigned p = 0; p < config->places; p++) {
    if (config->place[p] >= qtr_grid_cells(grid)) return QTR_ERR_PLACE;
    if (!(config->weight[p] > 0.0 && config->weight[p] <= DBL_MAX)) return QTR_ERR_WEIGHT;
  }
  return QTR_OK;
}

void qtr_regions_default(qtr_regions_config *config) {
  *config = (qtr_regions_config){.max_size = 25, .diameter = 15};
}

int qtr_regions_build_built(qtr_regions *regions, const qtr_grid *grid, const qtr_regions_config *config,
                            qtr_regions_scratch *scratch, uint32_t config_id) {
  int status = config_id == QTR_CONFIG_ID ? check(grid, config) : QTR_ERR_CONFIG;
  if (status == QTR_OK) status = check_places(grid, config);
  if (status != QTR_OK) return status;
  const division d = {regions, config, scratch, &scratch->nearby, qtr_grid_cells(grid)};
  regions->cells = d.cells;
  qtr_nearby_init(&scratch->nearby, grid);
  for (uint32_t cell = 0; cell < d.cells; cell++) regions->of[cell] = QTR_NO_REGION;
  memset(scratch->error, 0, d.cells * sizeof *scratch->error);
  regions->count = 0;
  status = cover_all(&d);
  if (status != QTR_OK) return status;
  follow_medians(&d);
  for (int round = 0; round < ROUNDS; round++) {
    exchange(&d);
    dissolve(&d);
  }
  exchange(&d);
  number(&d);
  for (uint32_t region = 0; region < regions->count && may_go_on(&d); region++) find_median(&d, (qtr_region)region);
  return may_go_on(&d) ? QTR_OK : QTR_ERR_STOPPED;
}

#include "search/selection.h"

#include <math.h>
#include <string.h>

#include "core/block.h"
#include "model/rounding.h"
#include "quarter/status.h"

#define ROW_ROOM (QTR_SELECTION_ACTIVE * 32u) /* ones of the active columns */
#define PIVOTS_A_STEP 64u
#define BOX 0.1          /* of the scale: how far prices may go from where they were good, at first */
#define LEAST_GAIN 1e-7  /* of the gap: what is less is nothing */
#define FINEST 1e-10     /* of the target */
#define ROUNDING 1e-12   /* of the scale */
#define LEAST_LEVEL 1e-4 /* of a column in the basis: what is less is none, or rows that are shifted */
#define TRIPLES_A_ROUND 24u
#define ROUND_DROP 0.02 /* of the gap, that a round of triples is to bring */
#define FRUITLESS_MOST 3u
#define PENALTY 4.0 /* times the scale, of a column that is ruled out; and times that where it stays */

enum phase { PHASE_LOOK = 0, PHASE_ENTER = 1, PHASE_OPTIMAL = 2, PHASE_STUCK = 3 };

static const qtr_bound *bound_of(const qtr_selection *s) {
  return s->pool->bound;
}

static unsigned places_of(const qtr_selection *s) {
  return bound_of(s)->game->board.places;
}

static const qtr_label *label_of(const qtr_selection *s, uint32_t choice) {
  return qtr_pool_label(s->pool, s->choice[choice].label);
}

/* What a place counts for, about: prices may all be 0. */
static double scale_of(const qtr_selection *s) {
  double sum = fabs(s->upper - s->left);
  for (unsigned place = 0; place < places_of(s); place++) sum += fabs(bound_of(s)->price[place]);
  return sum > 0.0 ? sum / (double)places_of(s) : 1.0;
}

/* Of a column: what is less is nothing. The gap is as wide as it likes where no game worth the name is known. */
static double least_gain(const qtr_selection *s) {
  const double gap = s->upper - s->target;
  const double relative = LEAST_GAIN * (gap < s->scale ? gap : s->scale);
  const double gain = relative < s->finest ? relative : s->finest;
  return gain > ROUNDING * s->scale ? gain : ROUNDING * s->scale;
}

/* ---- rows: places, squads, triples ---- */

static uint32_t row_of_squad(const qtr_selection *s, unsigned squad) {
  return places_of(s) + squad;
}

static uint32_t row_of_triple(const qtr_selection *s, uint32_t triple) {
  return places_of(s) + s->pool->squads + triple;
}

static void list_rows(const qtr_selection *s, uint32_t choice, qtr_column *column) {
  const qtr_label *label = label_of(s, choice);
  column->worth = s->choice[choice].worth;
  column->count = 0;
  for (unsigned place = 0; place < places_of(s); place++)
    if (qtr_label_has(label, place)) column->row[column->count++] = (uint16_t)place;
  column->row[column->count++] = (uint16_t)row_of_squad(s, label->squad);
  for (uint32_t t = 0; t < s->triples; t++)
    if (qtr_triple_counts(&s->triple[t], label)) column->row[column->count++] = (uint16_t)row_of_triple(s, t);
}

/* For the simplex method: what is ruled out must not pay. */
static void column_of(const void *context, int32_t number, qtr_column *column) {
  const qtr_selection *s = context;
  list_rows(s, (uint32_t)number, column);
  if (s->choice[number].off != 0) column->worth -= s->penalty * (double)column->count;
}

static void add_rows(qtr_selection *s) {
  const bool needs_all = qtr_objective_needs_all(&bound_of(s)->game->objective);
  const double box = BOX * s->scale;
  for (unsigned place = 0; place < places_of(s); place++) {
    const double price = bound_of(s)->price[place];
    qtr_simplex_add_row(&s->simplex, 1.0, price - box, price + box, !needs_all);
  }
  for (unsigned squad = 0; squad < s->pool->squads; squad++) {
    const double most = s->pool->squad[squad].most;
    qtr_simplex_add_row(&s->simplex, (double)s->pool->squad[squad].count, most - box, most + box, false);
  }
}

/* ---- set-up ---- */

static void list_choices(qtr_selection *s) {
  s->choices = 0;
  for (uint32_t label = 0; label < s->pool->labels; label++)
    if (qtr_pool_is_route(s->pool, label))
      s->choice[s->choices++] = (qtr_choice){qtr_pool_worth(s->pool, label), 0.0, label, 0, false};
}

static uint32_t bytes_of_set(const qtr_selection *s) {
  return (places_of(s) + 7) / 8;
}

static bool lay_out(qtr_selection *s, uint8_t *block, size_t bytes) {
  const uint32_t rows = places_of(s) + s->pool->squads + QTR_MOST_TRIPLES;
  const size_t simplex = qtr_simplex_bytes(rows);
  const size_t needed = (size_t)s->pool->routes * sizeof(qtr_choice) + simplex + rows * sizeof(double) +
                        (size_t)bytes_of_set(s) * 256 * sizeof(double) +
                        block_piece((QTR_SELECTION_ACTIVE + 1) * sizeof(uint32_t)) * 2 +
                        block_piece(ROW_ROOM * sizeof(uint16_t));
  if (bytes < needed) return false;
  s->choice = block_cut(&block, (size_t)s->pool->routes * sizeof(qtr_choice));
  s->price = block_cut(&block, rows * sizeof(double));
  s->sum_of_byte = block_cut(&block, (size_t)bytes_of_set(s) * 256 * sizeof(double));
  s->active = block_cut(&block, (QTR_SELECTION_ACTIVE + 1) * sizeof(uint32_t));
  s->row_begin = block_cut(&block, (QTR_SELECTION_ACTIVE + 1) * sizeof(uint32_t));
  s->row = block_cut(&block, ROW_ROOM * sizeof(uint16_t));
  qtr_simplex_init(&s->simplex, block_cut(&block, simplex), rows, column_of, s);
  return true;
}

bool qtr_selection_begin(qtr_selection *s, const qtr_pool *pool, void *block, size_t bytes, double target) {
  s->pool = pool;
  if (!lay_out(s, block, bytes)) return false;
  s->target = target;
  s->upper = s->node_upper = s->round_upper = pool->upper;
  s->left = qtr_objective_left(&bound_of(s)->game->objective, 1.0);
  s->triples = s->fruitless = s->actives = s->depth = 0;
  s->scale = scale_of(s);
  s->finest = FINEST * fabs(target);
  s->penalty = PENALTY * s->scale;
  list_choices(s);
  add_rows(s);
  qtr_simplex_refactor(&s->simplex);
  s->phase = PHASE_LOOK;
  return true;
}

/* ---- a look at all routes ---- */

static void take_prices(qtr_selection *s) {
  for (uint32_t row = 0; row < s->simplex.rows; row++) {
    const double price = s->simplex.price[row];
    s->price[row] = s->simplex.has_slack[row] && price < 0.0 ? 0.0 : price;
  }
  for (uint32_t byte = 0; byte < bytes_of_set(s); byte++) {
    double *sum = s->sum_of_byte + 256 * (size_t)byte;
    sum[0] = 0.0;
    for (unsigned bit = 0; bit < 8; bit++)
      for (unsigned less = 0; less < 1u << bit; less++)
        sum[(1u << bit) + less] = sum[less] + (8 * byte + bit < places_of(s) ? s->price[8 * byte + bit] : 0.0);
  }
}

static double net_of(const qtr_selection *s, uint32_t choice) {
  const qtr_label *label = label_of(s, choice);
  double net = s->choice[choice].worth;
  for (uint32_t byte = 0; byte < bytes_of_set(s); byte++)
    net -= s->sum_of_byte[256 * (size_t)byte + (label->set[byte / 4] >> (8 * (byte % 4)) & 0xFF)];
  for (uint32_t t = 0; t < s->triples; t++) {
    const double price = s->price[row_of_triple(s, t)];
    if (price > 0.0 && qtr_triple_counts(&s->triple[t], label)) net -= price;
  }
  return net;
}

/* The bound that the prices prove on games of the routes that are not ruled out; and of each squad the most. */
static double look(qtr_selection *s, double *most) {
  double upper = s->left;
  for (unsigned squad = 0; squad < s->pool->squads; squad++) most[squad] = -HUGE_VAL;
  for (uint32_t i = 0; i < s->choices; i++) {
    if (s->choice[i].off != 0) continue;
    const double net = s->choice[i].net = net_of(s, i);
    double *of_squad = &most[label_of(s, i)->squad];
    if (net > *of_squad) *of_squad = net;
  }
  for (unsigned place = 0; place < places_of(s); place++) upper += s->price[place];
  for (uint32_t t = 0; t < s->triples; t++) upper += s->price[row_of_triple(s, t)];
  for (unsigned squad = 0; squad < s->pool->squads; squad++) upper += (double)s->pool->squad[squad].count * most[squad];
  return upper;
}

static void mark_basis(qtr_selection *s, bool in_basis) {
  for (uint32_t i = 0; i < s->simplex.rows; i++)
    if (s->simplex.basis[i] >= 0) s->choice[s->simplex.basis[i]].in_basis = in_basis;
}

/* Before any branch what is dropped is dropped for good; the basis goes by the new numbers. */
static void compact(qtr_selection *s) {
  uint32_t kept = 0;
  for (uint32_t i = 0; i < s->choices; i++) {
    if (s->choice[i].off != 0) continue;
    if (s->choice[i].in_basis)
      for (uint32_t j = 0; j < s->simplex.rows; j++)
        if (s->simplex.basis[j] == (int32_t)i) s->simplex.basis[j] = (int32_t)kept;
    s->choice[kept++] = s->choice[i];
  }
  s->choices = kept;
}

/* Routes that are below the most of their squad by what is left of the gap, or more. */
static void drop(qtr_selection *s, const double *most) {
  const uint8_t level = (uint8_t)(s->depth + 1);
  const double gap = s->node_upper - s->target;
  mark_basis(s, true);
  for (uint32_t i = 0; i < s->choices; i++) {
    qtr_choice *choice = &s->choice[i];
    if (choice->off == 0 && !choice->in_basis && choice->net <= most[label_of(s, i)->squad] - gap) choice->off = level;
  }
  if (s->depth == 0) compact(s);
  mark_basis(s, false);
}

/* Of every so many routes the one that gains most: routes that stand together are much alike. */
static void list_active(qtr_selection *s) {
  double gain[QTR_SELECTION_ACTIVE];
  uint32_t best[QTR_SELECTION_ACTIVE];
  const double least = least_gain(s);
  for (uint32_t i = 0; i < QTR_SELECTION_ACTIVE; i++) gain[i] = least;
  for (uint32_t i = 0; i < s->choices; i++) {
    const double own = s->choice[i].net - s->price[row_of_squad(s, label_of(s, i)->squad)];
    if (s->choice[i].off != 0 || own <= gain[i % QTR_SELECTION_ACTIVE]) continue;
    gain[i % QTR_SELECTION_ACTIVE] = own;
    best[i % QTR_SELECTION_ACTIVE] = i;
  }
  s->actives = 0;
  s->row_begin[0] = 0;
  for (uint32_t i = 0; i < QTR_SELECTION_ACTIVE; i++) {
    const uint32_t begin = s->row_begin[s->actives];
    if (gain[i] <= least || begin + s->simplex.rows > ROW_ROOM) continue;
    qtr_column column = {0.0, 0, s->row + begin};
    list_rows(s, best[i], &column);
    s->active[s->actives++] = best[i];
    s->row_begin[s->actives] = begin + column.count;
  }
}

static void look_at_all(qtr_selection *s) {
  double most[QTR_MAX_SEEKERS];
  take_prices(s);
  const double upper = look(s, most);
  if (upper < s->node_upper) {
    s->node_upper = upper;
    if (s->depth == 0) s->upper = upper > s->target ? upper : s->target;
    drop(s, most);
  }
  list_active(s);
  s->entered = 0;
  s->phase = PHASE_ENTER;
}

/* ---- pivots among the active ---- */

static qtr_column active_column(const qtr_selection *s, uint32_t i) {
  const qtr_column column = {s->choice[s->active[i]].worth, s->row_begin[i + 1] - s->row_begin[i],
                             s->row + s->row_begin[i]};
  return column;
}

/* The one with the greatest gain enters. False: none has any. */
static bool enter_best(qtr_selection *s) {
  double most = least_gain(s);
  uint32_t best = s->actives;
  for (uint32_t i = 0; i < s->actives; i++) {
    const qtr_column column = active_column(s, i);
    const double gain = qtr_simplex_gain(&s->simplex, &column);
    if (gain <= most) continue;
    most = gain;
    best = i;
  }
  if (qtr_simplex_enter_elastic(&s->simplex, most)) return true;
  if (best == s->actives) return false;
  const qtr_column column = active_column(s, best);
  return qtr_simplex_enter(&s->simplex, (int32_t)s->active[best], &column);
}

static void enter_some(qtr_selection *s) {
  for (uint32_t i = 0; i < PIVOTS_A_STEP; i++) {
    if (!enter_best(s)) {
      s->phase = s->entered > 0 ? PHASE_LOOK : PHASE_OPTIMAL;
      return;
    }
    s->entered++;
  }
}

/* ---- the programme solved ---- */

static uint32_t mix(const qtr_selection *s, const qtr_label **route, double *share) {
  uint32_t count = 0;
  for (uint32_t i = 0; i < s->simplex.rows; i++) {
    if (s->simplex.basis[i] < 0 || s->simplex.level[i] <= LEAST_LEVEL) continue;
    route[count] = label_of(s, (uint32_t)s->simplex.basis[i]);
    share[count++] = s->simplex.level[i];
  }
  return count;
}

static bool is_whole(const qtr_mixture *mixture) {
  for (uint32_t i = 0; i < mixture->count; i++)
    if (mixture->share[i] < 1.0 - LEAST_LEVEL && mixture->route[i]->before != QTR_NO_LABEL) return false;
  return true;
}

/* A triple without a price may go. */
static void forget_triples(qtr_selection *s) {
  uint32_t kept = 0;
  for (uint32_t t = 0; t < s->triples; t++) {
    const uint32_t row = row_of_triple(s, kept);
    if (qtr_simplex_is_slack(&s->simplex, row)) {
      qtr_simplex_remove_row(&s->simplex, row);
    } else {
      s->triple[kept++] = s->triple[t];
    }
  }
  s->triples = kept;
}

static bool add_triples(qtr_selection *s, const qtr_mixture *mixture) {
  if (s->triples + TRIPLES_A_ROUND > QTR_MOST_TRIPLES) forget_triples(s);
  const unsigned room = QTR_MOST_TRIPLES - s->triples;
  const unsigned found = qtr_triples_broken(mixture, places_of(s), &s->triple[s->triples],
                                            room < TRIPLES_A_ROUND ? room : TRIPLES_A_ROUND);
  for (unsigned i = 0; i < found; i++) qtr_simplex_add_row(&s->simplex, 1.0, 0.0, s->scale, true);
  s->triples += found;
  qtr_simplex_refactor(&s->simplex);
  return found > 0;
}

/* ---- branches ---- */

static void begin_node(qtr_selection *s, double upper) {
  s->node_upper = s->round_upper = upper;
  s->fruitless = 0;
  for (uint32_t i = 0; i < s->choices; i++)
    if (s->choice[i].off == 0 && qtr_branch_rules_out(&s->branch[s->depth - 1], label_of(s, i)))
      s->choice[i].off = (uint8_t)s->depth;
  qtr_simplex_refactor(&s->simplex);
  s->phase = PHASE_LOOK;
}

static void forget_node(qtr_selection *s) {
  for (uint32_t i = 0; i < s->choices; i++)
    if (s->choice[i].off >= s->depth) s->choice[i].off = 0;
}

/* The other side of the last branch of which it has not been looked at. False: there is none. */
static bool go_back(qtr_selection *s) {
  for (; s->depth > 0; s->depth--) {
    qtr_branch *branch = &s->branch[s->depth - 1];
    forget_node(s);
    if (branch->last) continue;
    branch->last = true;
    branch->holds = !branch->holds;
    begin_node(s, branch->upper);
    return true;
  }
  return false;
}

static void add_branch(qtr_selection *s, const qtr_mixture *mixture) {
  qtr_branch branch;
  if (s->depth == QTR_SELECTION_DEPTH ||
      !qtr_branch_find(mixture, places_of(s), s->pool->squads, LEAST_LEVEL, &branch)) {
    s->phase = PHASE_STUCK;
    return;
  }
  branch.upper = s->node_upper;
  s->branch[s->depth++] = branch;
  begin_node(s, branch.upper);
}

/* ---- steps ---- */

/* Ruled out, and yet in use: what it costs is too little. */
static bool raise_penalty(qtr_selection *s) {
  for (uint32_t i = 0; i < s->simplex.rows; i++) {
    if (s->simplex.basis[i] < 0 || s->choice[s->simplex.basis[i]].off == 0 || s->simplex.level[i] <= LEAST_LEVEL)
      continue;
    s->penalty *= PENALTY;
    qtr_simplex_refactor(&s->simplex);
    return true;
  }
  return false;
}

static bool is_fruitless(qtr_selection *s) {
  if (s->round_upper - s->node_upper > ROUND_DROP * (s->node_upper - s->target))
    s->fruitless = 0;
  else
    s->fruitless++;
  s->round_upper = s->node_upper;
  return s->fruitless > (s->depth == 0 ? FRUITLESS_MOST : 1);
}

/* Triples as long as they bring something, then a branch. */
static enum qtr_selecting use_mixture(qtr_selection *s) {
  const qtr_label *route[QTR_MAX_PLACES + QTR_MAX_SEEKERS + QTR_MOST_TRIPLES];
  double share[QTR_MAX_PLACES + QTR_MAX_SEEKERS + QTR_MOST_TRIPLES];
  const qtr_mixture mixture = {mix(s, route, share), route, share};
  if (qtr_simplex_widen(&s->simplex, LEAST_LEVEL) || raise_penalty(s)) {
    s->phase = PHASE_LOOK;
    return QTR_SELECTING;
  }
  if (is_whole(&mixture)) return QTR_SELECTION_GAME;
  if (!is_fruitless(s) && add_triples(s, &mixture))
    s->phase = PHASE_LOOK;
  else
    add_branch(s, &mixture);
  return QTR_SELECTING;
}

static enum qtr_selecting step(qtr_selection *s) {
  switch (s->phase) {
  case PHASE_LOOK: look_at_all(s); return QTR_SELECTING;
  case PHASE_ENTER: enter_some(s); return QTR_SELECTING;
  case PHASE_OPTIMAL: return use_mixture(s);
  default: return QTR_SELECTION_STUCK;
  }
}

enum qtr_selecting qtr_selection_go_on(qtr_selection *s) {
  if (s->node_upper > s->target) return step(s);
  if (go_back(s)) return QTR_SELECTING;
  s->upper = s->target;
  return QTR_SELECTED;
}

void qtr_selection_routes(const qtr_selection *s, qtr_routes *routes) {
  const unsigned seekers = bound_of(s)->game->board.seekers;
  bool taken[QTR_MAX_SEEKERS] = {false};
  for (unsigned i = 0; i < QTR_MAX_ROUTES; i++) routes->length[i] = 0;
  for (uint32_t i = 0; i < s->simplex.rows; i++) {
    if (s->simplex.basis[i] < 0 || s->simplex.level[i] < 0.5) continue;
    const uint32_t label = s->choice[s->simplex.basis[i]].label;
    unsigned seeker = 0;
    while (seeker < seekers && (taken[seeker] || s->pool->squad_of[seeker] != qtr_pool_label(s->pool, label)->squad))
      seeker++;
    if (seeker == seekers || qtr_pool_label(s->pool, label)->before == QTR_NO_LABEL) continue;
    taken[seeker] = true;
    routes->length[seeker] = (uint16_t)qtr_pool_places(s->pool, label, routes->place[seeker]);
  }
}

void qtr_selection_raise(qtr_selection *s, double target) {
  if (target > s->target) s->target = target;
  if (s->node_upper > s->target) s->phase = PHASE_STUCK;
}

#include "search/master.h"

#include <math.h>
#include <string.h>

#include "core/block.h"
#include "model/rounding.h"
#include "quarter/status.h"

#define ROW_ROOM (QTR_MASTER_ACTIVE * 32u) /* ones of the active columns */
#define PIVOTS_A_STEP 64u
#define LEAST_GAIN 1e-7 /* of the gap: what is less is nothing */
#define FINEST 1e-10    /* of the target */
#define ROUNDING 1e-12  /* of the scale */
#define TRIPLES_A_ROUND 32u
#define TRIPLES_A_PLACE 8u
#define PENALTY 4.0 /* times the scale, of a column that is ruled out; and times that where it stays */

static const qtr_bound *bound_of(const qtr_master *m) {
  return m->pool->bound;
}

static unsigned places_of(const qtr_master *m) {
  return bound_of(m)->game->board.places;
}

/* What a place counts for, about: prices may all be 0. */
static double scale_of(const qtr_master *m, const qtr_duals *duals) {
  double sum = fabs(qtr_pool_upper(m->pool, duals) - qtr_objective_left(&bound_of(m)->game->objective, 1.0));
  for (unsigned place = 0; place < places_of(m); place++) sum += fabs(duals->place[place]);
  return sum > 0.0 ? sum / (double)places_of(m) : 1.0;
}

/* The gap is as wide as it likes where no game worth the name is known. */
void qtr_master_be_as_fine(qtr_master *m, double gap, double target) {
  const double relative = LEAST_GAIN * (gap < m->scale ? gap : m->scale);
  const double finest = FINEST * fabs(target);
  const double gain = relative < finest ? relative : finest;
  m->least_gain = gain > ROUNDING * m->scale ? gain : ROUNDING * m->scale;
}

/* ---- rows: places, squads, triples ---- */

static uint32_t row_of_squad(const qtr_master *m, unsigned squad) {
  return places_of(m) + squad;
}

static uint32_t row_of_triple(const qtr_master *m, uint32_t triple) {
  return places_of(m) + m->pool->squads + triple;
}

static bool counts(const qtr_choice *choice, uint32_t triple) {
  return (choice->counts[triple / 8] >> (triple % 8) & 1u) != 0;
}

static void list_rows(const qtr_master *m, uint32_t choice, qtr_column *column) {
  const qtr_label *label = qtr_master_label(m, choice);
  column->worth = m->choice[choice].worth;
  column->count = 0;
  for (unsigned place = 0; place < places_of(m); place++)
    if (qtr_label_has(label, place)) column->row[column->count++] = (uint16_t)place;
  column->row[column->count++] = (uint16_t)row_of_squad(m, label->squad);
  for (uint32_t t = 0; t < m->triples; t++)
    if (counts(&m->choice[choice], t)) column->row[column->count++] = (uint16_t)row_of_triple(m, t);
}

/* For the simplex method: what is ruled out must not pay. */
static void column_of(const void *context, int32_t number, qtr_column *column) {
  const qtr_master *m = context;
  list_rows(m, (uint32_t)number, column);
  if (m->choice[number].off != 0) column->worth -= m->penalty * (double)column->count;
}

/* For which of the triples from `first` on each of the routes counts. */
static void count_triples(qtr_master *m, uint32_t first) {
  for (uint32_t i = 0; i < m->choices; i++) {
    const qtr_label *label = qtr_master_label(m, i);
    uint8_t *of_choice = m->choice[i].counts;
    for (uint32_t t = first; t < m->triples; t++) {
      const uint8_t bit = (uint8_t)(1u << (t % 8));
      of_choice[t / 8] =
          (uint8_t)(qtr_triple_counts(&m->triple[t], label) ? of_choice[t / 8] | bit : of_choice[t / 8] & ~bit);
    }
  }
}

static void add_rows(qtr_master *m, const qtr_duals *from, const qtr_boxes *boxes) {
  const bool needs_all = qtr_objective_needs_all(&bound_of(m)->game->objective);
  const double box = boxes->of_places * m->scale;
  const double wide = boxes->of_squads * m->scale;
  for (unsigned place = 0; place < places_of(m); place++)
    qtr_simplex_add_row(&m->simplex, 1.0, from->place[place] - box, from->place[place] + box, !needs_all);
  for (unsigned squad = 0; squad < m->pool->squads; squad++)
    qtr_simplex_add_row(&m->simplex, (double)m->pool->squad[squad].count, from->squad[squad] - wide,
                        from->squad[squad] + wide, false);
  for (uint32_t t = 0; t < from->triples; t++) {
    m->triple[t] = from->triple[t];
    qtr_simplex_add_row(&m->simplex, 1.0, from->toll[t] - box, from->toll[t] + box, true);
  }
  m->triples = from->triples;
  count_triples(m, 0);
}

/* ---- set-up ---- */

static void list_choices(qtr_master *m) {
  m->choices = 0;
  for (uint32_t label = 0; label < m->pool->labels; label++)
    if (qtr_pool_is_route(m->pool, label))
      m->choice[m->choices++] = (qtr_choice){qtr_pool_worth(m->pool, label), 0.0, label, 0, false, {0}};
}

static const size_t bytes_of_triples = QTR_MOST_TRIPLES / 8;

static uint32_t bytes_of_set(const qtr_master *m) {
  return (places_of(m) + 7) / 8;
}

uint32_t qtr_master_triples_most(const qtr_pool *pool) {
  const uint32_t most = TRIPLES_A_PLACE * pool->bound->game->board.places;
  return most < QTR_MOST_TRIPLES ? most : QTR_MOST_TRIPLES;
}

static uint32_t rows_of(const qtr_master *m) {
  return places_of(m) + m->pool->squads + qtr_master_triples_most(m->pool);
}

static size_t bytes_of(const qtr_master *m) {
  const uint32_t rows = rows_of(m);
  return (size_t)m->pool->routes * sizeof(qtr_choice) + qtr_simplex_bytes(rows) + 2 * rows * sizeof(double) +
         block_piece(rows * sizeof(qtr_label *)) + (bytes_of_set(m) + bytes_of_triples) * 256 * sizeof(double) +
         block_piece((QTR_MASTER_ACTIVE + 1) * sizeof(uint32_t)) * 2 + block_piece(ROW_ROOM * sizeof(uint16_t));
}

static void lay_out(qtr_master *m, uint8_t *block) {
  const uint32_t rows = rows_of(m);
  m->choice = block_cut(&block, (size_t)m->pool->routes * sizeof(qtr_choice));
  m->price = block_cut(&block, rows * sizeof(double));
  m->share = block_cut(&block, rows * sizeof(double));
  m->mixed = block_cut(&block, rows * sizeof(qtr_label *));
  m->sum_of_byte = block_cut(&block, (size_t)bytes_of_set(m) * 256 * sizeof(double));
  m->toll_of_byte = block_cut(&block, bytes_of_triples * 256 * sizeof(double));
  m->active = block_cut(&block, (QTR_MASTER_ACTIVE + 1) * sizeof(uint32_t));
  m->row_begin = block_cut(&block, (QTR_MASTER_ACTIVE + 1) * sizeof(uint32_t));
  m->row = block_cut(&block, ROW_ROOM * sizeof(uint16_t));
  qtr_simplex_init(&m->simplex, block, rows, column_of, m);
}

/* Choices stand in the order of their labels. */
static uint32_t choice_of(const qtr_master *m, uint32_t label) {
  uint32_t low = 0, high = m->choices;
  while (low + 1 < high) {
    const uint32_t middle = low + (high - low) / 2;
    if (m->choice[middle].label <= label)
      low = middle;
    else
      high = middle;
  }
  return low;
}

/* Rows that are new begin with their own elastic columns. */
static void take_basis(qtr_master *m, const qtr_basis *basis) {
  if (basis->rows > m->simplex.rows) return;
  for (uint32_t i = 0; i < basis->routes; i++) m->simplex.basis[i] = (int32_t)choice_of(m, basis->label[i]);
  for (uint32_t i = basis->routes; i < basis->rows; i++) m->simplex.basis[i] = basis->elastic[i - basis->routes];
}

void qtr_master_basis(const qtr_master *m, qtr_basis *basis) {
  basis->rows = m->simplex.rows;
  basis->routes = 0;
  for (uint32_t i = 0; i < basis->rows; i++) {
    const int32_t number = m->simplex.basis[i];
    if (number >= 0)
      basis->label[basis->routes++] = m->choice[number].label;
    else
      basis->elastic[i - basis->routes] = number;
  }
}

bool qtr_master_begin(qtr_master *m, const qtr_pool *pool, void *block, size_t bytes, const qtr_duals *from,
                      const qtr_basis *basis, const qtr_boxes *boxes) {
  m->pool = pool;
  if (bytes < bytes_of(m)) return false;
  lay_out(m, block);
  m->actives = m->entered = 0;
  m->scale = scale_of(m, from);
  m->least_gain = ROUNDING * m->scale;
  m->penalty = PENALTY * m->scale;
  list_choices(m);
  add_rows(m, from, boxes);
  take_basis(m, basis);
  qtr_simplex_refactor(&m->simplex);
  return true;
}

/* ---- a look at all routes ---- */

/* Of eight prices at most, the sum for each value of a byte. */
static void sum_up(double *sum, const double *price, uint32_t count) {
  sum[0] = 0.0;
  for (unsigned bit = 0; bit < 8; bit++)
    for (unsigned less = 0; less < 1u << bit; less++)
      sum[(1u << bit) + less] = sum[less] + (bit < count ? price[bit] : 0.0);
}

static void sum_up_all(double *sum, const double *price, uint32_t count) {
  for (uint32_t first = 0; first < count; first += 8)
    sum_up(sum + 256 * (size_t)(first / 8), price + first, count - first);
}

static void take_prices(qtr_master *m) {
  for (uint32_t row = 0; row < m->simplex.rows; row++) {
    const double price = m->simplex.price[row];
    m->price[row] = m->simplex.has_slack[row] && price < 0.0 ? 0.0 : price;
  }
  sum_up_all(m->sum_of_byte, m->price, places_of(m));
  sum_up_all(m->toll_of_byte, m->price + row_of_triple(m, 0), m->triples);
}

static double net_of(const qtr_master *m, uint32_t choice) {
  const qtr_label *label = qtr_master_label(m, choice);
  double net = m->choice[choice].worth;
  for (uint32_t byte = 0; byte < bytes_of_set(m); byte++)
    net -= m->sum_of_byte[256 * (size_t)byte + (label->set[byte / 4] >> (8 * (byte % 4)) & 0xFF)];
  for (uint32_t byte = 0; 8 * byte < m->triples; byte++)
    net -= m->toll_of_byte[256 * (size_t)byte + m->choice[choice].counts[byte]];
  return net;
}

double qtr_master_look(qtr_master *m, double *most) {
  double upper = qtr_objective_left(&bound_of(m)->game->objective, 1.0);
  take_prices(m);
  for (unsigned squad = 0; squad < m->pool->squads; squad++) most[squad] = -HUGE_VAL;
  for (uint32_t i = 0; i < m->choices; i++) {
    if (m->choice[i].off != 0) continue;
    const double net = m->choice[i].net = net_of(m, i);
    double *of_squad = &most[qtr_master_label(m, i)->squad];
    if (net > *of_squad) *of_squad = net;
  }
  for (unsigned place = 0; place < places_of(m); place++) upper += m->price[place];
  for (uint32_t t = 0; t < m->triples; t++) upper += m->price[row_of_triple(m, t)];
  for (unsigned squad = 0; squad < m->pool->squads; squad++) upper += (double)m->pool->squad[squad].count * most[squad];
  m->entered = 0;
  return upper;
}

void qtr_master_mark_basis(qtr_master *m, bool in_basis) {
  for (uint32_t i = 0; i < m->simplex.rows; i++)
    if (m->simplex.basis[i] >= 0) m->choice[m->simplex.basis[i]].in_basis = in_basis;
}

/* The basis goes by the new numbers. */
void qtr_master_compact(qtr_master *m) {
  uint32_t kept = 0;
  for (uint32_t i = 0; i < m->choices; i++) {
    if (m->choice[i].off != 0) continue;
    if (m->choice[i].in_basis)
      for (uint32_t j = 0; j < m->simplex.rows; j++)
        if (m->simplex.basis[j] == (int32_t)i) m->simplex.basis[j] = (int32_t)kept;
    m->choice[kept++] = m->choice[i];
  }
  m->choices = kept;
}

/* Of every so many routes the one that gains most: routes that stand together are much alike. */
void qtr_master_list_active(qtr_master *m) {
  double gain[QTR_MASTER_ACTIVE];
  uint32_t best[QTR_MASTER_ACTIVE];
  for (uint32_t i = 0; i < QTR_MASTER_ACTIVE; i++) gain[i] = m->least_gain;
  for (uint32_t i = 0; i < m->choices; i++) {
    const double own = m->choice[i].net - m->price[row_of_squad(m, qtr_master_label(m, i)->squad)];
    if (m->choice[i].off != 0 || own <= gain[i % QTR_MASTER_ACTIVE]) continue;
    gain[i % QTR_MASTER_ACTIVE] = own;
    best[i % QTR_MASTER_ACTIVE] = i;
  }
  m->actives = 0;
  m->row_begin[0] = 0;
  for (uint32_t i = 0; i < QTR_MASTER_ACTIVE; i++) {
    const uint32_t begin = m->row_begin[m->actives];
    if (gain[i] <= m->least_gain || begin + m->simplex.rows > ROW_ROOM) continue;
    qtr_column column = {0.0, 0, m->row + begin};
    list_rows(m, best[i], &column);
    m->active[m->actives++] = best[i];
    m->row_begin[m->actives] = begin + column.count;
  }
}

/* ---- pivots among the active ---- */

static qtr_column active_column(const qtr_master *m, uint32_t i) {
  const qtr_column column = {m->choice[m->active[i]].worth, m->row_begin[i + 1] - m->row_begin[i],
                             m->row + m->row_begin[i]};
  return column;
}

/* The one with the greatest gain enters. False: none has any. */
static bool enter_best(qtr_master *m) {
  double most = m->least_gain;
  uint32_t best = m->actives;
  for (uint32_t i = 0; i < m->actives; i++) {
    const qtr_column column = active_column(m, i);
    const double gain = qtr_simplex_gain(&m->simplex, &column);
    if (gain <= most) continue;
    most = gain;
    best = i;
  }
  if (qtr_simplex_enter_elastic(&m->simplex, most)) return true;
  if (best == m->actives) return false;
  const qtr_column column = active_column(m, best);
  return qtr_simplex_enter(&m->simplex, (int32_t)m->active[best], &column);
}

bool qtr_master_pivot(qtr_master *m) {
  for (uint32_t i = 0; i < PIVOTS_A_STEP; i++) {
    if (!enter_best(m)) return false;
    m->entered++;
  }
  return true;
}

/* ---- what the programme is at ---- */

void qtr_master_duals(const qtr_master *m, qtr_duals *duals) {
  for (unsigned place = 0; place < places_of(m); place++) duals->place[place] = m->price[place];
  duals->triples = m->triples;
  for (uint32_t t = 0; t < m->triples; t++) {
    duals->triple[t] = m->triple[t];
    duals->toll[t] = m->price[row_of_triple(m, t)];
  }
}

qtr_mixture qtr_master_mixture(const qtr_master *m) {
  uint32_t count = 0;
  for (uint32_t i = 0; i < m->simplex.rows; i++) {
    if (m->simplex.basis[i] < 0 || m->simplex.level[i] <= QTR_MASTER_LEAST_SHARE) continue;
    m->mixed[count] = qtr_master_label(m, (uint32_t)m->simplex.basis[i]);
    m->share[count++] = m->simplex.level[i];
  }
  return (qtr_mixture){count, m->mixed, m->share};
}

/* One whose slack is in the basis holds nobody back. */
static void forget_triples(qtr_master *m) {
  uint32_t kept = 0;
  for (uint32_t t = 0; t < m->triples; t++) {
    const uint32_t row = row_of_triple(m, kept);
    if (qtr_simplex_is_slack(&m->simplex, row)) {
      qtr_simplex_remove_row(&m->simplex, row);
    } else {
      m->triple[kept++] = m->triple[t];
    }
  }
  m->triples = kept;
}

bool qtr_master_add_triples(qtr_master *m, const qtr_mixture *mixture) {
  const uint32_t most = qtr_master_triples_most(m->pool);
  if (m->triples + TRIPLES_A_ROUND > most) {
    forget_triples(m);
    count_triples(m, 0);
  }
  const unsigned room = most - m->triples;
  const unsigned found = qtr_triples_broken(mixture, places_of(m), &m->triple[m->triples],
                                            room < TRIPLES_A_ROUND ? room : TRIPLES_A_ROUND);
  for (unsigned i = 0; i < found; i++) qtr_simplex_add_row(&m->simplex, 1.0, 0.0, m->scale, true);
  m->triples += found;
  count_triples(m, m->triples - found);
  qtr_simplex_refactor(&m->simplex);
  return found > 0;
}

bool qtr_master_raise_penalty(qtr_master *m) {
  for (uint32_t i = 0; i < m->simplex.rows; i++) {
    if (m->simplex.basis[i] < 0 || m->choice[m->simplex.basis[i]].off == 0 ||
        m->simplex.level[i] <= QTR_MASTER_LEAST_SHARE)
      continue;
    m->penalty *= PENALTY;
    qtr_simplex_refactor(&m->simplex);
    return true;
  }
  return false;
}

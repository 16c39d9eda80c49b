#include "search/pool.h"

#include <string.h>

#include "model/rounding.h"
#include "quarter/status.h"
#include "robot/board.h"

#define LABELS_A_HEAD 2u /* that the block has room for */
#define HEADS_A_LABEL 4u /* in use, of the layer that is grown from */
#define LEAST_HEADS 256u

enum label_state {
  LABEL_OPEN = 0,
  LABEL_BEATEN = 1, /* not grown from any more */
  LABEL_ROUTE = 2,
  LABEL_MARKED = 3, /* a route to be kept */
  LABEL_ON_WAY = 4  /* grown from to one of those */
};

static const qtr_gains *gains_of(const qtr_pool *pool) {
  return &pool->bound->gains;
}

static unsigned places_of(const qtr_pool *pool) {
  return pool->bound->game->board.places;
}

/* ---- seekers that set out alike ---- */

static bool is_of_squad(const qtr_squad *squad, const qtr_squad *other) {
  return squad->kind == other->kind && squad->node == other->node && squad->ready == other->ready;
}

static void list_squads(qtr_pool *pool) {
  const qtr_board *board = &pool->bound->game->board;
  pool->squads = 0;
  for (unsigned i = 0; i < board->seekers; i++) {
    const qtr_squad own = {gains_of(pool)->kind_of[i], 1, (uint16_t)(board->places + board->start_of[i]),
                           qtr_board_ready(board, i)};
    unsigned squad = 0;
    while (squad < pool->squads && !is_of_squad(&pool->squad[squad], &own)) squad++;
    pool->squad_of[i] = (uint8_t)squad;
    if (squad < pool->squads)
      pool->squad[squad].count++;
    else
      pool->squad[pool->squads++] = own;
  }
}

/* ---- prices ---- */

void qtr_pool_duals(const qtr_pool *pool, qtr_duals *duals) {
  const qtr_board *board = &pool->bound->game->board;
  duals->triples = 0;
  for (unsigned place = 0; place < board->places; place++) duals->place[place] = pool->bound->price[place];
  for (unsigned i = 0; i < board->seekers; i++) {
    int visits[QTR_MAX_PLACES] = {0};
    duals->squad[pool->squad_of[i]] = qtr_gains_walk(gains_of(pool), i, visits);
  }
}

double qtr_pool_upper(const qtr_pool *pool, const qtr_duals *duals) {
  double upper = qtr_objective_left(&pool->bound->game->objective, 1.0);
  for (unsigned place = 0; place < places_of(pool); place++) upper += duals->place[place];
  for (uint32_t t = 0; t < duals->triples; t++) upper += duals->toll[t];
  for (unsigned squad = 0; squad < pool->squads; squad++) upper += pool->squad[squad].count * duals->squad[squad];
  return upper;
}

/* The triples of each place, one place behind the other. */
static void list_tolls(qtr_pool *pool) {
  const qtr_duals *duals = pool->duals;
  uint32_t count = 0;
  for (unsigned place = 0; place < places_of(pool); place++) {
    pool->toll_begin[place] = count;
    for (uint32_t t = 0; t < duals->triples; t++) {
      const uint16_t *of = duals->triple[t].place;
      for (unsigned i = 0; i < 3; i++)
        if (of[i] == place && duals->toll[t] > 0.0)
          pool->toll[count++] = (qtr_toll){{of[(i + 1) % 3], of[(i + 2) % 3]}, duals->toll[t]};
    }
  }
  pool->toll_begin[places_of(pool)] = count;
}

/* What a label pays that goes on to a place: tolls of the triples that it is the second one of. */
static double toll_at(const qtr_pool *pool, const qtr_label *label, unsigned place) {
  double toll = 0.0;
  for (uint32_t i = pool->toll_begin[place]; i < pool->toll_begin[place + 1]; i++)
    if (qtr_label_has(label, pool->toll[i].other[0]) != qtr_label_has(label, pool->toll[i].other[1]))
      toll += pool->toll[i].toll;
  return toll;
}

/* ---- labels ---- */

static uint32_t hash_of(const qtr_pool *pool, const uint32_t *set, unsigned squad) {
  uint32_t hash = 0x811C9DC5u ^ squad;
  for (uint32_t w = 0; w < pool->words; w++) hash = (hash ^ set[w]) * 0x9E3779B1u ^ hash >> 15;
  hash ^= hash >> 16;
  hash *= 0x85EBCA6Bu;
  return (hash ^ hash >> 13) & (pool->heads - 1);
}

static bool are_same(const qtr_pool *pool, const qtr_label *a, const qtr_label *b) {
  return a->squad == b->squad && memcmp(a->set, b->set, pool->words * sizeof a->set[0]) == 0;
}

/* Net of prices, a route that ends there. */
static double net_of_route(const qtr_pool *pool, const qtr_label *label) {
  return label->net + qtr_gains_go_home(gains_of(pool), pool->squad[label->squad].kind, label->node, label->when);
}

/* The label last in the block, not counted yet: another one is there sooner, having collected as much; or it is so to
 * others. */
static bool is_beaten(qtr_pool *pool, const qtr_label *grown, uint32_t head) {
  for (uint32_t i = pool->head[head]; i != QTR_NO_LABEL; i = qtr_pool_label(pool, i)->next) {
    qtr_label *other = qtr_pool_label(pool, i);
    if (other->node != grown->node || !are_same(pool, other, grown)) continue;
    if (other->when <= grown->when && other->net >= grown->net) return true;
    if (grown->when <= other->when && grown->net >= other->net) other->state = LABEL_BEATEN;
  }
  return false;
}

static void keep(qtr_pool *pool, qtr_label *grown) {
  const uint32_t head = hash_of(pool, grown->set, grown->squad);
  if (is_beaten(pool, grown, head)) return;
  grown->next = pool->head[head];
  pool->head[head] = pool->labels++;
}

/* On to a place that it has not been to, if it may collect enough there. C may charge half of a toll that is paid there
 * once more, where the third place of the triple comes next. The label to be stands behind the last. */
static void grow_to(qtr_pool *pool, uint32_t from, unsigned place, qtr_memory memory) {
  const qtr_label *label = qtr_pool_label(pool, from);
  const qtr_gains *gains = gains_of(pool);
  const unsigned kind = pool->squad[label->squad].kind;
  const qtr_steps way = qtr_gains_travel(gains, kind, label->node)[place];
  if (way == QTR_NEVER) return;
  const qtr_steps when = label->when + way;
  const double all = label->net + qtr_gains_at(gains, kind, place, memory, when);
  if (all <= pool->least[label->squad]) return;
  const double toll = toll_at(pool, label, place);
  if (all - 0.5 * toll <= pool->least[label->squad] || !qtr_gains_in_time(gains, kind, place, when)) return;
  qtr_label *grown = qtr_pool_label(pool, pool->labels);
  memcpy(grown, label, pool->stride);
  grown->net += qtr_game_worth(pool->bound->game, place, when) - pool->duals->place[place] - toll;
  grown->when = when;
  grown->before = from;
  grown->node = (uint16_t)place;
  grown->state = LABEL_OPEN;
  grown->set[place / 32] |= 1u << (place % 32);
  keep(pool, grown);
}

/* Nor back to a look before one that it has taken. */
static void add_looks_before(const qtr_pool *pool, qtr_places *been) {
  const qtr_looks *looks = &gains_of(pool)->looks;
  if (!qtr_looks_in_use(looks)) return;
  for (unsigned place = places_of(pool); place-- > looks->firsts;)
    if (qtr_places_has(been, place)) qtr_places_add(been, qtr_looks_before(looks, place));
}

static void grow(qtr_pool *pool, uint32_t from) {
  const qtr_label *label = qtr_pool_label(pool, from);
  qtr_places been;
  if (label->state == LABEL_BEATEN) return;
  qtr_places_clear(&been);
  memcpy(been.word, label->set, pool->words * sizeof label->set[0]);
  add_looks_before(pool, &been);
  for (unsigned place = 0; place < places_of(pool); place++)
    if (!qtr_places_has(&been, place))
      grow_to(pool, from, place, qtr_near_of(&gains_of(pool)->near, place, &been, &been));
}

/* ---- layers: labels of as many places ---- */

/* Of routes with the same places the best counts, and the first among equals. */
static bool is_best_route(const qtr_pool *pool, uint32_t label) {
  const qtr_label *own = qtr_pool_label(pool, label);
  const double net = net_of_route(pool, own);
  if (own->state == LABEL_BEATEN || net <= pool->least[own->squad]) return false;
  for (uint32_t i = pool->head[hash_of(pool, own->set, own->squad)]; i != QTR_NO_LABEL;
       i = qtr_pool_label(pool, i)->next) {
    const qtr_label *other = qtr_pool_label(pool, i);
    if (i == label || other->state == LABEL_BEATEN || !are_same(pool, other, own)) continue;
    const double others = net_of_route(pool, other);
    if (others > net || (others == net && i < label)) return false;
  }
  return true;
}

static void mark_routes(qtr_pool *pool) {
  for (uint32_t i = pool->layer_begin; i < pool->layer_end; i++) {
    if (!is_best_route(pool, i)) continue;
    qtr_pool_label(pool, i)->state = LABEL_ROUTE;
    pool->routes++;
  }
}

/* The layer grown is the next to be grown from. */
static void begin_layer(qtr_pool *pool, uint32_t begin) {
  pool->layer_begin = pool->cursor = begin;
  pool->layer_end = pool->labels;
  mark_routes(pool);
  pool->heads = LEAST_HEADS;
  while (pool->heads < pool->heads_most && pool->heads / HEADS_A_LABEL < pool->layer_end - begin) pool->heads *= 2;
  memset(pool->head, 0xFF, pool->heads * sizeof pool->head[0]);
}

/* No room for what a label may grow into. */
static bool is_full(const qtr_pool *pool) {
  return (uint64_t)pool->labels + places_of(pool) >= pool->labels_most;
}

static void set_out(qtr_pool *pool, unsigned squad) {
  qtr_label *label = qtr_pool_label(pool, pool->labels);
  memset(label, 0, pool->stride);
  label->when = pool->squad[squad].ready;
  label->before = QTR_NO_LABEL;
  label->node = pool->squad[squad].node;
  label->squad = (uint8_t)squad;
  keep(pool, label);
}

/* ---- the whole list ---- */

static size_t bytes_of_sets(const qtr_pool *pool) {
  return (pool->words * sizeof(uint32_t) + 7) / 8 * 8;
}

static void lay_out(qtr_pool *pool, void *block, size_t bytes) {
  const size_t a_head = LABELS_A_HEAD * (size_t)pool->stride + sizeof pool->head[0];
  pool->heads_most = LEAST_HEADS;
  while (pool->heads_most < UINT32_MAX / 2 && 2 * (size_t)pool->heads_most * a_head <= bytes) pool->heads_most *= 2;
  pool->head = block;
  pool->label = (uint8_t *)block + pool->heads_most * sizeof pool->head[0];
  const size_t labels = (bytes - pool->heads_most * sizeof pool->head[0]) / pool->stride;
  pool->labels_room = pool->labels_most = labels < QTR_NO_LABEL ? (uint32_t)labels : QTR_NO_LABEL - 1;
}

void qtr_pool_init(qtr_pool *pool, void *block, size_t bytes, const qtr_bound *bound) {
  pool->bound = bound;
  pool->words = (places_of(pool) + 31) / 32;
  pool->stride = (uint32_t)(offsetof(qtr_label, set) + bytes_of_sets(pool));
  pool->labels = pool->kept = pool->routes = 0;
  lay_out(pool, block, bytes);
  list_squads(pool);
}

/* Those kept collect what they do by the prices in force. */
static void price_anew(qtr_pool *pool, uint32_t number) {
  qtr_label *label = qtr_pool_label(pool, number);
  if (label->before == QTR_NO_LABEL) return;
  const qtr_label *before = qtr_pool_label(pool, label->before);
  label->net = before->net + qtr_game_worth(pool->bound->game, label->node, label->when) -
               pool->duals->place[label->node] - toll_at(pool, before, label->node);
}

void qtr_pool_begin(qtr_pool *pool, const qtr_duals *duals, const double *least) {
  pool->duals = duals;
  memcpy(pool->least, least, pool->squads * sizeof least[0]);
  list_tolls(pool);
  for (uint32_t label = 0; label < pool->kept; label++) price_anew(pool, label);
  qtr_pool_forget_listed(pool);
  pool->heads = LEAST_HEADS;
  memset(pool->head, 0xFF, pool->heads * sizeof pool->head[0]);
  for (unsigned squad = 0; squad < pool->squads && !is_full(pool); squad++) set_out(pool, squad);
  begin_layer(pool, pool->kept);
}

enum qtr_listing qtr_pool_go_on(qtr_pool *pool, uint32_t count) {
  if (is_full(pool)) return QTR_POOL_FULL;
  for (; count > 0 && pool->cursor < pool->layer_end; count--) {
    if (is_full(pool)) return QTR_POOL_FULL;
    grow(pool, pool->cursor++);
  }
  if (pool->cursor < pool->layer_end) return QTR_LISTING;
  if (pool->labels == pool->layer_end) return QTR_LISTED;
  begin_layer(pool, pool->layer_end);
  return QTR_LISTING;
}

bool qtr_pool_is_route(const qtr_pool *pool, uint32_t label) {
  return qtr_pool_label(pool, label)->state == LABEL_ROUTE;
}

double qtr_pool_net(const qtr_pool *pool, uint32_t label) {
  return net_of_route(pool, qtr_pool_label(pool, label));
}

double qtr_pool_worth(const qtr_pool *pool, uint32_t number) {
  const qtr_label *label = qtr_pool_label(pool, number);
  const qtr_duals *duals = pool->duals;
  double worth = net_of_route(pool, label);
  for (unsigned place = 0; place < places_of(pool); place++)
    if (qtr_label_has(label, place)) worth += duals->place[place];
  for (uint32_t t = 0; t < duals->triples; t++)
    if (qtr_triple_counts(&duals->triple[t], label)) worth += duals->toll[t];
  return worth;
}

unsigned qtr_pool_length(const qtr_pool *pool, uint32_t label) {
  unsigned length = 0;
  for (uint32_t i = label; qtr_pool_label(pool, i)->before != QTR_NO_LABEL; i = qtr_pool_label(pool, i)->before)
    length++;
  return length;
}

unsigned qtr_pool_places(const qtr_pool *pool, uint32_t label, uint16_t *place) {
  const unsigned length = qtr_pool_length(pool, label);
  unsigned left = length;
  for (uint32_t i = label; left > 0; i = qtr_pool_label(pool, i)->before) place[--left] = qtr_pool_label(pool, i)->node;
  return length;
}

size_t qtr_pool_bytes(const qtr_pool *pool, uint32_t labels) {
  return pool->heads_most * sizeof pool->head[0] + (size_t)labels * pool->stride;
}

/* ---- routes that are kept ---- */

void qtr_pool_mark(qtr_pool *pool, uint32_t label) {
  qtr_pool_label(pool, label)->state = LABEL_MARKED;
}

static bool is_kept(const qtr_label *label) {
  return label->state == LABEL_MARKED || label->state == LABEL_ON_WAY;
}

/* From the last one on, for each was grown from one further ahead. */
static void mark_ways(qtr_pool *pool) {
  for (uint32_t i = pool->labels; i-- > 0;) {
    const qtr_label *label = qtr_pool_label(pool, i);
    if (!is_kept(label) || label->before == QTR_NO_LABEL) continue;
    qtr_label *before = qtr_pool_label(pool, label->before);
    if (before->state != LABEL_MARKED) before->state = LABEL_ON_WAY;
  }
}

/* Each goes by its new number before any is moved. */
static uint32_t number_anew(qtr_pool *pool) {
  uint32_t count = 0;
  for (uint32_t i = 0; i < pool->labels; i++) {
    qtr_label *label = qtr_pool_label(pool, i);
    if (!is_kept(label)) continue;
    label->next = count++;
    if (label->before != QTR_NO_LABEL) label->before = qtr_pool_label(pool, label->before)->next;
  }
  return count;
}

void qtr_pool_keep_marked(qtr_pool *pool, uint32_t *number, uint32_t numbers) {
  mark_ways(pool);
  const uint32_t count = number_anew(pool);
  for (uint32_t i = 0; i < numbers; i++) number[i] = qtr_pool_label(pool, number[i])->next;
  for (uint32_t i = 0; i < pool->labels; i++) {
    qtr_label *label = qtr_pool_label(pool, i);
    if (!is_kept(label)) continue;
    label->state = label->state == LABEL_MARKED ? LABEL_ROUTE : LABEL_BEATEN;
    if (label->next != i) memcpy(qtr_pool_label(pool, label->next), label, pool->stride);
  }
  pool->kept = count;
  qtr_pool_forget_listed(pool);
}

void qtr_pool_forget_listed(qtr_pool *pool) {
  pool->labels = pool->kept;
  pool->routes = 0;
  for (uint32_t label = 0; label < pool->kept; label++) pool->routes += qtr_pool_is_route(pool, label);
}

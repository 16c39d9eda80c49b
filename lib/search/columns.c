#include "search/columns.h"

#include <math.h>
#include <string.h>

#include "model/rounding.h"

#define FIRST_BOX 0.02 /* of the scale: how far prices may be proposed from the center's; */
#define LEAST_BOX 0.004
#define NARROWER 0.5   /* after prices that proved no lower bound, */
#define WIDER 2.0      /* and where the box alone is in the way */
#define SQUADS_BOX 4.0 /* of the scale: what is left to squads follows from prices, and is hardly held */

#define NEXT_TO_NOTHING 0.02 /* of the gap: a programme that may gain no more is solved */
#define LEAST_DROP 1e-3      /* of the gap: a list that brings the bound down by less is barren; */
#define BARREN_MOST 64u      /* so many in a row, */
#define FRUITLESS_MOST 6u    /* so many programmes solved without a new triple, */
#define RAISED_MOST 12u      /* or so many lists of ever fewer routes that are too long: nothing more is to be had */

#define LEAST_GAIN 1e-9 /* of the scale: a route that gains less is none */
#define HIGHER 0.25     /* of the way from what routes are to collect to what walks do, where too many collect it */
#define NEAR 0.1        /* of the scale: routes that lack no more are kept for the next programme */
#define LABELS_AT_FIRST (1u << 19)
#define LABELS_A_STEP 4096u

enum phase { PHASE_BEGIN = 0, PHASE_LOOK = 1, PHASE_PIVOT = 2, PHASE_FILL = 3, PHASE_LIST = 4, PHASE_STUCK = 5 };

static unsigned places_of(const qtr_columns *c) {
  return c->bound->game->board.places;
}

void qtr_columns_begin(qtr_columns *c, qtr_bound *bound, qtr_pool *pool, const qtr_columns_room *room, double target) {
  c->bound = bound;
  c->pool = pool;
  c->room = *room;
  c->labels = room->labels < LABELS_AT_FIRST ? room->labels : LABELS_AT_FIRST;
  c->target = target;
  qtr_pool_duals(pool, &c->center);
  c->upper = qtr_pool_upper(pool, &c->center);
  c->basis.rows = c->basis.routes = 0;
  c->box = FIRST_BOX;
  c->fruitless = c->barren = c->raised = 0;
  c->phase = PHASE_BEGIN;
}

/* ---- the programme over the routes at hand ---- */

static void begin_master(qtr_columns *c) {
  const qtr_boxes boxes = {c->box, SQUADS_BOX};
  if (!qtr_master_begin(&c->master, c->pool, c->room.block, c->room.bytes, &c->center, &c->basis, &boxes)) {
    c->phase = PHASE_STUCK;
    return;
  }
  qtr_master_be_as_fine(&c->master, c->upper - c->target, c->target);
  c->phase = PHASE_LOOK;
}

static void look(qtr_columns *c) {
  qtr_master_look(&c->master, c->trial.squad);
  qtr_master_list_active(&c->master);
  c->phase = PHASE_PIVOT;
}

/* Routes in the basis, and those that are not far from it. */
static bool is_near(const qtr_columns *c, uint32_t choice, double below) {
  const double most = c->trial.squad[qtr_master_label(&c->master, choice)->squad];
  return c->master.choice[choice].in_basis || c->master.choice[choice].net > most - below;
}

/* Labels that they take at most. */
static uint32_t measure_near(const qtr_columns *c, double below) {
  uint32_t labels = 0;
  for (uint32_t i = 0; i < c->master.choices; i++)
    if (is_near(c, i, below)) labels += qtr_pool_length(c->pool, c->master.choice[i].label) + 1;
  return labels;
}

/* As many of them as leave half of the room. */
static void keep_near(qtr_columns *c) {
  double below = NEAR * c->master.scale;
  qtr_master_mark_basis(&c->master, true);
  while (below > LEAST_GAIN * c->master.scale && measure_near(c, below) > c->labels / 2) below *= NARROWER;
  for (uint32_t i = 0; i < c->master.choices; i++)
    if (is_near(c, i, below)) qtr_pool_mark(c->pool, c->master.choice[i].label);
  qtr_master_basis(&c->master, &c->basis);
  qtr_pool_keep_marked(c->pool, c->basis.label, c->basis.routes);
}

static void propose(qtr_columns *c) {
  const qtr_mixture mixture = qtr_master_mixture(&c->master);
  c->broken = qtr_triples_broken(&mixture, places_of(c), c->triple, QTR_COLUMNS_ROUND);
  qtr_master_duals(&c->master, &c->trial);
  c->model = qtr_pool_upper(c->pool, &c->trial);
  keep_near(c);
  c->phase = PHASE_FILL;
}

static void pivot(qtr_columns *c) {
  if (qtr_master_pivot(&c->master)) return;
  if (qtr_master_is_solved(&c->master))
    propose(c);
  else
    c->phase = PHASE_LOOK;
}

/* ---- the routes that gain ---- */

/* Half of a triple's toll for each of its moves, there and back. */
static void find_charges(qtr_columns *c, const qtr_duals *duals) {
  const unsigned places = places_of(c);
  for (size_t i = 0; i < (size_t)places * places; i++) c->room.charge[i] = 0.0;
  for (uint32_t t = 0; t < duals->triples; t++)
    for (unsigned i = 0; i < 3; i++)
      for (unsigned j = 0; j < 3; j++)
        if (i != j)
          c->room.charge[duals->triple[t].place[i] * places + duals->triple[t].place[j]] += 0.5 * duals->toll[t];
}

/* False: stopped, and to be begun anew. */
static bool fill(qtr_columns *c, const qtr_duals *duals) {
  find_charges(c, duals);
  qtr_gains_charge(&c->bound->gains, c->room.charge);
  return qtr_gains_fill(&c->bound->gains, duals->place);
}

static void begin_list(qtr_columns *c) {
  double least[QTR_MAX_SEEKERS];
  if (!fill(c, &c->trial)) return;
  for (unsigned squad = 0; squad < c->pool->squads; squad++)
    least[squad] = c->trial.squad[squad] + LEAST_GAIN * c->master.scale;
  c->pool->labels_most = c->labels;
  qtr_pool_begin(c->pool, &c->trial, least);
  c->phase = PHASE_LIST;
}

/* Too many gain, and none of those grown so far is a route: a longer list, if there is room, or only those that gain
 * more, up to what walks collect. */
static void list_anew(qtr_columns *c) {
  double least[QTR_MAX_SEEKERS];
  if (c->labels < c->room.labels) {
    c->labels = c->labels < c->room.labels / 2 ? 2 * c->labels : c->room.labels;
    c->phase = PHASE_FILL;
    return;
  }
  if (++c->raised > RAISED_MOST) {
    c->phase = PHASE_STUCK;
    return;
  }
  for (unsigned i = 0; i < c->bound->game->board.seekers; i++) {
    int visits[QTR_MAX_PLACES] = {0};
    const unsigned squad = c->pool->squad_of[i];
    const double most = qtr_gains_walk(&c->bound->gains, i, visits);
    least[squad] = c->pool->least[squad];
    if (most > least[squad]) least[squad] += HIGHER * (most - least[squad]);
  }
  qtr_pool_begin(c->pool, &c->trial, least);
}

/* ---- what the list proves ---- */

/* No route of a squad collects more than this: what is listed, or what is just not. Returns how many are listed. */
static uint32_t find_most(qtr_columns *c) {
  uint32_t count = 0;
  for (unsigned squad = 0; squad < c->pool->squads; squad++) c->trial.squad[squad] = c->pool->least[squad];
  for (uint32_t i = c->pool->kept; i < c->pool->labels; i++) {
    if (!qtr_pool_is_route(c->pool, i)) continue;
    double *most = &c->trial.squad[qtr_pool_label(c->pool, i)->squad];
    const double net = qtr_pool_net(c->pool, i);
    if (net > *most) *most = net;
    count++;
  }
  return count;
}

static void keep_listed(qtr_columns *c) {
  for (uint32_t i = 0; i < c->pool->labels; i++)
    if (qtr_pool_is_route(c->pool, i)) qtr_pool_mark(c->pool, i);
  qtr_pool_keep_marked(c->pool, c->basis.label, c->basis.routes);
}

/* The programme over what is at hand then; but not for ever, if the bound comes down no more. */
static void begin_next(qtr_columns *c) {
  c->raised = 0;
  c->phase = ++c->barren > BARREN_MOST ? PHASE_STUCK : PHASE_BEGIN;
}

/* They prove nothing, being some of many. */
static void go_on_with(qtr_columns *c) {
  keep_listed(c);
  begin_next(c);
}

/* Triples without a toll give way where there is no room. */
static void forget_triples(qtr_duals *duals) {
  uint32_t kept = 0;
  for (uint32_t t = 0; t < duals->triples; t++) {
    if (duals->toll[t] <= 0.0) continue;
    duals->triple[kept] = duals->triple[t];
    duals->toll[kept++] = duals->toll[t];
  }
  duals->triples = kept;
}

static bool has_triple(const qtr_duals *duals, const qtr_triple *triple) {
  for (uint32_t t = 0; t < duals->triples; t++)
    if (memcmp(&duals->triple[t], triple, sizeof *triple) == 0) return true;
  return false;
}

/* False: there are none that are new, or no room for them. */
static bool add_triples(qtr_columns *c) {
  qtr_duals *center = &c->center;
  const uint32_t most = qtr_master_triples_most(c->pool);
  if (center->triples + c->broken > most) {
    forget_triples(center);
    c->basis.rows = 0;
  }
  const uint32_t before = center->triples;
  for (uint32_t i = 0; i < c->broken && center->triples < most; i++) {
    if (has_triple(center, &c->triple[i])) continue;
    center->triple[center->triples] = c->triple[i];
    center->toll[center->triples++] = 0.0;
  }
  return center->triples > before;
}

static enum qtr_pricing end_round(qtr_columns *c) {
  if (add_triples(c)) {
    c->fruitless = 0;
    c->box = FIRST_BOX;
    return QTR_PRICED;
  }
  c->box *= WIDER;
  if (++c->fruitless > FRUITLESS_MOST) c->phase = PHASE_STUCK;
  return QTR_PRICING;
}

static enum qtr_pricing judge(qtr_columns *c, uint32_t listed) {
  const double upper = qtr_pool_upper(c->pool, &c->trial);
  const bool better = upper < c->upper;
  if (better) {
    if (c->upper - upper > LEAST_DROP * (c->upper - c->target)) c->barren = 0;
    c->upper = upper;
    c->center = c->trial;
  } else if (c->box > LEAST_BOX) {
    c->box *= NARROWER;
  }
  keep_listed(c);
  begin_next(c);
  if (c->upper - c->model <= NEXT_TO_NOTHING * (c->upper - c->target)) return end_round(c);
  if (better && listed == 0) c->box *= WIDER;
  return QTR_PRICING;
}

static enum qtr_pricing list(qtr_columns *c) {
  const enum qtr_listing status = qtr_pool_go_on(c->pool, LABELS_A_STEP);
  if (status == QTR_LISTING) return QTR_PRICING;
  const uint32_t listed = find_most(c);
  if (status == QTR_LISTED) return judge(c, listed);
  if (listed == 0)
    list_anew(c);
  else
    go_on_with(c);
  return QTR_PRICING;
}

enum qtr_pricing qtr_columns_go_on(qtr_columns *c) {
  switch (c->phase) {
  case PHASE_BEGIN: begin_master(c); return QTR_PRICING;
  case PHASE_LOOK: look(c); return QTR_PRICING;
  case PHASE_PIVOT: pivot(c); return QTR_PRICING;
  case PHASE_FILL: begin_list(c); return QTR_PRICING;
  case PHASE_LIST: return list(c);
  default: return QTR_PRICING_STUCK;
  }
}

bool qtr_columns_settle(qtr_columns *c) {
  return fill(c, &c->center);
}

void qtr_columns_list(qtr_columns *c, double gap) {
  double least[QTR_MAX_SEEKERS];
  for (unsigned squad = 0; squad < c->pool->squads; squad++) least[squad] = c->center.squad[squad] - gap;
  qtr_pool_begin(c->pool, &c->center, least);
}

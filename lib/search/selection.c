#include "search/selection.h"

#include "model/rounding.h"

#define BOX 0.1         /* of the scale: how far prices may go from where they were good, at first */
#define ROUND_DROP 0.02 /* of the gap, that a round of triples is to bring */
#define FRUITLESS_MOST 3u

enum phase { PHASE_LOOK = 0, PHASE_ENTER = 1, PHASE_STUCK = 2 };

static unsigned places_of(const qtr_selection *s) {
  return s->pool->bound->game->board.places;
}

bool qtr_selection_begin(qtr_selection *s, const qtr_pool *pool, void *block, size_t bytes, const qtr_duals *from,
                         const qtr_basis *basis, double target) {
  const qtr_boxes boxes = {BOX, BOX};
  s->pool = pool;
  s->target = target;
  s->upper = s->node_upper = s->round_upper = qtr_pool_upper(pool, from);
  s->fruitless = s->depth = 0;
  s->phase = PHASE_LOOK;
  return qtr_master_begin(&s->master, pool, block, bytes, from, basis, &boxes);
}

/* ---- a look at all routes ---- */

/* Routes that are below the most of their squad by what is left of the gap, or more: before any branch for good. */
static void drop(qtr_selection *s, const double *most) {
  qtr_master *master = &s->master;
  const uint8_t level = (uint8_t)(s->depth + 1);
  const double gap = s->node_upper - s->target;
  qtr_master_mark_basis(master, true);
  for (uint32_t i = 0; i < master->choices; i++) {
    qtr_choice *choice = &master->choice[i];
    if (choice->off == 0 && !choice->in_basis && choice->net <= most[qtr_master_label(master, i)->squad] - gap)
      choice->off = level;
  }
  if (s->depth == 0) qtr_master_compact(master);
  qtr_master_mark_basis(master, false);
}

static void look_at_all(qtr_selection *s) {
  double most[QTR_MAX_SEEKERS];
  const double upper = qtr_master_look(&s->master, most);
  if (upper < s->node_upper) {
    s->node_upper = upper;
    if (s->depth == 0) s->upper = upper > s->target ? upper : s->target;
    drop(s, most);
  }
  qtr_master_be_as_fine(&s->master, s->upper - s->target, s->target);
  qtr_master_list_active(&s->master);
  s->phase = PHASE_ENTER;
}

static bool is_whole(const qtr_mixture *mixture) {
  for (uint32_t i = 0; i < mixture->count; i++)
    if (mixture->share[i] < 1.0 - QTR_MASTER_LEAST_SHARE && mixture->route[i]->before != QTR_NO_LABEL) return false;
  return true;
}

/* ---- branches ---- */

static void begin_node(qtr_selection *s, double upper) {
  s->node_upper = s->round_upper = upper;
  s->fruitless = 0;
  for (uint32_t i = 0; i < s->master.choices; i++)
    if (s->master.choice[i].off == 0 && qtr_branch_rules_out(&s->branch[s->depth - 1], qtr_master_label(&s->master, i)))
      s->master.choice[i].off = (uint8_t)s->depth;
  qtr_simplex_refactor(&s->master.simplex);
  s->phase = PHASE_LOOK;
}

static void forget_node(qtr_selection *s) {
  for (uint32_t i = 0; i < s->master.choices; i++)
    if (s->master.choice[i].off >= s->depth) s->master.choice[i].off = 0;
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
      !qtr_branch_find(mixture, places_of(s), s->pool->squads, QTR_MASTER_LEAST_SHARE, &branch)) {
    s->phase = PHASE_STUCK;
    return;
  }
  branch.upper = s->node_upper;
  s->branch[s->depth++] = branch;
  begin_node(s, branch.upper);
}

/* ---- steps ---- */

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
  s->phase = PHASE_LOOK;
  if (qtr_simplex_widen(&s->master.simplex, QTR_MASTER_LEAST_SHARE) || qtr_master_raise_penalty(&s->master))
    return QTR_SELECTING;
  const qtr_mixture mixture = qtr_master_mixture(&s->master);
  if (is_whole(&mixture)) return QTR_SELECTION_GAME;
  if (is_fruitless(s) || !qtr_master_add_triples(&s->master, &mixture)) add_branch(s, &mixture);
  return QTR_SELECTING;
}

static enum qtr_selecting enter_some(qtr_selection *s) {
  if (qtr_master_pivot(&s->master)) return QTR_SELECTING;
  if (qtr_master_is_solved(&s->master)) return use_mixture(s);
  s->phase = PHASE_LOOK;
  return QTR_SELECTING;
}

static enum qtr_selecting step(qtr_selection *s) {
  switch (s->phase) {
  case PHASE_LOOK: look_at_all(s); return QTR_SELECTING;
  case PHASE_ENTER: return enter_some(s);
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
  const unsigned seekers = s->pool->bound->game->board.seekers;
  bool taken[QTR_MAX_SEEKERS] = {false};
  for (unsigned i = 0; i < QTR_MAX_ROUTES; i++) routes->length[i] = 0;
  for (uint32_t i = 0; i < s->master.simplex.rows; i++) {
    if (s->master.simplex.basis[i] < 0 || s->master.simplex.level[i] < 0.5) continue;
    const uint32_t label = s->master.choice[s->master.simplex.basis[i]].label;
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

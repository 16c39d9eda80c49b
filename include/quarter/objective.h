/* What a game is played for: all that depends on which objective it is, in one room.
 *
 * Each objective is put as a sum over the places, to be maximised, of what the visit of a place is worth at its step t:
 *
 *   discounted      w P gamma^max(t-1, 0), w = 10        (paper, Eq. 4.2)
 *   expected time   -P t, and every place must be visited; with an end of the search P (T_end - t), and what is left
 *                   out counts as found at T_end
 *   deadline        P where t <= T, else 0
 *
 * P is the share that a place has of all that can be found; discounted value and deadline count that in full, which is
 * less than 1 where looks miss. No worth rises with t, which is what the bounds rest on (lib/search/bound.h); and each
 * can be taken apart at any moment into what came before it and what comes after, which is what backups rest on (Eq.
 * 4.7): the first two counted from there, whenever it is. With an end or a deadline what comes depends on when it is,
 * and keys have a clock.
 */
#ifndef QUARTER_OBJECTIVE_H
#define QUARTER_OBJECTIVE_H

#include <stdbool.h>
#include <stdint.h>

#include "quarter/config.h"

QTR_C_BEGIN

enum qtr_objective_kind {
  QTR_DISCOUNTED = 0, /* maximise the sum over places of w P gamma^max(t-1, 0), w = 10 (paper, section 4.1) */
  QTR_TIME = 1,       /* minimise the expected step of the visit, the sum of P t */
  QTR_DEADLINE = 2,   /* maximise the probability of a visit by a step, the sum of P over the places with t <= T */
  QTR_OBJECTIVES      /* how many there are */
};

/* What a mission is played for. */
typedef struct {
  uint8_t kind; /* enum qtr_objective_kind */
  double gamma; /* discount a step, 0 < gamma < 1; under expected time too, for the value that is told beside it */
  qtr_steps deadline; /* T, under QTR_DEADLINE alone */
  double home_weight; /* under QTR_TIME alone: what each seeker's arrival at home counts beside the places, in units of
                         their weights; 0 or more */
} qtr_aim;

/* Discounted, gamma 0.99. */
void qtr_aim_default(qtr_aim *aim);

/* QTR_OK, or QTR_ERR_ARGUMENT for a kind or a discount that there is not. */
int qtr_aim_check(const qtr_aim *aim);

#define QTR_REWARD_SCALE 10.0 /* w of Eq. 4.2 */
#define QTR_NEGLIGIBLE 1e-9   /* share of an objective: nobody calls an order optimal on which less than this depends */

/* Under discounting a game is refused whose nearest place has less than this left of it when it is reached: the floats
 * of the Q-table end at 1e-38, and what they cannot tell from nothing must not be called equal. */
#define QTR_OBJECTIVE_LEAST_POWER 1e-28

/* What else a game's worth depends on, of the mission's terms. */
typedef struct {
  double findable;    /* W: probability of what can be found at all; 1 where looks never miss */
  double home_weight; /* v: what a step until a seeker is home counts, as a likelihood; 0: nothing */
  qtr_steps end;      /* T_end, the latest end of a seeker's endurance; 0: none has one */
} qtr_objective_terms;

/* An objective ready for use; fill it by qtr_objective_init(). */
typedef struct {
  uint8_t kind;       /* enum qtr_objective_kind */
  qtr_steps deadline; /* T */
  qtr_objective_terms terms;
  double scale;                       /* of rewards, in units of P: w W discounted, W by a deadline */
  double time_end;                    /* T_end under expected time, else 0 */
  double power[QTR_OBJECTIVE_POWERS]; /* gamma^n */
} qtr_objective;

/* What the time that passes after a choice brings, until somebody is to choose again. */
typedef struct {
  double reward;   /* counted from the moment of the choice */
  double discount; /* of what comes after; 1 under expected time */
  qtr_steps now;   /* how far it has come, since the game's start */
} qtr_outcome;

/* What a whole game earns, whatever it was played for. */
typedef struct {
  double value;         /* discounted */
  double expected_time; /* steps; with a weight of coming home that included */
  double found;         /* probability of a find; under a deadline, by then */
  double worth;         /* under the objective, to be maximised: value, -expected_time, or found */
} qtr_score;

/* Get an objective ready for an aim that was checked. `terms` NULL: none. */
void qtr_objective_init(qtr_objective *objective, const qtr_aim *aim, const qtr_objective_terms *terms);

/* gamma^n beyond the powers kept ready. */
double qtr_objective_far_power(const qtr_objective *objective, qtr_steps n);

/* gamma^n under either objective. */
static inline double qtr_objective_power(const qtr_objective *objective, qtr_steps n) {
  return n < QTR_OBJECTIVE_POWERS ? objective->power[n] : qtr_objective_far_power(objective, n);
}

/* ---- the worth of visits ---- */

static inline double qtr_objective_discounted(const qtr_objective *objective, double probability, qtr_steps when) {
  return QTR_REWARD_SCALE * objective->terms.findable * probability *
         qtr_objective_power(objective, when > 0 ? when - 1 : 0);
}

/* What the first visit of a place of this likelihood is worth at step `when`. Never rises with `when`. */
static inline double qtr_objective_worth(const qtr_objective *objective, double probability, qtr_steps when) {
  if (objective->kind == QTR_TIME) return probability * (objective->time_end - (double)when);
  if (objective->kind == QTR_DEADLINE) return when <= objective->deadline ? objective->scale * probability : 0.0;
  return objective->scale * probability * qtr_objective_power(objective, when > 0 ? when - 1 : 0);
}

/* What leaving out places of this likelihood is worth. */
static inline double qtr_objective_left(const qtr_objective *objective, double probability) {
  return -objective->time_end * probability;
}

/* Whether a game is worth nothing that leaves a place out. Then a place can have a price below 0, for nobody may refuse
 * to take it at that price. */
bool qtr_objective_needs_all(const qtr_objective *objective);

/* Whether what lies `steps` ahead can still be told from nothing. */
bool qtr_objective_tells(const qtr_objective *objective, qtr_steps steps);

/* The aim for a game of which nothing can be told by its own: the same places found soonest. */
void qtr_aim_undiscount(qtr_aim *aim);

/* Whether the visit makes up so little of a game worth `worth` that its order is not called optimal
 * (QTR_NEGLIGIBLE). */
bool qtr_objective_neglects(const qtr_objective *objective, double probability, qtr_steps when, double worth);

/* Add up what a game earns, given each place's step of first visit, QTR_NEVER for one that is left out, and the steps
 * until they are home of all seekers in all. */
void qtr_objective_score(const qtr_objective *objective, qtr_score *score, const double *probability,
                         const qtr_steps *visit, unsigned places, uint64_t home);

/* ---- worth from some moment on ---- */

/* The greatest step that what is still to come depends on: 0 where it is the same whenever it comes, so that states
 * differ by their places and seekers alone. */
qtr_steps qtr_objective_last_clock(const qtr_objective *objective);

/* The reward of a visit at the moment of the choice, with no time passing. */
double qtr_objective_at_once(const qtr_objective *objective, double probability, qtr_steps now);

/* A visit that happens now counts for so much, without the scale of rewards; and what is worth `worth` from `steps` on
 * counts for so much now, while places of the likelihood `waiting` wait for it. A deadline, which tells no two moments
 * apart before it, takes the least expected time here. */
double qtr_objective_visit(const qtr_objective *objective, double probability);
double qtr_objective_delayed(const qtr_objective *objective, double worth, qtr_steps steps, double waiting);

/* What is worth `worth`, counted from the start, seen from step `now`, when places of the likelihood `unvisited` are
 * left and `seekers` have not gone home: the most that can still come. */
double qtr_objective_from_now(const qtr_objective *objective, double worth, qtr_steps now, double unvisited,
                              unsigned seekers);

/* ---- time as a backup sees it: a beginning, then stretch by stretch first wait, then the visits in it, at last its
 * end ---- */

/* A choice has been made at step `now`, and nothing has passed yet. */
void qtr_objective_begin(qtr_outcome *outcome, qtr_steps now);

/* All that is unvisited at first waits for the whole stretch of `passed` steps, and so do seekers that are not home. */
void qtr_objective_wait(const qtr_objective *objective, qtr_outcome *outcome, double unvisited, unsigned seekers,
                        qtr_steps passed);

/* A visit `offset` steps, one or more, into the stretch: what waited no longer from there on is given back. */
void qtr_objective_collect(const qtr_objective *objective, qtr_outcome *outcome, double probability, qtr_steps offset,
                           qtr_steps passed);

void qtr_objective_pass(const qtr_objective *objective, qtr_outcome *outcome, qtr_steps passed);

/* What a seeker costs that goes home now, `steps` from there. */
double qtr_objective_leave(const qtr_objective *objective, qtr_steps steps);

/* The game is over, and places of this likelihood were left out: with an end they wait until then. */
void qtr_objective_end(const qtr_objective *objective, qtr_outcome *outcome, double unvisited);

/* ---- what people are told ---- */

/* An objective in words. Its figure is its worth as people read it: the discounted value, the expected time. */
typedef struct {
  const char *figure;  /* "expected time" */
  const char *goal;    /* the same as what is sought: "least expected time" */
  const char *limit;   /* what the bound is of: "no less time than" */
  const char *unit;    /* of the figure, singular; NULL: it has none */
  uint8_t beside;      /* enum qtr_objective_kind: whose figure is told beside its own */
  bool less_is_better; /* of the figure */
  bool fades;          /* what comes late may count for next to nothing */
} qtr_objective_words;

/* Of a kind that there is. */
const qtr_objective_words *qtr_objective_in_words(uint8_t kind);

/* What missions and command lines call the objectives, in the order of the kinds; ended by NULL. */
extern const char *const qtr_objective_names[];

/* What a game that earns so much is worth under an objective, and the figure of a worth. */
double qtr_objective_of_score(uint8_t kind, const qtr_score *score);
double qtr_objective_figure(uint8_t kind, double worth);

/* Whether one figure is better than another. */
bool qtr_objective_is_better(uint8_t kind, double figure, double than);

/* How far a bound lies from a figure, relative to it; 0 where the figure is past the bound. */
double qtr_objective_gap(uint8_t kind, double figure, double bound);

/* Whether a game is worth more than another, or as much and takes less expected time: what is discounted away counts
 * for nothing in a sum, but it still has to be searched. */
bool qtr_score_is_better(const qtr_score *score, const qtr_score *than);

QTR_C_END

#endif

#include "quarter/seeker.h"

#include <stddef.h>

#include "core/apart.h"
#include "core/bytes.h"
#include "quarter/status.h"
#include "robot/bits.h"
#include "robot/board.h"

/* Where all seekers fit in one word, nothing is reckoned. */
static unsigned word_of(unsigned seeker) {
  return (QTR_MAX_SEEKERS > 32) ? (seeker / 32u) : 0u;
}

static uint32_t bit_of(unsigned seeker) {
  return (uint32_t)1 << ((QTR_MAX_SEEKERS > 32) ? (seeker % 32u) : seeker);
}

static bool set_has(const qtr_seeker_set *set, unsigned seeker) {
  return (set->word[word_of(seeker)] & bit_of(seeker)) != 0u;
}

static void set_add(qtr_seeker_set *set, unsigned seeker) {
  set->word[word_of(seeker)] |= bit_of(seeker);
}

static void set_remove(qtr_seeker_set *set, unsigned seeker) {
  set->word[word_of(seeker)] &= ~bit_of(seeker);
}

static unsigned seekers_of(const qtr_seeker *seeker) {
  return seeker->policy->board.seekers;
}

/* The deployment is copied: all seekers of a search have equal ones, and nobody can change one under way. */
int qtr_seeker_init_built(qtr_seeker *seeker, const qtr_policy *policy, unsigned self, const qtr_deployment *deployment,
                          uint32_t run, uint32_t config_id) {
  if (config_id != QTR_CONFIG_ID) {
    return QTR_ERR_CONFIG;
  }
  if (self >= policy->board.seekers) {
    return QTR_ERR_ARGUMENT;
  }
  bytes_clear(seeker, sizeof *seeker);
  seeker->policy = policy;
  seeker->self = (uint8_t)self;
  seeker->run = run;
  if (deployment == NULL) {
    qtr_deployment_home(&seeker->deployment, policy);
  } else {
    seeker->deployment = *deployment;
  }
  seeker->identity = qtr_deployment_identity(&seeker->deployment, policy);
  qtr_division_begin(&seeker->division, policy, &seeker->deployment);
  return QTR_OK;
}

/* ---- what is known, and what follows from it ---- */

/* Territories that this robot has scanned whole: they are done, and to be announced. One without places is so from the
 * start. When the division has just been worked out, those known to be done are announced too: after a reset nobody
 * knows whether they were. */
static void find_finished(qtr_seeker *seeker) {
  const qtr_division *division = &seeker->division;
  qtr_seeker_set closed = seeker->divided ? seeker->done : (qtr_seeker_set){{0}};
  for (unsigned i = 0; i < division->moves; i++) {
    if (!place_is_in(&seeker->visited, division->place[i])) {
      set_add(&closed, division->seeker[i]);
    }
  }
  for (unsigned t = 0; t < seekers_of(seeker); t++) {
    if (!set_has(&closed, t)) {
      set_add(&seeker->done, t);
      set_add(&seeker->unsaid, t);
    }
  }
}

/* The first time round tells what is done already: territories without a place, and what a save said. */
bool qtr_seeker_plan(qtr_seeker *seeker) {
  if (seeker->divided) {
    return false;
  }
  if (qtr_division_play(&seeker->division, seeker->policy)) {
    return true;
  }
  find_finished(seeker);
  seeker->divided = true;
  return false;
}

/* From the start, for moves can be undone: what a robot could reach from there it can reach from wherever it has gone
 * since. */
static bool is_in_reach(const qtr_seeker *seeker, unsigned place) {
  const qtr_board *board = &seeker->policy->board;
  const unsigned start = (unsigned)board->places + seeker->deployment.start_of[seeker->self];
  return qtr_steps_between(board, seeker->self, start, place) != QTR_NEVER;
}

/* A place may be blocked and visited, by one who got there all the same: then it is visited. */
static bool is_to_try(const qtr_seeker *seeker, unsigned place) {
  return !place_is_in(&seeker->visited, place) && !place_is_in(&seeker->blocked, place) && is_in_reach(seeker, place);
}

/* When a robot comes to a territory, and backwards if that is odd: in pass p it walks that of seeker self + p, its own
 * first, then all of seekers known to be lost before the others'. */
static unsigned round_of(const qtr_seeker *seeker, unsigned territory) {
  const unsigned seekers = seekers_of(seeker);
  const unsigned pass = ((territory < seeker->self) ? seekers : 0u) + territory - seeker->self;
  return ((pass == 0u) || set_has(&seeker->lost, territory)) ? pass : (pass + (2u * seekers));
}

/* The next place: the first to try of the first territory in turn that has one and is not known to be done; the last
 * one on an odd turn. So two robots next to one another come to a third one's territory from both ends. */
QTR_APART static void find_target(qtr_seeker *seeker) {
  const qtr_division *division = &seeker->division;
  unsigned first = 4u * QTR_MAX_SEEKERS; /* after all */
  for (unsigned i = 0; i < division->moves; i++) {
    const unsigned territory = division->seeker[i];
    if (set_has(&seeker->done, territory) || !is_to_try(seeker, division->place[i])) {
      continue;
    }
    const unsigned turn = round_of(seeker, territory);
    if (turn < (first + (turn % 2u))) {
      first = turn;
      seeker->target = division->place[i];
      seeker->territory = (uint8_t)territory;
    }
  }
}

/* All has been tried: what was blocked is tried once more, and nothing else is. */
static bool begin_last_round(qtr_seeker *seeker) {
  if (seeker->last_round) {
    return false;
  }
  seeker->last_round = true;
  seeker->retry = seeker->blocked;
  for (unsigned w = 0; w < QTR_PLACE_WORDS; w++) {
    seeker->blocked.word[w] = ~seeker->retry.word[w];
  }
  return true;
}

/* Target and territory follow from what is known now, and from nothing else: so it does not matter in which order it
 * became known, nor whether there was a reset in between. */
static void settle(qtr_seeker *seeker) {
  if (seeker->settled) {
    return;
  }
  while (qtr_seeker_plan(seeker)) {}
  seeker->settled = true;
  seeker->target = QTR_STAND_DOWN;
  seeker->territory = seeker->self;
  if (seeker->found) {
    return;
  }
  do {
    find_target(seeker);
  } while ((seeker->target == QTR_STAND_DOWN) && begin_last_round(seeker));
}

/* ---- what a robot is told ---- */

/* Whether a look at this place is one that this robot has not made. Looks at one place lie in one cell. By that and by
 * nothing else are they told: whatever a table says of them, nobody has looked where it has not been. */
static bool is_unmade_look(const qtr_seeker *seeker, unsigned look, unsigned place) {
  const qtr_policy *policy = seeker->policy;
  if (place_is_in(&seeker->visited, look)) {
    return false;
  }
  if (!QTR_TERMS) {
    return look == place;
  }
  return (place < policy->board.places) && (qtr_policy_cell(policy, look) == qtr_policy_cell(policy, place));
}

/* Which of several looks at a place was made: the one that the robot was sent for, or the first that it has not made
 * itself. */
static unsigned look_made(const qtr_seeker *seeker, unsigned place) {
  if (!QTR_TERMS) {
    return place;
  }
  unsigned made = place;
  unsigned look = seeker->policy->board.places;
  while (look-- > 0u) {
    if (!is_unmade_look(seeker, look, place)) {
      continue;
    }
    made = look;
    if (seeker->settled && (look == seeker->target)) {
      break;
    }
  }
  return made;
}

void qtr_seeker_visited(qtr_seeker *seeker, unsigned at) {
  if (at >= seeker->policy->board.places) {
    return;
  }
  const unsigned place = look_made(seeker, at);
  if (place_is_in(&seeker->visited, place)) {
    return;
  }
  place_put(&seeker->visited, place);
  seeker->settled = false;
  if (seeker->divided) {
    find_finished(seeker);
  }
}

/* All looks at it. Not taken back on a later visit: is_to_try() asks for visits first. */
void qtr_seeker_blocked(qtr_seeker *seeker, unsigned place) {
  for (unsigned look = 0; look < seeker->policy->board.places; look++) {
    if (is_unmade_look(seeker, look, place)) {
      place_put(&seeker->blocked, look);
      seeker->settled = false;
    }
  }
}

/* Said once as the finder; repeated like all that is known by qtr_seeker_known(). */
void qtr_seeker_found(qtr_seeker *seeker) {
  if (!seeker->found) {
    seeker->found = true;
    seeker->found_unsaid = true;
    seeker->settled = false;
  }
}

/* What is heard is known, and not announced as one's own: done means scanned by whoever announces it. The count of
 * strangers stays at its greatest, where wrapping around would make it look well. */
bool qtr_seeker_hear(qtr_seeker *seeker, const qtr_signal *signal) {
  if ((signal->identity != seeker->identity) || (signal->run != seeker->run)) {
    seeker->foreign += (seeker->foreign < UINT32_MAX) ? 1u : 0u;
    return false;
  }
  if (signal->kind == QTR_SIGNAL_FOUND) {
    seeker->found = true;
  } else if ((signal->kind == QTR_SIGNAL_TERRITORY_DONE) && (signal->territory < seekers_of(seeker))) {
    set_add(&seeker->done, signal->territory);
  } else {
    return false;
  }
  seeker->settled = false;
  return true;
}

/* It moves no territory and takes no place away, so a seeker that is called lost by mistake costs ways, and never a
 * place. */
void qtr_seeker_lost(qtr_seeker *seeker, unsigned who) {
  if (who >= seekers_of(seeker)) {
    return;
  }
  set_add(&seeker->lost, who);
  seeker->settled = false;
}

/* ---- what a robot asks ---- */

/* All questions settle first, so that the answer is by what is known now. */
uint16_t qtr_seeker_target(qtr_seeker *seeker) {
  settle(seeker);
  return seeker->target;
}

/* Ends, for each time round a place is blocked, and on the last round it stays so: twice round all places at most. */
bool qtr_seeker_field_built(qtr_seeker *seeker, qtr_field *field, qtr_cell here, uint32_t config_id) {
  const qtr_grid ground = qtr_policy_ground(seeker->policy, seeker->self);
  const qtr_grid *grid = &ground;
  if ((config_id != QTR_CONFIG_ID) || (qtr_grid_cost(grid, here) == 0u)) {
    return false;
  }
  while (qtr_seeker_target(seeker) != QTR_STAND_DOWN) {
    (void)qtr_field_fill(field, grid, qtr_policy_cell(seeker->policy, seeker->target)); /* of a policy's own grid */
    if (qtr_field_next(field, grid, here) != QTR_NO_CELL) {
      return true;
    }
    qtr_seeker_blocked(seeker, seeker->target);
  }
  return false;
}

/* Who says it is not in it: a signal is true or not, whoever repeats it. */
static qtr_signal signal_of(const qtr_seeker *seeker, uint8_t kind, unsigned territory) {
  return (qtr_signal){seeker->identity, seeker->run, kind, (uint8_t)territory};
}

/* A find before territories: whoever hears it needs no others. */
bool qtr_seeker_announce(qtr_seeker *seeker, qtr_signal *signal) {
  settle(seeker);
  if (seeker->found_unsaid) {
    seeker->found_unsaid = false;
    *signal = signal_of(seeker, QTR_SIGNAL_FOUND, 0);
    return true;
  }
  for (unsigned t = 0; t < seekers_of(seeker); t++) {
    if (!set_has(&seeker->unsaid, t)) {
      continue;
    }
    set_remove(&seeker->unsaid, t);
    *signal = signal_of(seeker, QTR_SIGNAL_TERRITORY_DONE, t);
    return true;
  }
  return false;
}

/* FOUND first: it spares the others the most. */
bool qtr_seeker_known(const qtr_seeker *seeker, unsigned index, qtr_signal *signal) {
  if (seeker->found) {
    *signal = signal_of(seeker, QTR_SIGNAL_FOUND, 0);
    if (index-- == 0u) {
      return true;
    }
  }
  for (unsigned t = 0; t < seekers_of(seeker); t++) {
    if (!set_has(&seeker->done, t)) {
      continue;
    }
    *signal = signal_of(seeker, QTR_SIGNAL_TERRITORY_DONE, t);
    if (index-- == 0u) {
      return true;
    }
  }
  return false;
}

/* Without a find, all territories done is the one good reason to stand; else what is left is out of reach, or
 * blocked. */
enum qtr_standing qtr_seeker_standing(qtr_seeker *seeker) {
  settle(seeker);
  if (seeker->target != QTR_STAND_DOWN) {
    return QTR_UNDER_WAY;
  }
  if (seeker->found) {
    return QTR_STANDS_FOUND;
  }
  for (unsigned t = 0; t < seekers_of(seeker); t++) {
    if (!set_has(&seeker->done, t)) {
      return QTR_STANDS_BLOCKED;
    }
  }
  return QTR_STANDS_DONE;
}

unsigned qtr_seeker_territory(qtr_seeker *seeker) {
  settle(seeker);
  return seeker->territory;
}

/* What others have announced does not count, though this robot has not seen it: it is scanned. */
unsigned qtr_seeker_left(qtr_seeker *seeker, qtr_places *left) {
  const qtr_division *division = &seeker->division;
  qtr_places unscanned;
  unsigned count = 0;
  settle(seeker);
  qtr_places_clear(&unscanned);
  for (unsigned i = 0; i < division->moves; i++) {
    const unsigned place = division->place[i];
    if (set_has(&seeker->done, division->seeker[i]) || place_is_in(&seeker->visited, place)) {
      continue;
    }
    /* By the paper's rule two seekers may be bound for one place. */
    count += place_is_in(&unscanned, place) ? 0u : 1u;
    place_put(&unscanned, place);
  }
  if (left != NULL) {
    *left = unscanned;
  }
  return count;
}

uint32_t qtr_seeker_foreign(const qtr_seeker *seeker) {
  return seeker->foreign;
}

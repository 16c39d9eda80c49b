/* The compact Q-table: exact keys, a float each (or a double, where asked for), in one block of the caller's.
 *
 * An entry is Q(s, a), stored under the joint state that the choice leads to before time passes. Two pairs (s, a) that
 * lead to the same such state have the same value and share the entry. A hash picks the slot, the stored key decides.
 * An entry takes only the words that the mission's keys need: 12 bytes for 20 places and 2 seekers. The table begins
 * small and doubles in place for as long as the block holds it.
 */
#ifndef QUARTER_SEARCH_QTABLE_H
#define QUARTER_SEARCH_QTABLE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "quarter/config.h"
#include "quarter/key.h"

typedef struct {
  uint32_t entries;     /* in use */
  uint32_t slots;       /* in use or free */
  uint32_t slots_limit; /* that the block holds */
  uint32_t refused;     /* entries that a full table did not take */
  uint8_t entry_words;  /* key and value */
  uint8_t value_words;  /* 1: floats, 2: doubles */
  uint8_t key_words;    /* of a key; the stored key may take one more, for its tag */
  uint32_t before;      /* while it grows: slots until then, */
  uint32_t cleared;     /* the first of the new ones that is not known to be free, */
  uint32_t
      swept;    /* and the first of the old ones whose entry is yet to be moved; not below `before`: it does not grow */
  uint32_t tag; /* of the entries in their right slots, in the top bits of a stored key */
  uint32_t *word; /* the block */
} qtr_qtable;

/* An empty table for keys of a shape, in a block of QTR_QTABLE_LEAST_WORDS at the least; more than QTR_QTABLE_WORDS are
 * not used. `precise`: doubles for values, at 4 bytes more an entry. */
void qtr_qtable_init(qtr_qtable *table, uint32_t *word, size_t words, const qtr_key_shape *keys, bool precise);

/* The table stands in another block now, no smaller, whose start holds what the old one held. QTR_OK, or QTR_ERR_SPACE
 * with nothing changed. */
int qtr_qtable_move(qtr_qtable *table, uint32_t *word, size_t words);

/* Words of a block in which no more than `more` entries to come are refused that one of QTR_QTABLE_WORDS would take. */
size_t qtr_qtable_needs(const qtr_qtable *table, uint32_t more);

/* Make room for `more` entries to come, a share of bounded work at a call: false when there is all that the block can
 * give. In between the table is neither read nor written, or they would have to wait for a whole doubling, which takes
 * seconds. */
bool qtr_qtable_make_room(qtr_qtable *table, uint32_t more);

/* Bytes that an entry takes, key and value. */
uint32_t qtr_qtable_entry_bytes(const qtr_qtable *table);

/* Look an entry up. False if there is none. */
bool qtr_qtable_get(const qtr_qtable *table, const qtr_key *key, double *value);

/* The same in two steps, for who looks many entries up: where one is sought from, with its memory asked for, then the
 * entry itself. In between nothing is set. */
uint32_t qtr_qtable_home(const qtr_qtable *table, const qtr_key *key);
bool qtr_qtable_get_from(const qtr_qtable *table, const qtr_key *key, uint32_t home, double *value);

/* A number of 32 bits for a key, the same however large the table is; few keys share theirs. */
uint32_t qtr_qtable_hash(const qtr_qtable *table, const qtr_key *key);

/* The value that an entry takes which is nearest to `value`, and the least one that is not below it: a bound must stay
 * one when it is stored. */
double qtr_qtable_nearest(const qtr_qtable *table, double value);
double qtr_qtable_round_up(const qtr_qtable *table, double value);

/* Set an entry, new or old, to the nearest value that it takes. False, and counted in `refused`, if it is new and the
 * table is full. */
bool qtr_qtable_set(qtr_qtable *table, const qtr_key *key, double value);

#endif

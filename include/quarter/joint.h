/* The joint game of k seekers (paper, section 4.2.2): its state, the choices allowed, a choice made, time advanced, and
 * the key under which a state is stored.
 *
 * Learner and robot both play by this one module, so that they cannot disagree about a state's key or its successor.
 * A node is a point between which travel times are known: places are nodes 0..places-1, the distinct start cells come
 * after them. A seeker is idle at a node, bound for a place, or stood down for the rest of the game.
 *
 * Idle seekers choose one after another with no time passing, the one at the lowest node first (the lower seeker on a
 * tie). The order does not depend on which seeker is where, so states that differ only by who is who are one state.
 */
#ifndef QUARTER_JOINT_H
#define QUARTER_JOINT_H

#include <stdbool.h>
#include <stdint.h>

#include "quarter/config.h"
#include "quarter/places.h"

#define QTR_STAND_DOWN ((uint16_t)0xFFFF) /* as a choice; and as a node, of a seeker that has stood down */
#define QTR_NOBODY (-1)
#define QTR_MAX_STARTS 32767 /* so that every node has a number of 16 bits */

enum qtr_rule {
  QTR_RULE_FREE = 0, /* an unvisited place that nobody is bound for, or stand down */
  QTR_RULE_PAPER = 1 /* Table 1: never stand down; when fewer places than seekers are left, any unvisited place */
};

/* What does not change during a game: the board it is played on. Fill the first part, then call qtr_board_init(). */
typedef struct {
  uint16_t places;                    /* 1..QTR_MAX_PLACES */
  uint16_t starts;                    /* places that a seeker may start from, 1..QTR_MAX_STARTS */
  uint8_t seekers;                    /* 1..QTR_MAX_SEEKERS */
  uint8_t rule;                       /* enum qtr_rule */
  uint16_t start_of[QTR_MAX_SEEKERS]; /* each seeker's start, 0..starts-1: its node is places + start_of[i] */
  const uint8_t *steps;               /* travel times, 4 bytes little-endian each, a row of `places` for every node,
                                        QTR_NEVER for no way; must outlive the board */
  /* set by qtr_board_init() */
  qtr_steps longest; /* the greatest finite travel time */
  uint16_t key_bits; /* that the greatest key takes */
  uint8_t key_words; /* the same in words, 1..QTR_KEY_WORDS */
} qtr_board;

typedef struct {
  qtr_places visited;
  qtr_places bound;   /* places that some seeker is bound for */
  uint16_t unvisited; /* how many places are left to visit */
  uint16_t node[QTR_MAX_SEEKERS];
  qtr_steps remaining[QTR_MAX_SEEKERS]; /* 0 unless bound for node[i] */
} qtr_joint;

/* Words that hold the key of any state of any board of this build: visited places, and a node and a time a seeker. */
#define QTR_KEY_WORDS (QTR_PLACE_WORDS + (QTR_MAX_SEEKERS * 48 + 31) / 32)

/* A state's exact key: an integer of the board's key_words words, the least significant first. Words beyond them are
 * not written. */
typedef struct {
  uint32_t word[QTR_KEY_WORDS];
} qtr_key;

/* Derive the size of the keys from places, starts, seekers and longest, which must be in their ranges. Part of
 * qtr_board_init(). */
void qtr_board_measure_keys(qtr_board *board);

/* Check the first part and derive the rest. QTR_OK, QTR_ERR_ARGUMENT, QTR_ERR_LIMIT, or QTR_ERR_CONFIG if the caller was
 * built under other sizes. */
#define qtr_board_init(board) qtr_board_init_built(board, QTR_CONFIG_ID)
int qtr_board_init_built(qtr_board *board, uint32_t config_id);

/* Travel time from a node to a place; QTR_NEVER if there is no way, or no such node or place. */
qtr_steps qtr_board_steps(const qtr_board *board, unsigned node, unsigned place);

/* The first state: every seeker idle at its start, `cleared` (NULL for none) visited. */
void qtr_joint_start(qtr_joint *joint, const qtr_board *board, const qtr_places *cleared);

/* The seeker whose turn it is to choose, or QTR_NOBODY: then time advances, or the game is over. Seekers with nothing
 * left to choose have been stood down already. */
int qtr_joint_chooser(const qtr_joint *joint, const qtr_board *board);

/* What `seeker`, whose turn it is, may choose: the places, one or more, and (returned) whether it may stand down. The
 * last seeker that can reach a place left over may not: every place is visited in the end. A seeker that is none, or is not
 * idle, may choose nothing: no place, and false. */
bool qtr_joint_choices(const qtr_joint *joint, const qtr_board *board, int seeker, qtr_places *choices);

/* Make an allowed choice. A place at no distance is visited at once. True if it was. Nothing happens, and false, for a
 * seeker that is none or is not idle, or a place that is none, is visited or is out of its reach. */
bool qtr_joint_choose(qtr_joint *joint, const qtr_board *board, int seeker, uint16_t choice);

/* Nobody is to choose: let the least remaining travel time pass. Returns it, and adds to `arrived` (may be NULL) each
 * place now visited for the first time. 0 with nothing changed: the game is over. */
qtr_steps qtr_joint_advance(qtr_joint *joint, const qtr_board *board, qtr_places *arrived);

/* The key: V plus the sorted (node, remaining) pairs, in mixed radix. Equal keys are equal states, exactly. */
void qtr_joint_key(qtr_key *key, const qtr_joint *joint, const qtr_board *board);

#endif

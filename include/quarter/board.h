/* The board that the joint game is played on: what does not change while it goes on.
 *
 * A node is a point between which travel times are known: places are nodes 0..places-1, the distinct start cells come
 * after them.
 */
#ifndef QUARTER_BOARD_H
#define QUARTER_BOARD_H

#include <stdint.h>

#include "quarter/config.h"
#include "quarter/key.h"
#include "quarter/terms.h"

QTR_C_BEGIN

#define QTR_STAND_DOWN ((uint16_t)0xFFFF) /* as a choice; and as a node, of a seeker that has stood down */
#define QTR_MAX_STARTS 32767              /* so that every node has a number of 16 bits */

enum qtr_rule {
  QTR_RULE_FREE = 0, /* an unvisited place that nobody is bound for, or stand down */
  QTR_RULE_PAPER = 1 /* Table 1: never stand down; when fewer places than seekers are left, any unvisited place */
};

/* Fill all but `keys`, then call qtr_board_init(). */
typedef struct {
  uint16_t places;                    /* 1..QTR_MAX_PLACES */
  uint16_t starts;                    /* places that a seeker may start from, 1..QTR_MAX_STARTS */
  uint8_t seekers;                    /* 1..QTR_MAX_SEEKERS */
  uint8_t rule;                       /* enum qtr_rule */
  uint8_t step_bytes;                 /* 1, 2 or 4: of a travel time */
  uint8_t classes;                    /* of seekers, each with travel times of its own; 0 is one, too */
  uint16_t start_of[QTR_MAX_SEEKERS]; /* each seeker's start, 0..starts-1: its node is places + start_of[i] */
  uint8_t class_of[QTR_MAX_SEEKERS];  /* and its class */
  const uint8_t *steps;               /* travel times, scans included, little-endian, a row of `places` for every node,
                                         all ones for no way; one such matrix after the other for each class; must
                                         outlive the board */
  qtr_key_shape keys;                 /* set by qtr_board_init(): `longest` is the greatest finite travel time, or the
                                         latest ready time */
  qtr_terms terms;                    /* all 0: none */
} qtr_board;

/* Check what is filled in and derive the rest. QTR_OK, QTR_ERR_ARGUMENT, QTR_ERR_LIMIT, or QTR_ERR_CONFIG if the caller
 * was built under other sizes. */
#define qtr_board_init(board) qtr_board_init_built(board, QTR_CONFIG_ID)
int qtr_board_init_built(qtr_board *board, uint32_t config_id);

/* Places and starts. */
unsigned qtr_board_nodes(const qtr_board *board);

/* Classes of seekers, one or more. */
unsigned qtr_board_classes(const qtr_board *board);

/* Travel time from a node to a place, scan included, for a seeker, and for any of a class; QTR_NEVER if there is no
 * way, or no such seeker, class, node or place. */
qtr_steps qtr_board_steps(const qtr_board *board, unsigned seeker, unsigned node, unsigned place);
qtr_steps qtr_board_class_steps(const qtr_board *board, unsigned of_class, unsigned node, unsigned place);

/* Step from which a seeker of the board's is in the game; by which it must be home, QTR_NEVER if ever; and, where there
 * are ends, its way home from a place of the board's. */
qtr_steps qtr_board_ready(const qtr_board *board, unsigned seeker);
qtr_steps qtr_board_end(const qtr_board *board, unsigned seeker);
qtr_steps qtr_board_home(const qtr_board *board, unsigned seeker, unsigned place);

QTR_C_END

#endif

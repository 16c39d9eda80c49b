/* Array sizes of the core, the only place where they are stated.
 *
 * Every array in Quarter has a fixed size from this file. Choose a profile (QTR_PROFILE_MCU, or the host profile by
 * default), override single sizes with -D, or name a header of your own with -DQTR_CONFIG_HEADER='"my_quarter.h"'.
 * All code that is linked together must be built under the same sizes: QTR_CONFIG_ID is compared when a structure is
 * initialised, and a difference is QTR_ERR_CONFIG, never a fault later on.
 */
#ifndef QUARTER_CONFIG_H
#define QUARTER_CONFIG_H

#include <stdint.h>

#ifdef QTR_CONFIG_HEADER
#include QTR_CONFIG_HEADER
#endif

/* Cells of a grid, columns x rows, blocked ones included. A distance field costs 6 bytes a cell up to 65,535 cells,
 * 8 beyond, on the robot as on the host. */
#ifndef QTR_MAX_CELLS
#ifdef QTR_PROFILE_MCU
#define QTR_MAX_CELLS (32 * 32)
#else
#define QTR_MAX_CELLS (1024 * 1024)
#endif
#endif

/* Candidate places of a mission, 1..32767. A set of places costs a robot one 32-bit word for every 32 of them. */
#ifndef QTR_MAX_PLACES
#ifdef QTR_PROFILE_MCU
#define QTR_MAX_PLACES 16
#else
#define QTR_MAX_PLACES 128
#endif
#endif

/* Seekers of a mission, 1..255. */
#ifndef QTR_MAX_SEEKERS
#ifdef QTR_PROFILE_MCU
#define QTR_MAX_SEEKERS 4
#else
#define QTR_MAX_SEEKERS 16
#endif
#endif

/* Learner: 32-bit words given to the Q-table's entries. An entry takes 2 words for a small mission and up to 7 for a
 * large one. A full table refuses new entries and counts them; the certificate stays valid, its gap closes slower. */
#ifndef QTR_QTABLE_WORDS
#ifdef QTR_PROFILE_MCU
#define QTR_QTABLE_WORDS 8192
#else
#define QTR_QTABLE_WORDS (1ul << 26)
#endif
#endif

/* Learner: time slots of the price bound. A mission whose search takes more steps is bounded in slots of several
 * steps, which stays valid and is less tight. Memory: 18 bytes for every slot and place. */
#ifndef QTR_BOUND_SLOTS
#ifdef QTR_PROFILE_MCU
#define QTR_BOUND_SLOTS 256
#else
#define QTR_BOUND_SLOTS 4096
#endif
#endif

#if QTR_MAX_CELLS < 1 || QTR_MAX_CELLS > 16777216
#error "QTR_MAX_CELLS must lie in 1..16777216"
#endif
#if QTR_MAX_PLACES < 1 || QTR_MAX_PLACES > 32767
#error "QTR_MAX_PLACES must lie in 1..32767"
#endif
#if QTR_MAX_SEEKERS < 1 || QTR_MAX_SEEKERS > 255
#error "QTR_MAX_SEEKERS must lie in 1..255"
#endif
#if QTR_BOUND_SLOTS < 16
#error "QTR_BOUND_SLOTS must be 16 or more"
#endif

/* A cell's index, row * columns + column; row 0 is the top row. */
#if QTR_MAX_CELLS <= 65535
typedef uint16_t qtr_cell;
#else
typedef uint32_t qtr_cell;
#endif
#define QTR_NO_CELL ((qtr_cell)-1)

/* A duration or a moment, in steps of the grid. */
typedef uint32_t qtr_steps;
#define QTR_NEVER UINT32_MAX

/* What the linked objects must agree on, as one number. */
#define QTR_CONFIG_ID                                                                                                  \
  ((uint32_t)(((uint32_t)(QTR_MAX_CELLS) * 2654435761u) ^ ((uint32_t)(QTR_MAX_PLACES) * 2246822519u) ^                 \
              ((uint32_t)(QTR_MAX_SEEKERS) * 3266489917u) ^ ((uint32_t)(QTR_QTABLE_WORDS) * 668265263u) ^              \
              ((uint32_t)(QTR_BOUND_SLOTS) * 374761393u)))

#endif

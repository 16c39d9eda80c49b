/* Array sizes of the core, the only place where they are stated.
 *
 * Every array in Quarter has a fixed size from this file. Choose a profile (QTR_PROFILE_MCU, the default under Arduino,
 * ESP-IDF, PlatformIO and Zephyr; QTR_PROFILE_TINY; else the host profile), override single sizes with -D, or name a
 * header of your own with -DQTR_CONFIG_HEADER='"my_quarter.h"'. All code that is linked together must be built under
 * the same sizes. Whoever sets up a structure whose size depends on them (the functions that end in _built and _sized,
 * behind macros of the plain name) hands over the caller's QTR_CONFIG_ID; a difference is QTR_ERR_CONFIG with nothing
 * written, never a fault later on.
 */
#ifndef QUARTER_CONFIG_H
#define QUARTER_CONFIG_H

#include <stddef.h> /* NULL, which README's robot loop hands over */
#include <stdint.h>

#ifdef QTR_CONFIG_HEADER
#include QTR_CONFIG_HEADER
#endif

/* What is built by a firmware's framework is for a robot: application and library alike. Tiny is for one that learns by
 * itself, 100 cells, 8 places and 2 seekers in 16 kB (docs/DESIGN.md), without spots or regions, and like any other
 * robot's in the rest. */
#if !defined(QTR_PROFILE_MCU) && (defined(ARDUINO) || defined(ESP_PLATFORM) || defined(PLATFORMIO) ||                  \
                                  defined(__ZEPHYR__) || defined(QTR_PROFILE_TINY))
#define QTR_PROFILE_MCU
#endif

/* Around what a public header declares: C++ links it as C. */
#ifdef __cplusplus
#define QTR_C_BEGIN extern "C" {
#define QTR_C_END }
#else
#define QTR_C_BEGIN
#define QTR_C_END
#endif

/* Cells of a grid, columns x rows, blocked ones included. A robot's field of directions (quarter/field.h) takes 2
 * bytes a cell below 4,096 cells, else 4. */
#ifndef QTR_MAX_CELLS
#if defined(QTR_PROFILE_TINY)
#define QTR_MAX_CELLS 100
#elif defined(QTR_PROFILE_MCU)
#define QTR_MAX_CELLS 1024
#else
#define QTR_MAX_CELLS 4194304
#endif
#endif

/* Candidate places of a mission, 1..4096. A set of places costs a robot one 32-bit word for every 32 of them. */
#ifndef QTR_MAX_PLACES
#if defined(QTR_PROFILE_TINY)
#define QTR_MAX_PLACES 8
#elif defined(QTR_PROFILE_MCU)
#define QTR_MAX_PLACES 16
#else
#define QTR_MAX_PLACES 1024
#endif
#endif

/* Seekers of a mission, 1..64. */
#ifndef QTR_MAX_SEEKERS
#if defined(QTR_PROFILE_TINY)
#define QTR_MAX_SEEKERS 2
#elif defined(QTR_PROFILE_MCU)
#define QTR_MAX_SEEKERS 4
#else
#define QTR_MAX_SEEKERS 32
#endif
#endif

/* Classes of robots in a mission, 1..64: what differs in speed, ground or scan times. Each takes a matrix of travel
 * times. */
#ifndef QTR_MAX_CLASSES
#if defined(QTR_PROFILE_TINY)
#define QTR_MAX_CLASSES 1
#elif defined(QTR_PROFILE_MCU)
#define QTR_MAX_CLASSES 4
#else
#define QTR_MAX_CLASSES 8
#endif
#endif

/* Whether missions may make use of the field's terms (quarter/terms.h): classes, ready times, endurance, looks, a
 * deadline, coming home. 0 leaves their code and memory out; missions and tables with such are refused. */
#ifndef QTR_TERMS
#ifdef QTR_PROFILE_TINY
#define QTR_TERMS 0
#else
#define QTR_TERMS 1
#endif
#endif

/* Places of a hiding spot, 1..8. The best order inside a spot is worked out over the subsets of its places, in
 * 12 * size * 2^size bytes of scratch. */
#ifndef QTR_MAX_SPOT_SIZE
#if defined(QTR_PROFILE_TINY)
#define QTR_MAX_SPOT_SIZE 2
#elif defined(QTR_PROFILE_MCU)
#define QTR_MAX_SPOT_SIZE 5
#else
#define QTR_MAX_SPOT_SIZE 8
#endif
#endif

/* Learner: regions that a map is divided into. */
#ifndef QTR_MAX_REGIONS
#if defined(QTR_PROFILE_TINY)
#define QTR_MAX_REGIONS 1
#elif defined(QTR_PROFILE_MCU)
#define QTR_MAX_REGIONS 1024
#else
#define QTR_MAX_REGIONS 524288
#endif
#endif

/* Learner: greatest limits that a division may be asked for: cells in a region, 1..4095, and steps between two of them,
 * 1..65535. The work for each cell of the map grows with the regions' size. */
#ifndef QTR_MAX_REGION_SIZE
#define QTR_MAX_REGION_SIZE 255
#endif
#ifndef QTR_MAX_REGION_DIAMETER
#define QTR_MAX_REGION_DIAMETER 65535
#endif

/* Learner: what blocks in static storage are made for (quarter/learner.h), where the build holds more: the host takes
 * blocks by need, and those of its largest mission would be gigabytes. A mission beyond them is QTR_ERR_SPACE there. */
#ifndef QTR_STATIC_PLACES
#define QTR_STATIC_PLACES (QTR_MAX_PLACES < 128 ? QTR_MAX_PLACES : 128)
#endif
#ifndef QTR_STATIC_CELLS
#define QTR_STATIC_CELLS (QTR_MAX_CELLS < 1048576 ? QTR_MAX_CELLS : 1048576)
#endif
#ifndef QTR_STATIC_REGIONS
#define QTR_STATIC_REGIONS (QTR_MAX_REGIONS < 131072 ? QTR_MAX_REGIONS : 131072)
#endif

/* Learner: 32-bit words given to the Q-table's entries at most. An entry takes 2 words for a small mission and up to 7
 * for a large one. A full table refuses new entries and counts them; the certificate stays valid, its gap closes
 * slower. */
#ifndef QTR_QTABLE_WORDS
#if defined(QTR_PROFILE_TINY)
#define QTR_QTABLE_WORDS 1024
#elif defined(QTR_PROFILE_MCU)
#define QTR_QTABLE_WORDS 8192
#else
#define QTR_QTABLE_WORDS (1ul << 26)
#endif
#endif

#define QTR_QTABLE_LEAST_WORDS 1024 /* that a table can begin with */

/* Learner: time slots of the price bound. A mission whose search takes more steps is bounded in slots of several steps,
 * which stays valid and is less tight; what is left of the slots goes into what routes remember. Memory: 24 bytes for
 * every slot and place. */
#ifndef QTR_BOUND_SLOTS
#if defined(QTR_PROFILE_TINY)
#define QTR_BOUND_SLOTS 18
#elif defined(QTR_PROFILE_MCU)
#define QTR_BOUND_SLOTS 256
#else
#define QTR_BOUND_SLOTS 4096
#endif
#endif

/* Learner: what is known at a time of the bound as a function of its prices. */
#define QTR_MAX_CUTS (QTR_MAX_PLACES < 64 ? QTR_MAX_PLACES + 1 : QTR_MAX_PLACES > 128 ? 250 : 64)

/* Learner: bytes of a qtr_learner_memory for routes within the gap (quarter/learner.h), 32 to 72 for each of those
 * begun; a caller's own block may be as large as it likes. 0: none are listed. */
#ifndef QTR_ROUTE_BYTES
#ifdef QTR_PROFILE_MCU
#define QTR_ROUTE_BYTES 0
#else
#define QTR_ROUTE_BYTES (192ul << 20)
#endif
#endif

/* Learner: powers of gamma that are kept ready, 8 bytes each; later ones are computed, which takes longer. Other sizes
 * may differ in the last bit of what is discounted. */
#ifndef QTR_OBJECTIVE_POWERS
#if defined(QTR_PROFILE_TINY)
#define QTR_OBJECTIVE_POWERS 64
#elif defined(QTR_PROFILE_MCU)
#define QTR_OBJECTIVE_POWERS 512
#else
#define QTR_OBJECTIVE_POWERS 4096
#endif
#endif

#if QTR_MAX_CELLS < 1 || QTR_MAX_CELLS > 16777216
#error "QTR_MAX_CELLS must lie in 1..16777216"
#endif
#if QTR_MAX_PLACES < 1
#error "QTR_MAX_PLACES must be 1 or more"
#endif
#if QTR_MAX_PLACES > 4096
#error "QTR_MAX_PLACES must be at most 4096: a key's length is counted in 8 bits, a travel time's place in 32"
#endif
#if QTR_QTABLE_WORDS < QTR_QTABLE_LEAST_WORDS
#error "QTR_QTABLE_WORDS must be 1024 or more"
#endif
#if QTR_MAX_SEEKERS < 1 || QTR_MAX_SEEKERS > 64
#error "QTR_MAX_SEEKERS must lie in 1..64"
#endif
#if QTR_MAX_CLASSES < 1 || QTR_MAX_CLASSES > 64
#error "QTR_MAX_CLASSES must lie in 1..64"
#endif
#if QTR_MAX_SPOT_SIZE < 1 || QTR_MAX_SPOT_SIZE > 8
#error "QTR_MAX_SPOT_SIZE must lie in 1..8"
#endif
#if QTR_MAX_REGIONS < 1 || QTR_MAX_REGIONS > 16777216
#error "QTR_MAX_REGIONS must lie in 1..16777216"
#endif
#if QTR_MAX_REGION_SIZE < 1 || QTR_MAX_REGION_SIZE > 4095
#error "QTR_MAX_REGION_SIZE must lie in 1..4095"
#endif
#if QTR_MAX_REGION_DIAMETER < 1 || QTR_MAX_REGION_DIAMETER > 65535
#error "QTR_MAX_REGION_DIAMETER must lie in 1..65535"
#endif
#if QTR_BOUND_SLOTS < 16
#error "QTR_BOUND_SLOTS must be 16 or more"
#endif
#if QTR_OBJECTIVE_POWERS < 16 || QTR_OBJECTIVE_POWERS > 65536
#error "QTR_OBJECTIVE_POWERS must lie in 16..65536"
#endif

/* A cell's index, row * columns + column; row 0 is the top row. */
#if QTR_MAX_CELLS <= 65535
typedef uint16_t qtr_cell;
#else
typedef uint32_t qtr_cell;
#endif
#define QTR_NO_CELL ((qtr_cell) - 1)

/* A region's number, 0 and up. */
#if QTR_MAX_REGIONS <= 65535
typedef uint16_t qtr_region;
#else
typedef uint32_t qtr_region;
#endif
#define QTR_NO_REGION ((qtr_region) - 1)

/* A duration or a moment, in steps of the grid. */
typedef uint32_t qtr_steps;
#define QTR_NEVER UINT32_MAX

/* What the linked objects must agree on, as one number. */
#define QTR_CONFIG_ID                                                                                                  \
  ((uint32_t)(((uint32_t)(QTR_MAX_CELLS) * 2654435761u) ^ ((uint32_t)(QTR_MAX_PLACES) * 2246822519u) ^                 \
              ((uint32_t)(QTR_MAX_SEEKERS) * 3266489917u) ^ ((uint32_t)(QTR_QTABLE_WORDS) * 668265263u) ^              \
              ((uint32_t)(QTR_MAX_CLASSES) * 2654435789u) ^ ((uint32_t)(QTR_TERMS) * 2246822543u) ^                    \
              ((uint32_t)(QTR_BOUND_SLOTS) * 374761393u) ^ ((uint32_t)(QTR_MAX_SPOT_SIZE) * 1013904223u) ^             \
              ((uint32_t)(QTR_MAX_REGIONS) * 2246822507u) ^ ((uint32_t)(QTR_MAX_REGION_SIZE) * 3266489909u) ^          \
              ((uint32_t)(QTR_MAX_REGION_DIAMETER) * 2654435769u) ^ ((uint32_t)(QTR_OBJECTIVE_POWERS) * 2147483659u) ^ \
              ((uint32_t)(QTR_ROUTE_BYTES) * 3266489891u)))

#endif

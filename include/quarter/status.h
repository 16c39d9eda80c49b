/* What the core's functions return: 0 for success, a negative code for an error, a positive number for a count. */
#ifndef QUARTER_STATUS_H
#define QUARTER_STATUS_H

#include "quarter/config.h"

QTR_C_BEGIN

#define QTR_VERSION_MAJOR 0
#define QTR_VERSION_MINOR 1
#define QTR_VERSION_PATCH 0
#define QTR_VERSION_STRING "0.1.0"
/* As one number, which #if can compare: a byte each, as a table says who wrote it. */
#define QTR_VERSION ((QTR_VERSION_MAJOR * 65536L) + (QTR_VERSION_MINOR * 256L) + QTR_VERSION_PATCH)

enum {
  QTR_OK = 0,
  QTR_ERR_CONFIG = -1,       /* built under other array sizes than the caller (quarter/config.h) */
  QTR_ERR_ARGUMENT = -2,     /* an argument out of its range */
  QTR_ERR_LIMIT = -3,        /* more cells, places, seekers or travel time than this build holds */
  QTR_ERR_SPACE = -4,        /* the output buffer is too small */
  QTR_ERR_TRUNCATED = -5,    /* table: fewer bytes than its header says */
  QTR_ERR_MAGIC = -6,        /* table: not a Quarter policy table */
  QTR_ERR_FORMAT = -7,       /* table: a format version that this build does not read */
  QTR_ERR_CHECKSUM = -8,     /* table: the CRC does not match */
  QTR_ERR_CORRUPT = -9,      /* table: an offset, index or value out of its range */
  QTR_ERR_SELFTEST = -10,    /* table: this build plays the game otherwise than the one that wrote it */
  QTR_ERR_NO_START = -11,    /* mission: no seeker */
  QTR_ERR_NO_PLACE = -12,    /* mission: no place */
  QTR_ERR_START = -13,       /* mission: a start off the map or on an obstacle */
  QTR_ERR_PLACE = -14,       /* mission: a place off the map, on an obstacle, or twice on one cell */
  QTR_ERR_WEIGHT = -15,      /* mission: a weight that is not a finite number above 0 */
  QTR_ERR_UNREACHABLE = -16, /* mission: a place that no seeker can reach */
  QTR_ERR_DISCOUNT = -17,    /* mission: gamma leaves next to nothing of even the nearest place (quarter/game.h) */
  QTR_ERR_TRAVEL = -18,      /* table: travel times that contradict one another, or a place that no seeker can reach */
  QTR_ERR_CERTIFICATE = -19, /* table: a value, bound or gap that is no number, or that the others contradict */
  QTR_ERR_STOPPED = -20,     /* the caller's watch ended the work before it was done (quarter/watch.h) */
  QTR_ERR_SAVE = -21,        /* save: torn, or of another robot, table or format */
  QTR_ERR_CLASS = -22,       /* mission: a class of robots out of its ranges, or a seeker of a class that is none */
  QTR_ERR_LOOKS = -23,       /* mission: a place's looks or detection out of range, or looks that take no step each */
  QTR_ERR_HORIZON = -24      /* mission: no seeker can search any place by the deadline, or within its endurance */
};

/* QTR_VERSION of the library that is linked. */
uint32_t qtr_version(void);

/* One line of English for a status, never NULL; static storage. */
const char *qtr_strerror(int status);

/* Whether QTR_ASSERT() looks: 0 where NDEBUG is defined, as in a release build, and 1 elsewhere, unless it is given. */
#ifndef QTR_ASSERTIONS
#ifdef NDEBUG
#define QTR_ASSERTIONS 0
#else
#define QTR_ASSERTIONS 1
#endif
#endif

/* What always holds, or a programmer has made a mistake; bytes from outside never get here. Override to trap, log or
 * compile it out. */
#ifndef QTR_ASSERT
#if QTR_ASSERTIONS && defined(__GNUC__)
#define QTR_ASSERT(condition) ((condition) ? (void)0 : __builtin_trap())
#else
#define QTR_ASSERT(condition) ((void)(0 && (condition)))
#endif
#endif

QTR_C_END

#endif

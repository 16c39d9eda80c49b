/* The distances of TSPLIB 95, section 2; degrees as its authors' code takes them: cut off, where the text rounds. */
#include <math.h>

#include "field/tsplib.h"
#include "model/rounding.h"

#define TSPLIB_PI 3.141592
#define EARTH_RADIUS 6378.388 /* km */

static double nearest(double x) {
  return floor(x + 0.5);
}

static double euclidean(const double *from, const double *to) {
  const double x = from[0] - to[0];
  const double y = from[1] - to[1];
  return sqrt(x * x + y * y);
}

/* Pseudo-Euclidean: rounded to the nearest, and up where that is less. */
static double att(const double *from, const double *to) {
  const double x = from[0] - to[0];
  const double y = from[1] - to[1];
  const double apart = sqrt((x * x + y * y) / 10.0);
  const double rounded = nearest(apart);
  return rounded < apart ? rounded + 1.0 : rounded;
}

/* Degrees and minutes, DDD.MM, in radians. */
static double radians(double coordinate) {
  const double degrees = trunc(coordinate);
  return TSPLIB_PI * (degrees + 5.0 * (coordinate - degrees) / 3.0) / 180.0;
}

/* On a sphere: latitude, then longitude. */
static double geographical(const double *from, const double *to) {
  const double q1 = cos(radians(from[1]) - radians(to[1]));
  const double q2 = cos(radians(from[0]) - radians(to[0]));
  const double q3 = cos(radians(from[0]) + radians(to[0]));
  return floor(EARTH_RADIUS * acos(fmin(1.0, 0.5 * ((1.0 + q1) * q2 - (1.0 - q1) * q3))) + 1.0);
}

uint32_t tsplib_distance(enum tsplib_kind kind, const double *from, const double *to) {
  switch (kind) {
  case TSPLIB_EUC_2D: return (uint32_t)nearest(euclidean(from, to));
  case TSPLIB_CEIL_2D: return (uint32_t)ceil(euclidean(from, to));
  case TSPLIB_ATT: return (uint32_t)att(from, to);
  case TSPLIB_GEO: return (uint32_t)geographical(from, to);
  default: return 0;
  }
}

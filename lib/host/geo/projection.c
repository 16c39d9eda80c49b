#include "host/geo/projection.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "host/base/library.h"

#define NEED "degrees take PROJ (package libproj-dev)"

#ifdef QUARTER_PROJ
#include <proj.h>

struct projection {
  PJ_CONTEXT *context;
  PJ *conversion;
};

static __typeof__(proj_context_create) *context_create;
static __typeof__(proj_context_destroy) *context_destroy;
static __typeof__(proj_log_level) *log_level;
static __typeof__(proj_create) *create;
static __typeof__(proj_destroy) *destroy;
static __typeof__(proj_trans) *trans;

static const library_function functions[] = {{"proj_context_create", &context_create},
                                             {"proj_context_destroy", &context_destroy},
                                             {"proj_log_level", &log_level},
                                             {"proj_create", &create},
                                             {"proj_destroy", &destroy},
                                             {"proj_trans", &trans},
                                             {NULL, NULL}};

static const double DEGREE = 3.14159265358979323846 / 180.0;

static int begin(projection *p, const qtr_geo *origin, fault *why) {
  char text[160];
  snprintf(text, sizeof text, "+proj=aeqd +lat_0=%.9f +lon_0=%.9f +ellps=WGS84 +units=m",
           (double)origin->latitude / (double)QTR_GEO_ONE, (double)origin->longitude / (double)QTR_GEO_ONE);
  p->context = context_create();
  if (p->context == NULL) return fault_set(why, "no memory for a projection");
  log_level(p->context, PJ_LOG_NONE);
  p->conversion = create(p->context, text);
  return p->conversion != NULL ? 0 : fault_set(why, "PROJ does not know the projection '%s'", text);
}

projection *projection_open(const qtr_geo *origin, fault *why) {
  if (library_load(QUARTER_PROJ, functions, NEED, why) != 0) return NULL;
  projection *p = calloc(1, sizeof *p);
  if (p == NULL) fault_set(why, "no memory for a projection");
  if (p == NULL || begin(p, origin, why) == 0) return p;
  projection_close(p);
  return NULL;
}

static int convert(projection *p, PJ_DIRECTION direction, double x, double y, double *u, double *v) {
  const PJ_COORD to = trans(p->conversion, direction, (PJ_COORD){.v = {x, y, 0.0, 0.0}});
  *u = to.v[0];
  *v = to.v[1];
  return isfinite(*u) && isfinite(*v) ? 0 : -1;
}

int projection_to_degrees(projection *p, double east, double north, double *latitude, double *longitude) {
  double lambda, phi;
  if (convert(p, PJ_INV, east, north, &lambda, &phi) != 0) return -1;
  *latitude = phi / DEGREE;
  *longitude = lambda / DEGREE;
  return 0;
}

int projection_to_metres(projection *p, double latitude, double longitude, double *east, double *north) {
  return convert(p, PJ_FWD, longitude * DEGREE, latitude * DEGREE, east, north);
}

void projection_close(projection *p) {
  if (p == NULL) return;
  if (p->conversion != NULL) destroy(p->conversion);
  if (p->context != NULL) context_destroy(p->context);
  free(p);
}

#else

projection *projection_open(const qtr_geo *origin, fault *why) {
  (void)origin;
  fault_set(why, NEED ", which was not there when Quarter was built: install it and build again");
  return NULL;
}

int projection_to_degrees(projection *p, double east, double north, double *latitude, double *longitude) {
  (void)p;
  (void)east;
  (void)north;
  *latitude = *longitude = NAN;
  return -1;
}

int projection_to_metres(projection *p, double latitude, double longitude, double *east, double *north) {
  (void)p;
  (void)latitude;
  (void)longitude;
  *east = *north = NAN;
  return -1;
}

void projection_close(projection *p) {
  (void)p;
}

#endif

/* GeoJSON files, RFC 7946: features, and where they lie on the map. Degrees are made metres by the mission's `geo`. */
#ifndef QUARTER_HOST_GEOJSON_H
#define QUARTER_HOST_GEOJSON_H

#include "host/geo/projection.h"
#include "host/input/input.h"
#include "host/input/tree.h"

typedef struct {
  const input *in;
  tree file;
  projection *globe;    /* NULL: coordinates are metres in the map frame */
  double area, area_on; /* of what was marked last, in cells: all of it, and what of it lies on the map */
} geojson;

typedef struct {
  int index;             /* in the file */
  const char *type;      /* of the geometry */
  tree_node *shape;      /* its coordinates */
  tree_node *node;       /* the feature itself, for faults */
  tree_node *properties; /* NULL: none */
} geojson_feature;

/* Read the file, which `named_by` ("mission.yaml:3") asked for. 0, or -1 with *fault set and nothing to close: also
 * where its coordinates are degrees and the mission has no `geo`. */
int geojson_open(geojson *g, const input *in, const char *path, const char *named_by, fault *why);
void geojson_close(geojson *g);

/* Visit each feature that has a geometry; what is not 0 ends it and is returned. -1 with the fault set for a file that
 * has no features. */
typedef int geojson_visit(void *context, geojson *g, const geojson_feature *f);
int geojson_each(geojson *g, geojson_visit *visit, void *context);

/* A point's coordinates on the map. 0, or -1 with the fault set: also where they are off the map, and on it when
 * latitude and longitude are exchanged. */
int geojson_position(geojson *g, tree_node *coordinates, input_position *out);

bool geojson_is_area(const geojson_feature *f); /* a Polygon or MultiPolygon */

/* Set mask[cell] of the cells of an area: those whose middle it holds where `middles` and there are any, else all that
 * it cuts. How many, or -1 with the fault set: it is no polygon, or lies outside the map. */
long geojson_mark(geojson *g, const geojson_feature *f, uint8_t *mask, bool middles);

#endif

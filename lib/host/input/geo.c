#include "host/input/geo.h"

#include <math.h>

static tree_keys KEYS = {"latitude", "longitude", "yaw", NULL};
static const char *const WHAT = "'geo'";
static const double TURN = 6.283185307179586;

static int64_t whole(double value) {
  return (int64_t)llround(value * (double)QTR_GEO_ONE);
}

/* Only what lies beyond a pole can be told for an exchange: 13.4, 52.5 is as good a place as 52.5, 13.4. */
static int check_degrees(tree *yaml, tree_node *latitude, tree_node *longitude, double north, double east) {
  if (fabs(north) > 90.0 && fabs(north) <= 180.0 && fabs(east) <= 90.0)
    return tree_fault(yaml, latitude,
                      "'latitude' is %g and 'longitude' %g: they seem exchanged; write them the other "
                      "way round",
                      north, east);
  if (!(fabs(north) <= 90.0))
    return tree_fault(yaml, latitude, "'latitude' is %g; give degrees north, from -90 to 90", north);
  if (!(fabs(east) <= 180.0))
    return tree_fault(yaml, longitude, "'longitude' is %g; give degrees east, from -180 to 180", east);
  return 0;
}

static int read_degrees(qtr_geo *geo, tree *yaml, tree_node *node) {
  double north, east;
  tree_node *latitude = tree_need(yaml, node, WHAT, "latitude", "52.5163"), *longitude;
  if (latitude == NULL || (longitude = tree_need(yaml, node, WHAT, "longitude", "13.3777")) == NULL) return -1;
  if (tree_number(yaml, latitude, "latitude", &north) || tree_number(yaml, longitude, "longitude", &east)) return -1;
  if (check_degrees(yaml, latitude, longitude, north, east)) return -1;
  geo->latitude = whole(north);
  geo->longitude = whole(east);
  return 0;
}

static int read_yaw(qtr_geo *geo, tree *yaml, tree_node *node) {
  double yaw = 0.0;
  tree_node *turn = tree_find(yaml, node, "yaw");
  if (turn == NULL) return 0;
  if (tree_number(yaml, turn, "yaw", &yaw)) return -1;
  if (!(fabs(yaw) <= TURN))
    return tree_fault(yaml, turn, "'yaw' is %g; give radians, from -6.2831 to 6.2831 (90 degrees are 1.5708)", yaw);
  geo->yaw = whole(yaw);
  return 0;
}

int geo_read(input *in, tree *yaml, tree_node *root) {
  tree_node *node = tree_find(yaml, root, "geo");
  if (node == NULL) return 0;
  if (tree_check_keys(yaml, node, WHAT, KEYS, false)) return -1;
  if (!in->frame.metric)
    return tree_fault(yaml, node,
                      "'geo' puts metres on the globe, and this map has none; delete it, or name a map with "
                      "metres");
  if (read_degrees(&in->geo, yaml, node) || read_yaw(&in->geo, yaml, node)) return -1;
  in->geo.given = true;
  return 0;
}

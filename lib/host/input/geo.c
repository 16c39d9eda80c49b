#include "host/input/geo.h"

#include <math.h>
#include <string.h>

#include "host/base/text.h"
#include "host/input/mission_keys.h"

static int64_t whole(double value) {
  return (int64_t)llround(value * (double)QTR_GEO_ONE);
}

/* The number that a key has; NaN where it has none, which is told of where it is read. */
static double number_of(tree *yaml, tree_node *node, const char *key) {
  const char *text;
  double number;
  tree_node *value = tree_find(yaml, node, key);
  if (value == NULL || !tree_plain(yaml, value, &text) || text_number(&number, text, strlen(text)) != NULL) return NAN;
  return number;
}

/* Only what lies beyond a pole can be told for an exchange: 13.4, 52.5 is as good a place as 52.5, 13.4. */
static int check_exchange(tree *yaml, tree_node *node) {
  const double north = number_of(yaml, node, "latitude"), east = number_of(yaml, node, "longitude");
  if (!(fabs(north) > 90.0 && fabs(north) <= 180.0 && fabs(east) <= 90.0)) return 0;
  return tree_fault(yaml, tree_find(yaml, node, "latitude"),
                    "'latitude' is %g and 'longitude' %g: they seem exchanged; write them the other way round", north,
                    east);
}

int geo_read(input *in, tree *yaml, tree_node *root) {
  mission_geo geo = {0};
  tree_node *node = tree_find(yaml, root, "geo");
  if (node == NULL) return 0;
  if (!in->frame.metric)
    return tree_fault(yaml, node,
                      "'geo' puts metres on the globe, and this map has none; delete it, or name a map with "
                      "metres");
  if (check_exchange(yaml, node) || keys_read(&geo, &mission_geo_keys, yaml, node, "'geo'", NULL)) return -1;
  in->geo = (qtr_geo){true, whole(geo.latitude), whole(geo.longitude), whole(geo.yaw)};
  return 0;
}

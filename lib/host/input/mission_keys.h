/* What a mission may say: the keys of the mission itself, of a robot, a place and more, a record each. The reader, its
 * faults, docs/mission.md and docs/mission.schema.json are made of these. */
#ifndef QUARTER_HOST_MISSION_KEYS_H
#define QUARTER_HOST_MISSION_KEYS_H

#include <stdint.h>

#include "host/input/input.h"
#include "host/input/keys.h"

/* What a key's `where` says where only such maps have a use for it. */
#define MISSION_ROS_MAPS "ROS maps"

/* A robot or a place, as its keys are read. */
typedef struct {
  double x, y;
  int32_t column, row;
  input_site it; /* all but the position, which the reader makes of the above */
} mission_site;

/* Its position, as its set's `either` counts them. */
enum mission_position { MISSION_METRES, MISSION_CELLS };

/* Where the map lies on the globe: degrees, degrees, radians. */
typedef struct {
  double latitude, longitude, yaw;
} mission_geo;

/* Places out of a raster, or a GeoJSON. */
typedef struct {
  char file[INPUT_PATH_SIZE];
  double footprint; /* metres, cells on a map without */
  double share;
} mission_raster;

/* With the position that `group` says that it states. */
input_site mission_site_of(const mission_site *stated, int group);

extern const key_set mission_keys;         /* into an `input` */
extern const key_set mission_robot_keys;   /* into a mission_site */
extern const key_set mission_place_keys;   /* likewise */
extern const key_set mission_geo_keys;     /* into a mission_geo */
extern const key_set mission_corner_keys;  /* into a mission_site */
extern const key_set mission_geojson_keys; /* into a mission_raster */
extern const key_set mission_raster_keys;  /* into a mission_raster */
extern const key_set mission_class_keys;   /* into an input_class */

#endif

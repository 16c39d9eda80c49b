#include "host/input/mission_keys.h"

#include <math.h>

#include "host/input/words.h"
#include "quarter/objective.h"

/* ---- a robot, a place ---- */

static const key_group positions[] = {
    [MISSION_METRES] = {{"x", "y"}, "metres"}, [MISSION_CELLS] = {{"column", "row"}, "cells"}, {{NULL}, NULL}};

#define POSITION                                                                                                       \
  {.name = "x",                                                                                                        \
   .kind = KEY_NUMBER,                                                                                                 \
   .help = "metres in the map frame (cells from the lower left corner, on a map without metres)",                      \
   .example = "1.5",                                                                                                   \
   .unit = "m",                                                                                                        \
   KEY_FIELD(mission_site, x)},                                                                                        \
      {.name = "y",                                                                                                    \
       .kind = KEY_NUMBER,                                                                                             \
       .help = "likewise, upwards",                                                                                    \
       .example = "1.5",                                                                                               \
       .unit = "m",                                                                                                    \
       KEY_FIELD(mission_site, y)},                                                                                    \
      {.name = "column",                                                                                               \
       .kind = KEY_INTEGER,                                                                                            \
       .help = "cell, counted from 0 at the left",                                                                     \
       .example = "4",                                                                                                 \
       KEY_FIELD(mission_site, column)},                                                                               \
  {                                                                                                                    \
    .name = "row", .kind = KEY_INTEGER, .help = "cell, counted from 0 at the top", .example = "4",                     \
    KEY_FIELD(mission_site, row)                                                                                       \
  }

#define NAME(what)                                                                                                     \
  {.name = "name",                                                                                                     \
   .kind = KEY_NAME,                                                                                                   \
   .help = what,                                                                                                       \
   .example = "Bay 3",                                                                                                 \
   .standard = "its number, from 0",                                                                                   \
   KEY_FIELD(mission_site, it.name)}

#define SECONDS .kind = KEY_NUMBER, .unit = "s", .noun = "seconds", .most = LONGEST
#define LONGEST 1e7 /* seconds: beyond, steps might not be counted */

static const key_record robot_records[] = {
    POSITION,
    NAME("what reports, pictures and options call it; no two robots have one name"),
    {.name = "class",
     .kind = KEY_NAME,
     .help = "one of `classes`",
     .example = "drone",
     .standard = "as the mission says",
     KEY_FIELD(mission_site, it.class_name)},
    {.name = "ready_seconds",
     SECONDS,
     .help = "when it sets out",
     .example = "60",
     .standard = "0",
     KEY_FIELD(mission_site, it.ready_seconds),
     KEY_GIVEN(mission_site, it.ready_given)},
    {.name = NULL}};

#define DETECTION                                                                                                      \
  .kind = KEY_NUMBER, .help = "probability that a look finds what is there", .example = "0.8",                         \
  .noun = "a probability", .most = 1.0, .least_out = true
#define LOOKS                                                                                                          \
  .kind = KEY_INTEGER, .help = "that it is worth at most, where looks may miss; each after the first is worth less",   \
  .example = "2", .least = 1.0, .most = 255.0

static const char *const weight_words[] = {"poa", "likelihood", NULL};

static const key_record place_records[] = {
    POSITION,
    {.name = "weight",
     .also = weight_words,
     .kind = KEY_NUMBER,
     .help = "how likely the target is there, in any unit: shares of the sum count",
     .example = "2",
     .standard = "1",
     .noun = "a likelihood in any unit",
     .most = HUGE_VAL,
     .least_out = true,
     KEY_FIELD(mission_site, it.weight)},
    NAME("what reports, pictures and options call it; no two places have one name"),
    {.name = "scan_seconds",
     SECONDS,
     .help = "what a look at it takes, for every class: it counts when the look ends",
     .example = "30",
     .standard = "as the class, or the mission, says",
     KEY_FIELD(mission_site, it.scan_seconds),
     KEY_GIVEN(mission_site, it.scan_given)},
    {.name = "detection", DETECTION, .standard = "the mission's", KEY_FIELD(mission_site, it.detection)},
    {.name = "looks", LOOKS, .standard = "the mission's", KEY_FIELD(mission_site, it.looks)},
    {.name = NULL}};

const key_set mission_robot_keys = {"A robot", robot_records, positions, "position"};
const key_set mission_place_keys = {"A place", place_records, positions, "position"};

input_site mission_site_of(const mission_site *stated, int group) {
  input_site site = stated->it;
  site.position = group == MISSION_METRES ? (input_position){true, stated->x, stated->y}
                                          : (input_position){false, stated->column, stated->row};
  return site;
}

#define SPEED                                                                                                          \
  .kind = KEY_NUMBER, .help = "over plain ground", .example = "0.5", .where = METRIC_MAPS, .unit = "m/s",              \
  .noun = "a speed", .most = 1e4, .least_out = true

#define METRIC_MAPS "maps with metres"

/* ---- where the map lies ---- */

static const key_record geo_records[] = {
    {.name = "latitude",
     .kind = KEY_NUMBER,
     .help = "of the map frame's origin (x = 0, y = 0), north positive, WGS84",
     .example = "52.5163",
     .unit = "degrees",
     .noun = "degrees north",
     .least = -90.0,
     .most = 90.0,
     .needed = true,
     KEY_FIELD(mission_geo, latitude)},
    {.name = "longitude",
     .kind = KEY_NUMBER,
     .help = "likewise, east positive",
     .example = "13.3777",
     .unit = "degrees",
     .noun = "degrees east",
     .least = -180.0,
     .most = 180.0,
     .needed = true,
     KEY_FIELD(mission_geo, longitude)},
    {.name = "yaw",
     .kind = KEY_NUMBER,
     .help = "by which the frame's x axis is turned from east, counter-clockwise; 90 degrees are 1.5708",
     .example = "0.25",
     .standard = "0",
     .unit = "radians",
     .noun = "radians",
     .least = -6.283185307179586,
     .most = 6.283185307179586,
     KEY_FIELD(mission_geo, yaw)},
    {.name = NULL}};

const key_set mission_geo_keys = {"Where the map lies on the globe", geo_records, NULL, NULL};

/* ---- the ground ---- */

static const key_record corner_records[] = {POSITION, {.name = NULL}};

const key_set mission_corner_keys = {"A corner of a polygon", corner_records, positions, "position"};

/* ---- places out of a raster ---- */

static const key_record raster_records[] = {
    {.name = "file",
     .kind = KEY_FILE,
     .help = "a likelihood, in any unit, for each piece of the ground: a PGM or PNG that covers the map, bright being "
             "likely, or an ESRI ASCII grid in the map frame",
     .example = "likelihood.pgm",
     .needed = true,
     KEY_FIELD(mission_raster, file)},
    {.name = "footprint",
     .kind = KEY_NUMBER,
     .help =
         "side of the square that a robot's sensor sees (in cells, on a map without metres): the likelihood of a tile "
         "of that size is the weight of one place, named by the tile's column and row from the map's lower left "
         "corner, "
         "as B07",
     .example = "5",
     .unit = "m",
     .noun = "a length",
     .most = HUGE_VAL,
     .least_out = true,
     .needed = true,
     KEY_FIELD(mission_raster, footprint)},
    {.name = "share",
     .kind = KEY_NUMBER,
     .help = "as much of the likelihood that robots can get to is covered, the likeliest tiles first",
     .example = "0.8",
     .standard = "1",
     .noun = "a share",
     .most = 1.0,
     .least_out = true,
     KEY_FIELD(mission_raster, share)},
    {.name = NULL}};

const key_set mission_raster_keys = {"Places out of a raster", raster_records, NULL, NULL};

/* ---- places out of a GeoJSON ---- */

static const key_record geojson_records[] = {
    {.name = "file",
     .kind = KEY_FILE,
     .help =
         "GeoJSON: each Point is a place, by its properties `weight` (or `poa`, `POA`, `likelihood`), `name` and other "
         "keys of a place; the weight of each Polygon is spread evenly over it; in degrees, as `geo` puts them on the "
         "map, or, where its `crs` is named \"local\", in metres in the map frame",
     .example = "places.geojson",
     .needed = true,
     KEY_FIELD(mission_raster, file)},
    {.name = "footprint",
     .kind = KEY_NUMBER,
     .help = "side of the tiles that polygons are cut into, as for a raster (in cells, on a map without metres); a "
             "polygon's `name` comes before a tile's, as Orchard B07",
     .example = "5",
     .standard = "none: points alone are read",
     .unit = "m",
     .noun = "a length",
     .most = HUGE_VAL,
     .least_out = true,
     KEY_FIELD(mission_raster, footprint)},
    {.name = "share",
     .kind = KEY_NUMBER,
     .help = "as much of the polygons' likelihood that robots can get to is covered, the likeliest tiles first",
     .example = "0.8",
     .standard = "1",
     .noun = "a share",
     .most = 1.0,
     .least_out = true,
     KEY_FIELD(mission_raster, share)},
    {.name = NULL}};

const key_set mission_geojson_keys = {"Places out of a GeoJSON", geojson_records, NULL, NULL};

/* ---- classes of robots ---- */

static const key_record class_records[] = {{.name = "speed",
                                            SPEED,
                                            .standard = "the mission's",
                                            KEY_FIELD(input_class, speed),
                                            KEY_GIVEN(input_class, stated)},
                                           {.name = "scan_seconds",
                                            SECONDS,
                                            .help = "what a look takes, at places that say nothing of it",
                                            .example = "30",
                                            .standard = "the mission's",
                                            KEY_FIELD(input_class, scan_seconds),
                                            KEY_GIVEN(input_class, stated)},
                                           {.name = "endurance_seconds",
                                            SECONDS,
                                            .least_out = true,
                                            .help = "from its ready time until it must be back at its start",
                                            .example = "900",
                                            .standard = "no end",
                                            KEY_FIELD(input_class, endurance_seconds),
                                            KEY_GIVEN(input_class, stated)},
                                           {.name = "avoid",
                                            .kind = KEY_LIST,
                                            .help = "places that it may not visit, by name or number",
                                            .example = "[Bay 3]",
                                            .standard = "none"},
                                           {.name = "rough",
                                            .kind = KEY_SWITCH,
                                            .help = "whether it may enter ground that takes longer than other ground",
                                            .example = "false",
                                            .standard = "true",
                                            KEY_FIELD(input_class, rough)},
                                           {.name = NULL}};

const key_set mission_class_keys = {"A class of robots", class_records, NULL, NULL};

/* ---- the mission ---- */

static const key_record mission_records[] = {
    {.name = "map",
     .kind = KEY_FILE,
     .help = "a drawing, a Moving AI map, or a ROS map_server YAML",
     .example = "map.yaml",
     .needed = true,
     KEY_FIELD(input, map)},
    {.name = "cell_size",
     .kind = KEY_NUMBER,
     .help = "side of a planning cell; on ROS maps a cell that any obstacle touches is blocked, on others it says how "
             "large the map's cells are",
     .example = "0.2",
     .standard = "the map's resolution; without one, no metres",
     .unit = "m",
     .noun = "a length",
     .most = HUGE_VAL,
     .least_out = true,
     KEY_FIELD(input, ground.cell_size),
     KEY_GIVEN(input, ground.size_given)},
    {.name = "robot_radius",
     .kind = KEY_NUMBER,
     .help = "obstacles grow by it, so that a robot's middle may be anywhere in a free cell",
     .example = "0.2",
     .standard = "0",
     .where = MISSION_ROS_MAPS,
     .unit = "m",
     .noun = "a length",
     .most = HUGE_VAL,
     KEY_FIELD(input, ground.robot_radius),
     KEY_GIVEN(input, ground.radius_given)},
    {.name = "unknown",
     .kind = KEY_WORD,
     .help = "what unknown ground is: an obstacle, or free",
     .example = "blocked",
     .standard = "blocked, but for what the map's thresholds make free",
     .where = MISSION_ROS_MAPS,
     .words = words_unknown,
     KEY_FIELD(input, ground.unknown),
     KEY_GIVEN(input, ground.unknown_given)},
    {.name = "grey_cost",
     .kind = KEY_INTEGER,
     .help =
         "what entering the darkest grey takes that is no obstacle, in times of free ground; lighter ones take less, "
         "in proportion, and the worst pixel of a cell counts",
     .example = "5",
     .standard = "greys are obstacles",
     .where = MISSION_ROS_MAPS " of `mode: scale`",
     .least = 1.0,
     .most = 255.0,
     KEY_FIELD(input, ground.grey_cost)},
    {.name = "terrain",
     .kind = KEY_FILE,
     .help =
         "what entering a cell takes in steps, 1 to 255, and 0 where no robot may go: a PGM or PNG whose grey, of 255, "
         "says so, or an ESRI ASCII grid; the worst of what lies over a cell counts",
     .example = "terrain.pgm",
     .standard = "as the map says",
     KEY_FIELD(input, terrain)},
    {.name = "keepout",
     .kind = KEY_FILE,
     .help = "where no robot may go: the dark half of an image that covers the map (PGM, PNG), or numbers but 0 of an "
             "ESRI ASCII grid; a cell that any of it cuts is blocked",
     .example = "keepout.pgm",
     .standard = "nowhere",
     KEY_FIELD(input, keepout)},
    {.name = "no_go",
     .kind = KEY_POLYGONS,
     .help = "likewise, polygons, each a list of its corners in their order around it, or the Polygons of a GeoJSON "
             "file; a "
             "cell that one cuts is blocked",
     .example = "[[{x: 0.5, y: 0.5}, {x: 1.5, y: 0.5}, {x: 1, y: 1.2}]]",
     .standard = "nowhere",
     .items = &mission_corner_keys},
    {.name = "robots",
     .kind = KEY_LIST,
     .help = "where the robots start, an item each (or one, and --robots K for K of them)",
     .example = "[{x: 0.5, y: 1.5}]",
     .standard = "a drawing's S",
     .items = &mission_robot_keys},
    {.name = "places",
     .kind = KEY_LIST,
     .help = "where the target may be, an item each",
     .example = "[{x: 0.5, y: 1.5, weight: 2}]",
     .standard = "a drawing's digits",
     .items = &mission_place_keys},
    {.name = "places_csv",
     .kind = KEY_FILE,
     .help = "more places, from a CSV whose header names keys of a place, in any order",
     .example = "places.csv",
     KEY_FIELD(input, csv)},
    {.name = "places_raster",
     .kind = KEY_MAPPING,
     .help = "more places, out of a raster of likelihoods: those that a sensor must see to cover a share of them",
     .example = "{file: likelihood.pgm, footprint: 5, share: 0.8}",
     .items = &mission_raster_keys},
    {.name = "places_geojson",
     .kind = KEY_MAPPING,
     .help = "more places, out of the points and polygons of a GeoJSON",
     .example = "{file: places.geojson, footprint: 5}",
     .items = &mission_geojson_keys},
    {.name = "cleared",
     .kind = KEY_LIST,
     .help =
         "places that were searched before, by name or else by number: nobody goes there again, and likelihoods are "
         "those of the rest",
     .example = "[0]",
     .standard = "none"},
    {.name = "objective",
     .kind = KEY_WORD,
     .help = "what is best: the likeliest places soonest, by gamma a second, the least expected time of the find, or "
             "the greatest probability of a find by the deadline",
     .example = "time",
     .standard = "discounted",
     .words = qtr_objective_names,
     KEY_FIELD(input, mission.aim.kind),
     KEY_GIVEN(input, objective_given)},
    {.name = "gamma",
     .kind = KEY_NUMBER,
     .help = "what a find a second later still counts for",
     .example = "0.99",
     .standard = "0.99",
     .noun = "a discount",
     .most = 1.0,
     .least_out = true,
     .most_out = true,
     KEY_FIELD(input, mission.aim.gamma),
     KEY_GIVEN(input, gamma_given)},
    {.name = "rule",
     .kind = KEY_WORD,
     .help = "whether a robot may stand down when the others do better without it, or must choose as in the paper",
     .example = "free",
     .standard = "free",
     .words = words_rule,
     KEY_FIELD(input, mission.rule),
     KEY_GIVEN(input, rule_given)},
    {.name = "deadline_seconds",
     SECONDS,
     .least_out = true,
     .help = "by when a find counts; under `objective: deadline` alone",
     .example = "600",
     KEY_FIELD(input, terms.deadline_seconds),
     KEY_GIVEN(input, terms.stated)},
    {.name = "home_weight",
     .kind = KEY_NUMBER,
     .help = "what each robot's arrival at its start counts beside the places, in their unit; under `objective: time` "
             "alone",
     .example = "1",
     .standard = "0",
     .noun = "a weight",
     .most = HUGE_VAL,
     KEY_FIELD(input, mission.aim.home_weight)},
    {.name = "speed",
     SPEED,
     .standard = "a cell a second",
     KEY_FIELD(input, terms.speed),
     KEY_GIVEN(input, terms.stated)},
    {.name = "step_seconds",
     .kind = KEY_NUMBER,
     .help = "what a step of the plan takes: all times are whole steps",
     .example = "0.5",
     .standard = "the longest that rounds no travel time by more than 1 %",
     .unit = "s",
     .noun = "seconds",
     .least = 1e-3,
     .most = 3600.0,
     KEY_FIELD(input, terms.step_seconds),
     KEY_GIVEN(input, terms.stated)},
    {.name = "scan_seconds",
     SECONDS,
     .help = "what a look at a place takes, where neither the place nor the class says",
     .example = "30",
     .standard = "0",
     KEY_FIELD(input, terms.scan_seconds),
     KEY_GIVEN(input, terms.stated)},
    {.name = "detection", DETECTION, .standard = "1", KEY_FIELD(input, terms.detection)},
    {.name = "looks", LOOKS, .standard = "1", KEY_FIELD(input, terms.looks)},
    {.name = "classes",
     .kind = KEY_NAMED,
     .help = "classes of robots, each by its name with what it differs in",
     .example = "{drone: {speed: 5, endurance_seconds: 900}}",
     .items = &mission_class_keys},
    {.name = "name",
     .kind = KEY_TEXT,
     .help = "for reports and pictures",
     .example = "Old quarry",
     KEY_FIELD(input, names.mission)},
    {.name = "geo",
     .kind = KEY_MAPPING,
     .help = "where on the globe the map lies",
     .example = "{latitude: 52.5163, longitude: 13.3777}",
     .where = METRIC_MAPS,
     .items = &mission_geo_keys},
    {.name = NULL}};

const key_set mission_keys = {"The mission", mission_records, NULL, NULL};

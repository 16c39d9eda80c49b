/* What an input says, as its readers fill it in: a mission, where its map lies, and where each start and place is
 * stated. Where the sources leave a choice open, read.h says what is made of it. */
#ifndef QUARTER_HOST_INPUT_H
#define QUARTER_HOST_INPUT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "host/base/fault.h"
#include "host/base/naming.h"
#include "host/base/notes.h"
#include "quarter/mission.h"
#include "quarter/names.h"

#define INPUT_PATH_SIZE 4096
#define INPUT_WORDS 16 /* of each kind that a caller may add */

/* The map frame in which the planning grid lies. Row 0 is the top row; without a turn y points up. */
typedef struct {
  bool metric;      /* false: the map has no metres, cell_size is 1 and the origin 0 */
  double cell_size; /* metres a cell */
  double origin_x;  /* metres: lower-left corner of the bottom-left cell, about which the grid is turned */
  double origin_y;
  double yaw; /* radians, counter-clockwise; 0: not turned */
} input_frame;

/* How the planner wants a map that has metres. */
typedef struct {
  double cell_size;    /* metres; 0: the map's resolution */
  double robot_radius; /* metres by which obstacles are inflated */
  uint8_t unknown;     /* enum input_unknown, where unknown_given */
  uint8_t grey_cost;   /* steps that entering the darkest grey short of an obstacle takes; 0: greys are obstacles */
  bool has_greys;      /* the map is of a kind that has such greys */
  bool size_given, radius_given, unknown_given;
} input_ground;

enum input_unknown { INPUT_UNKNOWN_BLOCKED, INPUT_UNKNOWN_FREE };

/* A position as the user states it: x and y in metres in the map frame, or column and row. */
typedef struct {
  bool metres;
  double x, y;
} input_position;

/* A robot or a place, as it is stated. */
typedef struct {
  input_position position;
  char name[QTR_SITE_NAME_BYTES]; /* empty: none */
  /* places */
  double weight;
  double scan_seconds; /* where scan_given */
  bool scan_given;
  double detection; /* 0: as the mission says */
  uint8_t looks;    /* likewise */
  /* robots */
  char class_name[QTR_SITE_NAME_BYTES]; /* empty: none */
  double ready_seconds;
  bool ready_given;
} input_site;

#define INPUT_UNSAID (-1.0) /* of seconds */

/* What is stated of a class of robots in seconds and metres; the rest is in the mission's class of the same number. */
typedef struct {
  char name[QTR_SITE_NAME_BYTES]; /* empty: robots that name no class */
  int line;
  double speed;             /* m/s; 0: the mission's */
  double scan_seconds;      /* INPUT_UNSAID: the mission's */
  double endurance_seconds; /* INPUT_UNSAID: no end */
  bool rough;               /* may enter ground of a cost above 1 */
  bool stated;              /* any of the above in seconds */
} input_class;

/* What is stated of the field's terms in seconds and metres, of which steps are made when all is read
 * (host/plan/terms.h). */
typedef struct {
  bool stated;         /* any of it */
  double speed;        /* m/s; 0: a cell a second */
  double step_seconds; /* 0: whichever suits the speeds */
  double scan_seconds;
  double deadline_seconds; /* 0: none */
  double detection;        /* of places that say nothing of it; 0: 1 */
  uint8_t looks;           /* likewise */
  input_class of_class[QTR_MAX_CLASSES];
  double place_scan[QTR_MAX_PLACES]; /* seconds; INPUT_UNSAID: as the class, or the mission, says */
  double ready[QTR_MAX_SEEKERS];     /* seconds */
} input_terms;

/* The file in which a start or place is stated. */
enum input_source { INPUT_FROM_MISSION, INPUT_FROM_MAP, INPUT_FROM_CSV, INPUT_FROM_GEOJSON, INPUT_FROM_OPTION };

typedef struct {
  uint8_t source; /* enum input_source */
  int line;       /* from 1 */
  int column;     /* from 1, in bytes; 0: the line says enough */
} input_origin;

typedef struct {
  qtr_mission mission;
  input_frame frame;             /* as positions are stated; mission.frame is the same one as a table holds it */
  double across, upward;         /* cells that the map spans, where its edge cuts the last of them; 0: all of them */
  double resolution;             /* metres a pixel of the map's image; 0: it has none */
  qtr_geo geo;                   /* where the frame lies on the globe */
  char path[INPUT_PATH_SIZE];    /* the input itself */
  char map[INPUT_PATH_SIZE];     /* the map: the input again, or what the mission names */
  char csv[INPUT_PATH_SIZE];     /* the mission's places_csv; empty: none */
  char geojson[INPUT_PATH_SIZE]; /* of its places_geojson; likewise, as are those below */
  char terrain[INPUT_PATH_SIZE], keepout[INPUT_PATH_SIZE];
  qtr_names names;                               /* of the mission, its places and robots */
  bool objective_given, gamma_given, rule_given; /* stated in the mission file */
  input_ground ground;
  input_terms terms;
  input_origin start_origin[QTR_MAX_SEEKERS];
  input_origin place_origin[QTR_MAX_PLACES];
  input_position start_position[QTR_MAX_SEEKERS]; /* as stated: they may have been moved since */
  input_position place_position[QTR_MAX_PLACES];
  uint16_t place_number[QTR_MAX_PLACES]; /* in the input, where places may have been left out; ascending */
  uint16_t places_stated;                /* in the input, the ones left out included */
  fault *all;                            /* where faults are gathered; NULL: the first one ends the reading */
  bool failed;                           /* and there was one */
  bool tiled;                            /* tiles have become places that go by column and row alone */
  qtr_places cleared;                    /* by their numbers: searched before the start */
  notes note;
  int map_notes; /* as many of them, the first, are about the map as ground to drive on */
} input;

typedef struct {
  double cell_size; /* metres, overrides the mission's; 0: as the mission says, or else the map's resolution */
  int robots;       /* overrides; 0: as many as the input has starts */
  double snap;      /* metres, cells on a map without: as far may a start or place be moved to a free cell */
  bool skip;        /* leave out places that are on no free cell */
  fault *all;       /* gather all faults here, a line each, in place of the first alone; NULL: do not */
  /* words of the caller's, which choose.h makes sense of */
  int clears, withouts, adds;
  const char *clear[INPUT_WORDS];   /* lists of places that are cleared */
  const char *without[INPUT_WORDS]; /* places and robots to leave out */
  const char *add[INPUT_WORDS];     /* "x,y,weight,name" of places to add */
} input_options;

/* The path of the file in which a start or place is stated. */
const char *input_source_path(const input *in, input_origin origin);

/* Whether to go on reading after a step that gave `status`: it went well, or faults are gathered. */
bool input_goes_on(input *in, int status, fault *why);

/* What places and robots are called. */
naming input_naming(const input *in);

/* Let place `from` stand in the place of `to`, number, name and all: where places are left out. */
void input_keep_place(input *in, int to, int from);

/* The same for robots. */
void input_keep_robot(input *in, int to, int from);

/* "place 3 (mission.yaml:17)" and "seeker 0 (area.txt:4:7)", for messages about a place or a seeker's start, by name
 * where it has one; the number is the input's. */
void input_place_name(const input *in, int place, char *out, size_t size);
void input_seeker_name(const input *in, int seeker, char *out, size_t size);

#endif

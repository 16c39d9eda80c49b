/* The command line of `quarter`. */
#ifndef QUARTER_TOOLS_OPTIONS_H
#define QUARTER_TOOLS_OPTIONS_H

#include <stdbool.h>
#include <stdint.h>

#include "host/base/fault.h"
#include "quarter/config.h"
#include "quarter/explore.h"
#include "quarter/places.h"

enum { OPTIONS_UNSET = -1 };

typedef struct {
  int seeker;
  uint32_t wait; /* steps that it starts later */
  double factor; /* 1: it is on time; 2: every move takes it twice as long */
} option_late;

typedef struct {
  int seeker;
  uint32_t step; /* from which on it does nothing more */
} option_lost;

typedef struct {
  const char *input;
  const char *output;    /* -o; NULL: none */
  const char *c_output;  /* --c; NULL: none */
  const char *curve;     /* CSV of the learning's progress; NULL: none */
  bool json;             /* print JSON instead of text */
  const char *json_path; /* write it here; NULL: standard output */
  bool quiet;
  bool help;
  /* the mission, where it is not to be as the input says */
  int robots;       /* 0: as the input says */
  int objective;    /* enum qtr_objective or OPTIONS_UNSET */
  int rule;         /* enum qtr_rule or OPTIONS_UNSET */
  double gamma;     /* 0: as the input says */
  double cell_size; /* metres; 0: as the input says */
  bool skip_unreachable;
  double snap; /* metres, or cells on a map without; 0: nothing is moved */
  /* learning */
  int setting; /* enum qtr_setting */
  qtr_exploration_plan exploration;
  double alpha;
  bool by_regions, by_spots;                      /* aggregation */
  int region_size, region_diameter, region_times; /* enum qtr_region_times */
  int spot_size, spot_diameter, spot_order;       /* enum qtr_spot_order */
  double spot_likelihood, region_likelihood;
  bool any_starts, any_cleared;
  double table_limit;      /* megabytes */
  uint64_t budget_entries; /* 0: none */
  double gap;
  double time_limit; /* seconds; 0: none */
  uint64_t episodes; /* 0: no limit */
  uint64_t seed;
  /* simulation */
  int lates, losts;
  option_late late[QTR_MAX_SEEKERS];
  option_lost lost[QTR_MAX_SEEKERS];
  int froms; /* seekers put elsewhere than the table says; 0: none */
  struct {
    int column, row;
  } from[QTR_MAX_SEEKERS];
  qtr_places clear; /* places cleared beforehand */
  int target;       /* place, or OPTIONS_UNSET */
  bool clear_all;
  /* drawing */
  bool regions, spots;
  /* belief */
  const char *history; /* CSV; NULL: none */
  const char *belief;  /* saved belief, read and written; NULL: none */
  double prior;        /* finds that the mission's weights count for; 0: not given */
  double keep;         /* 0: not given */
  double detection;
} options;

/* Which options a command takes; the name of each begins its line in the command's help. */
typedef struct {
  const char *name;    /* of the command */
  const char *allowed; /* its long options, each between blanks: " json quiet " */
} option_set;

/* Parse the words after the command. 0, or -1 with *fault set. */
int options_parse(options *o, const option_set *set, int argc, char **argv, fault *why);

#endif

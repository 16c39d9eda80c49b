/* The command line of `quarter`. */
#ifndef QUARTER_TOOLS_OPTIONS_H
#define QUARTER_TOOLS_OPTIONS_H

#include <stdbool.h>
#include <stdint.h>

#include "host/base/fault.h"
#include "host/base/option.h"
#include "host/plan/plan_config.h"
#include "host/plan/simulation.h"

typedef struct {
  const char *input;
  const char *second;    /* of a command that takes two */
  const char *output;    /* -o; NULL: none */
  const char *c_output;  /* --c; NULL: none */
  const char *profile;   /* "mcu", or a robot's config header; NULL: none */
  const char *against;   /* a table to compare the plan with; NULL: none is named */
  const char *curve;     /* CSV of the learning's progress; NULL: none */
  bool json;             /* print JSON instead of text */
  const char *json_path; /* write it here; NULL: standard output */
  bool quiet;
  bool help;
  plan_config plan;
  double time_limit;       /* seconds; 0: none */
  uint64_t episodes;       /* 0: no limit */
  uint64_t budget_entries; /* 0: none */
  simulation_config game;  /* who and where are words yet, below, until there is a table */
  char late[QTR_MAX_SEEKERS][QTR_SITE_NAME_BYTES], lost[QTR_MAX_SEEKERS][QTR_SITE_NAME_BYTES]; /* of game's, in order */
  double late_seconds[QTR_MAX_SEEKERS], lost_seconds[QTR_MAX_SEEKERS]; /* likewise, where they are given; else 0 */
  const char *target;                                                  /* NULL: none */
  /* drawing */
  bool regions, spots, dark, grid;
  /* a mission begun */
  const char *picture; /* NULL: beside the output */
  const char *open;    /* "WxH" of open ground; NULL: there is a map */
  double resolution;   /* of an image: metres a pixel; 0: not given */
  bool force;
  /* writing for others */
  const char *format; /* NULL: as the output's name ends */
  const char *robot;  /* name or number; NULL: all */
  bool places;        /* no waypoints but these */
  double altitude;    /* metres above home; 0: on the ground */
  double hold;        /* seconds at a place; below 0: as the mission says */
  /* belief */
  const char *history; /* CSV; NULL: none */
  const char *belief;  /* saved belief, read and written; NULL: none */
  double prior;        /* finds that the mission's weights count for; 0: not given */
  double keep;         /* 0: not given */
  double detection;    /* HISTORY_OF_PLACES: each place's own */
} options;

/* Every option of every command, each told of once: how it is spelt, what it takes, where that goes, what help says of
 * it. */
extern option_table option_records;

/* What a problem is made of an input by. */
#define OPTION_LINES_OF_PROBLEM                                                                                        \
  OPTION_LINE("robots"), OPTION_LINE("objective"), OPTION_LINE("deadline"), OPTION_LINE("gamma"), OPTION_LINE("rule"), \
      OPTION_LINE("cell-size"), OPTION_LINE("skip-unreachable"), OPTION_LINE("snap"), OPTION_LINE("clear"),            \
      OPTION_LINE("without"), OPTION_LINE("add")

/* How the list of a command ends that learns and reports, and that of one that answers without progress; and what their
 * help says of an early end: of a signal `what` is left, and `first` is what a command that learns may not have come
 * to. */
#define OPTION_LINES_OF_REPORT OPTION_LINE("json"), OPTION_LINE("quiet"), {NULL, NULL, 0}
#define OPTION_LINES_OF_ANSWER OPTION_LINE("json"), {"quiet", "no report but JSON", 0}, {NULL, NULL, 0}
#define STATUS_OF_SIGNAL(what) "130 (143) ended by Ctrl-C (SIGTERM), " what ".\n"
#define STATUS_OF_EARLY_END(first, what)                                                                               \
  "3 ended by the limit or a signal before " first "plan, nothing written; " STATUS_OF_SIGNAL(what)
#define STATUS_OF_UNFIT(what) "5 --profile's arrays are too small for the table, " what ".\n"

/* What is asked for where nothing is said. */
void options_default(options *o);

/* Parse the words after the command. 0, or -1 with *why set. */
int options_parse(options *o, const option_set *set, int argc, char **argv, fault *why);

/* The same of a command that takes two inputs. */
int options_parse_two(options *o, const option_set *set, int argc, char **argv, fault *why);

/* The same of a command that can do without an input: `input` is NULL then. */
int options_parse_any(options *o, const option_set *set, int argc, char **argv, fault *why);

/* The same for a command that reads no input. */
int options_parse_alone(options *o, const option_set *set, int argc, char **argv, fault *why);

#endif

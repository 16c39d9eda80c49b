/* The command line of quarter-demo and quarter-world. */
#ifndef QUARTER_DEMO_SETTINGS_H
#define QUARTER_DEMO_SETTINGS_H

#include <stdbool.h>
#include <stdint.h>

#include "host/base/fault.h"
#include "host/base/option.h"

enum { SETTINGS_ANY_MINE = -1, SETTINGS_NO_MINE = -2 };

typedef struct {
  const char *mission;
  const char *table;     /* NULL: learn it */
  const char *save;      /* where to write the table; NULL: nowhere */
  const char *replay;    /* HTML; NULL: none */
  const char *log;       /* LCM log; NULL: none */
  const char *faults;    /* script; NULL: none */
  const char *key;       /* of the seal on signals; NULL: none */
  const char *lcm_url;   /* NULL: as LCM_DEFAULT_URL says */
  const char *json_path; /* NULL: standard output */
  bool json, quiet, help, version;
  bool clear_all, lose_one, processes, live, follow, no_ghost;
  int port;     /* of the live view; 0: any free one */
  int robots;   /* 0: as the mission says */
  int mine;     /* place; or SETTINGS_ANY_MINE, drawn; or SETTINGS_NO_MINE */
  int runs;     /* 0: one game */
  int run;      /* number of the search, in all signals */
  int strategy; /* enum game_strategy */
  uint64_t seed;
  double speed;       /* times real time; 0: as fast as can be */
  double learn_limit; /* seconds */
} settings;

/* Of quarter-demo, which takes all there are. */
extern const option_set settings_options;

/* Whether a replay is to show the same game without a plan beside it: not where the game itself has none. */
bool settings_want_ghost(const settings *s);

/* Parse the words. `help` and `version` are printed by the caller if asked for. 0, or -1 with *why set. */
int settings_parse(settings *s, int argc, char **argv, fault *why);

#endif

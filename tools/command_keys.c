#include <stdlib.h>

#include "commands.h"
#include "host/input/mission_keys.h"
#include "host/input/reference.h"
#include "host/input/schema.h"
#include "options.h"
#include "print.h"

static const char intro[] =
    "quarter keys             every key of a mission: unit, range, default, example (docs/mission.md)\n"
    "quarter keys --json      the JSON Schema that an editor completes and checks missions by\n"
    "\n";

static const option_line lines[] = {
    {"json", "print the schema, or write it to FILE", 0},
    {NULL, NULL, 0},
};

static const char outro[] = "\n"
                            "An editor that knows YAML schemas takes the file by a first line in the mission:\n"
                            "# yaml-language-server: $schema=mission.schema.json\n"
                            "\n"
                            "Exit status: 0 done; 2 bad words.\n";

static const option_set set = {"keys", intro, outro, option_records, lines};

static void write_json(FILE *out, const void *what) {
  schema_write(out, what);
}

static const char steps_and_seconds[] =
    "\n## Steps and seconds\n"
    "A plan is made in steps of a fixed length. Where all robots have one speed, a step is the time that they take for "
    "a\n"
    "cell; where they differ, the longest that rounds nobody's time for a cell by more than 1 %; `step_seconds` sets "
    "it "
    "by\nhand. Scan and ready times are rounded up, endurance and deadlines down, so that no plan counts on time that\n"
    "there is not. Reports say what a step is and what it rounds. Ground of cost c takes c times as long as plain\n"
    "ground. A look counts when its scan ends; where the first finds with probability q, the second finds with\n"
    "q (1 - q). Where nothing is said of seconds a step is a cell.\n";

static void write_text(FILE *out, const void *what) {
  fputs("# A mission, key by key\n"
        "A mission is a YAML file that names a map, the robots and the places where the target may be:\n"
        "`quarter learn mission.yaml`. These are all keys that it may have; any other is refused, and so is a value "
        "outside of its\n"
        "range. A file that it names is looked for beside it. `quarter keys` prints this page, `quarter keys --json` "
        "the\n"
        "[schema](mission.schema.json) for editors; the reader, its messages and both of them are made of one list.\n",
        out);
  reference_write(out, what);
  fputs(
      "\n## A CSV of places\n"
      "The file of `places_csv` has a header that names keys of a place, in any order and case, then a place a line: "
      "`x,y,weight,name`.\n"
      "Columns of other names stay where they are; a note says which. Fields that hold separators, quotes or line "
      "breaks are quoted (RFC\n"
      "4180). Where the header has `;` between its columns, numbers may have commas: `0,5`. Blank lines and lines that "
      "begin with `#` are\n"
      "passed over. Empty fields of `name`, `scan_seconds`, `detection` and `looks` leave a place what the mission "
      "says.\n"
      "\n## Rasters\n"
      "A raster is a PGM, a PNG or an ESRI ASCII grid. An image covers the map exactly, whatever its resolution. A "
      "grid "
      "says where it\n"
      "lies: `xllcorner`, `yllcorner` and `cellsize` are metres in the map frame (cells from the lower left corner, on "
      "a "
      "map without\n"
      "metres), and where it does not reach, or has its `NODATA_value`, it says nothing.\n"
      "\n"
      "Of `places_raster` black is no likelihood, white the most. The ground is cut into tiles of `footprint` a side, "
      "from the map's\n"
      "lower left corner on. A tile that any class of robots can get into is a place at the free cell nearest to the "
      "middle of its "
      "likelihood, which\n"
      "is the place's weight, in the raster's unit. The likeliest tiles are taken, and come behind the places of "
      "`places` and\n"
      "`places_csv`, the likeliest first.\n",
      out);
  fputs(steps_and_seconds, out);
}

int command_keys(int argc, char **argv) {
  static options o;
  fault why;
  if (options_parse_alone(&o, &set, argc, argv, &why) != 0) return fault_exit(&why);
  if (o.help) return option_help(stdout, &set);
  return print_report(&o, write_json, write_text, &mission_keys, &why) == 0 ? EXIT_SUCCESS : fault_exit(&why);
}

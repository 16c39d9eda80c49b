#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "commands.h"
#include "history.h"
#include "host/base/count.h"
#include "host/base/file.h"
#include "host/base/json.h"
#include "host/base/outfile.h"
#include "host/base/separated.h"
#include "host/base/stop.h"
#include "host/input/frame.h"
#include "host/input/read.h"
#include "options.h"
#include "products.h"
#include "quarter/status.h"

static const char intro[] =
    "quarter belief mission.yaml --history games.csv -o places.csv      the places' weights, learnt from past games\n"
    "quarter belief mission.yaml --history new.csv --belief b.qtb       the same, kept from one time to the next\n"
    "quarter belief mission.yaml --belief b.qtb                         what a saved belief estimates\n"
    "\n"
    "games.csv has a header and a row for each place where a target was found: 'place' (its name or number, as this\n"
    "command lists them), 'column,row' or 'x,y'. A column 'found' with 0 tells of a place that was searched in vain, "
    "a\n"
    "column 'looks' how often, a column 'game' which rows are one game; without it every row is one. A look that "
    "found\n"
    "nothing leaves 1 - q of a place's likelihood, where q is the place's 'detection' in the mission.\n"
    "\n";

static const option_line lines[] = {
    OPTION_LINE("history"),
    OPTION_LINE("belief"),
    OPTION_LINE("prior"),
    OPTION_LINE("keep"),
    OPTION_LINE("detection"),
    {"output", "write the places as CSV, for a mission's places_csv; '-' is standard output", 0},
    {"json", "print the estimate as JSON, or write it to FILE", 0},
    {"cell-size, snap", "as in 'quarter learn'", 39},
    {"skip-unreachable", "leave out places that are on no free cell; the others keep their numbers", 0},
    {"quiet", "say nothing", 0},
    {NULL, NULL, 0},
};

static const char outro[] =
    "\n"
    "Exit status: 0 done; 2 bad input, nothing written; " STATUS_OF_SIGNAL("nothing half-written");

static const option_set set = {"belief", intro, outro, option_records, lines};

/* All that is read and worked out. */
typedef struct {
  const options *o;
  input in;
  qtr_belief belief;
  history_tally tally;
  double strength;               /* of the prior, in finds */
  bool resumed;                  /* from a saved belief */
  double before[QTR_MAX_PLACES]; /* the estimate before the history */
  double after[QTR_MAX_PLACES];
} estimation;

static estimation estimated;

/* ---- the belief, new or saved ---- */

/* A mark of the mission's places, so that a belief is not taken for another mission's (FNV-1a). */
static uint32_t mark_of(const qtr_mission *mission) {
  uint32_t mark = 2166136261u;
  const uint32_t head[3] = {mission->columns, mission->rows, mission->places};
  for (unsigned i = 0; i < 3u + mission->places; i++) {
    const uint32_t word = i < 3 ? head[i] : (uint32_t)mission->place[i - 3];
    for (unsigned byte = 0; byte < 4; byte++) mark = (mark ^ (word >> 8 * byte & 0xFFu)) * 16777619u;
  }
  return mark;
}

static int begin(estimation *s, fault *why) {
  const qtr_mission *mission = &s->in.mission;
  const double strength = s->o->prior > 0.0 ? s->o->prior : 0.5 * mission->places;
  const double keep = s->o->keep > 0.0 ? s->o->keep : 1.0;
  s->strength = strength;
  const int status = qtr_belief_init(&s->belief, mission->places, mission->weight, strength, keep);
  s->belief.about = mark_of(mission);
  if (status == QTR_OK) return 0;
  return fault_set(why, "%s: its weights cannot be a prior: %s; bring them closer together", s->o->input,
                   qtr_strerror(status));
}

static const char *fault_of(int status) {
  switch (status) {
  case QTR_ERR_TRUNCATED: return "is cut short; copy it again, or begin anew under another name";
  case QTR_ERR_MAGIC: return "is not a saved belief; name another file";
  case QTR_ERR_FORMAT: return "is a saved belief of another format version; use the Quarter that wrote it";
  case QTR_ERR_CHECKSUM: return "is damaged: its checksum does not match; copy it again, or begin anew";
  case QTR_ERR_LIMIT: return "has more places than this build holds; build with a larger QTR_MAX_PLACES";
  default: return "is not sound: a number in it is out of its range; begin anew under another name";
  }
}

static int load(estimation *s, fault *why) {
  const char *path = s->o->belief;
  file_bytes bytes;
  if (file_read(&bytes, path, FILE_TEXT_LIMIT, NULL, why) != 0) return -1;
  const int status = qtr_belief_load(&s->belief, bytes.data, (uint32_t)bytes.size);
  file_free(&bytes);
  if (s->o->history != NULL) file_forget(path); /* the new one takes its place */
  if (status != QTR_OK) return file_fault(why, path, 0, 0, "%s", fault_of(status));
  if (s->belief.about != mark_of(&s->in.mission) || s->belief.places != s->in.mission.places)
    return file_fault(why, path, 0, 0,
                      "is the belief about another mission's places (it has %d, %s %d); name the mission that it was "
                      "saved with, or another file",
                      s->belief.places, file_short_path(s->o->input), s->in.mission.places);
  if (s->o->prior > 0.0)
    return file_fault(why, path, 0, 0, "has its prior already; leave --prior out, or begin anew under another name");
  if (s->o->keep > 0.0) s->belief.keep = s->o->keep;
  for (unsigned p = 0; p < s->belief.places; p++) s->strength += s->belief.prior[p];
  s->resumed = true;
  return 0;
}

/* The belief to go on from: the saved one, if there is any. */
static int take_up(estimation *s, fault *why) {
  const options *o = s->o;
  struct stat about;
  if (o->belief != NULL && stat(o->belief, &about) == 0) return load(s, why);
  if (o->history != NULL) return begin(s, why);
  if (o->belief == NULL) return fault_set(why, "belief: name the games to learn from with --history FILE");
  return file_fault(why, o->belief, 0, 0, "no such belief yet; name the games to begin it with by --history FILE");
}

static int learn(estimation *s, fault *why) {
  if (input_read(&s->in, s->o->input, &s->o->plan.reading, why) != 0) return -1;
  notes_print(&s->in.note, s->in.map_notes);
  if (take_up(s, why) != 0) return -1;
  qtr_belief_estimate(&s->belief, s->before);
  if (s->o->history != NULL && history_read(&s->tally, &s->belief, &s->in, s->o->history, s->o->detection, why) != 0)
    return -1;
  qtr_belief_estimate(&s->belief, s->after);
  return 0;
}

/* ---- writing ---- */

/* How often a look at a place sees what is there. */
static double detection_of(const estimation *s, unsigned place) {
  return s->o->detection == HISTORY_OF_PLACES ? s->in.mission.detection[place] : s->o->detection;
}

/* Of all places, or NAN where they differ. */
static double common_detection(const estimation *s) {
  for (unsigned place = 1; place < s->belief.places; place++)
    if (detection_of(s, place) != detection_of(s, 0)) return NAN;
  return detection_of(s, 0);
}

static unsigned column_of(const estimation *s, unsigned place) {
  return (unsigned)(s->in.mission.place[place] % s->in.mission.columns);
}

static unsigned row_of(const estimation *s, unsigned place) {
  return (unsigned)(s->in.mission.place[place] / s->in.mission.columns);
}

/* Which places say themselves what the mission says else: a column each. */
typedef struct {
  bool names, scans, detections, looks;
} own_columns;

static own_columns find_columns(const estimation *s) {
  const input_terms *terms = &s->in.terms;
  const qtr_mission *mission = &s->in.mission;
  const naming n = input_naming(&s->in);
  own_columns own = {.names = naming_has_places(&n)};
  for (unsigned p = 0; p < s->belief.places; p++) {
    own.scans = own.scans || terms->place_scan[p] != INPUT_UNSAID;
    own.detections = own.detections || mission->detection[p] != (terms->detection > 0.0 ? terms->detection : 1.0);
    own.looks = own.looks || mission->looks[p] != (terms->looks > 0 ? terms->looks : 1);
  }
  return own;
}

static void write_own(FILE *out, const estimation *s, const own_columns *own, unsigned place) {
  const double scan = s->in.terms.place_scan[place];
  if (own->names) fputc(',', out), separated_put(out, s->in.names.place[place]);
  if (own->scans) fputc(',', out);
  if (own->scans && scan != INPUT_UNSAID) fprintf(out, "%.12g", scan);
  if (own->detections) fprintf(out, ",%.12g", s->in.mission.detection[place]);
  if (own->looks) fprintf(out, ",%u", (unsigned)s->in.mission.looks[place]);
  fputc('\n', out);
}

static void write_csv(FILE *out, const estimation *s) {
  const own_columns own = find_columns(s);
  fprintf(out, "%s,weight%s%s%s%s\n", s->in.frame.metric ? "x,y" : "column,row", own.names ? ",name" : "",
          own.scans ? ",scan_seconds" : "", own.detections ? ",detection" : "", own.looks ? ",looks" : "");
  for (unsigned place = 0; place < s->belief.places; place++) {
    if (s->in.frame.metric) {
      const input_position centre = frame_centre(&s->in, s->in.mission.place[place], true);
      fprintf(out, "%.12g,%.12g,", centre.x, centre.y);
    } else {
      fprintf(out, "%u,%u,", column_of(s, place), row_of(s, place));
    }
    fprintf(out, "%.12g", s->after[place]);
    write_own(out, s, &own, place);
  }
}

static void write_place(json *j, const estimation *s, unsigned place) {
  const naming n = input_naming(&s->in);
  json_flat_object(j, NULL);
  json_integer(j, "number", s->in.place_number[place]);
  naming_json_place(&n, j, place);
  json_integer(j, "column", column_of(s, place));
  json_integer(j, "row", row_of(s, place));
  if (s->in.frame.metric) {
    const input_position centre = frame_centre(&s->in, s->in.mission.place[place], true);
    json_number(j, "x", centre.x);
    json_number(j, "y", centre.y);
  }
  json_natural(j, "found", s->tally.found[place]);
  json_natural(j, "looks_in_vain", s->tally.vain[place]);
  json_number(j, "detection", detection_of(s, place));
  json_number(j, "before", s->before[place]);
  json_number(j, "estimate", s->after[place]);
  json_end_object(j);
}

static void write_json(FILE *out, const estimation *s) {
  json j;
  json_begin(&j, out);
  json_object(&j, NULL);
  json_string(&j, "command", "belief");
  json_string(&j, "input", s->o->input);
  if (s->o->history != NULL) json_string(&j, "history", s->o->history);
  if (s->o->belief != NULL) json_string(&j, "belief", s->o->belief);
  json_integer(&j, "places", s->belief.places);
  json_natural(&j, "games", s->tally.games);
  json_natural(&j, "finds", s->tally.finds);
  json_natural(&j, "games_without_find", s->tally.without);
  json_natural(&j, "games_in_all", s->belief.games);
  json_bool(&j, "resumed", s->resumed);
  json_number(&j, "prior", s->strength);
  json_number(&j, "keep", s->belief.keep);
  json_number(&j, "detection", common_detection(s)); /* null where places differ: each says its own */
  json_array(&j, "place");
  for (unsigned place = 0; place < s->belief.places; place++) write_place(&j, s, place);
  json_end_array(&j);
  notes_json(&s->in.note, &j);
  json_end_object(&j);
}

static void write_place_line(FILE *out, const estimation *s, unsigned place) {
  const naming n = input_naming(&s->in);
  fprintf(out, "  place %s (column %u, row %u): ", naming_place(&n, place).text, column_of(s, place), row_of(s, place));
  if (s->o->history != NULL)
    fprintf(out, "%.4g -> %.4g, found %s", s->before[place], s->after[place],
            counted(s->tally.found[place], "time").text);
  else
    fprintf(out, "%.4g", s->after[place]);
  /* Where looks miss nothing there is nothing to tell of them. */
  if (s->tally.vain[place] > 0 && detection_of(s, place) < 1.0)
    fprintf(out, ", %s in vain", counted(s->tally.vain[place], "look").text);
  fputc('\n', out);
}

static void write_text(FILE *out, const estimation *s) {
  const history_tally *tally = &s->tally;
  fprintf(out, "%s: %s, whose prior counts for %s\n", s->o->input, counted(s->belief.places, "place").text,
          measured(s->strength, "find").text);
  if (s->o->history != NULL)
    fprintf(out, "%s: %s with %s, %" PRIu32 " without any\n", s->o->history, counted(tally->games, "game").text,
            counted(tally->finds, "find").text, tally->without);
  if (s->o->belief != NULL) fprintf(out, "%s: %s in all\n", s->o->belief, counted(s->belief.games, "game").text);
  for (unsigned place = 0; place < s->belief.places; place++) write_place_line(out, s, place);
  if (s->o->output != NULL) fprintf(out, "wrote %s\n", s->o->output);
}

static void write_belief(FILE *out, const estimation *s) {
  static uint8_t bytes[QTR_BELIEF_BYTES(QTR_MAX_PLACES)];
  const int size = qtr_belief_save(&s->belief, bytes, sizeof bytes);
  fwrite(bytes, 1, (size_t)size, out);
}

/* ---- all that is to be written, together ---- */

typedef struct {
  const char *path; /* NULL: not wanted */
  void (*write)(FILE *out, const estimation *s);
  outfile out;
} product;

enum { CSV, JSON, TEXT, BELIEF, PRODUCTS }; /* the belief last: once it is saved, its games must not be given again */

static void plan(product *products, const options *o) {
  const char *json_path = o->json_path != NULL ? o->json_path : "-";
  const bool taken = o->output != NULL && strcmp(o->output, "-") == 0;
  const bool prints_json = o->json && strcmp(json_path, "-") == 0;
  products[CSV] = (product){.path = o->output, .write = write_csv};
  products[JSON] = (product){.path = o->json ? json_path : NULL, .write = write_json};
  products[TEXT] = (product){.path = o->quiet || taken || prints_json ? NULL : "-", .write = write_text};
  products[BELIEF] = (product){.path = o->history != NULL ? o->belief : NULL, .write = write_belief};
}

/* Everything is begun before anything is written: what cannot be written stops all of it. */
static int write_all(const estimation *s, fault *why) {
  product products[PRODUCTS];
  int begun = 0, status = 0;
  plan(products, s->o);
  for (; begun < PRODUCTS && status == 0; begun++)
    if (products[begun].path != NULL) status = outfile_open(&products[begun].out, products[begun].path, why);
  if (status != 0) begun--;
  for (int i = 0; i < begun; i++) {
    if (products[i].path == NULL) continue;
    if (status != 0) {
      outfile_abort(&products[i].out);
      continue;
    }
    products[i].write(products[i].out.file, s);
    status = outfile_commit(&products[i].out, why);
  }
  return status;
}

/* ---- the command ---- */

int command_belief(int argc, char **argv) {
  static options o;
  fault why;
  if (options_parse(&o, &set, argc, argv, &why) != 0) return fault_exit(&why);
  if (o.help) return option_help(stdout, &set);
  stop_at_once();
  estimated.o = &o;
  if (o.belief != NULL && strcmp(o.belief, "-") == 0) {
    fault_set(&why, "--belief -: a saved belief is read and written; name a file");
    return fault_exit(&why);
  }
  if (learn(&estimated, &why) != 0 || products_check(&o, &why) != 0 || write_all(&estimated, &why) != 0)
    return fault_exit(&why);
  return EXIT_SUCCESS;
}

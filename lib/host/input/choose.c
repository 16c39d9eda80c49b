#include "host/input/choose.h"

#include <stdbool.h>
#include <stdio.h>
#include <string.h>

#include "host/base/file.h"
#include "host/input/mission_keys.h"
#include "host/input/sites.h"

#define LIST 400 /* bytes of names in a note */

/* ---- cleared ---- */

int choose_cleared(input *in, tree *yaml, tree_node *root) {
  tree_node *list = tree_find(yaml, root, "cleared");
  const naming n = input_naming(in);
  const int count = list != NULL ? tree_count(list) : 0;
  for (int i = 0; i < count; i++) {
    tree_node *item = tree_item(yaml, list, i);
    const char *word;
    char wrong[FAULT_LINE];
    if (tree_text(yaml, item, "cleared", &word) != 0) return -1;
    const int place = naming_find_place(&n, word, wrong);
    if (place < 0) return tree_fault(yaml, item, "cleared: %s", wrong);
    qtr_places_add(&in->cleared, (unsigned)place);
  }
  return 0;
}

static int take_clear(input *in, const input_options *options, fault *why) {
  const naming n = input_naming(in);
  char wrong[FAULT_LINE];
  for (int i = 0; i < options->clears; i++)
    if (naming_list_places(&in->cleared, &n, options->clear[i], wrong) != 0)
      return fault_set(why, "--clear: %s", wrong);
  return 0;
}

/* ---- added ---- */

/* The text up to the next comma, of which *at is moved behind; NULL: there is none. */
static const char *next_part(const char **at, char *part, size_t size) {
  if (*at == NULL) return NULL;
  const size_t length = strcspn(*at, ",");
  snprintf(part, size, "%.*s", (int)length, *at);
  *at = (*at)[length] == ',' ? *at + length + 1 : NULL;
  return part;
}

/* What follows the third comma is the name, commas and all. */
static int add_place(input *in, const char *text, int nth, fault *why) {
  static const char *const keys[] = {"x", "y", "weight"};
  const value_site site = {why, "--add", nth, 0};
  const char *at = text;
  char part[64];
  mission_site place = {.it.weight = 1.0};
  for (int i = 0; i < 3; i++) {
    const char *value = next_part(&at, part, sizeof part);
    if (value == NULL) return fault_set(why, "--add %s: say X,Y,WEIGHT or X,Y,WEIGHT,NAME", text);
    if (keys_take(&place, keys_find(&mission_place_keys, keys[i]), &site, value) != 0) return -1;
  }
  if (at != NULL && keys_take(&place, keys_find(&mission_place_keys, "name"), &site, at) != 0) return -1;
  const input_site stated = mission_site_of(&place, MISSION_METRES);
  return sites_add_place(in, &stated, (input_origin){INPUT_FROM_OPTION, nth, 0}, why);
}

int choose_added(input *in, const input_options *options, fault *why) {
  for (int i = 0; i < options->adds; i++)
    if (add_place(in, options->add[i], i + 1, why) != 0) return -1;
  return 0;
}

/* ---- left out ---- */

typedef struct {
  bool place[QTR_MAX_PLACES], robot[QTR_MAX_SEEKERS];
} absent;

/* What a word without "place:" or "robot:" before it names: the one of the two that has the name. */
static int leave_out_either(absent *left, const naming *n, const char *word, fault *why) {
  char as_place[FAULT_LINE], as_robot[FAULT_LINE];
  const int place = naming_find_place(n, word, as_place), robot = naming_find_seeker(n, word, as_robot);
  if (place >= 0 && robot >= 0)
    return fault_set(why, "--without %s: there is such a place and such a robot; say place:%s or robot:%s", word, word,
                     word);
  if (place < 0 && robot < 0)
    return fault_set(why, "--without: %s%s", strstr(as_robot, "did you mean") != NULL ? as_robot : as_place,
                     strchr(word, ',') != NULL ? "; for several give --without once for each" : "");
  *(place >= 0 ? &left->place[place] : &left->robot[robot]) = true;
  return 0;
}

static int leave_out(absent *left, const input *in, const char *word, fault *why) {
  const naming n = input_naming(in);
  char wrong[FAULT_LINE];
  const bool place = strncmp(word, "place:", 6) == 0;
  if (!place && strncmp(word, "robot:", 6) != 0) return leave_out_either(left, &n, word, why);
  const int found = place ? naming_find_place(&n, word + 6, wrong) : naming_find_seeker(&n, word + 6, wrong);
  if (found < 0) return fault_set(why, "--without: %s", wrong);
  *(place ? &left->place[found] : &left->robot[found]) = true;
  return 0;
}

static void list_label(char list[LIST], size_t *used, const char *label) {
  if (*used < LIST) *used += (size_t)snprintf(list + *used, LIST - *used, "%s%s", *used > 0 ? ", " : "", label);
}

/* Close places up over those that are marked. How many went; their names are listed. */
static int drop_places(input *in, const bool *drop, char list[LIST]) {
  const naming n = input_naming(in);
  uint16_t kept = 0;
  size_t used = 0;
  list[0] = '\0';
  for (uint16_t i = 0; i < in->mission.places; i++) {
    if (drop[in->place_number[i]])
      list_label(list, &used, naming_place(&n, i).text);
    else
      input_keep_place(in, kept++, i);
  }
  const int gone = in->mission.places - kept;
  in->mission.places = kept;
  return gone;
}

static int drop_robots(input *in, const bool *drop, char list[LIST]) {
  const naming n = input_naming(in);
  uint8_t kept = 0;
  size_t used = 0;
  list[0] = '\0';
  for (uint8_t i = 0; i < in->mission.seekers; i++) {
    if (drop[i])
      list_label(list, &used, naming_seeker(&n, i).text);
    else
      input_keep_robot(in, kept++, i);
  }
  const int gone = in->mission.seekers - kept;
  in->mission.seekers = kept;
  return gone;
}

static int drop_cleared(input *in, fault *why) {
  bool drop[QTR_MAX_PLACES] = {false};
  char list[LIST];
  for (int i = 0; i < in->mission.places; i++) drop[i] = qtr_places_has(&in->cleared, (unsigned)i);
  if (drop_places(in, drop, list) == 0) return 0;
  notes_add(&in->note, "%s: cleared, and so searched by nobody: %s", file_short_path(in->path), list);
  if (in->mission.places > 0) return 0;
  return file_fault(why, in->path, 0, 0, "all places are cleared: there is nothing left to search; clear fewer");
}

static int drop_absent(input *in, const absent *left, fault *why) {
  char list[LIST];
  if (drop_places(in, left->place, list) > 0)
    notes_add(&in->note, "%s: left out by --without: place %s", file_short_path(in->path), list);
  if (drop_robots(in, left->robot, list) > 0)
    notes_add(&in->note, "%s: left out by --without: robot %s; robots are numbered anew", file_short_path(in->path),
              list);
  if (in->mission.places > 0 && in->mission.seekers > 0) return 0;
  return fault_set(why, "--without: no %s is left; leave fewer out", in->mission.places == 0 ? "place" : "robot");
}

int choose_rest(input *in, const input_options *options, fault *why) {
  absent left = {{false}, {false}};
  if (take_clear(in, options, why) != 0) return -1;
  for (int i = 0; i < options->withouts; i++)
    if (leave_out(&left, in, options->without[i], why) != 0) return -1;
  return drop_cleared(in, why) != 0 ? -1 : drop_absent(in, &left, why);
}

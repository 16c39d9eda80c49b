#include "host/base/naming.h"

#include <stdio.h>
#include <string.h>

#include "host/base/near.h"
#include "host/base/text.h"
#include "host/base/utf8.h"

enum { MOST_TOLD = 8 }; /* robots, in a fault */

static naming_label label_of(const char *name, unsigned number) {
  naming_label label;
  if (name[0] != '\0')
    snprintf(label.text, sizeof label.text, "%s", name);
  else
    snprintf(label.text, sizeof label.text, "%u", number);
  return label;
}

unsigned naming_looked_at(const naming *n, unsigned place) {
  return n->look_of == NULL ? place : n->look_of[2 * place] | (unsigned)n->look_of[2 * place + 1] << 8;
}

naming_label naming_place(const naming *n, unsigned place) {
  const unsigned of = naming_looked_at(n, place);
  naming_label label = label_of(n->names->place[of], n->number[of]);
  const size_t length = strlen(label.text);
  if (of != place) snprintf(label.text + length, sizeof label.text - length, " (look %u)", naming_look(n, place));
  return label;
}

unsigned naming_look(const naming *n, unsigned place) {
  unsigned look = 1;
  for (unsigned before = 0; before < place; before++) look += naming_looked_at(n, before) == naming_looked_at(n, place);
  return look;
}

naming_label naming_seeker(const naming *n, unsigned seeker) {
  return label_of(n->names->seeker[seeker], seeker);
}

/* ---- the other way ---- */

static const char *nearest(const char names[][QTR_SITE_NAME_BYTES], int count, const char *word) {
  const char *known[(QTR_MAX_PLACES > QTR_MAX_SEEKERS ? QTR_MAX_PLACES : QTR_MAX_SEEKERS) + 1];
  int named = 0;
  for (int i = 0; i < count; i++)
    if (names[i][0] != '\0') known[named++] = names[i];
  known[named] = NULL;
  return near_word(word, known);
}

static int find_name(const char names[][QTR_SITE_NAME_BYTES], int count, const char *word) {
  for (int i = 0; word[0] != '\0' && i < count; i++)
    if (strcmp(names[i], word) == 0) return i;
  return -1;
}

static int find_number(const uint16_t *number, int count, const char *word) {
  long value;
  if (word[0] < '0' || word[0] > '9' || !text_integer(&value, word, strlen(word))) return -1;
  for (int i = 0; i < count; i++)
    if (value == (number != NULL ? number[i] : i)) return i;
  return -1;
}

int naming_find_place(const naming *n, const char *word, char *wrong) {
  int place = find_name(n->names->place, n->places, word);
  if (place < 0) place = find_number(n->number, n->places, word);
  if (place >= 0) return place;
  const char *meant = nearest(n->names->place, n->places, word);
  const unsigned last = n->number[n->places - 1];
  if (meant != NULL)
    snprintf(wrong, FAULT_LINE, "there is no place %.100s; did you mean '%s'?", word, meant);
  else
    snprintf(wrong, FAULT_LINE, "there is no place %.100s; there are places %u to %u%s%s", word, n->number[0], last,
             n->number[0] != 0 || last != (unsigned)n->places - 1u ? " but those that were left out" : "",
             naming_has_places(n) ? ", or give a name" : "");
  return -1;
}

typedef struct {
  char text[FAULT_LINE / 2];
} robot_list;

/* "Mole and Vole", or "0 to 2" where not all have names, or there are many. */
static robot_list list_robots(const naming *n) {
  const char *known[MOST_TOLD + 1] = {NULL};
  robot_list list;
  int named = 0;
  for (int i = 0; i < n->seekers && i < MOST_TOLD; i++)
    if (n->names->seeker[i][0] != '\0') known[named++] = n->names->seeker[i];
  if (named > 0 && named == n->seekers)
    near_list(list.text, sizeof list.text, known);
  else
    snprintf(list.text, sizeof list.text, "0 to %d", n->seekers - 1);
  return list;
}

int naming_find_seeker(const naming *n, const char *word, char *wrong) {
  int seeker = find_name(n->names->seeker, n->seekers, word);
  if (seeker < 0) seeker = find_number(NULL, n->seekers, word);
  if (seeker >= 0) return seeker;
  const char *meant = nearest(n->names->seeker, n->seekers, word);
  if (meant != NULL)
    snprintf(wrong, FAULT_LINE, "there is no robot %.100s; did you mean '%s'?", word, meant);
  else
    snprintf(wrong, FAULT_LINE, "there is no robot %.100s; there are robots %s", word, list_robots(n).text);
  return -1;
}

int naming_list_places(qtr_places *places, const naming *n, const char *list, char *wrong) {
  if (find_name(n->names->place, n->places, list) >= 0) {
    qtr_places_add(places, (unsigned)find_name(n->names->place, n->places, list));
    return 0;
  }
  for (const char *at = list; at != NULL; at = strchr(at, ',') != NULL ? strchr(at, ',') + 1 : NULL) {
    char word[QTR_SITE_NAME_BYTES];
    const char *from = at;
    size_t length = strcspn(at, ",");
    text_trim(&from, &length);
    snprintf(word, sizeof word, "%.*s", (int)length, from);
    const int place = naming_find_place(n, word, wrong);
    if (place < 0) return -1;
    qtr_places_add(places, (unsigned)place);
  }
  return 0;
}

int naming_same_place(const naming *n, int place, const naming *other) {
  const unsigned at = naming_looked_at(n, (unsigned)place);
  const char *name = n->names->place[at];
  for (int i = 0; i < other->places; i++) {
    const unsigned its_at = naming_looked_at(other, (unsigned)i);
    const char *its = other->names->place[its_at];
    const bool nameless = name[0] == '\0' && its[0] == '\0';
    if (nameless ? other->number[its_at] != n->number[at] : strcmp(name, its) != 0) continue;
    if (naming_look(other, (unsigned)i) == naming_look(n, (unsigned)place)) return i;
  }
  return -1;
}

/* ---- as JSON ---- */

bool naming_has_places(const naming *n) {
  for (int i = 0; i < n->places; i++)
    if (n->names->place[i][0] != '\0') return true;
  return false;
}

void naming_json_place(const naming *n, json *j, unsigned place) {
  const char *name = n->names->place[naming_looked_at(n, place)];
  if (name[0] != '\0') json_string(j, "name", name);
  if (naming_looked_at(n, place) != place) json_natural(j, "look", naming_look(n, place));
}

void naming_json_seeker(const naming *n, json *j, unsigned seeker) {
  if (n->names->seeker[seeker][0] != '\0') json_string(j, "name", n->names->seeker[seeker]);
}

/* ---- what may be a name ---- */

const char *naming_wrong(const char *text) {
  const size_t length = strlen(text);
  if (length == 0 || text_blank(text, length)) return "is empty";
  if (text_blank(text, 1) || text_blank(text + length - 1, 1)) return "begins or ends with a blank";
  if (length >= QTR_SITE_NAME_BYTES) return "is too long";
  for (const char *c = text; *c != '\0';) {
    const int bytes = utf8_length(c);
    if (bytes == 0) return "is not UTF-8";
    if ((unsigned char)*c < 0x20 || (unsigned char)*c == 0x7f) return "has a control character";
    c += bytes;
  }
  return NULL;
}

/* What places and robots are called: by their names, or else by their numbers. */
#ifndef QUARTER_HOST_NAMING_H
#define QUARTER_HOST_NAMING_H

#include <stdint.h>

#include "host/base/fault.h"
#include "host/base/json.h"
#include "quarter/names.h"
#include "quarter/places.h"

/* Of a mission, or of a table; the pointers are theirs. */
typedef struct {
  const qtr_names *names;
  const uint16_t *number; /* of each place, in the input, where places may have been left out; ascending */
  int places, seekers;
  const uint8_t *look_of; /* u16 for each place: the one that it is a look at; NULL: none is another look */
} naming;

typedef struct {
  char text[QTR_SITE_NAME_BYTES + 16];
} naming_label;

/* "Bay 3", or "5" where it has no name; "Bay 3 (look 2)" for a later look at it. */
naming_label naming_place(const naming *n, unsigned place);
naming_label naming_seeker(const naming *n, unsigned seeker);

/* The place that one is a look at, itself for a first one; and which of the looks at it, from 1. */
unsigned naming_looked_at(const naming *n, unsigned place);
unsigned naming_look(const naming *n, unsigned place);

/* The place, or the seeker, that a word names: by its name, or else by its number. -1, with what is wrong written into
 * wrong[FAULT_LINE], where there is none. */
int naming_find_place(const naming *n, const char *word, char *wrong);
int naming_find_seeker(const naming *n, const char *word, char *wrong);

/* Add the places that a list names, with commas between. 0, or -1 as above. */
int naming_list_places(qtr_places *places, const naming *n, const char *list, char *wrong);

/* The place of another mission or table that is this one: that of its name, or, where neither has a name, that of its
 * number; a later look the same look at it. -1: none is. */
int naming_same_place(const naming *n, int place, const naming *other);

/* Whether any place has a name. */
bool naming_has_places(const naming *n);

/* The member "name", of a place or a seeker that has one; and "look", of a later look at a place. */
void naming_json_place(const naming *n, json *j, unsigned place);
void naming_json_seeker(const naming *n, json *j, unsigned seeker);

/* That text can be a name: UTF-8 without control characters, no blanks at its ends, at most QTR_SITE_NAME_BYTES - 1
 * bytes. NULL, or what is wrong with it ("has a control character"). */
const char *naming_wrong(const char *text);

#endif

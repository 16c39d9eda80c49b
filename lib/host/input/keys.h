/* Keys of a file: a record a key, of which reading, faults, the reference (reference.h) and the schema (schema.h) are
 * made. */
#ifndef QUARTER_HOST_KEYS_H
#define QUARTER_HOST_KEYS_H

#include <stdbool.h>
#include <stddef.h>

#include "host/input/tree.h"

/* What a value is, and so where it goes: a field of the settings of the type named. */
enum key_kind {
  KEY_TEXT,    /* a text that is not empty; char[size] */
  KEY_NAME,    /* the same, short and in one line, to tell places and robots apart (naming.h) */
  KEY_FILE,    /* a file, relative to the one read; its path, char[size] */
  KEY_NUMBER,  /* double */
  KEY_INTEGER, /* a whole number; an integer of any size */
  KEY_WORD,    /* one of `words`; its index, an integer of any size or a bool */
  KEY_SWITCH,  /* true or false; a bool */
  KEY_LIST, /* items, each with the keys of `items`, or, with NULL, single values; nowhere: the reader asks the tree */
  KEY_POLYGONS, /* a list of polygons, each a list of corners with the keys of `items`, or a file; nowhere */
  KEY_MAPPING,  /* one mapping with the keys of `items`; nowhere */
  KEY_NAMED     /* a mapping of names that the user chooses to mappings with the keys of `items`; nowhere */
};

typedef struct key_set key_set;

typedef struct {
  const char *name;
  const char *const *also; /* other words for it, ended by NULL; NULL: none */
  enum key_kind kind;
  const char *help;     /* a sentence without its full stop */
  const char *example;  /* its value */
  const char *standard; /* the default as people say it; NULL: none is told */
  const char *where;    /* what inputs alone have a use for it ("ROS maps"); NULL: all */
  bool needed;
  size_t at, size; /* of the field: KEY_FIELD() */
  size_t given;    /* of a bool that becomes true where the key is there: KEY_GIVEN(); 0: none */
  /* numbers */
  const char *unit;         /* "m"; NULL: none */
  const char *noun;         /* what to give ("a length"); NULL: "a number", "a whole number" */
  double least, most;       /* 0 and 0: any; `most` may be HUGE_VAL */
  bool least_out, most_out; /* the ends themselves are out */
  /* words, lists and mappings */
  const char *const *words;
  const key_set *items;
} key_record;

#define KEY_FIELD(settings, field) .at = offsetof(settings, field), .size = sizeof(((settings *)0)->field)
#define KEY_GIVEN(settings, field) .given = offsetof(settings, field)

#define KEYS_GROUP 2

/* Keys that are given together, and what they are. */
typedef struct {
  const char *names[KEYS_GROUP];
  const char *what;
} key_group;

/* All keys of a mapping. */
struct key_set {
  const char *title;         /* "A place" */
  const key_record *records; /* ended by one without a name */
  const key_group *either;   /* of these exactly one is given; ended by one without names; NULL: nothing of the kind */
  const char *either_what;   /* "position" */
};

/* Read the mapping's keys into `settings`, which hold their defaults: its keys are known ones, each there once, none is
 * missing, and values are in their ranges. `what` names the mapping ("place 3"). *group, which may be NULL, is the
 * group of `either` that is given. 0, or -1 with the fault set; where the tree gathers faults, with all of them
 * there. */
int keys_read(void *settings, const key_set *set, tree *yaml, tree_node *mapping, const char *what, int *group);

/* The value of one key out of any file. KEY_LIST and its like are none of these. */
int keys_take(void *settings, const key_record *r, const value_site *site, const char *text);

/* The record of a key, by its name or another word for it; NULL: there is none. */
const key_record *keys_find(const key_set *set, const char *name);

/* All words for all keys, ended by NULL. */
void keys_words(const char *words[TREE_KEYS_MOST + 1], const key_set *set);

/* The node of a key, under whatever word; NULL: it is not there. */
tree_node *keys_node(tree *yaml, tree_node *mapping, const key_record *r);

/* A number's range in words, "above 0 and below 1"; empty where there is none. */
#define KEYS_RANGE_SIZE 96
void keys_range(char out[KEYS_RANGE_SIZE], const key_record *r);

#endif

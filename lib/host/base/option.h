/* Command lines: a record an option, of which parsing, help and refusals are made. */
#ifndef QUARTER_HOST_OPTION_H
#define QUARTER_HOST_OPTION_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include "host/base/fault.h"

/* What a value is, and so where it goes: a field of the settings of the type named. */
enum option_kind {
  OPTION_MARK,   /* no value; bool, becomes true */
  OPTION_TEXT,   /* any word; const char * */
  OPTION_FILE,   /* a word that is not empty; const char * */
  OPTION_NUMBER, /* from least to most; double */
  OPTION_COUNT,  /* a whole number from first to last, in digits alone; an integer of any size */
  OPTION_WORD,   /* one of `words`; its index, an integer of any size or a bool */
  OPTION_OWN     /* what `take` makes of it */
};

typedef struct option_record option_record;
struct option_record {
  const char *name;     /* --name */
  char letter;          /* -l; 0: none */
  const char *argument; /* what help calls the value; NULL: there is none; "[=FILE]": there may be one */
  const char *help;     /* unless a command says otherwise; "%s" is the default */
  const char *standard; /* the default, as one would type it; NULL: none is told */
  enum option_kind kind;
  size_t at, size; /* of the field: OPTION_FIELD() */
  double least, most;
  bool open;         /* `least` and `most` themselves are out */
  const char *range; /* the two in words, for a fault; NULL: "from 0 to 1" is said of them */
  uint64_t first, last;
  const char *const *words; /* ended by NULL */
  int (*take)(void *settings, const option_record *record, const char *value, fault *why);
};

#define OPTION_FIELD(settings, field) .at = offsetof(settings, field), .size = sizeof(((settings *)0)->field)

/* All options of a program; "help" must be one of them. Ended by a record without a name. */
typedef const option_record option_table[];

/* A line of a command's help. The options that a command's lines name are those that it takes. */
typedef struct {
  const char *options; /* names, with what stands between them in help: "spot-size spot-diameter", "gap, seed" */
  const char *text;    /* NULL: the help of the first one's record; each "%s" is the next default */
  int column;          /* in which the text begins; 0: OPTION_COLUMN */
} option_line;

#define OPTION_COLUMN 27

/* A line of the first one's own help. */
#define OPTION_LINE(options) {options, NULL, 0}

typedef struct {
  const char *name; /* of the command, for faults; NULL: the program has one only */
  const char *intro, *outro;
  const option_record *table;
  const option_line *lines; /* ended by one without options */
} option_set;

/* Parse the words after argv[0] into `settings`, which hold their defaults, up to the first that is no option: optind
 * tells. 0, or -1 with *why set. */
int option_parse(void *settings, const option_set *set, int argc, char **argv, fault *why);

/* intro, the lines of the options, outro. The exit status: whether it was printed is found out at the end. */
int option_help(FILE *out, const option_set *set);

/* Whether the command takes the option: a line of its help names it, or it is "help". */
bool option_is_taken(const option_set *set, const char *name);

/* ---- for records that take their values themselves ---- */

/* The number that `value` is. 0, or -1 with *why set; `range` tells of least and most in words, NULL: in figures. */
int option_number(double *number, const char *name, const char *value, const char *range, double least, double most,
                  fault *why);
int option_count(uint64_t *count, const char *name, const char *value, uint64_t first, uint64_t last, fault *why);

/* The index among `words` of the first `length` characters of `value`. */
int option_word(int *index, const char *name, const char *value, size_t length, const char *const *words, fault *why);

#endif

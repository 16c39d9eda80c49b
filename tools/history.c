#include "history.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "host/base/count.h"
#include "host/base/near.h"
#include "host/base/separated.h"
#include "host/base/text.h"
#include "host/input/frame.h"
#include "quarter/status.h"

#define WORD_SHOWN 60
#define LOOKS_MOST 1000000 /* of a row */

enum { GAME, FOUND, LOOKS, PLACE, COLUMN, ROW, X, Y, KINDS };
static const char *const names[KINDS + 1] = {"game", "found", "looks", "place", "column", "row", "x", "y", NULL};

typedef struct {
  text_field name; /* empty where the history names no games */
  long line;
} game_name;

typedef struct {
  history_tally *tally;
  qtr_belief *belief;
  const input *in;
  const char *path;
  double detection;
  fault *why;
  separated rows;
  int columns;
  int kind[KINDS]; /* of each column */
  bool has[KINDS];
  text_field value[KINDS]; /* of the current row, by kind */
  qtr_search search;       /* of the current game */
  uint32_t finds;          /* in it */
  game_name *game;         /* all games so far */
  size_t games, room;
} reading;

static int shown(text_field it) {
  return it.length < WORD_SHOWN ? (int)it.length : WORD_SHOWN;
}

/* Stands in the file's bytes, and so outlives its row. */
static text_field field_of(const reading *r, int i) {
  return (text_field){r->rows.field[i].text, strlen(r->rows.field[i].text)};
}

/* ---- the header ---- */

static int unknown_column(reading *r, text_field it) {
  char word[WORD_SHOWN + 1], known[80];
  snprintf(word, sizeof word, "%.*s", shown(it), it.text);
  const char *meant = near_word(word, names);
  near_list(known, sizeof known, names);
  if (meant != NULL)
    return file_fault(r->why, r->path, r->rows.line, 0, "a history has no column \"%s\"; write \"%s\"", word, meant);
  return file_fault(r->why, r->path, r->rows.line, 0,
                    "a history has no column \"%s\"; write a header such as \"game,place,found\" (columns: %s)", word,
                    known);
}

static int take_column(reading *r, text_field it) {
  int kind = 0;
  while (kind < KINDS && !text_field_is(it, names[kind])) kind++;
  if (kind == KINDS) return unknown_column(r, it);
  if (r->has[kind])
    return file_fault(r->why, r->path, r->rows.line, 0, "two columns are \"%s\"; drop one of them", names[kind]);
  r->has[kind] = true;
  r->kind[r->columns++] = kind;
  return 0;
}

/* One way of naming the place, and that whole. */
static bool names_a_place(const reading *r) {
  const int by_number = r->has[PLACE], by_cell = r->has[COLUMN] || r->has[ROW], by_point = r->has[X] || r->has[Y];
  return by_number + by_cell + by_point == 1 && r->has[COLUMN] == r->has[ROW] && r->has[X] == r->has[Y];
}

static int read_header(reading *r) {
  for (int i = 0; i < r->rows.count; i++)
    if (take_column(r, field_of(r, i)) != 0) return -1;
  if (r->columns == 1 && r->has[FOUND]) {
    r->kind[0] = PLACE;
    r->has[PLACE] = true;
    r->has[FOUND] = false;
  }
  if (names_a_place(r)) return 0;
  return file_fault(r->why, r->path, r->rows.line, 0,
                    "the header must name the place in one way: \"place\", or \"column,row\", or \"x,y\"; write for "
                    "instance \"game,place,found\"");
}

/* ---- rows ---- */

static int split_row(reading *r) {
  const int count = r->rows.count;
  for (int i = 0; i < count && i < r->columns; i++) r->value[r->kind[i]] = field_of(r, i);
  if (count == r->columns) return 0;
  return file_fault(r->why, r->path, r->rows.line, 0,
                    "the line has %s and the header %d; write as many, with commas between",
                    counted((uint64_t)count, "field").text, r->columns);
}

static int unknown_place(reading *r, const char *which) {
  return file_fault(r->why, r->path, r->rows.line, 0,
                    "no place of %s is %s; correct the line, or add the place to the mission (its places are 0 to %d)",
                    file_short_path(r->in->path), which, r->in->places_stated - 1);
}

static int read_number(reading *r, double *value, int kind) {
  char number[SEPARATED_NUMBER];
  const text_field it = r->value[kind];
  const char *text = separated_number(&r->rows, it.text, number);
  const char *wrong = text_number(value, text, strlen(text));
  if (wrong == NULL) return 0;
  return file_fault(r->why, r->path, r->rows.line, 0, "the %s \"%.*s\" %s; write a number", names[kind], shown(it),
                    it.text, wrong);
}

/* "Bay 3 (look 2)" is a look at Bay 3. */
static size_t without_look(const char *text) {
  const char *mark = strstr(text, " (look ");
  char *end;
  if (mark == NULL || mark[7] < '1' || mark[7] > '9') return strlen(text);
  strtol(mark + 7, &end, 10);
  return strcmp(end, ")") == 0 ? (size_t)(mark - text) : strlen(text);
}

static int find_place(const naming *n, const char *text, char *wrong) {
  char of[QTR_SITE_NAME_BYTES];
  const int place = naming_find_place(n, text, wrong);
  if (place >= 0 || without_look(text) == strlen(text)) return place;
  snprintf(of, sizeof of, "%.*s", (int)without_look(text), text);
  return naming_find_place(n, of, wrong);
}

static int place_by_number(reading *r, unsigned *place) {
  const text_field it = r->value[PLACE];
  char which[WORD_SHOWN + 16];
  char wrong[FAULT_LINE];
  long number;
  const naming n = input_naming(r->in);
  const int named = find_place(&n, it.text, wrong);
  *place = (unsigned)named;
  if (named >= 0) return 0;
  if (!text_integer(&number, it.text, it.length))
    return file_fault(r->why, r->path, r->rows.line, 0,
                      "the place \"%.*s\" is not a number or a name of the mission's; write one, 0 to %d", shown(it),
                      it.text, r->in->places_stated - 1);
  if (number >= 0 && number < r->in->places_stated)
    return file_fault(r->why, r->path, r->rows.line, 0,
                      "place %ld was left out of %s by --skip-unreachable; leave the line out too", number,
                      file_short_path(r->in->path));
  snprintf(which, sizeof which, "number %ld", number);
  return unknown_place(r, which);
}

static int place_by_cell(reading *r, unsigned *place) {
  const qtr_mission *mission = &r->in->mission;
  double column, row;
  char which[100];
  if (read_number(r, &column, COLUMN) != 0 || read_number(r, &row, ROW) != 0) return -1;
  for (*place = 0; *place < mission->places; ++*place) {
    const qtr_cell cell = mission->place[*place];
    if (column == (double)(cell % mission->columns) && row == (double)(cell / mission->columns)) return 0;
  }
  snprintf(which, sizeof which, "at column %g, row %g", column, row);
  return unknown_place(r, which);
}

static int place_by_point(reading *r, unsigned *place) {
  double x, y;
  char which[100];
  if (read_number(r, &x, X) != 0 || read_number(r, &y, Y) != 0) return -1;
  const qtr_cell cell = frame_cell(r->in, (input_position){true, x, y});
  for (*place = 0; *place < r->in->mission.places; ++*place)
    if (r->in->mission.place[*place] == cell) return 0;
  snprintf(which, sizeof which, "at x %g, y %g", x, y);
  return unknown_place(r, which);
}

static int read_found(reading *r, bool *found) {
  static const char *const words[] = {"0", "1", "no", "yes", "false", "true"};
  const text_field it = r->value[FOUND];
  *found = true;
  if (!r->has[FOUND]) return 0;
  for (int i = 0; i < 6; i++) {
    *found = i % 2 == 1;
    if (text_field_is(it, words[i])) return 0;
  }
  return file_fault(r->why, r->path, r->rows.line, 0,
                    "found is \"%.*s\"; write 1 where the target was found, 0 where the place was searched in vain",
                    shown(it), it.text);
}

static int read_looks(reading *r, long *looks) {
  const text_field it = r->value[LOOKS];
  *looks = 1;
  if (!r->has[LOOKS] || (text_integer(looks, it.text, it.length) && *looks >= 1 && *looks <= LOOKS_MOST)) return 0;
  return file_fault(r->why, r->path, r->rows.line, 0,
                    "looks is \"%.*s\"; write how many looks at the place this line tells of, 1 to %d", shown(it),
                    it.text, LOOKS_MOST);
}

/* ---- games ---- */

static int end_game(reading *r) {
  if (r->games == 0) return 0;
  r->tally->games++;
  if (r->finds > 0) return 0;
  r->tally->without++;
  if (qtr_belief_not_found(r->belief, &r->search) == QTR_OK) return 0;
  return file_fault(r->why, r->path, r->game[r->games - 1].line, 0,
                    "the game that begins here has searched every place and found nothing, so its target was at none; "
                    "leave it out, or say with --detection (or \"detection\" in the mission) how often a look sees "
                    "what is there");
}

static int begin_game(reading *r, text_field name) {
  if (end_game(r) != 0) return -1;
  if (r->games == r->room) {
    r->room = r->room == 0 ? 256 : 2 * r->room;
    game_name *larger = realloc(r->game, r->room * sizeof *larger);
    if (larger == NULL) return fault_set(r->why, "%s: no memory for its games", file_short_path(r->path));
    r->game = larger;
  }
  r->game[r->games++] = (game_name){name, r->rows.line};
  r->finds = 0;
  qtr_belief_begin_game(r->belief);
  qtr_search_begin(&r->search, r->belief);
  return 0;
}

static int continue_or_begin_game(reading *r) {
  const text_field name = r->value[GAME];
  if (!r->has[GAME]) return begin_game(r, name);
  if (name.length == 0)
    return file_fault(r->why, r->path, r->rows.line, 0, "the game has no name; write a number or a word");
  if (r->games == 0) return begin_game(r, name);
  const text_field current = r->game[r->games - 1].name;
  if (name.length == current.length && memcmp(name.text, current.text, name.length) == 0) return 0;
  return begin_game(r, name);
}

static int compare_games(const void *a, const void *b) {
  const game_name *x = a, *y = b;
  const size_t common = x->name.length < y->name.length ? x->name.length : y->name.length;
  const int order = memcmp(x->name.text, y->name.text, common);
  if (order != 0) return order;
  if (x->name.length != y->name.length) return x->name.length < y->name.length ? -1 : 1;
  return (x->line > y->line) - (x->line < y->line);
}

static bool have_one_name(const game_name *x, const game_name *y) {
  return x->name.length == y->name.length && memcmp(x->name.text, y->name.text, x->name.length) == 0;
}

/* A game that goes on below another one would have been counted twice. Tells of the first line that does. */
static int check_games(reading *r) {
  const game_name *first = NULL, *again = NULL;
  if (!r->has[GAME]) return 0;
  qsort(r->game, r->games, sizeof *r->game, compare_games);
  for (size_t i = 1; i < r->games; i++) {
    if (!have_one_name(&r->game[i - 1], &r->game[i]) || (again != NULL && again->line < r->game[i].line)) continue;
    first = &r->game[i - 1];
    again = &r->game[i];
  }
  if (again == NULL) return 0;
  return file_fault(r->why, r->path, again->line, 0,
                    "game \"%.*s\" has ended already, with rows from line %ld on; put its rows together, or name this "
                    "one otherwise",
                    shown(again->name), again->name.text, first->line);
}

/* What is there was missed by all of the looks. */
static int miss(reading *r, unsigned place, long looks) {
  const bool own = r->detection == HISTORY_OF_PLACES;
  r->tally->vain[place] += (uint32_t)looks;
  for (long look = 0; look < looks; look++)
    if (qtr_search_empty(&r->search, place, own ? r->in->mission.detection[place] : r->detection) != QTR_OK) return -1;
  return 0;
}

static int read_place(reading *r, unsigned *place) {
  if (r->has[PLACE]) return place_by_number(r, place);
  return r->has[X] ? place_by_point(r, place) : place_by_cell(r, place);
}

static int read_row(reading *r) {
  unsigned place = 0;
  long looks;
  bool found;
  if (split_row(r) != 0) return -1;
  if (read_place(r, &place) != 0 || read_found(r, &found) != 0 || read_looks(r, &looks) != 0) return -1;
  if (continue_or_begin_game(r) != 0) return -1;
  if (!found) return miss(r, place, looks);
  if (miss(r, place, looks - 1) != 0) return -1;
  r->finds++;
  r->tally->finds++;
  r->tally->found[place]++;
  if (qtr_belief_found(r->belief, place) == QTR_OK) return 0;
  return file_fault(r->why, r->path, r->rows.line, 0, "place %u has more finds than can be counted; begin anew", place);
}

static int read_rows(reading *r, file_bytes *bytes) {
  int more;
  separated_begin(&r->rows, bytes, r->path, r->why);
  while ((more = separated_next(&r->rows)) > 0)
    if ((r->columns == 0 ? read_header(r) : read_row(r)) != 0) return -1;
  if (more < 0) return -1;
  if (r->columns == 0)
    return file_fault(r->why, r->path, 0, 0, "holds no header; start it with \"game,place,found\" or \"place\"");
  if (r->games == 0)
    return file_fault(r->why, r->path, 0, 0, "holds no game; write a row for each place where a target was found");
  return end_game(r) != 0 ? -1 : check_games(r);
}

int history_read(history_tally *tally, qtr_belief *belief, const input *in, const char *path, double detection,
                 fault *why) {
  static reading r;
  file_bytes bytes;
  memset(tally, 0, sizeof *tally);
  memset(&r, 0, sizeof r);
  r.tally = tally;
  r.belief = belief;
  r.in = in;
  r.path = path;
  r.detection = detection;
  r.why = why;
  if (file_read(&bytes, path, FILE_TEXT_LIMIT, NULL, why) != 0) return -1;
  const int status = read_rows(&r, &bytes);
  free(r.game);
  file_free(&bytes);
  return status;
}

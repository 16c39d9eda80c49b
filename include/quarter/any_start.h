/* A table that also answers for starts in any region of the map, and for any set of places cleared beforehand, so that
 * one table serves redeployment and a mission resumed.
 *
 * For every crew (a region for each seeker; those of one class and ready time are interchangeable, so that their
 * regions never fall from one to the next) and every set of places cleared there is a game to learn. Regions that
 * nobody gets to a place from are of no crew, if they are the last ones. All games are recorded on one board, whose
 * starts are the regions' representatives and after them the mission's own. The mission's own games come first, and in
 * a state that several games meet theirs decide, so that the certificate in the table is what they earn.
 *
 *   qtr_any_start_init(&any, &asked, &blocks, &travel);
 *   while (qtr_any_start_next(&any)) {
 *     // learn qtr_any_start_game(), or take what is known of the mission itself: any.is_whole
 *     qtr_any_start_add(&any, &routes, number);
 *   }
 *   qtr_any_start_finish(&any);
 *   qtr_table_write(&content, ...);  // content = qtr_any_start_content()
 *
 * It may be left after any game: off the table robots go by their rule.
 */
#ifndef QUARTER_ANY_START_H
#define QUARTER_ANY_START_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "quarter/game.h"
#include "quarter/play.h"
#include "quarter/regions.h"
#include "quarter/writer.h"

QTR_C_BEGIN

/* What the table is to be for. Game and regions must outlive its making. Robots come home to wherever they start.
 * None of them may have an end: who is home in time depends on where it is. */
typedef struct {
  const qtr_game *game;       /* the mission's own, set up */
  const qtr_regions *regions; /* any of them may be a start; NULL: the mission's own starts alone */
  bool any_cleared;           /* any set of places may be cleared; false: none */
} qtr_any_start_asked;

/* Memory of the caller's, by qtr_any_start_needs(). */
typedef struct {
  uint8_t *steps;    /* the board's travel times */
  qtr_cell *start;   /* cells of the board's starts */
  uint16_t *region;  /* of each cell; NULL without regions */
  uint8_t *entries;  /* states met, and in the end the table's records: grows with the games, see qtr_any_start_add() */
  size_t entry_room; /* bytes that `entries` holds */
} qtr_any_start_blocks;

/* How much of it, in bytes. */
typedef struct {
  size_t steps, start, region;
  uint16_t starts; /* of the board */
} qtr_any_start_sizes;

typedef struct {
  qtr_any_start_asked asked;
  qtr_any_start_blocks blocks;
  qtr_board board;
  uint16_t regions;   /* the board's first starts; 0: none */
  uint16_t inhabited; /* of them, the first ones: those that crews are drawn from */
  /* the game that is to be learnt */
  uint16_t start_of[QTR_MAX_SEEKERS]; /* the crew */
  qtr_places cleared;
  bool begun, finished;
  bool is_own;   /* the crew is the mission's own */
  bool is_whole; /* and nothing is cleared: the mission itself */
  /* so far */
  uint32_t count; /* entries, after qtr_any_start_finish() records */
  uint64_t games; /* added */
  double crews;   /* done */
} qtr_any_start;

/* QTR_OK; QTR_ERR_LIMIT for more regions than a table can tell starts of, QTR_ERR_ARGUMENT for robots that must be
 * home in time, and for any places cleared where they are looked at more than once or coming home counts. */
int qtr_any_start_needs(qtr_any_start_sizes *sizes, const qtr_any_start_asked *asked);

/* Measure the board. `travel` is scratch. QTR_OK, what qtr_any_start_needs() says, QTR_ERR_STOPPED by the mission's
 * watch, or QTR_ERR_CONFIG if the caller was built under other sizes. */
#define qtr_any_start_init(any, asked, blocks, travel)                                                                 \
  qtr_any_start_init_built(any, asked, blocks, travel, QTR_CONFIG_ID)
int qtr_any_start_init_built(qtr_any_start *any, const qtr_any_start_asked *asked, const qtr_any_start_blocks *blocks,
                             qtr_travel *travel, uint32_t config_id);

/* Ways to put the seekers into the regions, and into as many as these; games to learn; bytes of records that they take
 * at most. */
double qtr_any_start_count_crews(const qtr_any_start *any);
double qtr_any_start_crews_of(const qtr_mission *mission, unsigned regions);
double qtr_any_start_count_games(const qtr_any_start *any);
double qtr_any_start_estimate(const qtr_any_start *any);

/* Go on to the next game. False: there is none left. */
bool qtr_any_start_next(qtr_any_start *any);

/* The mission that is left in the game under way, as qtr_rest_make() has it: without the places cleared, and those that
 * nobody of the crew can get to; later looks have their numbers, too. False, with nothing made: there is none left. */
bool qtr_any_start_rest(const qtr_any_start *any, qtr_mission *rest, uint16_t *number);

/* That mission, and its game set up by the travel times that are known. QTR_OK; QTR_ERR_UNREACHABLE where no place is
 * left, or what qtr_rest_game() says, which for some crews is that they cannot play: then go on. */
int qtr_any_start_game(const qtr_any_start *any, qtr_game *game, qtr_mission *rest, uint16_t *number);

/* Record the game under way, played by routes whose places are those of a game of the rest, numbered by `number` (NULL:
 * as in the whole mission). QTR_OK; with nothing recorded QTR_ERR_SPACE if the entries have no room left: copy them to
 * a larger block, tell it by qtr_any_start_move(), and try again. */
int qtr_any_start_add(qtr_any_start *any, const qtr_routes *routes, const uint16_t *number);

/* The entries stand in another block now. */
void qtr_any_start_move(qtr_any_start *any, uint8_t *entries, size_t room);

/* No more games: sort the entries, and keep one record of each state. */
void qtr_any_start_finish(qtr_any_start *any);

/* What the table is made of; lives as long as all that it points to. The certificate is that of the mission's own
 * game. */
qtr_table_content qtr_any_start_content(const qtr_any_start *any, const qtr_certificate *certificate, uint64_t seed);

QTR_C_END

#endif

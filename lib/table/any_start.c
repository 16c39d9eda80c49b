#include "quarter/any_start.h"

#include <string.h>

#include "model/matrix.h"
#include "model/rounding.h"
#include "quarter/policy.h"
#include "quarter/rest.h"
#include "quarter/status.h"
#include "table/record.h"

/* ---- the board of all starts ---- */

/* What no board of other starts tells: who is home in time, for crews share states, and a state tells nothing of homes;
 * and which looks are left at a place that counts as cleared. How much coming home counts is not told either, but what
 * any crew does in a state can be done by all. */
static bool cannot_be_held(const qtr_any_start_asked *asked) {
  const qtr_game *game = asked->game;
  const bool counts_looks = game->board.terms.look_of != NULL;
  const bool counts_home = game->objective.terms.home_weight > 0.0;
  return game->board.terms.end != NULL || (asked->any_cleared && (counts_looks || counts_home));
}

/* Without regions there are no crews but the mission's own: then the games differ by the places cleared alone. */
static unsigned count_regions(const qtr_any_start_asked *asked) {
  return asked->regions != NULL ? asked->regions->count : 0;
}

/* Travel times stand as the table's own bytes, 4 each, from every node (places and starts) to every place, for each
 * class. */
int qtr_any_start_needs(qtr_any_start_sizes *sizes, const qtr_any_start_asked *asked) {
  const qtr_mission *mission = asked->game->mission;
  const unsigned places = asked->game->board.places;
  const uint32_t starts = count_regions(asked) + asked->game->board.starts;
  if (cannot_be_held(asked)) return QTR_ERR_ARGUMENT;
  if (starts > QTR_MAX_STARTS) return QTR_ERR_LIMIT;
  sizes->starts = (uint16_t)starts;
  sizes->start = starts * sizeof(qtr_cell);
  sizes->steps = 4u * ((size_t)places + starts) * places * mission->classes;
  sizes->region = asked->regions != NULL ? qtr_mission_cells(mission) * sizeof(uint16_t) : 0;
  return QTR_OK;
}

/* The regions' representatives, then the mission's own. */
static void set_starts(qtr_any_start *any) {
  const qtr_game *game = any->asked.game;
  qtr_cell *start = any->blocks.start;
  for (unsigned region = 0; region < any->regions; region++) *start++ = any->asked.regions->representative[region];
  for (unsigned own = 0; own < game->board.starts; own++) *start++ = qtr_game_start_cell(game, own);
  for (unsigned i = 0; i < any->board.seekers; i++)
    any->board.start_of[i] = (uint16_t)(any->regions + game->board.start_of[i]);
}

/* A robot looks up the start that stands for its cell, so a region's number is that of its representative among the
 * starts. */
static void set_regions(qtr_any_start *any) {
  const qtr_mission *mission = any->asked.game->mission;
  const uint32_t cells = any->regions > 0 ? qtr_mission_cells(mission) : 0;
  for (uint32_t cell = 0; cell < cells; cell++)
    any->blocks.region[cell] = mission->cost[cell] > 0 ? (uint16_t)any->asked.regions->of[cell] : QTR_POLICY_NO_REGION;
}

/* Whether a seeker that starts there can get to a place. */
static bool reaches(const qtr_any_start *any, unsigned seeker, unsigned start, unsigned place) {
  return qtr_board_steps(&any->board, seeker, any->board.places + start, place) != QTR_NEVER;
}

static bool is_inhabited(const qtr_any_start *any, unsigned region) {
  for (unsigned i = 0; i < any->board.seekers; i++)
    for (unsigned place = 0; place < any->board.places; place++)
      if (reaches(any, i, region, place)) return true;
  return false;
}

/* Seekers, rule, terms and numbers of places are the mission's own board's; the starts, and so the nodes and the keys,
 * are more. */
int qtr_any_start_init_built(qtr_any_start *any, const qtr_any_start_asked *asked, const qtr_any_start_blocks *blocks,
                             qtr_travel *travel, uint32_t config_id) {
  if (config_id != QTR_CONFIG_ID) return QTR_ERR_CONFIG;
  const qtr_mission *mission = asked->game->mission;
  qtr_any_start_sizes sizes;
  const int status = qtr_any_start_needs(&sizes, asked);
  if (status != QTR_OK) return status;
  memset(any, 0, sizeof *any);
  any->asked = *asked;
  any->blocks = *blocks;
  any->regions = (uint16_t)count_regions(asked);
  any->board = asked->game->board;
  any->board.starts = sizes.starts;
  any->board.steps = blocks->steps;
  any->board.terms.rules &= (uint8_t)~QTR_BY_HOME; /* crews of regions are multisets, wherever their homes are */
  set_starts(any);
  set_regions(any);
  const qtr_matrix_nodes nodes = {mission, any->board.places, any->board.terms.look_of, blocks->start, sizes.starts};
  if (qtr_matrix_fill(blocks->steps, &nodes, travel, NULL) < mission->places) return QTR_ERR_STOPPED;
  any->inhabited = any->regions;
  while (any->inhabited > 0 && !is_inhabited(any, any->inhabited - 1u)) any->inhabited--;
  return qtr_board_init(&any->board);
}

/* ---- how much it is ---- */

/* Seekers of one class that are ready at once may stand for one another, wherever they start. */
static bool are_alike(const qtr_mission *mission, unsigned a, unsigned b) {
  return mission->class_of[a] == mission->class_of[b] && mission->ready[a] == mission->ready[b];
}

/* Multisets of k regions out of n, for each kind of seekers: (n + k - 1)! / (k! (n - 1)!), factor by factor, each
 * partial product itself such a number. Doubles, as they may be beyond any integer. */
double qtr_any_start_crews_of(const qtr_mission *mission, unsigned regions) {
  double crews = 1.0;
  for (unsigned i = 0; regions > 0 && i < mission->seekers; i++) {
    unsigned before = 0;
    for (unsigned j = 0; j < i; j++) before += are_alike(mission, i, j);
    crews *= (double)(regions + before) / (double)(before + 1);
  }
  return crews;
}

double qtr_any_start_count_crews(const qtr_any_start *any) {
  return qtr_any_start_crews_of(any->asked.game->mission, any->inhabited);
}

/* Every set but that of all places. */
static double count_sets(const qtr_any_start *any) {
  double sets = 1.0;
  if (!any->asked.any_cleared) return sets;
  for (unsigned place = 0; place < any->board.places; place++) sets *= 2.0;
  return sets - 1.0;
}

/* Every crew with every set: the first factor is what --starts any costs, the second one what --cleared any does. */
double qtr_any_start_count_games(const qtr_any_start *any) {
  return qtr_any_start_count_crews(any) * count_sets(any);
}

/* A game's states: a choice for every place that is left, half of them in the mean, and for all seekers but one that
 * stand down. */
double qtr_any_start_estimate(const qtr_any_start *any) {
  const double places = any->board.places * (any->asked.any_cleared ? 0.5 : 1.0);
  return qtr_any_start_count_games(any) * (places + any->board.seekers - 1) * record_shape_written(&any->board).bytes;
}

/* ---- one game after another ---- */

/* The next set of cleared places, counting in binary; false where all are cleared, for then nothing is left. */
static bool next_cleared(qtr_any_start *any) {
  const unsigned places = any->board.places;
  unsigned place = 0;
  unsigned left = 0;
  while (place < places && qtr_places_has(&any->cleared, place)) qtr_places_remove(&any->cleared, place++);
  if (place < places) qtr_places_add(&any->cleared, place);
  for (unsigned p = 0; p < places; p++) left += !qtr_places_has(&any->cleared, p);
  return place < places && left > 0;
}

/* The region of the last alike seeker before one. */
static uint16_t least_region(const qtr_any_start *any, unsigned seeker) {
  for (unsigned j = seeker; j-- > 0;)
    if (are_alike(any->asked.game->mission, seeker, j)) return any->start_of[j];
  return 0;
}

/* The next crew in the order of the regions, each seeker's region no lower than that of an alike one before it. */
static bool next_crew(qtr_any_start *any) {
  unsigned i = any->board.seekers;
  while (i > 0 && any->start_of[i - 1] + 1 == any->inhabited) i--;
  if (i == 0) return false;
  any->start_of[i - 1]++;
  for (unsigned j = i; j < any->board.seekers; j++) any->start_of[j] = least_region(any, j);
  return true;
}

/* The mission itself first, from its own starts with nothing cleared: its certificate is the table's. */
static bool begin(qtr_any_start *any) {
  any->begun = any->is_own = any->is_whole = true;
  memcpy(any->start_of, any->board.start_of, sizeof any->start_of);
  return true;
}

/* For one crew all sets, then the next crew: the own one, and after it all multisets of regions, from the one of the
 * first region alone on. An own crew that stands on representatives is met again, and then its rank decides. */
bool qtr_any_start_next(qtr_any_start *any) {
  if (!any->begun) return begin(any);
  any->is_whole = false;
  if (any->asked.any_cleared && next_cleared(any)) return true;
  qtr_places_clear(&any->cleared);
  if (any->inhabited == 0) return false;
  if (!any->is_own) {
    any->crews += 1.0;
    return next_crew(any);
  }
  any->is_own = false;
  memset(any->start_of, 0, sizeof any->start_of);
  return true;
}

/* Places that the crew has no way to, beside those cleared. */
static void leave_out(const qtr_any_start *any, qtr_places *out) {
  *out = any->cleared;
  for (unsigned place = 0; place < any->asked.game->mission->places; place++) {
    bool in_reach = false;
    for (unsigned i = 0; i < any->board.seekers; i++) in_reach = in_reach || reaches(any, i, any->start_of[i], place);
    if (!in_reach) qtr_places_add(out, place);
  }
}

/* Later looks come in the order of the whole mission's, without those at places left out. */
static void number_looks(const qtr_any_start *any, uint16_t *number, unsigned places, const qtr_places *out) {
  const qtr_game *game = any->asked.game;
  for (uint16_t look = game->mission->places; look < game->board.places; look++)
    if (!qtr_places_has(out, qtr_game_place(game, look))) number[places++] = look;
}

/* From the representatives' cells: a table for any start knows no nearer where its robots will be. */
bool qtr_any_start_rest(const qtr_any_start *any, qtr_mission *rest, uint16_t *number) {
  qtr_cell start[QTR_MAX_SEEKERS];
  qtr_places out;
  unsigned left = 0;
  leave_out(any, &out);
  for (unsigned place = 0; place < any->asked.game->mission->places; place++) left += !qtr_places_has(&out, place);
  if (left == 0) return false;
  for (unsigned i = 0; i < any->board.seekers; i++) start[i] = any->blocks.start[any->start_of[i]];
  qtr_rest_make(rest, number, any->asked.game->mission, start, &out);
  number_looks(any, number, rest->places, &out);
  return true;
}

int qtr_any_start_game(const qtr_any_start *any, qtr_game *game, qtr_mission *rest, uint16_t *number) {
  if (!qtr_any_start_rest(any, rest, number)) return QTR_ERR_UNREACHABLE;
  return qtr_rest_game_known(game, rest, &any->board, number, any->start_of);
}

/* ---- entries: a record, and behind it its rank; among entries of one state the lowest rank stays ---- */

static uint32_t entry_size(const qtr_any_start *any) {
  return record_shape_written(&any->board).bytes + 1u;
}

static uint8_t *entry_at(const qtr_any_start *any, uint32_t i) {
  return any->blocks.entries + (size_t)i * entry_size(any);
}

/* Rank 0 is the mission's own crew, 1 all others. A rank is a byte behind the record, so that entries stay in one array
 * and the records can close up in place. */
static int add_entry(qtr_any_start *any, const qtr_joint *joint, uint16_t choice) {
  const uint32_t size = entry_size(any);
  if (any->count == UINT32_MAX || ((size_t)any->count + 1) * size > any->blocks.entry_room) return QTR_ERR_SPACE;
  uint8_t *entry = entry_at(any, any->count++);
  qtr_record_write(entry, joint, &any->board, choice);
  entry[size - 1] = any->is_own ? 0 : 1;
  return QTR_OK;
}

/* A route that is done means standing down: whoever has a place left in reach takes it, or the route would not be
 * whole. */
static uint16_t choice_of(const qtr_routes *routes, const uint16_t *number, int seeker, uint16_t *done) {
  if (done[seeker] >= routes->length[seeker]) return QTR_STAND_DOWN;
  const uint16_t place = routes->place[seeker][done[seeker]++];
  return number != NULL ? number[place] : place;
}

/* The game is played again on the table's board, where its keys are others than in the game that was learnt: all nodes
 * and places are there, and what is cleared counts as visited. A game is recorded whole or not at all. */
int qtr_any_start_add(qtr_any_start *any, const qtr_routes *routes, const uint16_t *number) {
  const uint32_t before = any->count;
  QTR_ASSERT(any->begun && !any->finished); /* a game is under way: qtr_any_start_next() said so */
  uint16_t done[QTR_MAX_SEEKERS] = {0};
  qtr_joint joint;
  qtr_joint_start(&joint, &any->board, any->start_of, &any->cleared);
  do {
    const int seeker = qtr_joint_chooser(&joint, &any->board);
    if (seeker == QTR_NOBODY) continue;
    const uint16_t choice = choice_of(routes, number, seeker, done);
    /* Routes lead to places that are left, each once. */
    QTR_ASSERT(choice == QTR_STAND_DOWN || !qtr_places_has(&joint.visited, choice));
    if (add_entry(any, &joint, choice) != QTR_OK) {
      any->count = before;
      return QTR_ERR_SPACE;
    }
    qtr_joint_choose(&joint, &any->board, seeker, choice);
  } while (qtr_joint_chooser(&joint, &any->board) != QTR_NOBODY || qtr_joint_advance(&joint, &any->board, NULL) > 0);
  any->games++;
  return QTR_OK;
}

/* Entries hold no pointers, so a copy is as good as they were. */
void qtr_any_start_move(qtr_any_start *any, uint8_t *entries, size_t room) {
  any->blocks.entries = entries;
  any->blocks.entry_room = room;
}

/* ---- sorting, in place ---- */

/* By key, then rank, then bytes: entries that are equal under this order are the same, so the order is one, whoever
 * sorts. */
static int compare(const qtr_any_start *any, uint32_t i, uint32_t j) {
  const uint32_t size = entry_size(any);
  const uint8_t *a = entry_at(any, i);
  const uint8_t *b = entry_at(any, j);
  const qtr_record_shape shape = record_shape_written(&any->board);
  const int order = record_compare(a, b, &shape);
  if (order != 0) return order;
  if (a[size - 1] != b[size - 1]) return a[size - 1] < b[size - 1] ? -1 : 1;
  return memcmp(a, b, size);
}

/* Through a copy on the stack: the greatest record is known. */
static void swap(const qtr_any_start *any, uint32_t i, uint32_t j) {
  uint8_t entry[QTR_RECORD_BYTES + 1];
  const uint32_t size = entry_size(any);
  memcpy(entry, entry_at(any, i), size);
  memcpy(entry_at(any, i), entry_at(any, j), size);
  memcpy(entry_at(any, j), entry, size);
}

/* Let the entry at `root` sink in the heap of the first `count`: no parent is less than its children then. */
static void sink(const qtr_any_start *any, uint32_t root, uint32_t count) {
  for (uint32_t child; root < count / 2; root = child) {
    child = 2 * root + 1;
    if (child + 1 < count && compare(any, child, child + 1) < 0) child++;
    if (compare(any, root, child) >= 0) return;
    swap(any, root, child);
  }
}

/* Heapsort (Williams 1964): no memory, no recursion, and never slow. */
static void sort(const qtr_any_start *any) {
  for (uint32_t root = any->count / 2; root > 0; root--) sink(any, root - 1, any->count);
  for (uint32_t count = any->count; count > 1; count--) {
    swap(any, 0, count - 1);
    sink(any, 0, count - 1);
  }
}

/* Entries of one state stand together now, the lowest rank first: that one stays. Records are shorter than entries, so
 * the end of those kept never comes past the entry that is read. */
void qtr_any_start_finish(qtr_any_start *any) {
  const qtr_record_shape shape = record_shape_written(&any->board);
  const uint32_t size = shape.bytes;
  uint8_t *end = any->blocks.entries; /* of the records that are kept */
  uint32_t kept = 0;
  sort(any);
  for (uint32_t i = 0; i < any->count; i++) {
    const uint8_t *entry = entry_at(any, i);
    if (kept > 0 && record_compare(entry, end - size, &shape) == 0) continue;
    memmove(end, entry, size);
    end += size;
    kept++;
  }
  any->count = kept;
  any->finished = true;
}

/* The box is left out, and so all of the map is held: robots may start in any cell of it. */
qtr_table_content qtr_any_start_content(const qtr_any_start *any, const qtr_certificate *certificate, uint64_t seed) {
  const qtr_game *game = any->asked.game;
  const qtr_table_content content = {.mission = game->mission,
                                     .board = &any->board,
                                     .probability = game->probability,
                                     .start = any->blocks.start,
                                     .region = any->regions > 0 ? any->blocks.region : NULL,
                                     .records = any->blocks.entries,
                                     .record_count = any->count,
                                     .certificate = certificate,
                                     .seed = seed,
                                     .terms = &game->objective.terms};
  return content;
}

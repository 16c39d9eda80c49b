#include "search/qtable.h"

#include <math.h>
#include <string.h>

#include "model/rounding.h"
#include "quarter/status.h"

#define TAG_BITS 2
#define TAG_MASK 0xC0000000u /* top bits of a stored key's last word: 0 = free slot, else when it was placed */
#define TAG_FIRST 0x40000000u
#define TAG_OTHER 0x80000000u
#define FIRST_SLOTS 1024u
#define SHARE 4096u /* slots cleared or swept at a time while the table grows */
#define VALUE_WORDS_MAX 2
#define ENTRY_WORDS_MAX (QTR_KEY_WORDS + 1 + VALUE_WORDS_MAX)

/* Memory asked for ahead, where the compiler can say so. */
#ifdef __GNUC__
#define PREFETCH(address) __builtin_prefetch(address)
#else
#define PREFETCH(address) ((void)(address))
#endif

/* A stored key and its value, as they lie in a slot. */
typedef struct {
  uint32_t word[ENTRY_WORDS_MAX];
} entry;

static unsigned stored_words(const qtr_qtable *table) {
  return (unsigned)table->entry_words - table->value_words;
}

static uint32_t slot_tag(const qtr_qtable *table, const uint32_t *slot) {
  return slot[stored_words(table) - 1] & TAG_MASK;
}

static uint32_t *slot_at(qtr_qtable *table, uint32_t slot) {
  return table->word + (size_t)slot * table->entry_words;
}

static const uint32_t *slot_read(const qtr_qtable *table, uint32_t slot) {
  return table->word + (size_t)slot * table->entry_words;
}

/* Doubles where floats would keep a gap open (QTR_FLOAT_GAP). */
static bool is_precise(const qtr_qtable *table) {
  return table->value_words == VALUE_WORDS_MAX;
}

static double load_value(const qtr_qtable *table, const uint32_t *slot) {
  double value;
  float single;
  if (is_precise(table)) {
    memcpy(&value, &slot[stored_words(table)], sizeof value);
    return value;
  }
  memcpy(&single, &slot[stored_words(table)], sizeof single);
  return (double)single;
}

static void store_value(const qtr_qtable *table, uint32_t *slot, double value) {
  const float single = (float)value;
  if (is_precise(table))
    memcpy(&slot[stored_words(table)], &value, sizeof value);
  else
    memcpy(&slot[stored_words(table)], &single, sizeof single);
}

/* A key's words are as many as its bits take; with the tag's two bits that can be one word more. */
static uint32_t last_word(const qtr_qtable *table, const qtr_key *key) {
  const uint32_t last = stored_words(table) > table->key_words ? 0 : key->word[table->key_words - 1];
  /* Keys are below 2^bits: the bits above, where the tag goes, are free. */
  QTR_ASSERT((last & TAG_MASK) == 0);
  return last | table->tag;
}

static void make_entry(const qtr_qtable *table, entry *made, const qtr_key *key, double value) {
  memcpy(made->word, key->word, table->key_words * sizeof(uint32_t));
  made->word[stored_words(table) - 1] = last_word(table, key);
  store_value(table, made->word, value);
}

/* Murmur3's mixing, on a key's words without its tag. Where an entry lies decides how long it is sought and nothing
 * else, so no run depends on the hash. */
static inline uint32_t hash_words(const qtr_qtable *table, const uint32_t *word) {
  uint32_t hash = 0x9E3779B9u;
  for (unsigned w = 0; w < table->key_words; w++) {
    uint32_t k = word[w];
    if (w + 1 == stored_words(table)) k &= ~TAG_MASK;
    k *= 0xCC9E2D51u;
    k = k << 15 | k >> 17;
    hash ^= k * 0x1B873593u;
    hash = (hash << 13 | hash >> 19) * 5u + 0xE6546B64u;
  }
  hash = (hash ^ hash >> 16) * 0x85EBCA6Bu;
  hash = (hash ^ hash >> 13) * 0xC2B2AE35u;
  return hash ^ hash >> 16;
}

/* hash / 2^32 of the way through the slots: any number of them will do, and where an entry lies in a table twice as
 * large is about twice as far. */
static uint32_t home_slot(const qtr_qtable *table, const uint32_t *word) {
  return (uint32_t)((uint64_t)hash_words(table, word) * table->slots >> 32);
}

static uint32_t after(const qtr_qtable *table, uint32_t slot) {
  return slot + 1 < table->slots ? slot + 1 : 0;
}

static uint32_t slots_in(const qtr_qtable *table, size_t words) {
  return (uint32_t)((words < QTR_QTABLE_WORDS ? words : QTR_QTABLE_WORDS) / table->entry_words);
}

int qtr_qtable_move(qtr_qtable *table, uint32_t *word, size_t words) {
  const uint32_t slots = slots_in(table, words);
  if (word == NULL || slots < table->slots) return QTR_ERR_SPACE;
  table->word = word;
  table->slots_limit = slots;
  return QTR_OK;
}

/* It begins small and doubles, so that a small game touches few pages. */
void qtr_qtable_init(qtr_qtable *table, uint32_t *word, size_t words, const qtr_key_shape *keys, bool precise) {
  table->key_words = keys->words;
  table->value_words = precise ? VALUE_WORDS_MAX : 1;
  table->entry_words = (uint8_t)((keys->bits + TAG_BITS + 31) / 32 + table->value_words);
  table->entries = 0;
  table->refused = 0;
  table->word = word;
  table->slots_limit = slots_in(table, words);
  table->slots = table->slots_limit < FIRST_SLOTS ? table->slots_limit : FIRST_SLOTS;
  table->before = table->cleared = table->swept = 0;
  table->tag = TAG_FIRST;
  memset(table->word, 0, (size_t)table->slots * table->entry_words * sizeof(uint32_t));
}

uint32_t qtr_qtable_entry_bytes(const qtr_qtable *table) {
  return table->entry_words * (uint32_t)sizeof(uint32_t);
}

static bool is_growing(const qtr_qtable *table) {
  return table->swept < table->before;
}

/* Whether a stored key is above (1), equal to (0) or below (-1) another one. As numbers, the tag on top: a free slot is
 * below them all. */
static inline int order_of(const qtr_qtable *table, const uint32_t *slot, const uint32_t *word, uint32_t last) {
  unsigned w = stored_words(table) - 1;
  if (slot[w] != last) return slot[w] > last ? 1 : -1;
  while (w-- > 0)
    if (slot[w] != word[w]) return slot[w] > word[w] ? 1 : -1;
  return 0;
}

static void mark_moved(const qtr_qtable *table, entry *moved) {
  uint32_t *last = &moved->word[stored_words(table) - 1];
  *last = (*last & ~TAG_MASK) | table->tag;
}

/* The first slot from this one on that holds no entry already moved, or one below. */
static uint32_t place_for(const qtr_qtable *table, const entry *moved, uint32_t slot) {
  const uint32_t last = moved->word[stored_words(table) - 1];
  while (slot_tag(table, slot_read(table, slot)) == table->tag &&
         order_of(table, slot_read(table, slot), moved->word, last) > 0)
    slot = after(table, slot);
  return slot;
}

static void exchange(const qtr_qtable *table, entry *moved, uint32_t *slot) {
  for (unsigned w = 0; w < table->entry_words; w++) {
    const uint32_t out = slot[w];
    slot[w] = moved->word[w];
    moved->word[w] = out;
  }
}

/* Put an entry where it belongs, then what lay there, and so on up to a free slot. What has been moved already goes on
 * from where it lay, all else from its home. */
static void place_entry(qtr_qtable *table, entry *moved) {
  uint32_t tag = 0;
  uint32_t slot = 0;
  do {
    if (tag != table->tag) slot = home_slot(table, moved->word);
    mark_moved(table, moved);
    slot = place_for(table, moved, slot);
    exchange(table, moved, slot_at(table, slot));
    tag = slot_tag(table, moved->word);
  } while (tag != 0);
}

/* The last time by less than twice, up to what the block holds. */
static uint32_t doubled(uint32_t slots, uint32_t limit) {
  return slots <= limit / 2 ? slots * 2 : limit;
}

/* Entries from which on a table of so many slots doubles. */
static uint32_t crowded(uint32_t slots) {
  return slots / 8 * 7;
}

/* As the table itself will grow: by doubling while it is crowded, and no further than the largest table of this
 * build. */
size_t qtr_qtable_needs(const qtr_qtable *table, uint32_t more) {
  const uint32_t most = slots_in(table, QTR_QTABLE_WORDS);
  uint32_t slots = table->slots;
  while (slots < most && table->entries + more >= crowded(slots)) slots = doubled(slots, most);
  return (size_t)slots * table->entry_words;
}

/* Twice the slots, in place: entries are moved one by one to where they belong now, each taking the next one out that
 * lies in its way; the tag tells which have been moved. */
static void begin_growth(qtr_qtable *table) {
  table->before = table->cleared = table->slots;
  table->swept = 0;
  table->slots = doubled(table->before, table->slots_limit);
  table->tag = table->tag == TAG_FIRST ? TAG_OTHER : TAG_FIRST;
}

static void sweep(qtr_qtable *table, uint32_t slot) {
  const uint32_t tag = slot_tag(table, slot_read(table, slot));
  entry moved;
  if (tag == 0 || tag == table->tag) return;
  memcpy(moved.word, slot_read(table, slot), table->entry_words * sizeof(uint32_t));
  slot_at(table, slot)[stored_words(table) - 1] = 0;
  place_entry(table, &moved);
}

/* All new slots are free before the first entry is moved, for it may come to lie anywhere. */
static void grow_on(qtr_qtable *table) {
  const uint32_t left = table->slots - table->cleared;
  const uint32_t share = left < SHARE ? left : SHARE;
  memset(slot_at(table, table->cleared), 0, (size_t)share * table->entry_words * sizeof(uint32_t));
  table->cleared += share;
  for (uint32_t i = share; i < SHARE && is_growing(table); i++) sweep(table, table->swept++);
}

bool qtr_qtable_make_room(qtr_qtable *table, uint32_t more) {
  if (!is_growing(table)) {
    if (table->slots == table->slots_limit || table->entries + more < crowded(table->slots)) return false;
    begin_growth(table);
  }
  grow_on(table);
  return true;
}

uint32_t qtr_qtable_hash(const qtr_qtable *table, const qtr_key *key) {
  return hash_words(table, key->word);
}

uint32_t qtr_qtable_home(const qtr_qtable *table, const qtr_key *key) {
  const uint32_t home = home_slot(table, key->word);
  PREFETCH(slot_read(table, home));
  return home;
}

/* Linear probing, which reads memory in order. From its home to where it lies an entry has none below it in its way
 * (Amble and Knuth, Ordered hash tables), so that the first one below ends a search in vain, and most are in vain.
 * Between two growths every entry has the table's tag, so key and tag are compared at once. */
static bool find(const qtr_qtable *table, const qtr_key *key, uint32_t home, uint32_t *slot) {
  const uint32_t last = last_word(table, key);
  /* Every entry lies where it is sought. */
  QTR_ASSERT(!is_growing(table));
  /* Some slot is free, or a search for a key that is not there would go round for ever. */
  QTR_ASSERT(table->entries < table->slots);
  uint32_t at = home;
  int order;
  while ((order = order_of(table, slot_read(table, at), key->word, last)) > 0) at = after(table, at);
  *slot = at;
  return order == 0;
}

bool qtr_qtable_get_from(const qtr_qtable *table, const qtr_key *key, uint32_t home, double *value) {
  uint32_t slot;
  if (!find(table, key, home, &slot)) return false;
  *value = load_value(table, slot_read(table, slot));
  return true;
}

bool qtr_qtable_get(const qtr_qtable *table, const qtr_key *key, double *value) {
  return qtr_qtable_get_from(table, key, home_slot(table, key->word), value);
}

double qtr_qtable_nearest(const qtr_qtable *table, double value) {
  return is_precise(table) ? value : (double)(float)value;
}

/* The least float that is not below: Q >= Q* must hold of what is stored. */
double qtr_qtable_round_up(const qtr_qtable *table, double value) {
  if (is_precise(table)) return value;
  const float nearest = (float)value;
  const float rounded = (double)nearest < value ? nextafterf(nearest, HUGE_VALF) : nearest;
  /* Q >= Q* outlives being stored. */
  QTR_ASSERT((double)rounded >= value);
  return (double)rounded;
}

/* Up to 7/8 full before it grows, and 15/16 where it cannot: a search then looks at (1 + 16) / 2 slots (Knuth). */
static bool add(qtr_qtable *table, const qtr_key *key, double value) {
  entry made;
  uint32_t slot;
  if (table->entries >= crowded(table->slots) && table->slots < table->slots_limit) {
    begin_growth(table);
    while (is_growing(table)) grow_on(table);
    /* Growing moves entries, and makes and loses none. */
    QTR_ASSERT(!find(table, key, home_slot(table, key->word), &slot));
  }
  if (table->entries + 1 >= table->slots - table->slots / 16) {
    table->refused++;
    return false;
  }
  table->entries++;
  make_entry(table, &made, key, value);
  place_entry(table, &made);
  return true;
}

bool qtr_qtable_set(qtr_qtable *table, const qtr_key *key, double value) {
  uint32_t slot;
  if (!find(table, key, home_slot(table, key->word), &slot)) return add(table, key, value);
  store_value(table, slot_at(table, slot), value);
  return true;
}

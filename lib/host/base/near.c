#include "host/base/near.h"

#include <stdbool.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>

#define LONGEST 31

static int least(int a, int b) {
  return a < b ? a : b;
}

/* Damerau's distance (neighbours swapped count one) of words of up to LONGEST letters. */
static int distance(const char *a, const char *b) {
  int table[LONGEST + 1][LONGEST + 1];
  int m = (int)strlen(a), n = (int)strlen(b);
  for (int i = 0; i <= m; i++) {
    for (int j = 0; j <= n; j++) {
      if (i == 0 || j == 0) {
        table[i][j] = i + j;
        continue;
      }
      int changed = table[i - 1][j - 1] + (a[i - 1] != b[j - 1]);
      table[i][j] = least(changed, 1 + least(table[i - 1][j], table[i][j - 1]));
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        table[i][j] = least(table[i][j], table[i - 2][j - 2] + 1);
      }
    }
  }
  return table[m][n];
}

/* How far apart the words are, as a slip; a large number if they are too far. */
static int slip(const char *word, const char *known, bool by_start) {
  size_t length = strlen(known), given = strlen(word), common = length < given ? length : given;
  if (strcasecmp(word, known) == 0) return 0;
  if (length > LONGEST) return LONGEST;
  int allowed = length <= 2 ? 0 : length <= 5 ? 1 : 2;
  int apart = distance(word, known);
  if (apart <= allowed) return apart;
  return by_start && common >= 3 && strncmp(word, known, common) == 0 ? LONGEST - 1 : LONGEST;
}

static const char *nearest(const char *word, const char *const known[], bool by_start) {
  const char *best = NULL;
  int best_slip = LONGEST;
  if (strlen(word) > LONGEST) return NULL;
  for (int i = 0; known[i] != NULL; i++) {
    int apart = slip(word, known[i], by_start);
    if (apart >= best_slip) continue;
    best = known[i];
    best_slip = apart;
  }
  return best;
}

const char *near_word(const char *word, const char *const known[]) {
  return nearest(word, known, true);
}

const char *near_slip(const char *word, const char *const known[]) {
  return nearest(word, known, false);
}

/* The words with commas between, and `last` before the last one. */
static void join(char *out, size_t size, const char *const words[], const char *last) {
  size_t used = 0;
  out[0] = '\0';
  for (int i = 0; words[i] != NULL && used < size; i++) {
    const char *joint = i == 0 ? "" : words[i + 1] == NULL ? last : ", ";
    int wrote = snprintf(out + used, size - used, "%s%s", joint, words[i]);
    used += wrote > 0 ? (size_t)wrote : 0;
  }
}

void near_list(char *out, size_t size, const char *const words[]) {
  join(out, size, words, " and ");
}

void near_choice(char *out, size_t size, const char *const words[]) {
  join(out, size, words, " or ");
}

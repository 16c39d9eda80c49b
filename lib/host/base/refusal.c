#include "host/base/refusal.h"

#include <stdbool.h>
#include <stdio.h>
#include <string.h>

#include "host/base/near.h"

#define KNOWN_MOST 128
#define WORD_SIZE 40

/* "learn: no such option '-x'; 'quarter learn --help' shows what there is" */
static int say(const char *command, const char *word, const char *what, fault *why) {
  if (command == NULL) return fault_set(why, "%s '%.200s'; --help shows what there is", what, word);
  return fault_set(why, "%s: %s '%.200s'; 'quarter %s --help' shows what there is", command, what, word, command);
}

static int refuse_long(const char *command, const char *word, const struct option *longs, fault *why) {
  const char *known[KNOWN_MOST + 1];
  char name[WORD_SIZE];
  const size_t length = strcspn(word + 2, "=");
  int count = 0;
  for (; longs[count].name != NULL && count < KNOWN_MOST; count++) {
    known[count] = longs[count].name;
    const bool same = strlen(known[count]) == length && strncmp(known[count], word + 2, length) == 0;
    if (same && word[2 + length] == '=') return say(command, word, "a value that is not wanted in", why);
  }
  known[count] = NULL;
  snprintf(name, sizeof name, "%.*s", length < WORD_SIZE ? (int)length : WORD_SIZE - 1, word + 2);
  const char *meant = near_word(name, known);
  if (meant == NULL) return say(command, word, "no such option", why);
  return fault_set(why, "%s%sno such option '%.200s'; did you mean --%s?", command != NULL ? command : "",
                   command != NULL ? ": " : "", word, meant);
}

int refuse_option(const char *command, int code, const char *word, const struct option *longs, fault *why) {
  const bool is_long = strncmp(word, "--", 2) == 0;
  const char letter[3] = {'-', (char)optopt, '\0'};
  if (!is_long && optopt > ' ' && optopt < 127) word = letter;
  if (code == ':') return say(command, word, "no value after", why);
  return is_long ? refuse_long(command, word, longs, why) : say(command, word, "no such option", why);
}

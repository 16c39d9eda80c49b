/* The word that the user may have meant. */
#ifndef QUARTER_HOST_NEAR_H
#define QUARTER_HOST_NEAR_H

#include <stddef.h>

/* The word of `known` (ended by NULL) that `word` is likely a slip of: another case, the start or an extension of it,
 * or one letter (two in a long word) left out, added, changed or swapped with its neighbour. NULL if there is none. */
const char *near_word(const char *word, const char *const known[]);

/* The same of letters alone: not for having the same start. */
const char *near_slip(const char *word, const char *const known[]);

/* "a, b and c" into out[size]; "a, b or c". */
void near_list(char *out, size_t size, const char *const words[]);
void near_choice(char *out, size_t size, const char *const words[]);

#endif

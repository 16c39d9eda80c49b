/* Numbers with their nouns: "1 place", "2 places", "0 entries". */
#ifndef QUARTER_HOST_COUNT_H
#define QUARTER_HOST_COUNT_H

#include <stdint.h>

/* By value, so that one call can print several: printf("%s, %s", counted(p, "place").text, counted(k,
 * "robot").text). */
typedef struct {
  char text[64];
} count_text;

count_text counted(uint64_t number, const char *noun);

/* The same for a measure, at six digits. */
count_text measured(double number, const char *noun);

#endif

#include "figures.h"

#include <inttypes.h>
#include <stdio.h>
#include <string.h>

#include "quarter/objective.h"

count_text figures_time(double steps, double step_seconds) {
  count_text told;
  if (step_seconds <= 0.0) return measured(steps, "step");
  snprintf(told.text, sizeof told.text, "%.6g s", steps * step_seconds);
  return told;
}

count_text figures_moment(qtr_steps step, double step_seconds) {
  count_text told;
  if (step_seconds > 0.0)
    snprintf(told.text, sizeof told.text, "step %" PRIu32 ", %.6g s", step, step * step_seconds);
  else
    snprintf(told.text, sizeof told.text, "step %" PRIu32, step);
  return told;
}

const char *figures_late(bool late) {
  return late ? ", after the deadline" : "";
}

count_text figures_places(unsigned places, unsigned looks) {
  count_text told = counted(places, "place");
  const size_t length = strlen(told.text);
  if (looks != places) snprintf(told.text + length, sizeof told.text - length, " (%.30s)", counted(looks, "look").text);
  return told;
}

static bool is_time(uint8_t objective) {
  return qtr_objective_in_words(objective)->unit != NULL;
}

count_text figures_told(uint8_t objective, double figure, double step_seconds) {
  count_text told;
  if (is_time(objective)) return figures_time(figure, step_seconds);
  snprintf(told.text, sizeof told.text, "%.6g", figure);
  return told;
}

double figures_unit(uint8_t objective, double step_seconds) {
  return is_time(objective) && step_seconds > 0.0 ? step_seconds : 1.0;
}

void figures_json_seconds(json *j, const char *key, double steps, double step_seconds) {
  if (step_seconds > 0.0) json_number(j, key, steps * step_seconds);
}

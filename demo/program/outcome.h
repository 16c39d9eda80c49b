/* How a game came out, told as the settings say: text for people, or JSON. */
#ifndef QUARTER_DEMO_OUTCOME_H
#define QUARTER_DEMO_OUTCOME_H

#include "game.h"
#include "plan.h"
#include "settings.h"

/* 0, or -1 with *why set. */
int outcome_print(const plan *p, const game_result *result, const settings *s, fault *why);

#endif

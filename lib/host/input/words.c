#include "host/input/words.h"

#include <stddef.h>

#include "quarter/environment.h"
#include "quarter/explore.h"
#include "quarter/joint.h"
#include "quarter/learner.h"

const char *const words_rule[] = {[QTR_RULE_FREE] = "free", [QTR_RULE_PAPER] = "paper", NULL};
const char *const words_unknown[] = {"blocked", "free", NULL};
const char *const words_setting[] = {[QTR_SETTING_CERTIFIED] = "certified", [QTR_SETTING_PAPER] = "paper", NULL};
const char *const words_exploration[] = {
    [QTR_EXPLORE_UNIFORM] = "uniform", [QTR_EXPLORE_EPSILON] = "epsilon", [QTR_EXPLORE_SOFTMAX] = "softmax", NULL};
const char *const words_region_times[] = {[QTR_TIMES_STANDING] = "representative", [QTR_TIMES_TRUE] = "true", NULL};
const char *const words_spot_order[] = {[QTR_SPOT_BEST] = "best", [QTR_SPOT_NEAREST] = "nearest", NULL};

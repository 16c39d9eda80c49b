/* The learner side whole, and the robot side under it: from a mission to a policy table. Link quarter::learn. */
#ifndef QUARTER_LEARN_H
#define QUARTER_LEARN_H

#include "quarter/any_start.h"
#include "quarter/belief.h"
#include "quarter/environment.h"
#include "quarter/explore.h"
#include "quarter/export.h"
#include "quarter/game.h"
#include "quarter/learner.h"
#include "quarter/mission.h"
#include "quarter/objective.h"
#include "quarter/play.h"
#include "quarter/random.h"
#include "quarter/regions.h"
#include "quarter/rest.h"
#include "quarter/robot.h"
#include "quarter/spots.h"
#include "quarter/start_regions.h"
#include "quarter/start_trials.h"
#include "quarter/travel.h"
#include "quarter/watch.h"
#include "quarter/writer.h"

#endif

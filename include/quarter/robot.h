/* The robot side whole: open a policy table, execute it. Integers only, no heap; link quarter::robot. */
#ifndef QUARTER_ROBOT_H
#define QUARTER_ROBOT_H

#include "quarter/board.h"
#include "quarter/claim.h"
#include "quarter/config.h"
#include "quarter/deployment.h"
#include "quarter/digest.h"
#include "quarter/division.h"
#include "quarter/field.h"
#include "quarter/grid.h"
#include "quarter/joint.h"
#include "quarter/key.h"
#include "quarter/names.h"
#include "quarter/nominal.h"
#include "quarter/places.h"
#include "quarter/policy.h"
#include "quarter/seeker.h"
#include "quarter/signal.h"
#include "quarter/status.h"
#include "quarter/terms.h"

#endif

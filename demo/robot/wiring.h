/* A robot's two mouths and three ears: all by which it is joined to the bus. */
#ifndef QUARTER_DEMO_WIRING_H
#define QUARTER_DEMO_WIRING_H

#include "bus.h"
#include "robot.h"

/* A voice that speaks on the bus. */
robot_voice wiring_voice(bus *b);

/* From now on the robot hears its own pose and scan, and TERMINATE. It must outlive the bus's use. */
void wiring_listen(bus *b, robot *r);

#endif

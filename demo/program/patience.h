/* How long the programs of one game wait for one another, on a clock that only goes forward, and how they say that it
 * was in vain. */
#ifndef QUARTER_DEMO_PATIENCE_H
#define QUARTER_DEMO_PATIENCE_H

#define PATIENCE_GATHER 15.0 /* seconds: a robot for a world to show itself, a world for all robots to answer */
#define PATIENCE_SILENCE 5.0 /* seconds without a word of the world after which a robot leaves */
#define PATIENCE_END 5.0     /* seconds for a world that knows that it is without robots to end by itself */

enum { EXIT_BROKEN_OFF = 3 }; /* exit status: world and robots lost one another before the game was over */

#endif

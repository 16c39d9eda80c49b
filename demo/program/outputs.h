/* The files that a game is to write, looked at before it begins. */
#ifndef QUARTER_DEMO_OUTPUTS_H
#define QUARTER_DEMO_OUTPUTS_H

#include "settings.h"

/* Each can be written, none is another one or an input. 0, or -1 with *why set; what is there stays as it was. */
int outputs_check(const settings *s, fault *why);

/* Once the mission is read: that none is a file which it names, such as its map. 0, or -1 with *why set. */
int outputs_spare_read(const settings *s, fault *why);

#endif

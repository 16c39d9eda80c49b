/* The names of the channels, all of them. A robot's channels carry its number, counted from 0. */
#ifndef QUARTER_DEMO_CHANNELS_H
#define QUARTER_DEMO_CHANNELS_H

#define CHANNEL_PREFIX "QUARTER_"
#define CHANNEL_POSE "QUARTER_R%d_POSE"       /* world to robot */
#define CHANNEL_SCAN "QUARTER_R%d_SCAN"       /* world to robot */
#define CHANNEL_COMMAND "QUARTER_R%d_COMMAND" /* robot to world */
#define CHANNEL_TERMINATE "QUARTER_TERMINATE" /* robot to robots */
#define CHANNEL_STATUS "QUARTER_STATUS"       /* world to viewers */
#define CHANNEL_SIZE 40                       /* bytes that a name takes at most */

#endif

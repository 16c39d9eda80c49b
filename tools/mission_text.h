/* A mission as one begins to write it: all keys, told of by their own records, those that may be left out as
 * comments. */
#ifndef QUARTER_TOOLS_MISSION_TEXT_H
#define QUARTER_TOOLS_MISSION_TEXT_H

#include <stdio.h>

#include "host/input/input.h"

typedef struct {
  const input *in;  /* its map, and the robots and places that it is to begin with */
  const char *name; /* the mission's file, for the commands in its head */
  const char *map;  /* as it names its map */
  bool ros;         /* a ROS map */
  bool own_robots;  /* they are what the map marks, not a proposal; so are the places */
  bool own_places;
} mission_text;

void mission_text_write(FILE *out, const mission_text *text);

#endif

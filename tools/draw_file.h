/* A picture's file: SVG, or PNG and PDF made of it. */
#ifndef QUARTER_TOOLS_DRAW_FILE_H
#define QUARTER_TOOLS_DRAW_FILE_H

#include "draw_input.h"
#include "draw_render.h"
#include "host/base/fault.h"
#include "host/input/input.h"

/* The map of an input, its places and starts, in the caller's arrays; the rest of *d stays. Everything in it points
 * into *in and the arrays, which must last. */
void draw_of_input(drawing *d, const input *in, drawing_seeker seekers[QTR_MAX_SEEKERS]);

/* By `format`, or, where that is NULL, as the path ends; one that ends in no way that is known is an SVG. -1 with *why
 * set: no such format, or a name that promises another one; `option` is the one that gave the path. */
int draw_file_form(enum draw_form *form, const char *option, const char *path, const char *format, fault *why);

/* Write the picture, whole or not at all. `what` names it for faults. 0, or -1 with *why set. */
int draw_file_write(const drawing *d, const char *what, const char *path, enum draw_form form, fault *why);

#endif

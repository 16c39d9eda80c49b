/* A picture as PNG or PDF. librsvg and cairo are behind it, and only here; they are loaded when one is drawn. */
#ifndef QUARTER_TOOLS_DRAW_RENDER_H
#define QUARTER_TOOLS_DRAW_RENDER_H

#include <stddef.h>
#include <stdio.h>

#include "host/base/fault.h"

/* In the order of draw_forms. */
enum draw_form { DRAW_SVG, DRAW_PNG, DRAW_PDF };

/* Names of the forms, which are files' endings too. Ended by NULL. */
extern const char *const draw_forms[];

/* Draw SVG text as PNG, two pixels to one of the picture, or as PDF, a point to a pixel. Nothing in it tells when.
 * 0, or -1 with *why set: what must be installed, where the libraries were not there when Quarter was built or are not
 * there now. */
int draw_render(FILE *out, const char *svg, size_t length, enum draw_form form, fault *why);

#endif

/* Text in XML: pictures, tracks. */
#ifndef QUARTER_HOST_XML_H
#define QUARTER_HOST_XML_H

#include <stdio.h>

/* Text with what XML reserves escaped and what it cannot hold replaced; cut after `most` characters. */
void xml_text(FILE *out, const char *text, int most);

#endif

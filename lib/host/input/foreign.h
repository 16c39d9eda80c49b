/* Files of other trades that users try: named as what they are, with what can be read instead. */
#ifndef QUARTER_HOST_FOREIGN_H
#define QUARTER_HOST_FOREIGN_H

#include "host/base/file.h"

/* "a GeoJSON, which is not read; ..." for a message behind "is" or "'map' names"; NULL if the contents are nothing that
 * is known here. */
const char *foreign_what(const file_bytes *bytes);

#endif

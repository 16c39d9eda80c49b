/* Settings come from their default: each such struct has a `made` that its _default() sets and its _check() looks at.
 * Memory that nobody set, or fields that a caller has never heard of, are refused instead of taken for settings. */
#ifndef QUARTER_MODEL_SETTINGS_H
#define QUARTER_MODEL_SETTINGS_H

#include <stdint.h>

#define SETTINGS_MADE ((uint32_t)0x4D616465)

#endif

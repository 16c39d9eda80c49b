/* A seal on termination signals, for a bus that strangers reach: a tag over a message's bytes, by a key that the whole
 * team holds and nobody else. Keyed BLAKE2b of libsodium; seal.c is the only file that includes it. It keeps forgers
 * out, not who repeats what was said in this run: that is still true. */
#ifndef QUARTER_DEMO_SEAL_H
#define QUARTER_DEMO_SEAL_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "host/base/fault.h"

enum { SEAL_TAG = 16, SEAL_KEY = 32 }; /* bytes */

typedef struct {
  uint8_t key[SEAL_KEY];
} seal;

/* Read a key: a file of 32 bytes or more, of whatever kind, that its owner alone may read. 0, or -1 with *why set;
 * always so where this build is without libsodium. */
int seal_read(seal *s, const char *path, fault *why);

void seal_tag(const seal *s, const uint8_t *bytes, size_t size, uint8_t tag[SEAL_TAG]);

/* Forget a key: nothing of it is left in *s. */
void seal_wipe(seal *s);

/* Whether the tag is that of these bytes: it takes as long for every tag. */
bool seal_holds(const seal *s, const uint8_t *bytes, size_t size, const uint8_t tag[SEAL_TAG]);

#endif

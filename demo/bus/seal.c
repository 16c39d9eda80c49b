#include "seal.h"

#ifdef QUARTER_HAVE_SODIUM

#include <sodium.h>
#include <sys/stat.h>

#include "host/base/file.h"

#define KEY_FILE_MOST 4096 /* bytes */

static int check_owner(const char *path, fault *why) {
  struct stat about;
  if (stat(path, &about) == 0 && (about.st_mode & (S_IRWXG | S_IRWXO)) == 0) return 0;
  return fault_set(why, "%s: others than its owner can get at this key; make a new one that they cannot: chmod 600 %s",
                   path, path);
}

int seal_read(seal *s, const char *path, fault *why) {
  file_bytes bytes;
  if (sodium_init() < 0) return fault_set(why, "%s: libsodium finds no random numbers on this machine", path);
  if (file_read(&bytes, path, KEY_FILE_MOST, NULL, why) != 0) return -1;
  int status = check_owner(path, why);
  if (status == 0 && bytes.size < SEAL_KEY)
    status = fault_set(why, "%s: a key has %d bytes or more, and this file %zu; make one: head -c 32 /dev/urandom >%s",
                       path, SEAL_KEY, bytes.size, path);
  if (status == 0) crypto_generichash(s->key, sizeof s->key, bytes.data, bytes.size, NULL, 0);
  sodium_memzero(bytes.data, bytes.size);
  file_free(&bytes);
  return status;
}

void seal_wipe(seal *s) {
  sodium_memzero(s, sizeof *s);
}

void seal_tag(const seal *s, const uint8_t *bytes, size_t size, uint8_t tag[SEAL_TAG]) {
  crypto_generichash(tag, SEAL_TAG, bytes, size, s->key, sizeof s->key);
}

bool seal_holds(const seal *s, const uint8_t *bytes, size_t size, const uint8_t tag[SEAL_TAG]) {
  uint8_t own[SEAL_TAG];
  seal_tag(s, bytes, size, own);
  return sodium_memcmp(own, tag, SEAL_TAG) == 0;
}

#else

#include <string.h>

int seal_read(seal *s, const char *path, fault *why) {
  (void)s;
  return fault_set(why,
                   "--key %s: this build is without libsodium, which seals signals; install libsodium-dev, then "
                   "configure and build again",
                   path);
}

void seal_wipe(seal *s) {
  (void)s;
}

void seal_tag(const seal *s, const uint8_t *bytes, size_t size, uint8_t tag[SEAL_TAG]) {
  (void)s;
  (void)bytes;
  (void)size;
  memset(tag, 0, SEAL_TAG);
}

bool seal_holds(const seal *s, const uint8_t *bytes, size_t size, const uint8_t tag[SEAL_TAG]) {
  (void)s;
  (void)bytes;
  (void)size;
  (void)tag;
  return false;
}

#endif

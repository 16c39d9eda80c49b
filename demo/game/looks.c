#include "looks.h"

#include "rng.h"

#define SALT UINT64_C(0x4C4F4F4B5341474E) /* other numbers than those that the game's noise is drawn from */

bool looks_find(uint64_t seed, int n, double detection) {
  rng dice;
  if (detection >= 1.0) return true;
  rng_seed(&dice, seed ^ SALT);
  for (int i = 1; i < n; i++) rng_next(&dice);
  return rng_unit(&dice) < detection;
}

int looks_needed(uint64_t seed, double detection) {
  int n = 1;
  while (n < LOOKS_NEVER && !looks_find(seed, n, detection)) n++;
  return n;
}

#include "host/plan/power.h"

#include <math.h>

/* By squaring. */
static double whole_power(double base, double exponent) {
  double power = 1.0;
  for (; exponent >= 1.0; exponent = floor(exponent / 2.0)) {
    if (fmod(exponent, 2.0) == 1.0) power *= base;
    base *= base;
  }
  return power;
}

/* Digit by digit of the binary fraction, base^(1/2), base^(1/4) and so on: products and roots are rounded alike by all
 * that follow IEEE 754. Each root halves what the one before was wrong by. */
double power_of(double base, double exponent) {
  const double whole = floor(exponent);
  double rest = exponent - whole, root = base, power = whole_power(base, whole);
  while (rest > 0.0) {
    root = sqrt(root);
    rest *= 2.0;
    if (rest < 1.0) continue;
    power *= root;
    rest -= 1.0;
  }
  return power;
}

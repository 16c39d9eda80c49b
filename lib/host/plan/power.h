/* A discount to a power that need not be whole, alike to the last bit wherever it is computed: pow() is not. */
#ifndef QUARTER_HOST_POWER_H
#define QUARTER_HOST_POWER_H

/* base^exponent for 0 < base < 1 and an exponent from 0 to 1e7. Base itself for 1. */
double power_of(double base, double exponent);

#endif

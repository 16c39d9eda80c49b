/* What users call the settings of a mission and of its learning: in mission files, on command lines, in reports;
 * objectives bring their own (qtr_objective_names). Each list is in the order of its enum and ended by NULL. */
#ifndef QUARTER_HOST_WORDS_H
#define QUARTER_HOST_WORDS_H

extern const char *const words_rule[];         /* enum qtr_rule */
extern const char *const words_unknown[];      /* enum input_unknown */
extern const char *const words_setting[];      /* enum qtr_setting */
extern const char *const words_exploration[];  /* enum qtr_exploration */
extern const char *const words_region_times[]; /* enum qtr_region_times */
extern const char *const words_spot_order[];   /* enum qtr_spot_order */

#endif

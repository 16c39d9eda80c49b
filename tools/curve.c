#include "curve.h"

#include <inttypes.h>

static void write_row(curve *c, const qtr_learner *learner, const qtr_certificate *certificate) {
  fprintf(c->out.file, "%" PRIu64 ",%.9g,%.9g,%.9g,%.9g,%" PRIu64 ",%" PRIu32 "\n", certificate->episodes,
          certificate->max_q, certificate->value, certificate->expected_time, certificate->bound, certificate->updates,
          qtr_learner_entries(learner));
  c->episodes = certificate->episodes;
  c->max_q = certificate->max_q;
  c->value = certificate->value;
}

int curve_begin(curve *c, const char *path, fault *why) {
  *c = (curve){.wanted = path != NULL};
  if (!c->wanted) return 0;
  if (outfile_open(&c->out, path, why) != 0) return -1;
  fputs("episode,max_q,value,expected_time,bound,updates,q_entries\n", c->out.file);
  return 0;
}

void curve_note(curve *c, const qtr_learner *learner, const qtr_certificate *certificate) {
  if (!c->wanted || certificate->episodes == c->episodes) return;
  if (certificate->max_q == c->max_q && certificate->value == c->value &&
      certificate->episodes < c->episodes + (c->episodes + 19) / 20)
    return;
  write_row(c, learner, certificate);
}

int curve_end(curve *c, const qtr_learner *learner, const qtr_certificate *certificate, fault *why) {
  if (!c->wanted) return 0;
  if (certificate->episodes != c->episodes || c->episodes == 0) write_row(c, learner, certificate);
  return outfile_commit(&c->out, why);
}

#include "curve.h"

#include <inttypes.h>

static bool bounds_time(const curve *c) {
  return c->step_seconds > 0.0 && c->objective == QTR_TIME;
}

static void write_row(curve *c, const qtr_learner *learner, const qtr_certificate *certificate) {
  fprintf(c->out.file, "%" PRIu64 ",%.9g,%.9g,%.9g,%.9g,%" PRIu64 ",%" PRIu32, certificate->episodes,
          certificate->max_q, certificate->value, certificate->expected_time, certificate->bound, certificate->updates,
          qtr_learner_entries(learner));
  if (c->step_seconds > 0.0) fprintf(c->out.file, ",%.9g", certificate->expected_time * c->step_seconds);
  if (bounds_time(c)) fprintf(c->out.file, ",%.9g", certificate->bound * c->step_seconds);
  fputc('\n', c->out.file);
  c->episodes = certificate->episodes;
  c->max_q = certificate->max_q;
  c->value = certificate->value;
}

int curve_begin(curve *c, const char *path, uint8_t objective, double step_seconds, fault *why) {
  *c = (curve){.wanted = path != NULL, .objective = objective, .step_seconds = step_seconds};
  if (!c->wanted) return 0;
  if (outfile_open(&c->out, path, why) != 0) return -1;
  fprintf(c->out.file, "episode,max_q,value,expected_time,bound,updates,q_entries%s%s\n",
          step_seconds > 0.0 ? ",expected_time_seconds" : "", bounds_time(c) ? ",bound_seconds" : "");
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

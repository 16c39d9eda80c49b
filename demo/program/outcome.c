#include "outcome.h"

#include "host/base/count.h"
#include "host/base/outfile.h"
#include "host/table/certificate.h"
#include "record.h"

static void write_outcome(FILE *out, const plan *p, const game_result *result, const settings *s) {
  json j;
  json_begin(&j, out);
  json_object(&j, NULL);
  json_string(&j, "mission", p->name);
  json_natural(&j, "seed", s->seed);
  json_integer(&j, "robots", p->t.policy.board.seekers);
  json_integer(&j, "mine", result->mine);
  json_number(&j, "pace", game_pace(&p->t));
  json_number(&j, "duration", game_pace(&p->t) * result->duration);
  json_number(&j, "times_real_time", game_pace(&p->t) * result->duration / result->wall_seconds);
  record_result(&j, p, result);
  json_end_object(&j);
}

static void tell_find(FILE *out, const plan *p, const game_result *r) {
  const naming n = table_naming(&p->t);
  const double pace = game_pace(&p->t);
  const qtr_steps step = plan_look_step(p, r->mine, r->looks_needed);
  fprintf(out, "found at place %s after %.1f s, ", naming_place(&n, (unsigned)r->mine).text, pace * r->found_at);
  if (r->looks_needed > 1) fprintf(out, "at look %d, ", r->looks_needed);
  if (step != QTR_NEVER)
    fprintf(out, "planned %.1f s", pace * step * game_step_seconds(&p->t));
  else
    fputs("not planned", out);
}

static void tell_outcome(FILE *out, const plan *p, const game_result *r, const settings *s) {
  const double pace = game_pace(&p->t);
  const table_certificate c = table_certificate_of(&p->t.policy);
  fprintf(out, "%s: %s, %s; the plan is ", p->name, counted(p->t.policy.board.seekers, "robot").text,
          counted((uint64_t)p->places, "place").text);
  certificate_tell(out, c.certified, c.gap, p->negligible);
  fprintf(out, "; expected time to find %.1f s\n", pace * p->expected_step * game_step_seconds(&p->t));
  fprintf(out, "seed %llu: ", (unsigned long long)s->seed);
  if (r->found_at >= 0.0)
    tell_find(out, p, r);
  else
    fprintf(out, "nothing found");
  if (r->all_stopped_at >= 0.0) fprintf(out, "; all stopped at %.1f s", pace * r->all_stopped_at);
  fprintf(out, "\n%s scanned, %d of them twice, %s, %s sent, %.0f times real time\n",
          counted((uint64_t)r->scanned, "place").text, r->duplicates,
          counted((uint64_t)r->collisions, "collision").text,
          counted(r->counts.sent[KIND_TERMINATE], "termination signal").text, pace * r->duration / r->wall_seconds);
  if (s->replay != NULL) fprintf(out, "wrote %s: open it in a web browser\n", s->replay);
  if (s->log != NULL) fprintf(out, "wrote %s\n", s->log);
  if (s->save != NULL) fprintf(out, "wrote %s\n", s->save);
}

int outcome_print(const plan *p, const game_result *result, const settings *s, fault *why) {
  outfile out;
  if (s->json) {
    if (outfile_open(&out, s->json_path != NULL ? s->json_path : "-", why) != 0) return -1;
    write_outcome(out.file, p, result, s);
    if (outfile_commit(&out, why) != 0) return -1;
  }
  if (s->quiet || (s->json && s->json_path == NULL)) return 0;
  if (outfile_open(&out, "-", why) != 0) return -1;
  tell_outcome(out.file, p, result, s);
  return outfile_commit(&out, why);
}

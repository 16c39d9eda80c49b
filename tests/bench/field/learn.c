#include "field/learn.h"

#include <stdlib.h>
#include <time.h>

#include "host/base/memory.h"

/* The processor's time, not the wall's: a machine that others work on as well changes nothing. */
double learn_clock(void) {
  struct timespec now;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static bool goes_on(void *end) {
  return learn_clock() < *(const double *)end;
}

static bool is_better(const qtr_certificate *now, const qtr_certificate *before, bool by_time) {
  return by_time ? now->objective < before->objective : now->objective > before->objective;
}

/* The last point is overwritten until the plan has become better since. */
static void note(learnt *l, const study *s, int setting, double begin) {
  learn_point point;
  const bool by_time = s->p.game->objective.kind == QTR_TIME;
  qtr_learner_certificate(s->learner, &point.certificate);
  point.seconds = learn_clock() - begin;
  /* What it has before its first game it does not show as learnt. */
  if (point.certificate.episodes == 0 && setting == QTR_SETTING_PAPER) return;
  const bool better = l->points == 0 || is_better(&point.certificate, &learnt_end(l)->certificate, by_time);
  if (better && l->points < LEARN_POINTS - 1) l->points++;
  if (better) l->point[l->points - 1] = point;
}

static void note_end(learnt *l, const study *s, double begin) {
  learn_point *end = &l->point[l->points++];
  qtr_learner_certificate(s->learner, &end->certificate);
  end->seconds = learn_clock() - begin;
}

static int take_routes(learnt *l, const study *s, fault *why) {
  const qtr_game *game = s->p.game;
  qtr_routes *routes = memory_take(sizeof *routes, why);
  l->best.length = routes != NULL ? memory_take(game->board.seekers * sizeof *l->best.length, why) : NULL;
  l->best.look = l->best.length != NULL ? memory_take(game->board.places * sizeof *l->best.look, why) : NULL;
  if (l->best.look != NULL) {
    unsigned *at = l->best.look;
    qtr_play_to_routes(qtr_learner_best(s->learner), game, routes);
    for (unsigned robot = 0; robot < game->board.seekers; robot++) {
      l->best.length[robot] = routes->length[robot];
      for (unsigned i = 0; i < routes->length[robot]; i++) *at++ = routes->place[robot][i];
    }
  }
  free(routes);
  return l->best.look != NULL ? 0 : -1;
}

int learn_for(learnt *l, problem_case *made, int setting, double gap, double seconds, fault *why) {
  study *s = made->s;
  const double begin = learn_clock();
  double end = begin + seconds;
  plan_config config;
  plan_config_default(&config);
  config.learner.setting = (uint8_t)setting;
  config.learner.gap = gap;
  s->p.in.mission.watch = (qtr_watch){goes_on, &end};
  *l = (learnt){0};
  int status = study_begin(s, &config, why);
  if (status == 0) {
    do note(l, s, setting, begin);
    while (goes_on(&end) && study_step(s) == QTR_LEARNING);
    note_end(l, s, begin);
    status = take_routes(l, s, why);
  }
  s->p.in.mission.watch = (qtr_watch){0};
  return status;
}

void learnt_drop(learnt *l) {
  free(l->best.length);
  free(l->best.look);
  *l = (learnt){0};
}

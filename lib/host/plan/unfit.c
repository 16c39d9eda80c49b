#include "host/plan/unfit.h"

#include <stdio.h>

#include "host/base/count.h"
#include "host/plan/terms.h"
#include "quarter/status.h"

#define NAME 300

qtr_steps unfit_way(const qtr_game *game, unsigned seeker, unsigned place) {
  const qtr_board *board = &game->board;
  return qtr_board_steps(board, seeker, (unsigned)board->places + board->start_of[seeker], place);
}

/* ---- robots and the time that they have ---- */

/* What a robot's first place asks of it. */
typedef struct {
  int seeker, place;  /* -1: none is in its reach */
  qtr_steps searched; /* step at which it has searched the place */
  qtr_steps away;     /* steps from its ready time until it is home again, where it has endurance */
} outing;

static const qtr_robot_class *class_of(const qtr_mission *mission, int seeker) {
  return &mission->robot_class[mission->class_of[seeker]];
}

/* To the place that is soonest done with. */
static outing nearest_outing(const qtr_game *game, int seeker) {
  const qtr_mission *mission = game->mission;
  const bool tires = class_of(mission, seeker)->endurance != QTR_NEVER;
  outing nearest = {seeker, -1, QTR_NEVER, QTR_NEVER};
  for (int place = 0; place < mission->places; place++) {
    const qtr_steps way = unfit_way(game, (unsigned)seeker, (unsigned)place);
    const qtr_steps home = tires ? qtr_game_way_home(game, (unsigned)seeker, (unsigned)place) : 0;
    if (way == QTR_NEVER || home == QTR_NEVER || way + home >= nearest.away) continue;
    nearest = (outing){seeker, place, mission->ready[seeker] + way, way + home};
  }
  return nearest;
}

static bool is_late(const qtr_mission *mission, const outing *o) {
  return mission->aim.kind == QTR_DEADLINE && o->searched > mission->aim.deadline;
}

static bool is_too_far(const qtr_mission *mission, const outing *o) {
  return o->away > class_of(mission, o->seeker)->endurance;
}

/* "12.5 s", or "25 steps". */
static const char *duration(char out[NAME], const pace *p, qtr_steps steps) {
  if (p->stated)
    snprintf(out, NAME, "%.6g s", steps * p->seconds_per_step);
  else
    snprintf(out, NAME, "%s", counted(steps, "step").text);
  return out;
}

/* What there is, as the mission says it and not as it is rounded. */
static const char *limit(char out[NAME], const input *in, const outing *o, bool far) {
  snprintf(out, NAME, "%.6g s",
           far ? in->terms.of_class[in->mission.class_of[o->seeker]].endurance_seconds : in->terms.deadline_seconds);
  return out;
}

/* "the nearest, place 3 (m.yaml:4), takes it 40 s there and back, and its endurance is 30 s" */
static void tell_outing(char *out, size_t size, const input *in, const pace *p, const outing *o) {
  char place[NAME], takes[NAME], has[NAME];
  const bool far = is_too_far(&in->mission, o);
  input_place_name(in, o->place, place, sizeof place);
  snprintf(out, size,
           far ? "the nearest, %s, takes it %s there and back, and its endurance is %s"
               : "the nearest, %s, is searched after %s, and the deadline is %s",
           place, duration(takes, p, far ? o->away : o->searched), limit(has, in, o, far));
}

void unfit_note(input *in, const qtr_game *game, const pace *p) {
  if (!terms_any(&in->mission)) return;
  for (int seeker = 0; seeker < in->mission.seekers; seeker++) {
    char name[NAME], what[3 * NAME];
    const outing o = nearest_outing(game, seeker);
    input_seeker_name(in, seeker, name, sizeof name);
    if (o.place < 0) {
      notes_add(&in->note, "%s can search no place: there is a way to none that its class may visit", name);
    } else if (is_too_far(&in->mission, &o) || is_late(&in->mission, &o)) {
      tell_outing(what, sizeof what, in, p, &o);
      notes_add(&in->note, "%s can search no place: %s", name, what);
    }
  }
}

/* ---- faults ---- */

/* The robot that lacks least. */
static outing nearest_of_all(const qtr_game *game) {
  outing nearest = {-1, -1, QTR_NEVER, QTR_NEVER};
  for (int seeker = 0; seeker < game->mission->seekers; seeker++) {
    const outing o = nearest_outing(game, seeker);
    if (o.place >= 0 && (nearest.place < 0 || o.searched < nearest.searched)) nearest = o;
  }
  return nearest;
}

static int fault_horizon(const input *in, const qtr_game *game, const pace *p, fault *why) {
  char name[NAME], what[3 * NAME];
  const outing o = nearest_of_all(game);
  if (o.place < 0)
    return fault_set(why, "%s: no robot can come back from any place; mend its start or its class", in->path);
  input_seeker_name(in, o.seeker, name, sizeof name);
  tell_outing(what, sizeof what, in, p, &o);
  return fault_set(why, "%s: nobody can search any place in time: for %s %s; %s", in->path, name, what,
                   is_too_far(&in->mission, &o) ? "raise endurance_seconds"
                                                : "give a later deadline_seconds, or --deadline");
}

static int fault_looks(const input *in, int place, fault *why) {
  char name[NAME];
  input_place_name(in, place, name, sizeof name);
  return fault_set(why, "%s: %s is looked at %d times, and a look at it takes some robots no time; give scan_seconds",
                   in->path, name, in->mission.looks[place]);
}

static int fault_mix(const input *in, int seeker, fault *why) {
  char with[NAME], without[NAME];
  const bool tires = class_of(&in->mission, seeker)->endurance != QTR_NEVER;
  input_seeker_name(in, tires ? seeker : 0, with, sizeof with);
  input_seeker_name(in, tires ? 0 : seeker, without, sizeof without);
  return fault_set(why,
                   "%s: under expected time all robots have endurance or none has: %s has, %s has not; give all of "
                   "them endurance_seconds, or take another objective",
                   in->path, with, without);
}

static int fault_limit(const input *in, int status, fault *why) {
  const qtr_mission *mission = &in->mission;
  int looks = 0;
  for (int place = 0; place < mission->places; place++) looks += mission->looks[place];
  if (looks <= QTR_MAX_PLACES) return fault_set(why, "%s: %s", in->path, qtr_strerror(status));
  return fault_set(why,
                   "%s: %s with their looks are %d, and each look counts as a place: %d are the most that this build "
                   "holds; state fewer looks, or build with a larger QTR_MAX_PLACES",
                   in->path, counted(mission->places, "place").text, looks, QTR_MAX_PLACES);
}

static int fault_start(const input *in, int seeker, fault *why) {
  char name[NAME];
  input_seeker_name(in, seeker, name, sizeof name);
  return fault_set(why,
                   "%s: %s starts on rough ground, which class %s may not enter; move it, or write \"rough: true\"",
                   in->path, name, in->terms.of_class[in->mission.class_of[seeker]].name);
}

int unfit_fault(const input *in, const qtr_game *game, const pace *p, int status, int culprit, fault *why) {
  switch (status) {
  case QTR_ERR_HORIZON: return fault_horizon(in, game, p, why);
  case QTR_ERR_LOOKS: return fault_looks(in, culprit, why);
  case QTR_ERR_CLASS: return fault_mix(in, culprit, why);
  case QTR_ERR_LIMIT: return fault_limit(in, status, why);
  case QTR_ERR_START: return fault_start(in, culprit, why);
  default: break;
  }
  if (status == QTR_ERR_ARGUMENT && in->mission.rule == QTR_RULE_PAPER && terms_any(&in->mission))
    return fault_set(why,
                     "%s: the paper's rule takes no classes, scan times, looks, ready times, endurance, deadline or "
                     "home_weight; write \"rule: free\", or leave --rule out",
                     in->path);
  return fault_set(why, "%s: %s", in->path, qtr_strerror(status));
}

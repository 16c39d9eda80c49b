#include "host/plan/terms.h"

#include <math.h>
#include <stdio.h>

#include "host/base/file.h"
#include "host/plan/power.h"

#define LONGEST_STEP 4000.0 /* seconds: a table counts microseconds in 32 bits */
#define SHORTEST_STEP 0.001 /* that step_seconds takes */
#define CELL_STEPS_MOST 65535u

/* ---- classes ---- */

static bool is_used(const qtr_mission *mission, int of) {
  for (int i = 0; i < mission->seekers; i++)
    if (mission->class_of[i] == of) return true;
  return false;
}

/* A class of nobody would have its part in the length of a step. */
static void drop_unused(input *in) {
  qtr_mission *mission = &in->mission;
  uint8_t kept = 0, now[QTR_MAX_CLASSES] = {0};
  for (int of = 0; of < mission->classes; of++) {
    if (!is_used(mission, of)) {
      if (in->terms.of_class[of].name[0] != '\0')
        notes_add(&in->note, "%s:%d: no robot is of class %s; give one \"class: %s\", or delete it",
                  file_short_path(in->path), in->terms.of_class[of].line, in->terms.of_class[of].name,
                  in->terms.of_class[of].name);
      continue;
    }
    now[of] = kept;
    mission->robot_class[kept] = mission->robot_class[of];
    in->terms.of_class[kept++] = in->terms.of_class[of];
  }
  for (int i = 0; i < mission->seekers; i++) mission->class_of[i] = now[mission->class_of[i]];
  mission->classes = kept;
}

static const char *class_label(const input_class *it, char *out, size_t size) {
  snprintf(out, size, "%s%s", it->name[0] != '\0' ? " of class " : "", it->name);
  return out;
}

/* Without a speed a cell takes a second. */
static double cell_seconds(const input *in, const input_class *it) {
  const double speed = it->speed > 0.0 ? it->speed : in->terms.speed;
  return speed > 0.0 ? in->frame.cell_size / speed : 1.0;
}

/* ---- the step ---- */

static int choose_step(input *in, pace *p, fault *why) {
  qtr_mission *mission = &in->mission;
  double seconds[QTR_MAX_CLASSES];
  uint32_t steps[QTR_MAX_CLASSES];
  char label[QTR_SITE_NAME_BYTES + 16];
  for (int i = 0; i < mission->classes; i++) seconds[i] = cell_seconds(in, &in->terms.of_class[i]);
  pace_choose(p, steps, seconds, mission->classes, in->terms.step_seconds);
  if (p->seconds_per_step > LONGEST_STEP || p->seconds_per_step < 1e-5)
    return file_fault(why, in->path, 0, 0,
                      "a robot%s takes %.6g s for a cell of %g m, and steps are of 0.00001 to %g s; mend its speed",
                      class_label(&in->terms.of_class[0], label, sizeof label), seconds[0], in->frame.cell_size,
                      LONGEST_STEP);
  for (int i = 0; i < mission->classes; i++) {
    if (steps[i] > CELL_STEPS_MOST)
      return file_fault(why, in->path, 0, 0,
                        "a robot%s takes %g s for a cell, %u steps of %g s, and %u are the most; mend its speed, or "
                        "make step_seconds larger",
                        class_label(&in->terms.of_class[i], label, sizeof label), seconds[i], (unsigned)steps[i],
                        p->seconds_per_step, CELL_STEPS_MOST);
    mission->robot_class[i].cell_steps = steps[i];
  }
  mission->step_time_us = p->stated ? (uint32_t)llround(p->seconds_per_step * 1e6) : 0;
  return 0;
}

/* ---- times ---- */

static double scan_seconds(const input_terms *terms, const input_class *it, int place) {
  if (terms->place_scan[place] >= 0.0) return terms->place_scan[place];
  return it->scan_seconds >= 0.0 ? it->scan_seconds : terms->scan_seconds;
}

static void set_class(input *in, pace *p, int of) {
  qtr_robot_class *to = &in->mission.robot_class[of];
  const input_class *it = &in->terms.of_class[of];
  for (int place = 0; place < in->mission.places; place++)
    to->scan[place] = pace_steps_up(p, scan_seconds(&in->terms, it, place));
  if (it->endurance_seconds > 0.0) to->endurance = pace_steps_down(p, it->endurance_seconds);
}

/* Where a look finds all that is there, no other is worth anything. */
static void drop_looks(input *in) {
  qtr_mission *mission = &in->mission;
  int dropped = 0;
  for (int place = 0; place < mission->places; place++) {
    if (mission->detection[place] < 1.0 || mission->looks[place] == 1) continue;
    mission->looks[place] = 1;
    dropped++;
  }
  if (dropped == mission->places)
    notes_add(
        &in->note,
        "%s: several looks are asked for, but the first finds all that is there; state how much a look finds, such "
        "as \"detection: 0.8\"",
        file_short_path(in->path));
}

static int check_ends(const input *in, const pace *p, fault *why) {
  for (int i = 0; i < in->mission.classes; i++)
    if (in->mission.robot_class[i].endurance == 0)
      return file_fault(why, in->path, in->terms.of_class[i].line, 0,
                        "endurance_seconds %g is less than a step of %g s; mend it, or step_seconds",
                        in->terms.of_class[i].endurance_seconds, p->seconds_per_step);
  return 0;
}

/* To one digit: 0.0588 is 0.05. */
static double round_down(double number) {
  const double unit = pow(10.0, floor(log10(number)));
  return fmax(floor(number / unit + 1e-9) * unit, SHORTEST_STEP);
}

static void note_rounding(input *in, const pace *p) {
  const char *path = file_short_path(in->path);
  if (!p->stated) return;
  if (p->rounding > PACE_ROUNDING)
    notes_add(&in->note, "%s: steps of %g s round travel times by up to %.2g %%; a smaller step_seconds is finer", path,
              p->seconds_per_step, 100.0 * p->rounding);
  if (p->end_rounding > PACE_ROUNDING)
    notes_add(&in->note,
              "%s: steps of %g s round scan times and the like by up to %.2g %%; \"step_seconds: %g\" is finer", path,
              p->seconds_per_step, 100.0 * fmin(p->end_rounding, 1.0),
              round_down(p->seconds_per_step / ceil(p->end_rounding / PACE_ROUNDING)));
}

/* ---- the objective ---- */

static int set_aim(input *in, pace *p, fault *why) {
  qtr_aim *aim = &in->mission.aim;
  const char *path = in->path;
  p->gamma = aim->gamma;
  aim->gamma = power_of(p->gamma, p->seconds_per_step);
  if (!(aim->gamma > 0.0 && aim->gamma < 1.0))
    return file_fault(why, path, 0, 0, "gamma %g a second is %g a step of %g s, of which no plan can be made; mend it",
                      p->gamma, aim->gamma, p->seconds_per_step);
  if (aim->kind != QTR_DEADLINE) return 0;
  if (in->terms.deadline_seconds <= 0.0)
    return file_fault(why, path, 0, 0,
                      "a deadline is asked for, and none is given; add \"deadline_seconds: 600\", or --deadline 600");
  aim->deadline = pace_steps_down(p, in->terms.deadline_seconds);
  return 0;
}

int terms_apply(input *in, pace *p, fault *why) {
  qtr_mission *mission = &in->mission;
  *p = (pace){.stated = in->terms.stated};
  drop_unused(in);
  if (choose_step(in, p, why) != 0) return -1;
  for (int i = 0; i < mission->classes; i++) set_class(in, p, i);
  for (int i = 0; i < mission->seekers; i++) mission->ready[i] = pace_steps_up(p, in->terms.ready[i]);
  drop_looks(in);
  if (check_ends(in, p, why) != 0 || set_aim(in, p, why) != 0) return -1;
  note_rounding(in, p);
  return 0;
}

/* ---- what missions have ---- */

static bool takes_scans(const qtr_mission *mission) {
  for (int place = 0; place < mission->places; place++)
    if (mission->robot_class[0].scan[place] > 0) return true;
  return false;
}

static bool misses(const qtr_mission *mission) {
  for (int place = 0; place < mission->places; place++)
    if (mission->detection[place] < 1.0) return true;
  return false;
}

bool terms_depend_on_progress(const qtr_mission *mission) {
  return terms_leave_no_spots(mission) || mission->aim.kind == QTR_DEADLINE;
}

bool terms_end(const qtr_mission *mission) {
  for (unsigned i = 0; i < mission->classes; i++)
    if (mission->robot_class[i].endurance != QTR_NEVER) return true;
  return false;
}

bool terms_leave_no_spots(const qtr_mission *mission) {
  if (mission->classes > 1 || terms_end(mission) || mission->aim.home_weight > 0.0) return true;
  for (int i = 0; i < mission->seekers; i++)
    if (mission->ready[i] > 0) return true;
  for (int place = 0; place < mission->places; place++)
    if (mission->looks[place] > 1) return true;
  return false;
}

static bool avoids(const qtr_mission *mission) {
  for (unsigned place = 0; place < mission->places; place++)
    if (qtr_places_has(&mission->robot_class[0].avoided, place)) return true;
  return false;
}

bool terms_any(const qtr_mission *mission) {
  const qtr_robot_class *all = &mission->robot_class[0];
  return terms_depend_on_progress(mission) || takes_scans(mission) || misses(mission) || all->smooth_only ||
         all->cell_steps > 1 || avoids(mission);
}

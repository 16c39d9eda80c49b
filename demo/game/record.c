#include "record.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "host/base/json.h"
#include "host/base/outfile.h"
#include "quarter/field.h"
#include "viewer_page.h"

#define TURN 6.283185307179586

/* ---- taking it down ---- */

void record_begin(record *r, const plan *p) {
  *r = (record){.p = p, .robots = p->t.policy.board.seekers};
}

void record_free(record *r) {
  for (int i = 0; i < r->robots; i++) free(r->track[i]);
  free(r->said);
  free(r->ghost);
  r->robots = 0;
}

static bool make_room(record *r) {
  if (r->samples < r->room) return true;
  const size_t room = r->room > 0 ? 2 * r->room : 1024;
  for (int i = 0; i < r->robots; i++) {
    record_sample *more = realloc(r->track[i], room * sizeof *more);
    if (more == NULL) return false;
    r->track[i] = more;
  }
  uint64_t *said = realloc(r->said, room * sizeof *said);
  if (said == NULL) return false;
  r->said = said;
  r->room = room;
  return true;
}

static record_sample sample_of(const arena *a, int robot) {
  const world_pose pose = world_pose_of(a->w, robot);
  return (record_sample){(int32_t)lround(100 * pose.at.x), (int32_t)lround(100 * (a->g.grid.rows - pose.at.y)),
                         (int16_t)lround(100 * remainder(pose.heading, TURN))};
}

void record_watch(void *user, const arena *a) {
  record *r = user;
  if (r->full || a->now + 1e-9 < r->next) return;
  r->next += RECORD_TICK;
  if (!make_room(r)) {
    r->full = true;
    return;
  }
  for (int i = 0; i < r->robots; i++) r->track[i][r->samples] = sample_of(a, i);
  r->said[r->samples] = a->signals;
  r->samples++;
}

int record_add_ghost(record *r, const arena_setup *setup, const volatile int *interrupted, fault *why) {
  if (interrupted != NULL && *interrupted != 0) return 0;
  r->ghost = malloc(sizeof *r->ghost);
  if (r->ghost == NULL) return fault_set(why, "no memory for the game without a plan");
  if (ghost_play(r->ghost, &r->p->t, setup, interrupted, why) != 0) return -1;
  if (r->ghost->samples > 0 && (interrupted == NULL || *interrupted == 0)) return 0;
  free(r->ghost);
  r->ghost = NULL;
  return 0;
}

/* ---- as JSON ---- */

static point middle_of(const plan *p, qtr_cell cell) {
  return (point){cell % p->t.policy.grid.columns + 0.5, cell / p->t.policy.grid.columns + 0.5};
}

static void write_point(json *j, const char *key, point at) {
  json_flat_array(j, key);
  json_number(j, NULL, at.x);
  json_number(j, NULL, at.y);
  json_end_array(j);
}

static void write_map(json *j, const plan *p) {
  const qtr_grid *grid = &p->t.policy.grid;
  char *row = malloc(grid->columns + 1u);
  json_object(j, "map");
  json_integer(j, "columns", grid->columns);
  json_integer(j, "rows", grid->rows);
  json_number(j, "cell_size", ground_of(&p->t.policy).cell_size);
  json_string(j, "unit", qtr_policy_frame(&p->t.policy).cell_size_um > 0 ? "m" : "cells"); /* of cell_size */
  json_array(j, "rows_text");
  for (unsigned r = 0; row != NULL && r < grid->rows; r++) json_string(j, NULL, table_grid_row(row, grid, r));
  json_end_array(j);
  json_end_object(j);
  free(row);
}

static double thousandths(double seconds) {
  return round(1000 * seconds) / 1000;
}

static void write_seconds(json *j, const char *key, double seconds) {
  if (seconds >= 0.0)
    json_number(j, key, thousandths(seconds));
  else
    json_null(j, key);
}

/* Seconds of the mission, which are those told; below 0 stays so. */
static double told(const plan *p, double seconds) {
  return game_pace(&p->t) * seconds;
}

static double planned_at(const plan *p, int place, int look) {
  const qtr_steps step = plan_look_step(p, place, look);
  return step != QTR_NEVER ? told(p, step * game_step_seconds(&p->t)) : -1.0;
}

/* What each look at a place counts, where that is more than one number says. */
static void write_looks(json *j, const plan *p, int place) {
  if (plan_look(p, place, 2) < 0 && p->truth.detection[place] >= 1.0) return;
  json_flat_array(j, "looks");
  for (int n = 1; plan_look(p, place, n) >= 0; n++) json_number(j, NULL, p->likelihood[plan_look(p, place, n)]);
  json_end_array(j);
}

static void write_places(json *j, const plan *p) {
  const naming n = table_naming(&p->t);
  json_array(j, "places");
  for (int place = 0; place < p->places; place++) {
    const point at = middle_of(p, qtr_policy_cell(&p->t.policy, (unsigned)place));
    json_flat_object(j, NULL);
    json_integer(j, "number", p->t.number[place]);
    naming_json_place(&n, j, (unsigned)place);
    json_number(j, "x", at.x);
    json_number(j, "y", at.y);
    json_number(j, "likelihood", p->truth.likelihood[place]);
    json_integer(j, "territory", p->territory[place]);
    write_seconds(j, "planned", planned_at(p, place, 1));
    write_looks(j, p, place);
    json_end_object(j);
  }
  json_end_array(j);
}

static void write_starts(json *j, const plan *p) {
  const qtr_board *board = &p->t.policy.board;
  json_array(j, "starts");
  for (int i = 0; i < board->seekers; i++)
    write_point(j, NULL, middle_of(p, qtr_policy_cell(&p->t.policy, (unsigned)board->places + board->start_of[i])));
  json_end_array(j);
}

/* A route as the cells it leads through. */
static void write_route(json *j, const plan *p, int seeker, qtr_field *way) {
  const qtr_policy *policy = &p->t.policy;
  const qtr_grid ground = qtr_policy_ground(policy, (unsigned)seeker);
  const table_route *route = &p->routes[seeker];
  qtr_cell cell = qtr_policy_cell(policy, (unsigned)policy->board.places + policy->board.start_of[seeker]);
  json_flat_array(j, NULL);
  write_point(j, NULL, middle_of(p, cell));
  for (int i = 0; i < route->places; i++) {
    const qtr_cell goal = qtr_policy_cell(policy, route->place[i]);
    qtr_field_fill(way, &ground, goal);
    while (cell != goal && cell != QTR_NO_CELL) {
      cell = qtr_field_next(way, &ground, cell);
      write_point(j, NULL, middle_of(p, cell));
    }
  }
  json_end_array(j);
}

static void write_routes(json *j, const plan *p) {
  qtr_field *way = malloc(sizeof *way);
  json_array(j, "routes");
  for (int i = 0; way != NULL && i < p->t.policy.board.seekers; i++) write_route(j, p, i, way);
  json_end_array(j);
  free(way);
}

/* The staircase of P(found by t) under the plan. */
static void write_plan(json *j, const plan *p) {
  const double last = p->t.policy.board.places > 0 ? 1e9 : 0.0;
  double step = -1.0;
  json_flat_array(j, "plan");
  for (;;) {
    double next = last;
    for (int place = 0; place < p->t.policy.board.places; place++)
      if (p->step[place] != QTR_NEVER && p->step[place] > step && p->step[place] < next) next = p->step[place];
    if (next >= last) break;
    step = next;
    write_point(j, NULL, (point){told(p, step * game_step_seconds(&p->t)), plan_found_by(p, step)});
  }
  json_end_array(j);
}

static void write_track(json *j, const record *r, int robot) {
  static const char *const keys[] = {"x", "y", "heading"};
  json_object(j, NULL);
  for (int key = 0; key < 3; key++) {
    json_flat_array(j, keys[key]);
    for (size_t i = 0; i < r->samples; i++) {
      const record_sample *s = &r->track[robot][i];
      json_integer(j, NULL, key == 0 ? s->x : key == 1 ? s->y : s->heading);
    }
    json_end_array(j);
  }
  json_end_object(j);
}

/* Where it changes: [seconds, signals so far]. */
static void write_said(json *j, const record *r) {
  uint64_t last = 0;
  json_flat_array(j, "said");
  for (size_t i = 0; i < r->samples; i++) {
    if (r->said[i] != last)
      write_point(j, NULL, (point){thousandths(told(r->p, RECORD_TICK * (double)i)), (double)r->said[i]});
    last = r->said[i];
  }
  json_end_array(j);
}

static void write_ghost_track(json *j, const ghost *g, int robot) {
  json_object(j, NULL);
  for (int key = 0; key < 2; key++) {
    json_flat_array(j, key == 0 ? "x" : "y");
    for (int i = 0; i < g->samples; i++) json_integer(j, NULL, key == 0 ? g->track[robot][i].x : g->track[robot][i].y);
    json_end_array(j);
  }
  json_end_object(j);
}

static void write_ghost(json *j, const plan *p, const ghost *g) {
  json_object(j, "ghost");
  json_string(j, "strategy", game_strategies[STRATEGY_NEAREST]);
  json_number(j, "duration", thousandths(told(p, g->duration)));
  write_seconds(j, "finished_at", told(p, g->finished_at));
  json_integer(j, "duplicates", g->duplicates);
  json_flat_array(j, "scans");
  for (int i = 0; i < g->scans; i++)
    write_point(j, NULL, (point){thousandths(told(p, g->scan[i].at)), g->scan[i].place});
  json_end_array(j);
  json_number(j, "tick", told(p, g->tick));
  json_array(j, "tracks");
  for (int robot = 0; robot < g->robots; robot++) write_ghost_track(j, g, robot);
  json_end_array(j);
  json_end_object(j);
}

/* ---- what happened ---- */

#define EVENT_TEXT (2 * QTR_SITE_NAME_BYTES + 80)

static naming_label robot_of(const naming *n, const arena_event *e) {
  return e->robot >= 0 ? naming_seeker(n, (unsigned)e->robot) : (naming_label){""};
}

static naming_label place_of(const naming *n, const arena_event *e) {
  return e->place >= 0 ? naming_place(n, (unsigned)e->place) : (naming_label){""};
}

/* A place, or what lies between them. */
static void describe_shut(char text[EVENT_TEXT], const naming_label *place) {
  if (place->text[0] != '\0')
    snprintf(text, EVENT_TEXT, "place %s is shut: nobody gets to it", place->text);
  else
    snprintf(text, EVENT_TEXT, "a door is shut");
}

static void describe(char text[EVENT_TEXT], const plan *p, const arena_event *e) {
  static const char *const does[] = {[EVENT_STOPPED] = "stopped",
                                     [EVENT_READY] = "sets out",
                                     [EVENT_HOMEWARD] = "has nothing left to do: it goes home",
                                     [EVENT_TIRED] = "is low on battery: it goes home",
                                     [EVENT_HOME] = "is home",
                                     [EVENT_EMPTY] = "is lost: its battery is empty",
                                     [EVENT_LOST] = "is lost",
                                     [EVENT_STUCK] = "is stuck",
                                     [EVENT_UNSTUCK] = "drives again",
                                     [EVENT_DEADLOCK] = "makes no way",
                                     [EVENT_RESET] = "has no power",
                                     [EVENT_RESTARTED] = "has power again, and goes on from its save"};
  const naming n = table_naming(&p->t);
  const naming_label robot = robot_of(&n, e), place = place_of(&n, e);
  switch (e->kind) {
  case EVENT_SCANNED: snprintf(text, EVENT_TEXT, "robot %s scanned place %s: clear", robot.text, place.text); break;
  case EVENT_LOOKED:
    snprintf(text, EVENT_TEXT, "robot %s scanned place %s again: clear", robot.text, place.text);
    break;
  case EVENT_MISSED:
    snprintf(text, EVENT_TEXT, "robot %s scanned place %s and missed what is there", robot.text, place.text);
    break;
  case EVENT_FOUND: snprintf(text, EVENT_TEXT, "robot %s found it at place %s", robot.text, place.text); break;
  case EVENT_DONE:
    snprintf(text, EVENT_TEXT, "robot %s: territory %s is done", robot.text,
             naming_seeker(&n, (unsigned)e->territory).text);
    break;
  case EVENT_SLIP:
    snprintf(text, EVENT_TEXT, "robot %s's wheels slip by up to %.0f %%", robot.text, 100 * e->share);
    break;
  case EVENT_LOSS: snprintf(text, EVENT_TEXT, "%.0f %% of the signals are lost from now on", 100 * e->share); break;
  case EVENT_SHUT: describe_shut(text, &place); break;
  case EVENT_MORE: snprintf(text, EVENT_TEXT, "more happened than is kept: from here on it is left out"); break;
  default: snprintf(text, EVENT_TEXT, "robot %s %s", robot.text, does[e->kind]);
  }
}

static void write_event(json *j, const plan *p, const arena_event *e) {
  static const char *const kinds[] = {
      [EVENT_SCANNED] = "scanned", [EVENT_FOUND] = "found",         [EVENT_DONE] = "territory_done",
      [EVENT_STOPPED] = "stopped", [EVENT_LOST] = "lost",           [EVENT_STUCK] = "stuck",
      [EVENT_UNSTUCK] = "unstuck", [EVENT_SLIP] = "slip",           [EVENT_LOSS] = "loss",
      [EVENT_SHUT] = "shut",       [EVENT_DEADLOCK] = "deadlock",   [EVENT_MORE] = "more",
      [EVENT_RESET] = "reset",     [EVENT_RESTARTED] = "restarted", [EVENT_LOOKED] = "looked",
      [EVENT_MISSED] = "missed",   [EVENT_READY] = "ready",         [EVENT_HOMEWARD] = "homeward",
      [EVENT_TIRED] = "battery",   [EVENT_HOME] = "home",           [EVENT_EMPTY] = "lost",
  };
  char text[EVENT_TEXT];
  describe(text, p, e);
  json_flat_object(j, NULL);
  write_seconds(j, "t", told(p, e->at));
  json_string(j, "kind", kinds[e->kind]);
  if (e->robot >= 0) json_integer(j, "robot", e->robot);
  if (e->place >= 0) json_integer(j, "place", e->place);
  if (e->territory >= 0) json_integer(j, "territory", e->territory);
  if (e->kind == EVENT_SHUT) {
    json_number(j, "x", e->middle.x);
    json_number(j, "y", e->middle.y);
  }
  json_string(j, "text", text);
  json_end_object(j);
}

void record_result(json *j, const plan *p, const game_result *result) {
  json_object(j, "result");
  write_seconds(j, "found_at", told(p, result->found_at));
  write_seconds(j, "planned_at", planned_at(p, result->mine, result->looks_needed));
  write_seconds(j, "all_stopped_at", told(p, result->all_stopped_at));
  json_integer(j, "scanned", result->scanned);
  json_integer(j, "duplicates", result->duplicates);
  json_integer(j, "collisions", result->collisions);
  json_integer(j, "deadlocks", result->deadlocks);
  json_flat_object(j, "messages");
  json_natural(j, "pose", result->counts.sent[KIND_POSE]);
  json_natural(j, "scan", result->counts.sent[KIND_SCAN]);
  json_natural(j, "command", result->counts.sent[KIND_COMMAND]);
  json_natural(j, "terminate", result->counts.sent[KIND_TERMINATE]);
  json_natural(j, "lost", result->counts.lost);
  json_natural(j, "ignored", result->counts.ignored);
  json_end_object(j);
  json_end_object(j);
}

static void write_game(json *j, const record *r, const arena *a, const game_result *result) {
  json_number(j, "duration", told(r->p, result->duration));
  json_number(j, "tick", told(r->p, RECORD_TICK));
  json_array(j, "tracks");
  for (int i = 0; i < r->robots; i++) write_track(j, r, i);
  json_end_array(j);
  json_array(j, "events");
  for (int i = 0; i < a->events; i++) write_event(j, r->p, &a->event[i]);
  json_end_array(j);
  write_said(j, r);
  record_result(j, r->p, result);
  if (r->ghost != NULL) write_ghost(j, r->p, r->ghost);
}

/* What the robots are called. */
static void write_robot_names(json *j, const plan *p) {
  const naming n = table_naming(&p->t);
  json_flat_array(j, "robot_names");
  for (int i = 0; i < n.seekers; i++) json_string(j, NULL, naming_seeker(&n, (unsigned)i).text);
  json_end_array(j);
}

static void write_head(json *j, const plan *p, const record_head *head) {
  json_integer(j, "format", 1);
  json_string(j, "title", p->name);
  json_string(j, "mission", p->name);
  json_natural(j, "seed", head->seed);
  json_string(j, "mode", head->clear_all ? "clear" : "find");
  json_number(j, "pace", game_pace(&p->t));
  write_map(j, p);
  json_integer(j, "robots", p->t.policy.board.seekers);
  write_robot_names(j, p);
  if (p->last_step >= 0.0) json_bool(j, "tires", true);
  json_number(j, "robot_radius", DEMO_RADIUS);
  write_starts(j, p);
  write_places(j, p);
  json_flat_array(j, "mines");
  if (head->mine >= 0) json_integer(j, NULL, head->mine);
  json_end_array(j);
  write_routes(j, p);
  write_plan(j, p);
}

void record_json(FILE *out, const record *r, const arena *a, const game_result *result) {
  const record_head head = {a->setup.seed, a->setup.clear_all, a->mine};
  json j;
  json_begin(&j, out);
  json_object(&j, NULL);
  write_head(&j, r->p, &head);
  write_game(&j, r, a, result);
  json_end_object(&j);
}

void record_hello(FILE *out, const plan *p, const record_head *head) {
  json j;
  json_begin(&j, out);
  json_object(&j, NULL);
  json_bool(&j, "live", true);
  write_head(&j, p, head);
  json_end_object(&j);
}

void record_event(FILE *out, const plan *p, const arena_event *e) {
  json j;
  json_begin(&j, out);
  write_event(&j, p, e);
}

/* ---- as a page ---- */

static const char hole[] = "<script id=\"replay\" type=\"application/json\">null</script>";

/* In a page, "</" would end the script that holds the data, and "<!--" would hide its end. In JSON, '<' is in strings
 * alone. */
static void put_escaped(FILE *out, const char *text) {
  for (; *text != '\0'; text++) {
    if (*text == '<')
      fputs("\\u003c", out);
    else
      fputc(*text, out);
  }
}

static void put_page(FILE *out, const char *data) {
  const char *page = (const char *)viewer_page;
  const char *end = strstr(strstr(page, hole), "null");
  fwrite(page, 1, (size_t)(end - page), out);
  put_escaped(out, data);
  fputs(end + strlen("null"), out);
}

int record_page(const char *path, const record *r, const arena *a, const game_result *result, fault *why) {
  outfile out;
  char *data = NULL;
  size_t size = 0;
  FILE *memory = open_memstream(&data, &size);
  if (memory == NULL) return fault_set(why, "%s: no memory for the replay", path);
  record_json(memory, r, a, result);
  if (fclose(memory) != 0 || r->full) {
    free(data);
    return fault_set(why, "%s: no memory for the replay of a game this long", path);
  }
  int status = outfile_open(&out, path, why);
  if (status == 0) {
    put_page(out.file, data);
    status = outfile_commit(&out, why);
  }
  free(data);
  return status;
}

void record_live_page(FILE *out) {
  put_page(out, "{\"live\": true}");
}

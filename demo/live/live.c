#define _GNU_SOURCE /* pthread_cond_clockwait(), of POSIX since 2024: a wait by a clock that only goes forward */

#include "live.h"

#include <civetweb.h>
#include <pthread.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <time.h>

#include "host/base/clock.h"

#define FRAME 0.1         /* seconds of the game between frames */
#define PULSE 2.0         /* seconds after which a viewer that has nothing to hear is looked after */
#define THREADS "32"      /* connections at a time: each has a thread */
#define TIMEOUT_MS "3000" /* for a whole request, and for a viewer to read what it is sent */

/* What viewers are told: kept as text, made by the game's thread, read by theirs. Everything below `lock` is under
 * it. */
struct live {
  struct mg_context *server;
  char *page;
  double next;
  pthread_mutex_t lock;
  pthread_cond_t changed;
  char *hello;
  double pace;               /* seconds that are told in one of the world's clock */
  char *frame;               /* {"t":..,"robots":..  without its end: the events differ from viewer to viewer */
  char *event[ARENA_EVENTS]; /* one text an event, of this game */
  int events;
  uint64_t game; /* how often another one began */
  uint64_t version;
  char *end;
  int watching;                /* viewers now */
  uint64_t came;               /* viewers so far */
  uint64_t seat[LIVE_VIEWERS]; /* who has it, as the number of viewers that had come; 0: nobody */
};

/* ---- text ---- */

typedef struct {
  FILE *file;
  char *data;
  size_t size;
} text;

static FILE *text_begin(text *t) {
  t->data = NULL;
  t->file = open_memstream(&t->data, &t->size);
  return t->file;
}

/* Events of a stream stand on one line. */
static char *text_end(text *t) {
  if (t->file == NULL) return NULL;
  fclose(t->file);
  for (char *c = t->data; c != NULL && *c != '\0'; c++)
    if (*c == '\n') *c = ' ';
  return t->data;
}

/* ---- who may ask ---- */

/* The name of this machine for itself, with a port or without: of a tunnel's other end it is another one. */
static bool is_here(const char *authority) {
  static const char *const names[] = {"localhost", "127.0.0.1", "[::1]"};
  for (int i = 0; i < 3; i++) {
    const size_t length = strlen(names[i]);
    if (strncasecmp(authority, names[i], length) != 0) continue;
    const char *port = authority + length;
    if (*port == '\0') return true;
    if (*port == ':' && strlen(port + 1) >= 1 && strlen(port + 1) <= 5)
      return strspn(port + 1, "0123456789") == strlen(port + 1);
  }
  return false;
}

/* A page from elsewhere may lead a name of its own to this address: the browser then says that name as the host, or the
 * page's as the origin. */
static bool is_welcome(const struct mg_connection *connection) {
  static const char scheme[] = "http://";
  const char *host = mg_get_header(connection, "Host");
  const char *origin = mg_get_header(connection, "Origin");
  if (host == NULL || !is_here(host)) return false;
  if (origin == NULL) return true;
  return strncmp(origin, scheme, strlen(scheme)) == 0 && is_here(origin + strlen(scheme));
}

/* ---- a viewer's thread ---- */

/* What the page needs and no more, for this origin alone. */
static const char headers[] =
    "Content-Security-Policy: default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; "
    "img-src data:; connect-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'\r\n"
    "X-Content-Type-Options: nosniff\r\n"
    "Referrer-Policy: no-referrer\r\n"
    "Cross-Origin-Resource-Policy: same-origin\r\n"
    "Cross-Origin-Opener-Policy: same-origin\r\n"
    "Cache-Control: no-store\r\n"
    "Connection: close\r\n";

static int answer(struct mg_connection *connection, int status, const char *reason, const char *type,
                  const char *body) {
  mg_printf(connection, "HTTP/1.1 %d %s\r\n%sContent-Type: %s; charset=utf-8\r\nContent-Length: %lu\r\n\r\n", status,
            reason, headers, type, (unsigned long)strlen(body));
  if (strcmp(mg_get_request_info(connection)->request_method, "HEAD") != 0) mg_write(connection, body, strlen(body));
  return status;
}

static int send_event(struct mg_connection *connection, const char *name, const char *data) {
  return mg_printf(connection, "event: %s\ndata: %s\n\n", name, data);
}

/* How far a viewer has come. */
typedef struct {
  uint64_t version, game;
  int events;
  bool greeted;
} progress_of_viewer;

/* Under the lock: the frame of now, with the events that this viewer has not seen. */
static char *frame_for(const live *view, progress_of_viewer *seen) {
  text t;
  FILE *out = text_begin(&t);
  if (out == NULL) return NULL;
  if (seen->game != view->game) seen->events = 0;
  fprintf(out, "%s, \"events\": [", view->frame);
  for (int i = seen->events; i < view->events; i++) fprintf(out, "%s%s", i > seen->events ? ", " : "", view->event[i]);
  fputs("]}", out);
  seen->events = view->events;
  seen->game = view->game;
  return text_end(&t);
}

static struct timespec soon(double seconds) {
  struct timespec then;
  clock_gettime(CLOCK_MONOTONIC, &then);
  const long nanoseconds = then.tv_nsec + (long)(1e9 * seconds) % 1000000000;
  return (struct timespec){then.tv_sec + (time_t)seconds + nanoseconds / 1000000000, nanoseconds % 1000000000};
}

/* Under the lock, which is let go for it: send what is newer, or a line that says nothing, for who has gone is found
 * out by writing alone. False: nobody is there any more. */
static bool send_news(live *view, struct mg_connection *connection, progress_of_viewer *seen) {
  const bool newer = view->version != seen->version;
  char *hello = newer && !seen->greeted ? strdup(view->hello) : NULL;
  char *frame = newer ? frame_for(view, seen) : NULL;
  bool alive = true;
  seen->version = view->version;
  pthread_mutex_unlock(&view->lock);
  if (!newer) alive = mg_printf(connection, ":\n\n") > 0;
  if (hello != NULL) alive = send_event(connection, "hello", hello) > 0;
  if (alive && frame != NULL) alive = send_event(connection, "frame", frame) > 0;
  seen->greeted = seen->greeted || newer;
  free(hello);
  free(frame);
  pthread_mutex_lock(&view->lock);
  return alive;
}

/* Under the lock: a seat for a viewer that comes. Where all are taken, who has had its own for longest loses it: a
 * browser comes back by itself, and whoever does not read, which at a frame's size cannot be told for minutes, does
 * not. */
static uint64_t *take_seat(live *view) {
  uint64_t *seat = &view->seat[0];
  for (int i = 1; i < LIVE_VIEWERS; i++)
    if (view->seat[i] < *seat) seat = &view->seat[i];
  *seat = ++view->came;
  view->watching++;
  pthread_cond_broadcast(&view->changed);
  return seat;
}

/* Under the lock. */
static void leave_seat(live *view, uint64_t *seat, uint64_t number) {
  if (*seat == number) *seat = 0;
  view->watching--;
  pthread_cond_broadcast(&view->changed);
}

/* Under the lock. */
static bool has_news(const live *view, const progress_of_viewer *seen) {
  return view->version != seen->version;
}

/* Under the lock: wait for something to tell, but not for ever. */
static void await_news(live *view, const progress_of_viewer *seen, const uint64_t *seat, uint64_t number) {
  const struct timespec then = soon(PULSE);
  int waited = 0;
  while (!has_news(view, seen) && view->end == NULL && *seat == number && waited == 0)
    waited = pthread_cond_clockwait(&view->changed, &view->lock, CLOCK_MONOTONIC, &then);
}

/* Under the lock: until the game is over, the seat lost, or the viewer gone. True: the game is over. */
static bool stream(live *view, struct mg_connection *connection, const uint64_t *seat) {
  const uint64_t number = *seat;
  progress_of_viewer seen = {0};
  bool alive = true;
  while (alive && *seat == number) {
    await_news(view, &seen, seat, number);
    if (!has_news(view, &seen) && view->end != NULL) return true;
    if (*seat == number) alive = send_news(view, connection, &seen);
  }
  return false;
}

static int serve_events(struct mg_connection *connection, live *view) {
  mg_printf(connection, "HTTP/1.1 200 OK\r\n%sContent-Type: text/event-stream\r\n\r\nretry: 1000\n\n", headers);
  pthread_mutex_lock(&view->lock);
  uint64_t *seat = take_seat(view);
  const uint64_t number = *seat;
  char *end = stream(view, connection, seat) ? strdup(view->end) : NULL;
  pthread_mutex_unlock(&view->lock);
  if (end != NULL) send_event(connection, "end", end);
  free(end);
  pthread_mutex_lock(&view->lock);
  leave_seat(view, seat, number);
  pthread_mutex_unlock(&view->lock);
  return 200;
}

static int serve(struct mg_connection *connection, void *user) {
  live *view = user;
  const struct mg_request_info *request = mg_get_request_info(connection);
  const bool heads = strcmp(request->request_method, "HEAD") == 0;
  if (!is_welcome(connection))
    return answer(connection, 421, "Misdirected Request", "text/plain", "Ask for localhost, from a page of its own.\n");
  if (!heads && strcmp(request->request_method, "GET") != 0)
    return answer(connection, 405, "Method Not Allowed", "text/plain", "GET alone.\n");
  if (strcmp(request->local_uri, "/") == 0) return answer(connection, 200, "OK", "text/html", view->page);
  if (strcmp(request->local_uri, "/events") != 0 || heads)
    return answer(connection, 404, "Not Found", "text/plain", "There is / alone.\n");
  return serve_events(connection, view);
}

/* ---- the game's thread ---- */

static int start_server(live *view, int port, fault *why) {
  char listen[32];
  struct mg_server_port ports[1];
  snprintf(listen, sizeof listen, "127.0.0.1:%d", port);
  const char *options[] = {"listening_ports",
                           listen,
                           "num_threads",
                           THREADS,
                           "request_timeout_ms",
                           TIMEOUT_MS,
                           "enable_keep_alive",
                           "no",
                           "enable_directory_listing",
                           "no",
                           "access_control_allow_origin",
                           "",
                           "access_control_allow_methods",
                           "",
                           NULL};
  view->server = mg_start(NULL, NULL, options);
  if (view->server == NULL || mg_get_server_ports(view->server, 1, ports) != 1)
    return fault_set(why, "--port %d: it cannot be served there; another program may have it: give another, or 0",
                     port);
  mg_set_request_handler(view->server, "**", serve, view);
  fprintf(stderr, "Watch it at http://127.0.0.1:%d/\n", ports[0].port);
  return 0;
}

int live_open(live **opened, int port, fault *why) {
  text t;
  live *view = calloc(1, sizeof *view);
  *opened = NULL;
  FILE *page = view != NULL ? text_begin(&t) : NULL;
  if (page == NULL) return fault_set(why, "no memory for the live view");
  record_live_page(page);
  fclose(page);
  view->page = t.data;
  pthread_mutex_init(&view->lock, NULL);
  pthread_cond_init(&view->changed, NULL);
  mg_init_library(0);
  if (start_server(view, port, why) != 0) return -1;
  *opened = view;
  return 0;
}

/* Under the lock: until `holds`, or the time is over. */
static void wait_while(live *view, bool (*holds)(const live *view), double seconds, const volatile int *interrupted) {
  const double end = clock_seconds() + seconds;
  while (holds(view) && clock_seconds() < end && (interrupted == NULL || *interrupted == 0)) {
    const struct timespec then = soon(0.2);
    pthread_cond_clockwait(&view->changed, &view->lock, CLOCK_MONOTONIC, &then);
  }
}

static bool nobody_came(const live *view) {
  return view->came == 0;
}

static bool somebody_watches(const live *view) {
  return view->watching > 0;
}

void live_await(live *view, double seconds, const volatile int *interrupted) {
  fprintf(stderr, "The game begins when somebody watches, or in %.0f seconds.\n", seconds);
  pthread_mutex_lock(&view->lock);
  wait_while(view, nobody_came, seconds, interrupted);
  pthread_mutex_unlock(&view->lock);
}

void live_hello(live *view, const plan *p, const record_head *head) {
  text t;
  if (text_begin(&t) != NULL) record_hello(t.file, p, head);
  pthread_mutex_lock(&view->lock);
  free(view->hello);
  view->hello = text_end(&t);
  view->pace = game_pace(&p->t);
  pthread_mutex_unlock(&view->lock);
}

/* The last one that there is room for says that there is no more. */
void live_event(live *view, const plan *p, const arena_event *e) {
  static const arena_event more = {.kind = EVENT_MORE, .robot = -1, .place = -1, .territory = -1};
  arena_event last = more;
  text t;
  if (view->events == ARENA_EVENTS || text_begin(&t) == NULL) return;
  last.at = e->at;
  record_event(t.file, p, view->events < ARENA_EVENTS - 1 ? e : &last);
  char *data = text_end(&t);
  if (data == NULL) return;
  pthread_mutex_lock(&view->lock);
  view->event[view->events++] = data;
  pthread_mutex_unlock(&view->lock);
}

void live_restart(live *view) {
  pthread_mutex_lock(&view->lock);
  while (view->events > 0) free(view->event[--view->events]);
  view->game++;
  pthread_mutex_unlock(&view->lock);
}

static char *frame_text(double told, int robots, int rows, const world_pose *poses) {
  text t;
  FILE *out = text_begin(&t);
  if (out == NULL) return NULL;
  fprintf(out, "{\"t\": %.2f, \"robots\": [", told);
  for (int i = 0; i < robots; i++)
    fprintf(out, "%s[%.2f, %.2f, %.2f]", i > 0 ? ", " : "", poses[i].at.x, rows - poses[i].at.y, poses[i].heading);
  fputs("]", out);
  return text_end(&t);
}

void live_frame(live *view, double now, int robots, int rows, const world_pose *poses) {
  if (now + 1e-9 < view->next && now > view->next - 2 * FRAME) return;
  view->next = now + FRAME;
  char *frame = frame_text(view->pace * now, robots, rows, poses);
  pthread_mutex_lock(&view->lock);
  free(view->frame);
  view->frame = frame;
  if (view->hello != NULL && view->frame != NULL) view->version++;
  pthread_cond_broadcast(&view->changed);
  pthread_mutex_unlock(&view->lock);
}

void live_end(live *view, const plan *p, const game_result *result) {
  text t;
  json j;
  if (text_begin(&t) == NULL) return;
  json_begin(&j, t.file);
  json_object(&j, NULL);
  record_result(&j, p, result);
  json_number(&j, "duration", game_pace(&p->t) * result->duration);
  json_end_object(&j);
  pthread_mutex_lock(&view->lock);
  view->end = text_end(&t);
  pthread_cond_broadcast(&view->changed);
  pthread_mutex_unlock(&view->lock);
}

void live_close(live *view) {
  if (view == NULL) return;
  pthread_mutex_lock(&view->lock);
  if (view->end == NULL) view->end = strdup("{}");
  pthread_cond_broadcast(&view->changed);
  wait_while(view, somebody_watches, 5.0, NULL);
  pthread_mutex_unlock(&view->lock);
  mg_stop(view->server);
  mg_exit_library();
  for (int i = 0; i < view->events; i++) free(view->event[i]);
  free(view->hello);
  free(view->frame);
  free(view->end);
  free(view->page);
  pthread_mutex_destroy(&view->lock);
  pthread_cond_destroy(&view->changed);
  free(view);
}

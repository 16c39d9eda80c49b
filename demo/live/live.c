#include "live.h"

#include <civetweb.h>
#include <pthread.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "progress.h"

#define FRAME 0.1 /* seconds of the game between frames */

/* What viewers are told: kept as text, made by the game's thread, read by theirs. Everything below `lock` is under it. */
struct live {
  struct mg_context *server;
  char *page;
  double next;
  pthread_mutex_t lock;
  pthread_cond_t changed;
  char *hello;
  char *frame;  /* {"t":..,"robots":..  without its end: the events differ from viewer to viewer */
  char **event; /* one text an event */
  int events;
  uint64_t version;
  char *end;
  int watching, came;
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

/* ---- a viewer's thread ---- */

static int serve_page(struct mg_connection *connection, void *user) {
  const live *view = user;
  mg_send_http_ok(connection, "text/html; charset=utf-8", (long long)strlen(view->page));
  mg_write(connection, view->page, strlen(view->page));
  return 200;
}

static int send_event(struct mg_connection *connection, const char *name, const char *data) {
  return mg_printf(connection, "event: %s\ndata: %s\n\n", name, data);
}

/* Under the lock: the frame of now, with the events that this viewer has not seen. */
static char *frame_for(const live *view, int *seen) {
  text t;
  FILE *out = text_begin(&t);
  if (out == NULL) return NULL;
  fprintf(out, "%s, \"events\": [", view->frame);
  for (int i = *seen; i < view->events; i++) fprintf(out, "%s%s", i > *seen ? ", " : "", view->event[i]);
  fputs("]}", out);
  *seen = view->events;
  return text_end(&t);
}

/* Wait for something newer than `version`. False: it is over. */
static bool await_news(live *view, uint64_t version) {
  while (view->version == version && view->end == NULL) pthread_cond_wait(&view->changed, &view->lock);
  return view->version != version;
}

static void stream(live *view, struct mg_connection *connection) {
  uint64_t version = 0;
  int seen = 0;
  bool greeted = false;
  bool alive = true;
  pthread_mutex_lock(&view->lock);
  while (alive && await_news(view, version)) {
    version = view->version;
    char *hello = greeted ? NULL : strdup(view->hello);
    char *frame = frame_for(view, &seen);
    pthread_mutex_unlock(&view->lock);
    if (hello != NULL) alive = send_event(connection, "hello", hello) > 0;
    if (alive && frame != NULL) alive = send_event(connection, "frame", frame) > 0;
    greeted = true;
    free(hello);
    free(frame);
    pthread_mutex_lock(&view->lock);
  }
  if (alive && view->end != NULL) send_event(connection, "end", view->end);
  pthread_mutex_unlock(&view->lock);
}

static int serve_events(struct mg_connection *connection, void *user) {
  live *view = user;
  mg_printf(connection, "HTTP/1.1 200 OK\r\nContent-Type: text/event-stream\r\nCache-Control: no-store\r\n"
                        "Connection: close\r\n\r\n");
  pthread_mutex_lock(&view->lock);
  view->watching++;
  view->came++;
  pthread_cond_broadcast(&view->changed);
  pthread_mutex_unlock(&view->lock);
  stream(view, connection);
  pthread_mutex_lock(&view->lock);
  view->watching--;
  pthread_cond_broadcast(&view->changed);
  pthread_mutex_unlock(&view->lock);
  return 200;
}

/* ---- the game's thread ---- */

static int start_server(live *view, int port, fault *why) {
  char listen[32];
  struct mg_server_port ports[1];
  snprintf(listen, sizeof listen, "127.0.0.1:%d", port);
  const char *options[] = {"listening_ports", listen, "num_threads", "8", "enable_directory_listing", "no", NULL};
  view->server = mg_start(NULL, NULL, options);
  if (view->server == NULL || mg_get_server_ports(view->server, 1, ports) != 1)
    return fault_set(why, "--port %d: it cannot be served there; another program may have it: give another, or 0",
                     port);
  mg_set_request_handler(view->server, "/events$", serve_events, view);
  mg_set_request_handler(view->server, "/$", serve_page, view);
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
    struct timespec soon;
    clock_gettime(CLOCK_REALTIME, &soon);
    soon.tv_nsec += 200000000;
    soon.tv_sec += soon.tv_nsec / 1000000000;
    soon.tv_nsec %= 1000000000;
    pthread_cond_timedwait(&view->changed, &view->lock, &soon);
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
  pthread_mutex_unlock(&view->lock);
}

void live_event(live *view, const arena_event *e) {
  text t;
  if (text_begin(&t) == NULL) return;
  record_event(t.file, e);
  char *data = text_end(&t);
  pthread_mutex_lock(&view->lock);
  char **more = realloc(view->event, ((size_t)view->events + 1) * sizeof *more);
  if (more != NULL) {
    view->event = more;
    view->event[view->events++] = data;
  }
  pthread_mutex_unlock(&view->lock);
  if (more == NULL) free(data);
}

static char *frame_text(double now, int robots, int rows, const world_pose *poses) {
  text t;
  FILE *out = text_begin(&t);
  if (out == NULL) return NULL;
  fprintf(out, "{\"t\": %.2f, \"robots\": [", now);
  for (int i = 0; i < robots; i++)
    fprintf(out, "%s[%.2f, %.2f, %.2f]", i > 0 ? ", " : "", poses[i].at.x, rows - poses[i].at.y, poses[i].heading);
  fputs("]", out);
  return text_end(&t);
}

void live_frame(live *view, double now, int robots, int rows, const world_pose *poses) {
  if (now + 1e-9 < view->next && now > view->next - 2 * FRAME) return;
  view->next = now + FRAME;
  char *frame = frame_text(now, robots, rows, poses);
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
  json_number(&j, "duration", result->duration);
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
  free(view->event);
  free(view->hello);
  free(view->frame);
  free(view->end);
  free(view->page);
  pthread_mutex_destroy(&view->lock);
  pthread_cond_destroy(&view->changed);
  free(view);
}

#include "draw_render.h"

#define NEED "PNG and PDF take librsvg (package librsvg2-dev)"

const char *const draw_forms[] = {"svg", "png", "pdf", NULL};

#ifdef QUARTER_RSVG
#include <cairo-pdf.h>
#include <librsvg/rsvg.h>
#include <math.h>
#include <stdbool.h>

#include "host/base/library.h"

static const double DENSITY = 2.0; /* of a PNG */

static __typeof__(rsvg_handle_new_from_data) *new_from_data;
static __typeof__(rsvg_handle_get_intrinsic_size_in_pixels) *size_in_pixels;
static __typeof__(rsvg_handle_render_document) *render_document;
static __typeof__(g_object_unref) *unref;
static __typeof__(cairo_image_surface_create) *image_create;
static __typeof__(cairo_pdf_surface_create_for_stream) *pdf_create;
static __typeof__(cairo_pdf_surface_set_metadata) *pdf_tell;
static __typeof__(cairo_surface_write_to_png_stream) *write_png;
static __typeof__(cairo_surface_finish) *surface_finish;
static __typeof__(cairo_surface_status) *surface_status;
static __typeof__(cairo_surface_destroy) *surface_destroy;
static __typeof__(cairo_create) *context_create;
static __typeof__(cairo_destroy) *context_destroy;
static __typeof__(cairo_scale) *scale;

/* librsvg brings cairo and GObject with it. */
static const library_function functions[] = {{"rsvg_handle_new_from_data", &new_from_data},
                                             {"rsvg_handle_get_intrinsic_size_in_pixels", &size_in_pixels},
                                             {"rsvg_handle_render_document", &render_document},
                                             {"g_object_unref", &unref},
                                             {"cairo_image_surface_create", &image_create},
                                             {"cairo_pdf_surface_create_for_stream", &pdf_create},
                                             {"cairo_pdf_surface_set_metadata", &pdf_tell},
                                             {"cairo_surface_write_to_png_stream", &write_png},
                                             {"cairo_surface_finish", &surface_finish},
                                             {"cairo_surface_status", &surface_status},
                                             {"cairo_surface_destroy", &surface_destroy},
                                             {"cairo_create", &context_create},
                                             {"cairo_destroy", &context_destroy},
                                             {"cairo_scale", &scale},
                                             {NULL, NULL}};

typedef struct {
  RsvgHandle *picture;
  double width, height; /* pixels */
  FILE *out;
} job;

static cairo_status_t put(void *to, const unsigned char *bytes, unsigned length) {
  return fwrite(bytes, 1, length, to) == length ? CAIRO_STATUS_SUCCESS : CAIRO_STATUS_WRITE_ERROR;
}

/* That the file was written is found out by who finishes it. */
static int paint(const job *j, cairo_surface_t *surface, double density) {
  const RsvgRectangle page = {0.0, 0.0, j->width, j->height};
  cairo_t *context = context_create(surface);
  scale(context, density, density);
  const bool done = render_document(j->picture, context, &page, NULL);
  context_destroy(context);
  return done && surface_status(surface) == CAIRO_STATUS_SUCCESS ? 0 : -1;
}

static int as_png(const job *j) {
  cairo_surface_t *surface =
      image_create(CAIRO_FORMAT_RGB24, (int)ceil(j->width * DENSITY), (int)ceil(j->height * DENSITY));
  int status = paint(j, surface, DENSITY);
  if (status == 0 && write_png(surface, put, j->out) != CAIRO_STATUS_SUCCESS) status = -1;
  surface_destroy(surface);
  return status;
}

static int as_pdf(const job *j) {
  cairo_surface_t *surface = pdf_create(put, j->out, j->width, j->height);
  pdf_tell(surface, CAIRO_PDF_METADATA_CREATE_DATE, "");
  int status = paint(j, surface, 1.0);
  surface_finish(surface);
  if (surface_status(surface) != CAIRO_STATUS_SUCCESS) status = -1;
  surface_destroy(surface);
  return status;
}

int draw_render(FILE *out, const char *svg, size_t length, enum draw_form form, fault *why) {
  job j = {.out = out};
  if (library_load(QUARTER_RSVG, functions, NEED, why) != 0) return -1;
  j.picture = new_from_data((const guint8 *)svg, length, NULL);
  int status = j.picture != NULL && size_in_pixels(j.picture, &j.width, &j.height) ? 0 : -1;
  if (status == 0) status = form == DRAW_PNG ? as_png(&j) : as_pdf(&j);
  if (j.picture != NULL) unref(j.picture);
  return status == 0 ? 0 : fault_set(why, "librsvg cannot draw the picture");
}

#else

int draw_render(FILE *out, const char *svg, size_t length, enum draw_form form, fault *why) {
  (void)out;
  (void)svg;
  (void)length;
  (void)form;
  return fault_set(why, NEED ", which was not there when Quarter was built: install it and build again");
}

#endif

#include "print.h"

#include "host/base/outfile.h"
#include "products.h"

static int print_to(const char *path, print_writer write, const void *what, fault *why) {
  outfile out;
  if (outfile_open(&out, path, why) != 0) return -1;
  write(out.file, what);
  return outfile_commit(&out, why);
}

int print_report(const options *o, print_writer json, print_writer text, const void *what, fault *why) {
  if (o->json && o->json_path == NULL) return print_to("-", json, what, why);
  if (o->json && print_to(o->json_path, json, what, why) != 0) return -1;
  return o->quiet || products_take_stdout(o) ? 0 : print_to("-", text, what, why);
}

#include "products.h"

#include <string.h>

#include "host/base/outfile.h"

enum { OUTPUTS = 6 };

typedef struct {
  const char *word;
  const char *path; /* NULL: not asked for */
} output;

static void list(output *outputs, const options *o) {
  const char *json = !o->json ? NULL : o->json_path != NULL ? o->json_path : "-";
  const output all[OUTPUTS] = {{"--output", o->output},
                               {"--c", o->c_output},
                               {"--curve", o->curve},
                               {"--picture", o->picture},
                               {"--belief", o->history != NULL ? o->belief : NULL},
                               {"--json", json}};
  memcpy(outputs, all, sizeof all);
}

static int check_pair(const output *first, const output *second, fault *why) {
  if (first->path == NULL || second->path == NULL || !outfile_is_same(first->path, second->path)) return 0;
  return fault_set(why, "%s %s: is where %s goes; name another file", second->word, second->path, first->word);
}

int products_check(const options *o, fault *why) {
  output outputs[OUTPUTS];
  list(outputs, o);
  for (int i = 0; i < OUTPUTS; i++) {
    for (int j = 0; j < i; j++)
      if (check_pair(&outputs[j], &outputs[i], why) != 0) return -1;
    if (outputs[i].path != NULL && outfile_try(outputs[i].path, why) != 0) return -1;
  }
  return 0;
}

static bool is_stdout(const char *path) {
  return path != NULL && (strcmp(path, "-") == 0 || strcmp(path, "/dev/stdout") == 0);
}

bool products_take_stdout(const options *o) {
  return is_stdout(o->output) || is_stdout(o->c_output) || is_stdout(o->curve);
}

#include "fit.h"

#include <inttypes.h>
#include <string.h>

#include "host/base/count.h"
#include "host/table/config_header.h"
#include "host/table/robot_needs.h"

int fit_begin(fit *f, const char *profile, fault *why) {
  *f = (fit){.profile = profile, .built = robot_sizes_mcu};
  if (profile == NULL || strcmp(profile, "mcu") == 0) return 0;
  return config_header_read(&f->built, profile, why);
}

void fit_take(fit *f, const qtr_policy *policy) {
  f->needed = robot_needs(policy);
  f->flash_bytes = policy->size;
}

int fit_check(const fit *f, const char *input, fault *why) {
  if (f->profile == NULL || robot_sizes_fit(&f->built, &f->needed)) return 0;
  why->text[0] = '\0';
  for (int i = 0; i < ROBOT_SIZES; i++) {
    if (f->built.of[i] >= f->needed.of[i]) continue;
    int (*const tell)(fault *, const char *, ...) = why->text[0] == '\0' ? fault_set : fault_add;
    tell(why, "%s: does not fit --profile %s: raise %s from %" PRIu32 " to %" PRIu32, input, f->profile,
         robot_size_macro[i], f->built.of[i], f->needed.of[i]);
  }
  why->status = EXIT_UNFIT;
  return -1;
}

void fit_write(FILE *out, const fit *f) {
  if (f->profile == NULL || !robot_sizes_fit(&f->built, &f->needed)) return;
  const robot_memory ram = robot_memory_of(&f->built, &robot_processor_32_bits);
  const robot_memory least = robot_memory_of(&f->needed, &robot_processor_32_bits);
  fprintf(out,
          "fits %s: %s of flash for the table, %s of RAM on a processor of 32 bits (policy %" PRIu64 ", seeker %" PRIu64
          ", field %" PRIu64 ")\n",
          f->profile, counted(f->flash_bytes, "byte").text, counted(ram.all, "byte").text, ram.policy, ram.seeker,
          ram.field);
  fprintf(out, "  cut to it, %s:", counted(least.all, "byte").text);
  for (int i = 0; i < ROBOT_SIZES; i++) fprintf(out, " %s=%" PRIu32, robot_size_macro[i], f->needed.of[i]);
  fputc('\n', out);
}

static void write_sizes(json *j, const char *key, const robot_sizes *sizes) {
  json_object(j, key);
  for (int i = 0; i < ROBOT_SIZES; i++) json_natural(j, robot_size_macro[i], sizes->of[i]);
  json_end_object(j);
}

static void write_memory(json *j, const char *key, const robot_sizes *sizes) {
  const robot_memory ram = robot_memory_of(sizes, &robot_processor_32_bits);
  json_object(j, key);
  json_natural(j, "policy", ram.policy);
  json_natural(j, "seeker", ram.seeker);
  json_natural(j, "field", ram.field);
  json_natural(j, "all", ram.all);
  json_end_object(j);
}

void fit_json(json *j, const fit *f) {
  if (f->profile == NULL) return;
  json_object(j, "profile");
  json_string(j, "name", f->profile);
  json_bool(j, "fits", robot_sizes_fit(&f->built, &f->needed));
  write_sizes(j, "sizes", &f->built);
  write_sizes(j, "needed", &f->needed);
  json_natural(j, "flash_bytes", f->flash_bytes);
  write_memory(j, "ram_bytes", &f->built);
  write_memory(j, "ram_bytes_needed", &f->needed);
  json_end_object(j);
}

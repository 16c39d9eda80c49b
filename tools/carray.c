#include "carray.h"

#include <ctype.h>
#include <inttypes.h>

#include "cname.h"
#include "host/table/robot_needs.h"
#include "quarter/status.h"

#define BYTES_A_LINE 16

/* NAME_CELLS and the like, and that the build holds as much. */
static void write_needs(FILE *out, const char *name, const qtr_policy *policy) {
  const robot_sizes needed = robot_needs(policy);
  char upper[CNAME_SIZE];
  for (size_t i = 0; i < sizeof upper; i++) upper[i] = (char)toupper((unsigned char)name[i]);
  for (int i = 0; i < ROBOT_SIZES; i++)
    fprintf(out, "#define %s_%s %" PRIu32 "\n", upper, robot_size_word(i), needed.of[i]);
  fprintf(out, "\n#ifdef __has_include\n#if __has_include(\"quarter/config.h\")\n#include \"quarter/config.h\"\n");
  for (int i = 0; i < ROBOT_SIZES; i++)
    fprintf(out, "#if %s < %s_%s\n#error \"%s needs %s to be %" PRIu32 " or more\"\n#endif\n", robot_size_macro[i],
            upper, robot_size_word(i), name, robot_size_macro[i], needed.of[i]);
  fprintf(out, "#endif\n#endif\n\n");
}

void carray_write(FILE *out, const char *path, const qtr_policy *policy) {
  const uint8_t *bytes = policy->bytes;
  const uint32_t size = policy->size;
  char name[CNAME_SIZE];
  cname_of_path(name, path);
  fprintf(out, "/* A Quarter policy table, made by quarter %s. Declare it where it is used:\n", QTR_VERSION_STRING);
  fprintf(out, " *   extern const uint8_t %s[];\n *   extern const uint32_t %s_size;\n */\n", name, name);
  fprintf(out, "#include <stdint.h>\n\n");
  write_needs(out, name, policy);
  fprintf(out, "extern const uint8_t %s[];\nextern const uint32_t %s_size;\n\n", name, name);
  fprintf(out, "const uint32_t %s_size = %" PRIu32 ";\nconst uint8_t %s[%" PRIu32 "] = {", name, size, name, size);
  for (uint32_t i = 0; i < size; i++)
    fprintf(out, "%s0x%02x%s", i % BYTES_A_LINE == 0 ? "\n  " : " ", bytes[i], i + 1 < size ? "," : "");
  fprintf(out, "};\n");
}

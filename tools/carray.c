#include "carray.h"

#include <inttypes.h>

#include "cname.h"
#include "quarter/status.h"

#define BYTES_A_LINE 16

void carray_write(FILE *out, const char *path, const uint8_t *bytes, uint32_t size) {
  char name[CNAME_SIZE];
  cname_of_path(name, path);
  fprintf(out, "/* A Quarter policy table, made by quarter %s. Declare it where it is used:\n", QTR_VERSION_STRING);
  fprintf(out, " *   extern const uint8_t %s[];\n *   extern const uint32_t %s_size;\n */\n", name, name);
  fprintf(out, "#include <stdint.h>\n\nextern const uint8_t %s[];\nextern const uint32_t %s_size;\n\n", name, name);
  fprintf(out, "const uint32_t %s_size = %" PRIu32 ";\nconst uint8_t %s[%" PRIu32 "] = {", name, size, name, size);
  for (uint32_t i = 0; i < size; i++)
    fprintf(out, "%s0x%02x%s", i % BYTES_A_LINE == 0 ? "\n  " : " ", bytes[i], i + 1 < size ? "," : "");
  fprintf(out, "};\n");
}

#include "program.h"

#include <stdlib.h>

#include "printing.h"
#include "quarter/status.h"

int program_main(const program *p, int argc, char **argv) {
  static settings s;
  fault why;
  if (settings_parse(&s, argc, argv, &why) != 0) return fault_exit(&why);
  if (s.help || s.version) {
    if (s.help)
      p->help(stdout);
    else
      printf("%s %s\n", p->name, QTR_VERSION_STRING);
    return print_end(p->name);
  }
  const int status = p->run(&s, &why);
  if (status == 0) return *p->interrupted != 0 ? *p->interrupted : EXIT_SUCCESS;
  if (why.status != EXIT_STOPPED || !s.quiet) fault_exit(&why); /* who asked for the end and for silence gets both */
  return status;
}

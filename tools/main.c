#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "commands.h"
#include "host/base/fault.h"
#include "host/base/near.h"
#include "quarter/status.h"

static const char help[] =
    "quarter new map.yaml                          a mission for a map, to be filled in, and a picture to do it by\n"
    "quarter learn mission.yaml -o mission.qtr     divide the area among the robots, with a certificate\n"
    "quarter check mission.yaml                    every fault of a mission at once, without learning\n"
    "quarter simulate mission.qtr --lost 1@40      play the policy, robots late or lost\n"
    "quarter draw mission.qtr -o mission.svg       a picture of the map, the territories and the routes\n"
    "quarter export mission.qtr -o ways.csv        the ways for others: GPX, QGroundControl, Nav2 ...\n"
    "quarter inspect mission.qtr                   what a policy table holds\n"
    "quarter compare before.qtr after.qtr          two plans side by side\n"
    "quarter tune mission.yaml                     which aggregation loses least on the ground\n"
    "quarter belief mission.yaml --history g.csv   likelihoods from where targets were found\n"
    "quarter exact mission.yaml                    the exact optimum of a small mission, for checking\n"
    "quarter keys                                  every key that a mission may have\n"
    "\n"
    "'quarter COMMAND --help' tells more; 'quarter --version' the version.\n"
    "\n"
    "Inputs: a drawing (.txt: # blocked, . free, ~ rough, S start, 1-9 a place of that weight), or a mission (.yaml) "
    "that\n"
    "names a drawing, a Moving AI .map or a ROS map, robots and places.\n";

static const struct {
  const char *name;
  int (*run)(int argc, char **argv);
} commands[] = {
    {"new", command_new},         {"check", command_check},       {"learn", command_learn},
    {"exact", command_exact},     {"simulate", command_simulate}, {"inspect", command_inspect},
    {"compare", command_compare}, {"draw", command_draw},         {"export", command_export},
    {"tune", command_tune},       {"belief", command_belief},     {"keys", command_keys},
};

static void refuse_command(const char *word) {
  enum { COUNT = sizeof commands / sizeof commands[0] };
  const char *known[COUNT + 3] = {"--help", "--version"};
  for (size_t i = 0; i < COUNT; i++) known[i + 2] = commands[i].name;
  const char *meant = near_word(word, known);
  if (meant != NULL)
    fprintf(stderr, "quarter: there is no command '%s'; did you mean '%s'?\n", word, meant);
  else
    fprintf(stderr, "quarter: there is no command '%s'; 'quarter --help' lists them\n", word);
}

/* Whatever a command said, it counts as said only once it has got through. */
static int finish(int status) {
  const bool failed = fflush(stdout) != 0 || ferror(stdout) != 0;
  if (!failed || (status != EXIT_SUCCESS && status < 128)) return status;
  fprintf(stderr, "quarter: standard output: cannot write: %s; send it elsewhere\n", strerror(errno));
  return EXIT_BAD_INPUT;
}

/* A closed descriptor would become that of the first file opened, and what is meant for it would end up there. */
static void hold_descriptors(void) {
  int descriptor;
  do descriptor = open("/dev/null", O_RDONLY);
  while (descriptor >= 0 && descriptor <= STDERR_FILENO);
  if (descriptor >= 0) close(descriptor);
}

static int run(int argc, char **argv) {
  const char *word = argc > 1 ? argv[1] : "--help";
  if (strcmp(word, "--help") == 0 || strcmp(word, "-h") == 0 || strcmp(word, "help") == 0) {
    fputs(help, argc > 1 ? stdout : stderr);
    return argc > 1 ? EXIT_SUCCESS : EXIT_BAD_INPUT;
  }
  if (strcmp(word, "--version") == 0) {
    puts("quarter " QTR_VERSION_STRING);
    return EXIT_SUCCESS;
  }
  for (size_t i = 0; i < sizeof commands / sizeof commands[0]; i++)
    if (strcmp(word, commands[i].name) == 0) return commands[i].run(argc - 1, argv + 1);
  refuse_command(word);
  return EXIT_BAD_INPUT;
}

int main(int argc, char **argv) {
  hold_descriptors();
  signal(SIGPIPE, SIG_IGN); /* a reader that has gone is an error like any other */
  return finish(run(argc, argv));
}

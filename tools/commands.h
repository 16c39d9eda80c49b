/* The commands of `quarter`: each takes its own words (argv[0] is its name) and returns the exit status. */
#ifndef QUARTER_TOOLS_COMMANDS_H
#define QUARTER_TOOLS_COMMANDS_H

int command_new(int argc, char **argv);
int command_learn(int argc, char **argv);
int command_exact(int argc, char **argv);
int command_simulate(int argc, char **argv);
int command_inspect(int argc, char **argv);
int command_tune(int argc, char **argv);
int command_belief(int argc, char **argv);
int command_compare(int argc, char **argv);
int command_draw(int argc, char **argv);
int command_keys(int argc, char **argv);
int command_check(int argc, char **argv);
int command_export(int argc, char **argv);

#endif

/* Identifiers for C and C++ from the names of files. */
#ifndef QUARTER_TOOLS_CNAME_H
#define QUARTER_TOOLS_CNAME_H

#define CNAME_SIZE 128

/* "out/mine field.c" becomes mine_field. What C or C++ keeps for itself gets a tail: int.c becomes int_policy. The name
 * with "_size" behind it is as good. */
void cname_of_path(char name[CNAME_SIZE], const char *path);

#endif

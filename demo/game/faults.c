#include "faults.h"

#include "host/base/file.h"
#include "host/input/tree.h"

#define LATEST 1e6 /* seconds */

int faults_add(fault_script *script, fault_event event) {
  if (script->count == FAULTS_MOST) return -1;
  int at = script->count++;
  for (; at > 0 && script->event[at - 1].at > event.at; at--) script->event[at] = script->event[at - 1];
  script->event[at] = event;
  return 0;
}

/* The number at a key, in a range; `otherwise` if the key is not there. */
static int read_number(tree *yaml, tree_node *item, const char *key, double least, double most, double otherwise,
                       double *number) {
  tree_node *node = tree_find(yaml, item, key);
  *number = otherwise;
  if (node == NULL) return 0;
  if (tree_number(yaml, node, key, number) != 0) return -1;
  if (*number >= least && *number <= most) return 0;
  return tree_fault(yaml, node, "%s: %g is not from %g to %g", key, *number, least, most);
}

static int read_robot(tree *yaml, tree_node *item, const char *key, int robots, int *robot) {
  tree_node *node = tree_find(yaml, item, key);
  long number = -1;
  *robot = -1;
  if (node == NULL) return 0;
  if (tree_integer(yaml, node, key, &number) != 0) return -1;
  if (number < 0 || number >= robots)
    return tree_fault(yaml, node, "%s: there is no robot %ld; they are 0 to %d", key, number, robots - 1);
  *robot = (int)number;
  return 0;
}

static int add(fault_script *script, tree *yaml, tree_node *item, fault_event event) {
  if (faults_add(script, event) == 0) return 0;
  return tree_fault(yaml, item, "more than %d faults; leave some out", FAULTS_MOST);
}

static int read_stuck(fault_script *script, tree *yaml, tree_node *item, double at, int robot) {
  double seconds;
  if (read_number(yaml, item, "for", 0.0, LATEST, 10.0, &seconds) != 0) return -1;
  if (add(script, yaml, item, (fault_event){at, FAULT_STUCK, robot, 0.0}) != 0) return -1;
  return add(script, yaml, item, (fault_event){at + seconds, FAULT_UNSTUCK, robot, 0.0});
}

static int read_share(fault_script *script, tree *yaml, tree_node *item, double at, const char *key, int kind,
                      int robot) {
  double share;
  if (read_number(yaml, item, key, 0.0, 0.95, 0.0, &share) != 0) return -1;
  return add(script, yaml, item, (fault_event){at, kind, robot, share});
}

/* What a fault is: the one of these keys that it has. */
static int read_kind(tree *yaml, tree_node *item, int *kind) {
  static const char *const keys[] = {"lost", "stuck", "slip", "loss"};
  static const int kinds[] = {FAULT_LOST, FAULT_STUCK, FAULT_SLIP, FAULT_LOSS};
  int count = 0;
  for (int i = 0; i < 4; i++) {
    if (tree_find(yaml, item, keys[i]) == NULL) continue;
    *kind = kinds[i];
    count++;
  }
  if (count != 1) return tree_fault(yaml, item, "a fault names one of lost, stuck, slip or loss, as {at: 20, lost: 1}");
  if (*kind != FAULT_STUCK && tree_find(yaml, item, "for") != NULL)
    return tree_fault(yaml, item, "for goes with stuck, as {at: 15, stuck: 0, for: 10}");
  if (*kind != FAULT_SLIP && tree_find(yaml, item, "robot") != NULL)
    return tree_fault(yaml, item, "robot goes with slip, as {at: 0, slip: 0.3, robot: 2}");
  return 0;
}

static int read_fault(fault_script *script, tree *yaml, tree_node *item, int robots) {
  static tree_keys keys = {"at", "lost", "stuck", "for", "slip", "robot", "loss", NULL};
  double at;
  int kind = FAULT_LOST, robot;
  if (tree_check_keys(yaml, item, "a fault", keys, false) != 0 || read_kind(yaml, item, &kind) != 0) return -1;
  if (read_number(yaml, item, "at", 0.0, LATEST, 0.0, &at) != 0) return -1;
  const char *whose = kind == FAULT_LOST ? "lost" : kind == FAULT_STUCK ? "stuck" : "robot";
  if (read_robot(yaml, item, whose, robots, &robot) != 0) return -1;
  switch (kind) {
  case FAULT_LOST: return add(script, yaml, item, (fault_event){at, FAULT_LOST, robot, 0.0});
  case FAULT_STUCK: return read_stuck(script, yaml, item, at, robot);
  case FAULT_SLIP: return read_share(script, yaml, item, at, "slip", FAULT_SLIP, robot);
  default: return read_share(script, yaml, item, at, "loss", FAULT_LOSS, -1);
  }
}

static int read_list(fault_script *script, tree *yaml, int robots) {
  static tree_keys keys = {"faults", NULL};
  if (tree_check_keys(yaml, tree_root(yaml), "a fault script", keys, false) != 0) return -1;
  tree_node *list = tree_need(yaml, tree_root(yaml), "a fault script", "faults", "faults: [{at: 20, lost: 1}]");
  if (list == NULL) return -1;
  if (tree_count(list) < 0) return tree_fault(yaml, list, "faults is a list, as [{at: 20, lost: 1}]");
  for (int i = 0; i < tree_count(list); i++)
    if (read_fault(script, yaml, tree_item(yaml, list, i), robots) != 0) return -1;
  return 0;
}

int faults_read(fault_script *script, const char *path, int robots, fault *why) {
  file_bytes bytes;
  tree yaml;
  script->count = 0;
  if (file_read(&bytes, path, FILE_TEXT_LIMIT, NULL, why) != 0) return -1;
  int status = tree_read(&yaml, path, &bytes, why);
  if (status == 0) {
    status = read_list(script, &yaml, robots);
    tree_free(&yaml);
  }
  file_free(&bytes);
  return status;
}

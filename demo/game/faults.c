#include "faults.h"

#include "body.h"
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

int faults_count(const fault_script *script, int kind) {
  int count = 0;
  for (int i = 0; script != NULL && i < script->count; i++) count += script->event[i].kind == kind;
  return count;
}

/* ---- numbers ---- */

/* The number at a key, in a range; `otherwise` if the key is not there. */
static int read_number(tree *yaml, tree_node *item, const char *key, double least, double most, double otherwise,
                       double *number) {
  tree_node *node = tree_find(yaml, item, key);
  *number = otherwise;
  if (node == NULL) return 0;
  if (tree_number(yaml, node, key, number) != 0) return -1;
  if (*number >= least && *number <= most) return 0;
  return tree_fault(yaml, node, "%s: %.10g is not from %.10g to %.10g", key, *number, least, most);
}

/* Whom a key names, by name or number; -1 if it is not there. */
static int read_robot(tree *yaml, tree_node *item, const char *key, const table *t, int *robot) {
  tree_node *node = tree_find(yaml, item, key);
  const naming n = table_naming(t);
  const char *word;
  char wrong[FAULT_LINE];
  *robot = -1;
  if (node == NULL) return 0;
  if (tree_text(yaml, node, key, &word) != 0) return -1;
  *robot = naming_find_seeker(&n, word, wrong);
  return *robot >= 0 ? 0 : tree_fault(yaml, node, "%s: %s", key, wrong);
}

/* ---- what is shut ---- */

static int read_index(tree *yaml, tree_node *node, const char *key, long *index) {
  tree_node *number = tree_need(yaml, node, "shut", key, "4");
  return number != NULL ? tree_integer(yaml, number, key, index) : -1;
}

/* The table's cell there; QTR_NO_CELL off the map, and where no robot can get to. */
static qtr_cell free_cell(const table *t, long column, long row) {
  if (column < 0 || column >= t->claim.map_columns || row < 0 || row >= t->claim.map_rows) return QTR_NO_CELL;
  const qtr_cell cell = table_cell(t, (int)column, (int)row);
  return cell != QTR_NO_CELL && qtr_grid_cost(&t->policy.grid, cell) != 0 ? cell : QTR_NO_CELL;
}

static int read_position(tree *yaml, tree_node *node, const table *t, qtr_cell *cell) {
  static tree_keys keys = {"column", "row", NULL};
  long column, row;
  if (tree_check_keys(yaml, node, "shut", keys, false) != 0) return -1;
  if (read_index(yaml, node, "column", &column) != 0 || read_index(yaml, node, "row", &row) != 0) return -1;
  *cell = free_cell(t, column, row);
  if (*cell != QTR_NO_CELL) return 0;
  return tree_fault(yaml, node, "shut: no robot can get to column %ld, row %ld as it is; name a free cell of the map",
                    column, row);
}

/* A place by its name or number, or a cell by its column and row on the map. */
static int read_shut(tree *yaml, tree_node *item, const table *t, qtr_cell *cell) {
  tree_node *node = tree_find(yaml, item, "shut");
  const naming n = table_naming(t);
  const char *word;
  char wrong[FAULT_LINE];
  if (tree_find(yaml, node, "column") != NULL || tree_find(yaml, node, "row") != NULL)
    return read_position(yaml, node, t, cell);
  if (tree_text(yaml, node, "shut", &word) != 0) return -1;
  const int place = naming_find_place(&n, word, wrong);
  if (place < 0) return tree_fault(yaml, node, "shut: %s", wrong);
  *cell = qtr_policy_cell(&t->policy, (unsigned)place);
  return 0;
}

/* ---- a fault ---- */

/* What a fault can be, by its key, and the key that says whose it is. */
typedef struct {
  const char *key, *whose;
  int kind;
} fault_name;

static const fault_name names[] = {{"lost", "lost", FAULT_LOST},  {"stuck", "stuck", FAULT_STUCK},
                                   {"slip", "robot", FAULT_SLIP}, {"loss", NULL, FAULT_LOSS},
                                   {"shut", NULL, FAULT_SHUT},    {"reset", "reset", FAULT_RESET}};
enum { NAMES = sizeof names / sizeof *names };

static int add(fault_script *script, tree *yaml, tree_node *item, fault_event event) {
  if (faults_add(script, event) == 0) return 0;
  return tree_fault(yaml, item, "more than %d faults; leave some out", FAULTS_MOST);
}

/* One that ends by itself. */
static int add_passing(fault_script *script, tree *yaml, tree_node *item, fault_event event) {
  const bool stuck = event.kind == FAULT_STUCK;
  double seconds;
  if (read_number(yaml, item, "for", stuck ? 0.0 : 1.0, LATEST, stuck ? 10.0 : 3.0, &seconds) != 0) return -1;
  if (add(script, yaml, item, event) != 0) return -1;
  event.at += seconds;
  event.kind = stuck ? FAULT_UNSTUCK : FAULT_RESTART;
  return add(script, yaml, item, event);
}

/* The one of the names that it has; NULL, with the fault told, if it has none, or several. */
static const fault_name *read_name(tree *yaml, tree_node *item) {
  const fault_name *name = NULL;
  int count = 0;
  for (int i = 0; i < NAMES; i++) {
    if (tree_find(yaml, item, names[i].key) == NULL) continue;
    name = &names[i];
    count++;
  }
  if (count == 1) return name;
  tree_fault(yaml, item, "a fault names one of lost, stuck, slip, loss, shut or reset, as {at: 20, lost: 1}");
  return NULL;
}

static int check_company(tree *yaml, tree_node *item, int kind) {
  if (kind != FAULT_STUCK && kind != FAULT_RESET && tree_find(yaml, item, "for") != NULL)
    return tree_fault(yaml, item, "for goes with stuck and reset, as {at: 15, stuck: 0, for: 10}");
  if (kind != FAULT_SLIP && tree_find(yaml, item, "robot") != NULL)
    return tree_fault(yaml, item, "robot goes with slip, as {at: 0, slip: 0.3, robot: 2}");
  return 0;
}

/* What it says beside when it is and whose. */
static int read_rest(fault_script *script, tree *yaml, tree_node *item, const table *t, const fault_name *name,
                     fault_event *event) {
  switch (name->kind) {
  case FAULT_STUCK:
  case FAULT_RESET: return add_passing(script, yaml, item, *event);
  case FAULT_SHUT:
    if (read_shut(yaml, item, t, &event->cell) != 0) return -1;
    break;
  case FAULT_SLIP:
  case FAULT_LOSS:
    if (read_number(yaml, item, name->key, 0.0, 0.95, 0.0, &event->share) != 0) return -1;
    break;
  default: break;
  }
  return add(script, yaml, item, *event);
}

static int read_fault(fault_script *script, tree *yaml, tree_node *item, const table *t) {
  static tree_keys keys = {"at", "lost", "stuck", "for", "slip", "robot", "loss", "shut", "reset", NULL};
  fault_event event = {.robot = -1};
  if (tree_check_keys(yaml, item, "a fault", keys, false) != 0) return -1;
  const fault_name *name = read_name(yaml, item);
  if (name == NULL || check_company(yaml, item, name->kind) != 0) return -1;
  event.kind = name->kind;
  if (read_number(yaml, item, "at", 0.0, LATEST, 0.0, &event.at) != 0) return -1;
  if (name->whose != NULL && read_robot(yaml, item, name->whose, t, &event.robot) != 0) return -1;
  return read_rest(script, yaml, item, t, name, &event);
}

static int read_list(fault_script *script, tree *yaml, const table *t) {
  static tree_keys keys = {"faults", NULL};
  if (tree_check_keys(yaml, tree_root(yaml), "a fault script", keys, false) != 0) return -1;
  tree_node *list = tree_need(yaml, tree_root(yaml), "a fault script", "faults", "faults: [{at: 20, lost: 1}]");
  if (list == NULL) return -1;
  if (tree_count(list) < 0) return tree_fault(yaml, list, "faults is a list, as [{at: 20, lost: 1}]");
  for (int i = 0; i < tree_count(list); i++)
    if (read_fault(script, yaml, tree_item(yaml, list, i), t) != 0) return -1;
  return 0;
}

int faults_read(fault_script *script, const char *path, const table *t, fault *why) {
  file_bytes bytes;
  tree yaml;
  script->count = 0;
  if (file_read(&bytes, path, FILE_TEXT_LIMIT, NULL, why) != 0) return -1;
  int status = tree_read(&yaml, path, &bytes, why);
  if (status == 0) {
    status = read_list(script, &yaml, t);
    tree_free(&yaml);
  }
  file_free(&bytes);
  for (int i = 0; i < script->count; i++) script->event[i].at /= body_pace(&t->policy);
  return status;
}

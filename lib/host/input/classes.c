#include "host/input/classes.h"

#include <stdio.h>
#include <string.h>

#include "host/base/near.h"
#include "host/input/mission_keys.h"

static const input_class unnamed = {.scan_seconds = INPUT_UNSAID, .endurance_seconds = INPUT_UNSAID, .rough = true};

/* ---- what they are ---- */

static int check_name(const input *in, tree *yaml, tree_node *node, const char *name, int count) {
  const char *wrong = name == NULL ? "is no plain word" : naming_wrong(name);
  if (wrong != NULL)
    return tree_fault(yaml, node, "the name of a class %s; give a text of at most %d bytes in one line", wrong,
                      QTR_SITE_NAME_BYTES - 1);
  for (int i = 0; i < count; i++)
    if (strcmp(in->terms.of_class[i].name, name) == 0)
      return tree_fault(yaml, node, "a second class is called '%s', after that of line %d; give it another name", name,
                        in->terms.of_class[i].line);
  return 0;
}

static int read_class(input *in, tree *yaml, tree_node *list, int i) {
  const char *name;
  char what[QTR_SITE_NAME_BYTES + 16];
  input_class *it = &in->terms.of_class[i];
  tree_node *node = tree_pair(yaml, list, i, &name);
  if (check_name(in, yaml, node, name, i)) return -1;
  *it = unnamed;
  it->line = tree_line(node);
  strcpy(it->name, name);
  snprintf(what, sizeof what, "class %s", name);
  if (keys_read(it, &mission_class_keys, yaml, node, what, NULL)) return -1;
  in->terms.stated = in->terms.stated || it->stated;
  in->mission.robot_class[i].smooth_only = !it->rough;
  return 0;
}

int classes_read(input *in, tree *yaml, tree_node *root) {
  tree_node *list = tree_find(yaml, root, "classes");
  in->terms.of_class[0] = unnamed;
  if (list == NULL) return 0;
  const int count = tree_pairs(list);
  if (count < 1)
    return tree_fault(yaml, list, "'classes' holds no class; write one, such as \"classes: {drone: {speed: 5}}\"");
  if (count > QTR_MAX_CLASSES)
    return tree_fault(yaml, list,
                      "%d classes are more than %d, the most that this build holds; list fewer, or build with a larger "
                      "QTR_MAX_CLASSES",
                      count, QTR_MAX_CLASSES);
  for (int i = 0; i < count; i++)
    if (read_class(in, yaml, list, i)) return -1;
  in->mission.classes = (uint8_t)count;
  return 0;
}

/* ---- who is of them ---- */

static int no_such_class(const input *in, const char *name, input_origin origin, fault *why) {
  const char *known[QTR_MAX_CLASSES + 1] = {NULL};
  char list[300];
  int count = 0;
  for (int i = 0; i < in->mission.classes; i++)
    if (in->terms.of_class[i].name[0] != '\0') known[count++] = in->terms.of_class[i].name;
  const char *path = input_source_path(in, origin), *meant = near_word(name, known);
  if (count == 0)
    return file_fault(why, path, origin.line, origin.column,
                      "there is no class '%s', for the mission has no 'classes'; add \"classes: {%s: {speed: 1}}\"",
                      name, name);
  if (meant != NULL)
    return file_fault(why, path, origin.line, origin.column, "there is no class '%s'; did you mean '%s'?", name, meant);
  near_list(list, sizeof list, known);
  return file_fault(why, path, origin.line, origin.column, "there is no class '%s'; 'classes' holds %s", name, list);
}

int classes_join(input *in, unsigned seeker, const char *name, input_origin origin, fault *why) {
  qtr_mission *mission = &in->mission;
  int of = 0;
  while (of < mission->classes && strcmp(in->terms.of_class[of].name, name) != 0) of++;
  if (of == mission->classes && name[0] != '\0') return no_such_class(in, name, origin, why);
  if (of == QTR_MAX_CLASSES)
    return file_fault(why, input_source_path(in, origin), origin.line, origin.column,
                      "a robot without a class is of one more, and %d are the most that this build holds; name one of "
                      "'classes', or build with a larger QTR_MAX_CLASSES",
                      QTR_MAX_CLASSES);
  if (of == mission->classes) in->terms.of_class[mission->classes++] = unnamed;
  mission->class_of[seeker] = (uint8_t)of;
  return 0;
}

/* ---- the rest ---- */

static int read_avoided(input *in, tree *yaml, tree_node *node, int of) {
  const naming n = input_naming(in);
  tree_node *list = tree_find(yaml, node, "avoid");
  for (int i = 0; list != NULL && i < tree_count(list); i++) {
    char wrong[FAULT_LINE];
    tree_node *item = tree_item(yaml, list, i);
    const char *word = tree_scalar(yaml, item, "avoid", "a list of places, by name or number");
    if (word == NULL) return -1;
    const int place = n.places > 0 ? naming_find_place(&n, word, wrong) : -1;
    if (place < 0)
      return tree_fault(yaml, item, "class %s avoids a place that is not there: %s", in->terms.of_class[of].name,
                        n.places > 0 ? wrong : "there are no places");
    qtr_places_add(&in->mission.robot_class[of].avoided, (unsigned)place);
  }
  return 0;
}

static int check_speed(const input *in, tree *yaml, tree_node *mapping) {
  tree_node *node = tree_find(yaml, mapping, "speed");
  if (node == NULL || in->frame.metric) return 0;
  return tree_fault(yaml, node,
                    "'speed' is in metres a second, and this map has no metres; add \"cell_size: 1\", the metres a "
                    "cell, or delete it");
}

static int check_objective(const input *in, tree *yaml, tree_node *root) {
  tree_node *deadline = tree_find(yaml, root, "deadline_seconds"), *home = tree_find(yaml, root, "home_weight");
  if (deadline != NULL && in->mission.aim.kind != QTR_DEADLINE)
    return tree_fault(yaml, deadline, "'deadline_seconds' is for \"objective: deadline\"; write that, or delete it");
  if (home != NULL && in->mission.aim.home_weight > 0.0 && in->mission.aim.kind != QTR_TIME)
    return tree_fault(yaml, home, "'home_weight' is for \"objective: time\"; write that, or delete it");
  return 0;
}

int classes_finish(input *in, tree *yaml, tree_node *root) {
  tree_node *list = tree_find(yaml, root, "classes");
  if (check_speed(in, yaml, root) || check_objective(in, yaml, root)) return -1;
  for (int i = 0; list != NULL && i < tree_pairs(list); i++) {
    const char *name;
    tree_node *node = tree_pair(yaml, list, i, &name);
    if (check_speed(in, yaml, node) || read_avoided(in, yaml, node, i)) return -1;
  }
  return 0;
}

/* A YAML document as a tree, with the line of every node and faults that name it. libyaml is behind it, and only
 * there. */
#ifndef QUARTER_HOST_TREE_H
#define QUARTER_HOST_TREE_H

#include <stdbool.h>
#include <stddef.h>

#include "host/base/file.h"
#include "host/input/value.h"

typedef struct {
  const char *path; /* for faults; must outlive the tree */
  fault *why;       /* where they go */
  fault *all; /* where they are gathered, so that reading goes on; NULL, as tree_read() has it: the first ends it */
  struct yaml_document_s *document;
} tree;

typedef const struct yaml_node_s tree_node;

/* Parse bytes that hold exactly one document, whose root is a mapping, and that libyaml would not take minutes for. 0,
 * or -1 with *fault set and nothing to free. */
int tree_read(tree *yaml, const char *path, const file_bytes *bytes, fault *why);
void tree_free(tree *yaml);

tree_node *tree_root(tree *yaml);
int tree_line(tree_node *node); /* from 1 */
int tree_fault(tree *yaml, tree_node *node, const char *format, ...) __attribute__((format(printf, 3, 4)));

#define TREE_KEYS_MOST 64

/* The keys that a mapping may have, ended by NULL; at most TREE_KEYS_MOST. */
typedef const char *const tree_keys[];

/* That `node` is a mapping with keys from `known` only, each at most once. `what` names it for the user ("a place").
 * With `others` keys that are nothing like a known one are allowed. 0, or -1 with the fault set. */
int tree_check_keys(tree *yaml, tree_node *node, const char *what, tree_keys known, bool others);

/* The value of a key; NULL if the mapping lacks it. */
tree_node *tree_find(tree *yaml, tree_node *mapping, const char *key);

/* The same, but lacking it is a fault that suggests `example`. */
tree_node *tree_need(tree *yaml, tree_node *mapping, const char *what, const char *key, const char *example);

/* Items of a list, -1 if it is none; and one of them. */
int tree_count(tree_node *list);
tree_node *tree_item(tree *yaml, tree_node *list, int index);

/* Pairs of a mapping, -1 if it is none; and the value of one of them with its key, NULL if that is no plain word. */
int tree_pairs(tree_node *mapping);
tree_node *tree_pair(tree *yaml, tree_node *mapping, int index, const char **key);

/* Whether a node is a plain value, and its text. */
bool tree_plain(tree *yaml, tree_node *node, const char **text);

/* Whether a mapping has a number for a key, as {x: 0,5} has. */
bool tree_has_number_key(tree *yaml, tree_node *mapping);

/* Where a node stands; and its text, or NULL with the fault set that it is no single value but should be `wanted`. */
value_site tree_site(tree *yaml, tree_node *node);
const char *tree_scalar(tree *yaml, tree_node *node, const char *key, const char *wanted);

/* A node's value as what it must be; `key` names it in the fault. 0, or -1 with the fault set. */
int tree_number(tree *yaml, tree_node *node, const char *key, double *out);
int tree_integer(tree *yaml, tree_node *node, const char *key, long *out);
int tree_text(tree *yaml, tree_node *node, const char *key,
              const char **out); /* not empty; lives as long as the tree */

/* One of `words` (ended by NULL, case ignored), as its index. */
int tree_word(tree *yaml, tree_node *node, const char *key, tree_keys words, int *out);

#endif

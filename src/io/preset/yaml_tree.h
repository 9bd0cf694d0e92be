/* A YAML text as a tree of nodes that know where they stand: one document, no anchors, aliases, tags or directives, no
 * key twice. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "base/text.h"

enum thud_yaml_kind { THUD_YAML_SCALAR, THUD_YAML_LIST, THUD_YAML_KEYS };

enum { THUD_YAML_DEPTH_MAX = 12, THUD_YAML_CHILDREN_MAX = 2000 };

/* Children of THUD_YAML_KEYS alternate between key and value. */
struct thud_yaml_node {
    enum thud_yaml_kind kind;
    bool quoted, flow;
    int line, column;                        /* from 1 */
    size_t start, end;                       /* bytes; of block lists and keys: to the end of the last child */
    size_t text, length;                     /* of a scalar: in the tree's pool, NUL-terminated */
    int parent, next, first, last, children; /* indices; -1: none */
};

struct thud_yaml {
    struct thud_yaml_node *node; /* node[0] is the root */
    int count;
    struct thud_text pool;
};

/* `name` stands in messages. Errors: THUD_INPUT with place, THUD_MEMORY. */
enum thud_status thud_yaml_read(const char *text, size_t size, const char *name, struct thud_yaml *tree,
                                struct thud_error *err);
void thud_yaml_clear(struct thud_yaml *tree);

const char *thud_yaml_text(const struct thud_yaml *tree, int node);
/* Value of a key, -1 where there is none; *key (may be NULL) gets the key's node. */
int thud_yaml_find(const struct thud_yaml *tree, int keys, const char *name, int *key);
/* Child by number from 0, -1 past the last. */
int thud_yaml_child(const struct thud_yaml *tree, int node, int index);

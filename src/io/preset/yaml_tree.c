#include "io/preset/yaml_tree.h"

#include <assert.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>
#include <yaml.h>

#include "base/grow.h"

/* What reading needs; libyaml counts characters, so `byte` says where each begins. */
struct reading {
    struct thud_yaml *tree;
    const char *text; /* behind a byte-order mark */
    size_t size, skipped;
    size_t *byte, characters;
    const char *name;
    struct thud_error *err;
    int open, depth; /* the collection whose children come now */
    bool whole;      /* the document has ended */
};

static enum thud_status refuse(struct reading *r, yaml_mark_t mark, const char *what, const char *allowed)
{
    thud_error_set(r->err, THUD_INPUT, "%s", what);
    thud_error_place(r->err, r->name, (int)mark.line + 1, (int)mark.column + 1);
    if (allowed)
        thud_error_allow(r->err, "%s", allowed);
    return THUD_INPUT;
}

static enum thud_status no_memory(struct reading *r)
{
    return thud_error_set(r->err, THUD_MEMORY, "out of memory");
}

/* Line and column of a byte. */
static yaml_mark_t mark_of(const struct reading *r, size_t byte)
{
    yaml_mark_t mark = {0};
    for (size_t i = 0; i < byte && i < r->size; i++) {
        mark.column = r->text[i] == '\n' ? 0 : mark.column + (((unsigned char)r->text[i] & 0xc0) != 0x80);
        mark.line += r->text[i] == '\n';
    }
    return mark;
}

static size_t byte_of(const struct reading *r, yaml_mark_t mark)
{
    size_t i = mark.index < r->characters ? mark.index : r->characters;
    return r->skipped + r->byte[i];
}

static bool map_characters(struct reading *r)
{
    r->byte = malloc((r->size + 1) * sizeof *r->byte);
    if (!r->byte)
        return false;
    for (size_t i = 0; i < r->size; i++)
        if (((unsigned char)r->text[i] & 0xc0) != 0x80)
            r->byte[r->characters++] = i;
    r->byte[r->characters] = r->size;
    return true;
}

/* Index of a new last child of the open collection, -1 without memory. */
static int add(struct reading *r, enum thud_yaml_kind kind, yaml_mark_t start, yaml_mark_t end)
{
    struct thud_yaml *tree = r->tree;
    struct thud_yaml_node *node = thud_grow(tree->node, (size_t)tree->count, sizeof *node);
    if (!node)
        return -1;
    tree->node = node;
    int index = tree->count++;
    node[index] = (struct thud_yaml_node){.kind = kind,
                                          .line = (int)start.line + 1,
                                          .column = (int)start.column + 1,
                                          .start = byte_of(r, start),
                                          .end = byte_of(r, end),
                                          .parent = r->open,
                                          .next = -1,
                                          .first = -1,
                                          .last = -1};
    if (r->open >= 0) {
        struct thud_yaml_node *parent = &tree->node[r->open];
        if (parent->last >= 0)
            tree->node[parent->last].next = index;
        else
            parent->first = index;
        parent->last = index;
        parent->children++;
    }
    return index;
}

static bool keep_text(struct thud_yaml *tree, int node, const char *text, size_t length)
{
    tree->node[node].text = tree->pool.size;
    tree->node[node].length = length;
    thud_text_bytes(&tree->pool, text, length);
    thud_text_bytes(&tree->pool, "", 1);
    return !tree->pool.failed;
}

/* Whether the next child of the open collection is a key. */
static bool key_expected(const struct reading *r)
{
    return r->open >= 0 && r->tree->node[r->open].kind == THUD_YAML_KEYS && r->tree->node[r->open].children % 2 == 0;
}

static enum thud_status check_duplicate(struct reading *r, int key, yaml_mark_t mark)
{
    const struct thud_yaml *tree = r->tree;
    const char *text = thud_yaml_text(tree, key);
    for (int i = tree->node[r->open].first; i != key && i >= 0; i = tree->node[tree->node[i].next].next)
        if (strcmp(thud_yaml_text(tree, i), text) == 0) {
            refuse(r, mark, "the key is given twice", NULL);
            thud_error_allow(r->err, "once; it is on line %d already", tree->node[i].line);
            thud_error_key(r->err, "%s", text);
            return THUD_INPUT;
        }
    return THUD_OK;
}

static enum thud_status take_scalar(struct reading *r, const yaml_event_t *event)
{
    const char *text = (const char *)event->data.scalar.value;
    size_t length = event->data.scalar.length;
    bool key = key_expected(r);
    if (memchr(text, '\0', length))
        return refuse(r, event->start_mark, "a NUL character", "printable text");
    int node = add(r, THUD_YAML_SCALAR, event->start_mark, event->end_mark);
    if (node < 0 || !keep_text(r->tree, node, text, length))
        return no_memory(r);
    struct thud_yaml_node *n = &r->tree->node[node];
    n->quoted = event->data.scalar.style != YAML_PLAIN_SCALAR_STYLE;
    while (n->end > n->start &&
           strchr(" \r\n", r->text[n->end - r->skipped - 1])) /* a block of lines goes on to the next key */
        n->end--;
    return key ? check_duplicate(r, node, event->start_mark) : THUD_OK;
}

static enum thud_status take_start(struct reading *r, const yaml_event_t *event, enum thud_yaml_kind kind, bool flow)
{
    if (key_expected(r))
        return refuse(r, event->start_mark, "a list or keys are given where a key is expected", "key: value");
    if (++r->depth > THUD_YAML_DEPTH_MAX)
        return refuse(r, event->start_mark, "nested too deeply", NULL);
    int node = add(r, kind, event->start_mark, event->end_mark);
    if (node < 0)
        return no_memory(r);
    r->tree->node[node].flow = flow;
    r->open = node;
    return THUD_OK;
}

static void take_end(struct reading *r, const yaml_event_t *event)
{
    struct thud_yaml_node *node = &r->tree->node[r->open];
    node->end = node->flow        ? byte_of(r, event->end_mark)
                : node->last >= 0 ? r->tree->node[node->last].end
                                  : node->start;
    r->open = node->parent;
    r->depth--;
}

static enum thud_status check_plain(struct reading *r, const yaml_event_t *event)
{
    const yaml_char_t *anchor = NULL, *tag = NULL;
    if (event->type == YAML_SCALAR_EVENT) {
        anchor = event->data.scalar.anchor;
        tag = event->data.scalar.tag;
    } else if (event->type == YAML_SEQUENCE_START_EVENT) {
        anchor = event->data.sequence_start.anchor;
        tag = event->data.sequence_start.tag;
    } else if (event->type == YAML_MAPPING_START_EVENT) {
        anchor = event->data.mapping_start.anchor;
        tag = event->data.mapping_start.tag;
    }
    if (event->type == YAML_ALIAS_EVENT)
        return refuse(r, event->start_mark, "aliases (*name) are not taken", "write the value out");
    if (anchor)
        return refuse(r, event->start_mark, "anchors (&name) are not taken", "write the value out");
    if (tag)
        return refuse(r, event->start_mark, "tags (!name) are not taken", "write the value alone");
    return THUD_OK;
}

static enum thud_status take_document(struct reading *r, const yaml_event_t *event)
{
    if (event->data.document_start.version_directive ||
        event->data.document_start.tag_directives.start != event->data.document_start.tag_directives.end)
        return refuse(r, event->start_mark, "directives (%YAML, %TAG) are not taken", "omit the line");
    if (r->whole)
        return refuse(r, event->start_mark, "a second document begins", "one in each file");
    return THUD_OK;
}

static enum thud_status add_event(struct reading *r, const yaml_event_t *event)
{
    enum thud_status status = check_plain(r, event);
    if (status != THUD_OK)
        return status;
    if (r->open >= 0 && r->tree->node[r->open].children >= THUD_YAML_CHILDREN_MAX)
        return refuse(r, event->start_mark, "too many values", NULL);
    switch (event->type) {
    case YAML_DOCUMENT_START_EVENT:
        return take_document(r, event);
    case YAML_DOCUMENT_END_EVENT:
        r->whole = true;
        return THUD_OK;
    case YAML_SCALAR_EVENT:
        return take_scalar(r, event);
    case YAML_SEQUENCE_START_EVENT:
        return take_start(r, event, THUD_YAML_LIST, event->data.sequence_start.style == YAML_FLOW_SEQUENCE_STYLE);
    case YAML_MAPPING_START_EVENT:
        return take_start(r, event, THUD_YAML_KEYS, event->data.mapping_start.style == YAML_FLOW_MAPPING_STYLE);
    case YAML_SEQUENCE_END_EVENT:
    case YAML_MAPPING_END_EVENT:
        take_end(r, event);
        return THUD_OK;
    default:
        return THUD_OK;
    }
}

/* What libyaml finds wrong. Its reader gives a byte and no mark. */
static enum thud_status syntax(struct reading *r, const yaml_parser_t *parser)
{
    yaml_mark_t mark = parser->problem_mark;
    if (parser->error == YAML_MEMORY_ERROR)
        return no_memory(r);
    if (parser->error == YAML_READER_ERROR)
        return refuse(r, mark_of(r, parser->problem_offset), parser->problem, "printable UTF-8 text");
    size_t at = byte_of(r, mark) - r->skipped;
    if (at < r->size && r->text[at] == '\t')
        return refuse(r, mark, "a tab is not allowed here", "spaces");
    return refuse(r, mark, parser->problem ? parser->problem : "not YAML", NULL);
}

static enum thud_status read_events(struct reading *r)
{
    yaml_parser_t parser;
    enum thud_status status = THUD_OK;
    if (!yaml_parser_initialize(&parser))
        return no_memory(r);
    yaml_parser_set_encoding(&parser, YAML_UTF8_ENCODING);
    yaml_parser_set_input_string(&parser, (const unsigned char *)r->text, r->size);
    for (bool end = false; status == THUD_OK && !end;) {
        yaml_event_t event;
        if (!yaml_parser_parse(&parser, &event)) {
            status = syntax(r, &parser);
            break;
        }
        end = event.type == YAML_STREAM_END_EVENT;
        status = add_event(r, &event);
        yaml_event_delete(&event);
    }
    yaml_parser_delete(&parser);
    return status;
}

static bool is_utf16(const char *text, size_t size)
{
    return size >= 2 && (memcmp(text, "\xff\xfe", 2) == 0 || memcmp(text, "\xfe\xff", 2) == 0);
}

/* YAML also ends a line at a carriage return alone, where editors and our own saving see none: what is changed there
 * would take the next line with it. */
static enum thud_status check_line_ends(struct reading *r)
{
    for (size_t i = 0; i < r->size; i++)
        if (r->text[i] == '\r' && (i + 1 == r->size || r->text[i + 1] != '\n'))
            return refuse(r, mark_of(r, i), "the line ends with a carriage return alone", "line ends LF or CR LF");
    return THUD_OK;
}

enum thud_status thud_yaml_read(const char *text, size_t size, const char *name, struct thud_yaml *tree,
                                struct thud_error *err)
{
    bool mark = size >= 3 && memcmp(text, "\xef\xbb\xbf", 3) == 0;
    struct reading r = {.tree = tree, .text = text, .size = size, .name = name, .err = err, .open = -1};
    *tree = (struct thud_yaml){0};
    if (is_utf16(text, size))
        return refuse(&r, (yaml_mark_t){0}, "the file is UTF-16", "UTF-8 text");
    if (mark) {
        r.text += 3;
        r.size -= 3;
        r.skipped = 3;
    }
    enum thud_status status = check_line_ends(&r);
    if (status == THUD_OK)
        status = map_characters(&r) ? read_events(&r) : no_memory(&r);
    if (status == THUD_OK && tree->count == 0)
        status = refuse(&r, (yaml_mark_t){0}, "the file is empty", "a preset, see thud-preset(5)");
    free(r.byte);
    if (status != THUD_OK)
        thud_yaml_clear(tree);
    return status;
}

void thud_yaml_clear(struct thud_yaml *tree)
{
    free(tree->node);
    thud_text_clear(&tree->pool);
    *tree = (struct thud_yaml){0};
}

const char *thud_yaml_text(const struct thud_yaml *tree, int node)
{
    assert(tree->node[node].kind == THUD_YAML_SCALAR);
    return tree->pool.data + tree->node[node].text;
}

int thud_yaml_find(const struct thud_yaml *tree, int keys, const char *name, int *key)
{
    if (keys < 0 || tree->node[keys].kind != THUD_YAML_KEYS)
        return -1;
    for (int i = tree->node[keys].first; i >= 0; i = tree->node[tree->node[i].next].next)
        if (strcmp(thud_yaml_text(tree, i), name) == 0) {
            if (key)
                *key = i;
            return tree->node[i].next;
        }
    return -1;
}

int thud_yaml_child(const struct thud_yaml *tree, int node, int index)
{
    int i = tree->node[node].first;
    while (i >= 0 && index-- > 0)
        i = tree->node[i].next;
    return i;
}

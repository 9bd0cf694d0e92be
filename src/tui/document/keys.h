/* What keys do where; the table is key_list.h. */
#pragma once

#include "base/text.h"
#include "tui/terminal/backend.h"

/* Where a key holds: a set of screens or modes. */
enum {
    THUD_AT_MODEL = 1,
    THUD_AT_CONTACT = 2,
    THUD_AT_RECORD = 4,
    THUD_AT_RESULTS = 8,
    THUD_AT_PLOTS = 16,
    THUD_AT_SWEEP = 32,
    THUD_AT_HELP = 128,
    THUD_AT_TYPING = 256,
    THUD_AT_CHOOSING = 512,
    THUD_AT_MODEL_CONTACT = THUD_AT_MODEL | THUD_AT_CONTACT,
    THUD_AT_SIDE = 1024, /* the fields at the side of Plots on a wide terminal */
    THUD_AT_PLOTS_SIDE = THUD_AT_PLOTS | THUD_AT_SIDE,
    THUD_AT_OTHER = 4096, /* a screen without keys of its own */
    THUD_AT_FORMS = THUD_AT_MODEL | THUD_AT_CONTACT | THUD_AT_RECORD | THUD_AT_RESULTS | THUD_AT_SWEEP | THUD_AT_SIDE |
                    THUD_AT_OTHER,
    THUD_AT_NEW = 2048, /* the form of a new scene */
    THUD_AT_SHELF = 8192,
    THUD_AT_DESIGNS = 16384, /* their list */
    THUD_AT_GENERAL = 255 | THUD_AT_SIDE | THUD_AT_OTHER
};

enum thud_action {
    THUD_DO_NOTHING,
#define THUD_KEY(where, action, ...) THUD_DO_##action,
#define THUD_KEY_AGAIN(...)
#include "tui/document/key_list.h"
#undef THUD_KEY
#undef THUD_KEY_AGAIN
    THUD_ACTIONS
};

struct thud_key_entry {
    int where;
    enum thud_action action;
    int key, other;
    const char *written, *label, *help;
};

int thud_key_count(void);
const struct thud_key_entry *thud_key_at(int index);
/* What `key` does at `where` (one bit). */
enum thud_action thud_key_action(int where, int key);

void thud_commands_text(struct thud_text *out); /* ":word arguments" a line */

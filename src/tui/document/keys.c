#include <stddef.h>

#include "tui/document/keys.h"
#include "tui/tui.h"

static const struct thud_key_entry table[] = {
#define THUD_KEY(where, action, key, other, written, label, help)                                                      \
    {THUD_AT_##where, THUD_DO_##action, key, other, written, label, help},
#define THUD_KEY_AGAIN THUD_KEY
#include "tui/document/key_list.h"
#undef THUD_KEY_AGAIN
#undef THUD_KEY
};

int thud_key_count(void)
{
    return (int)(sizeof table / sizeof *table);
}

const struct thud_key_entry *thud_key_at(int index)
{
    return &table[index];
}

enum thud_action thud_key_action(int where, int key)
{
    for (int i = 0; i < thud_key_count(); i++)
        if ((table[i].where & where) && (table[i].key == key || (table[i].other && table[i].other == key)))
            return table[i].action;
    return THUD_DO_NOTHING;
}

static const struct {
    int where;
    const char *name;
} places[] = {{THUD_AT_GENERAL, "All screens"},
              {THUD_AT_FORMS, "Fields"},
              {THUD_AT_MODEL, "Model"},
              {THUD_AT_CONTACT, "Contact"},
              {THUD_AT_RECORD, "Record"},
              {THUD_AT_RESULTS, "Results"},
              {THUD_AT_PLOTS, "Plots"},
              {THUD_AT_SWEEP, "Sweep"},
              {THUD_AT_HELP, "Help"},
              {THUD_AT_TYPING, "While typing"},
              {THUD_AT_CHOOSING, "In a list"},
              {THUD_AT_NEW, "New scene"},
              {THUD_AT_SHELF, "Shelf of figures"},
              {THUD_AT_DESIGNS, "Designs"}};

void thud_tui_keys_text(struct thud_text *out)
{
    for (size_t place = 0; place < sizeof places / sizeof *places; place++)
        for (int i = 0; i < thud_key_count(); i++) {
            bool set = table[i].where == THUD_AT_GENERAL || table[i].where == THUD_AT_FORMS;
            if (set ? table[i].where == places[place].where : table[i].where & places[place].where && place > 1)
                thud_text_append(out, "%s\t%s\t%s\n", places[place].name, table[i].written, table[i].help);
        }
}

void thud_commands_text(struct thud_text *out)
{
#define THUD_RUN(word, short_word, usage, name) thud_text_append(out, ":%s %s\n", word, usage);
#define THUD_BY(word, usage, function)          thud_text_append(out, ":%s %s\n", word, usage);
#define THUD_SET(word, usage, key)              thud_text_append(out, ":%s %s\n", word, usage);
#define THUD_ACT(word, short_word, action)      thud_text_append(out, ":%s \n", word);
#define THUD_OF(word, usage, screen)            thud_text_append(out, ":%s %s\n", word, usage);
#define THUD_CLI(word, id)                      thud_text_append(out, ":%s [OPTION ...]\n", word);
#include "tui/document/command_list.h"
}

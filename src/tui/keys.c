#include "tui/keys.h"

static const struct thud_key_entry table[] = {
#define THUD_KEY(where, action, key, other, written, label, help)                                                      \
    {THUD_AT_##where, THUD_DO_##action, key, other, written, label, help},
#define THUD_KEY_AGAIN THUD_KEY
#include "tui/key_list.h"
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

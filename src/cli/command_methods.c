/* thud methods: the time-stepping methods with their order and limits. */

#include "cli/commands.h"
#include "core/methods/method.h"
#include "io/result/list_rows.h"

static void table(struct thud_text *out)
{
    thud_text_append(out, "auto: the exact method; a run says what it came to\n");
    for (int i = 0; i < thud_method_count(); i++) {
        const struct thud_method *m = thud_method_at(i);
        thud_text_append(out, "\n%s: %s\n", m->name, m->title);
        thud_cli_words(m->summary, out);
        thud_cli_references(m->reference, out);
        thud_text_append(out, "  ");
        if (m->order > 0)
            thud_text_append(out, "order %d; ", m->order);
        thud_text_append(out, "%s; %s", m->flags & THUD_METHOD_FIXED_STEP ? "fixed step" : "takes a tolerance",
                         m->flags & THUD_METHOD_LOCATES      ? "events located"
                         : m->flags & THUD_METHOD_CAN_LOCATE ? "events located on request"
                                                             : "events not located");
        thud_text_append(out, "\n");
        thud_cli_words(m->limits, out);
    }
}

enum thud_status thud_command_methods(const struct thud_args *args, struct thud_error *err)
{
    return thud_cli_list(args, table, thud_methods_put, err);
}

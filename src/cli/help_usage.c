#include "cli/help.h"

#include <stdio.h>
#include <string.h>

void thud_help_all(struct thud_text *out)
{
    thud_text_append(out, "thud: earthquake pounding of neighbouring buildings\n");
    for (int i = 0; i < THUD_COMMANDS; i++) {
        const struct thud_command *command = thud_command_at((enum thud_command_id)i);
        char usage[64];
        snprintf(usage, sizeof usage, "thud %s%s%s", command->name, command->name[0] ? " " : "", command->operands);
        thud_text_append(out, "  %-26s %s\n", usage, command->summary);
    }
    thud_text_append(out, "PRESET: a name (towers) or a file. Options: thud help COMMAND. Manual: thud(1)\n");
}

void thud_help_command(struct thud_text *out, enum thud_command_id id)
{
    const struct thud_command *command = thud_command_at(id);
    const char *part = "";
    thud_text_append(out, "usage: thud %s%s%s%s[options]\n%s\n", command->name, command->name[0] ? " " : "",
                     command->operands, command->operands[0] ? " " : "", command->summary);
    for (int i = 0; i < thud_option_count(); i++) {
        const struct thud_option *option = thud_option_at(i);
        char usage[64];
        if (!thud_option_belongs(option, id))
            continue;
        if (strcmp(part, thud_option_part(i)) != 0)
            thud_text_append(out, "\n%s\n", thud_option_part(i));
        part = thud_option_part(i);
        snprintf(usage, sizeof usage, "%s%s%s%s", option->name[1] ? "--" : "-", option->name,
                 thud_option_stands_alone(option) ? "" : " ", option->argument ? option->argument : "");
        thud_text_append(out, "  %-25s %s%s\n", usage, option->help, option->repeatable ? " (repeatable)" : "");
    }
}

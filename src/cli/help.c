#include "cli/help.h"

#include <stdio.h>
#include <string.h>

void thud_help_all(struct thud_text *out)
{
    thud_text_append(out, "thud: earthquake pounding of neighbouring buildings\n\n");
    for (int i = 0; i < THUD_COMMANDS; i++) {
        const struct thud_command *command = thud_command_at((enum thud_command_id)i);
        char usage[64];
        snprintf(usage, sizeof usage, "thud %s%s%s", command->name, command->name[0] ? " " : "", command->operands);
        thud_text_append(out, "  %-26s %s\n", usage, command->summary);
    }
    thud_text_append(out, "\nA PRESET is a name (towers) or a file. Options: `thud help COMMAND`.\n"
                          "Manual: thud(1), thud-preset(5), thud-output(5), thud-model(7), thud-methods(7)\n");
}

/* How a record is read, `thud record` says too. */
static bool said_by_record(const struct thud_option *option, enum thud_command_id id)
{
    return id == THUD_COMMAND_RUN && option->argument && thud_option_belongs(option, THUD_COMMAND_RECORD) &&
           !thud_option_belongs(option, THUD_COMMAND_BENCH) && !thud_option_belongs(option, THUD_COMMAND_FIGURES) &&
           strcmp(option->name, "periods") != 0;
}

/* What is asked of floor spectra; thud(1) says it. */
static bool said_of_spectra(const struct thud_option *option, enum thud_command_id id)
{
    return id == THUD_COMMAND_RUN && (strcmp(option->name, "periods") == 0 || strcmp(option->name, "floor") == 0);
}

/* What every command with a ground motion takes, `thud run` says. */
static bool of_every_motion(const struct thud_option *option, enum thud_command_id id)
{
    bool spectral = strcmp(option->name, "sa") == 0 || strcmp(option->name, "period") == 0;
    return (id == THUD_COMMAND_RECORD || id == THUD_COMMAND_SUITE) && option->argument && option->name[1] &&
           thud_option_belongs(option, THUD_COMMAND_RUN) &&
           (spectral || thud_option_belongs(option, THUD_COMMAND_BENCH)) && strcmp(option->name, "format") != 0;
}

/* The names of the options that another command's help explains. */
static void name_others(struct thud_text *out, enum thud_command_id id, const char *lead, const char *end,
                        bool (*said)(const struct thud_option *option, enum thud_command_id id))
{
    thud_text_append(out, "%s:", lead);
    for (int i = 0; i < thud_option_count(); i++)
        if (thud_option_belongs(thud_option_at(i), id) && said(thud_option_at(i), id))
            thud_text_append(out, " %s%s", thud_option_at(i)->name[1] ? "--" : "-", thud_option_at(i)->name);
    thud_text_append(out, "%s", end);
}

/* Commands whose help does not say again what a run's says of the scene. */
static bool is_study(enum thud_command_id id)
{
    return id == THUD_COMMAND_SWEEP || id == THUD_COMMAND_GAP || id == THUD_COMMAND_FRAGILITY ||
           id == THUD_COMMAND_UNCERTAINTY || id == THUD_COMMAND_REPORT;
}

/* A study takes all that a run takes; what a run's help says of its scene is not said again. */
static bool said_by_run(const struct thud_option *option, enum thud_command_id id)
{
    return is_study(id) && !thud_option_stands_alone(option) && thud_option_belongs(option, THUD_COMMAND_RUN) &&
           (!thud_option_belongs(option, THUD_COMMAND_FIGURES) || thud_option_belongs(option, THUD_COMMAND_RECORD));
}

/* How large pictures are and in what type, `thud figures` says for others that have much to say. */
static bool said_by_figures(const struct thud_option *option, enum thud_command_id id)
{
    if (id == THUD_COMMAND_RUN && strcmp(option->name, "j") == 0)
        return true;
    return (id == THUD_COMMAND_RUN || id == THUD_COMMAND_SWEEP) &&
           (strcmp(option->name, "format") == 0 || strcmp(option->name, "size") == 0 ||
            strcmp(option->name, "width") == 0 || strcmp(option->name, "font") == 0);
}

void thud_help_command(struct thud_text *out, enum thud_command_id id)
{
    const struct thud_command *command = thud_command_at(id);
    thud_text_append(out, "usage: thud %s%s%s%s[options]\n%s\n\n", command->name, command->name[0] ? " " : "",
                     command->operands, command->operands[0] ? " " : "", command->summary);
    for (int i = 0; i < thud_option_count(); i++) {
        const struct thud_option *option = thud_option_at(i);
        /* whoever reads this has found --help, and the list must fit a screen */
        if (!thud_option_belongs(option, id) || said_by_run(option, id) || said_by_record(option, id) ||
            of_every_motion(option, id) || said_by_figures(option, id) || said_of_spectra(option, id) ||
            strcmp(option->name, "help") == 0)
            continue;
        char usage[64];
        snprintf(usage, sizeof usage, "%s%s%s%s", option->name[1] ? "--" : "-", option->name,
                 thud_option_stands_alone(option) ? "" : " ", option->argument ? option->argument : "");
        thud_text_append(out, "  %-25s %s%s\n", usage, option->help, option->repeatable ? " (repeatable)" : "");
    }
    if (id == THUD_COMMAND_RUN) /* no empty line: it fills a screen */
        name_others(out, id, "of `record`", "\n", said_by_record);
    if (id == THUD_COMMAND_RUN)
        name_others(out, id, "of `figures`", "; ", said_by_figures);
    if (id == THUD_COMMAND_RUN)
        name_others(out, id, "of spectra", "\n", said_of_spectra);
    if (id == THUD_COMMAND_RECORD || id == THUD_COMMAND_SUITE)
        name_others(out, id, "\nof `run`", "\n", of_every_motion);
    if (is_study(id))
        thud_text_append(out, "and what `thud run --help` says of the scene, its ground motion and its method\n");
}

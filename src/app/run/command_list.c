#include "app/run/command.h"

#include <stddef.h>
#include <string.h>

/* Operands after the first are of the same kind. */
#define COMMAND(name, operands, help, word)                                                                            \
    {                                                                                                                  \
        name, operands, help, THUD_WORD_##word, THUD_WORD_NONE                                                         \
    }

static const struct thud_command commands[THUD_COMMANDS] = {
    [THUD_COMMAND_SCREEN] = COMMAND("", "[PRESET]", "the terminal interface", PRESET),
    [THUD_COMMAND_RUN] = COMMAND("run", "PRESET", "one scene, one result", PRESET),
    [THUD_COMMAND_NEW] = COMMAND("new", "FILE", "a preset of two neighbours to start from", FILE),
    [THUD_COMMAND_SWEEP] = COMMAND("sweep", "PRESET", "a parametric study; by default the preset's own", PRESET),
    [THUD_COMMAND_GAP] = COMMAND("gap", "PRESET", "the required gap, compared with rules of codes", PRESET),
    [THUD_COMMAND_SOLVE] = COMMAND("solve", "PRESET", "the value at which a criterion is met", PRESET),
    [THUD_COMMAND_FRAGILITY] = COMMAND("fragility", "PRESET", "event probability against intensity and gap", PRESET),
    [THUD_COMMAND_UNCERTAINTY] = COMMAND("uncertainty", "PRESET", "propagation of the inputs' uncertainty", PRESET),
    [THUD_COMMAND_FIGURES] = COMMAND("figures", "[NAME...]", "fig2 to fig10 of the paper, or all", FIGURE),
    [THUD_COMMAND_SIMPLIFY] = COMMAND("simplify", "PRESET", "the cheapest model that keeps an accuracy", PRESET),
    [THUD_COMMAND_BENCH] = COMMAND("bench", "[PRESET]", "speed against accuracy of every method", PRESET),
    [THUD_COMMAND_STABILITY] = COMMAND("stability", "[PRESET]", "where methods fail", PRESET),
    [THUD_COMMAND_VERIFY] = COMMAND("verify", "[PRESET...]", "presets against their stored expectations", PRESET),
    [THUD_COMMAND_RECORD] = {"record", "VERB [FILE...]", "info, spectrum, convert, list or synthesize",
                             THUD_WORD_RECORD_VERB, THUD_WORD_FILE},
    [THUD_COMMAND_SUITE] = COMMAND("suite", "FOLDER", "motions selected and scaled to a design spectrum", FILE),
    [THUD_COMMAND_REPORT] = COMMAND("report", "PRESET", "a document about your buildings: HTML, Markdown", PRESET),
    [THUD_COMMAND_EXPORT] = {"export", "PROGRAM PRESET", "the scene as a script: opensees", THUD_WORD_PROGRAM,
                             THUD_WORD_PRESET},
    [THUD_COMMAND_STIFFNESS] = COMMAND("stiffness", "PRESET", "contact stiffness from slabs, and its effect", PRESET),
    [THUD_COMMAND_BUILDING] = {"building", "PRESET", "its storeys; import FILE: a matrix, modes, tables",
                               THUD_WORD_BUILDING_VERB, THUD_WORD_FILE},
    [THUD_COMMAND_LAWS] = COMMAND("laws", "[NAME]", "impact laws and the restitution they actually give", NONE),
    [THUD_COMMAND_METHODS] = COMMAND("methods", "", "time-stepping methods, their order and limits", NONE),
    [THUD_COMMAND_HELP] = COMMAND("help", "[WORDS]", "this list, a command, or a search of the manual", COMMAND),
};

enum {
    RUN = 1 << THUD_COMMAND_RUN,
    SWEEP = 1 << THUD_COMMAND_SWEEP | 1 << THUD_COMMAND_FRAGILITY,
    FRAGILITY = 1 << THUD_COMMAND_FRAGILITY,
    UNCERTAINTY = 1 << THUD_COMMAND_UNCERTAINTY,
    GAP = 1 << THUD_COMMAND_GAP | UNCERTAINTY,
    SUITE = 1 << THUD_COMMAND_SUITE,
    RECORD = 1 << THUD_COMMAND_RECORD | SUITE,
    RECORD_VERBS = 1 << THUD_COMMAND_RECORD,
    STUDY = RUN | SWEEP | GAP,
    FIGURES = 1 << THUD_COMMAND_FIGURES,
    PICTURES = STUDY | FIGURES | 1 << THUD_COMMAND_BENCH | 1 << THUD_COMMAND_STABILITY,
    FILES = PICTURES | RECORD | 1 << THUD_COMMAND_SIMPLIFY,
    LISTS = 1 << THUD_COMMAND_LAWS | 1 << THUD_COMMAND_METHODS,
    BENCH = 1 << THUD_COMMAND_BENCH,
    STIFFNESS = 1 << THUD_COMMAND_STIFFNESS,
    SIMPLIFY = 1 << THUD_COMMAND_SIMPLIFY,
    SOLVE = 1 << THUD_COMMAND_SOLVE | SIMPLIFY,
    SOLVE_ALONE = 1 << THUD_COMMAND_SOLVE,
    BUILDING = 1 << THUD_COMMAND_BUILDING,
    REPORT = 1 << THUD_COMMAND_REPORT,
    EXPORT = 1 << THUD_COMMAND_EXPORT,
    VERIFY = 1 << THUD_COMMAND_VERIFY,
    SCREEN = 1 << THUD_COMMAND_SCREEN,
    NEW = 1 << THUD_COMMAND_NEW,
    MEASURE = 1 << THUD_COMMAND_BENCH | 1 << THUD_COMMAND_STABILITY,
    MOTION = STUDY | RECORD | EXPORT | REPORT | STIFFNESS | SOLVE, /* what specifies a ground motion */
    ALL = (1 << THUD_COMMANDS) - 1
};

static const struct thud_option options[] = {
    {"set", "KEY=VALUE", "set a value: gap=12cm", THUD_WORD_KEY, true,
     STUDY | MEASURE | RECORD_VERBS | SCREEN | EXPORT | REPORT | STIFFNESS | SOLVE | NEW | BUILDING},
    {"case", "CASE", "none, bumper, cavity or link; default as written", THUD_WORD_CASE, false,
     RUN | SWEEP | UNCERTAINTY | MEASURE | EXPORT | STIFFNESS | SOLVE_ALONE},
    {"record", "FILE", "the ground motion", THUD_WORD_FILE, false,
     STUDY | MEASURE | SCREEN | VERIFY | EXPORT | REPORT | STIFFNESS | SOLVE},
    {"peak", "ACCELERATION", "scale the ground motion to this peak, e.g. \"0.821 g\"", THUD_WORD_TEXT, false,
     STUDY | MEASURE | FIGURES | RECORD | SCREEN | EXPORT | REPORT | STIFFNESS | SOLVE},
    {"sa", "ACCELERATION", "scale to this spectral acceleration, 5 % damped", THUD_WORD_TEXT, false, MOTION},
    {"period", "TIME", "period of --sa; default: mean of the first periods", THUD_WORD_TEXT, false, MOTION},
    {"dt", "TIME", "time step, if the record does not state it", THUD_WORD_TEXT, false,
     STUDY | MEASURE | FIGURES | RECORD | SCREEN | VERIFY | EXPORT | REPORT | STIFFNESS | SOLVE},
    {"unit", "UNIT", "unit, if the record does not state it", THUD_WORD_CHOICE, false,
     STUDY | MEASURE | FIGURES | RECORD | SCREEN | VERIFY | EXPORT | REPORT | STIFFNESS | SOLVE},
    {"channel", "NAME", "channel of a record with several, by number or name", THUD_WORD_TEXT, false, MOTION},
    {"component", "NAME", "NS, 090, rotd50, rotd100, rot30 or governs", THUD_WORD_TEXT, false, MOTION},
    {"column", "N", "column of the acceleration in a table, or all", THUD_WORD_TEXT, false, MOTION},
    {"skip", "N", "lines to skip at a record's start", THUD_WORD_TEXT, false, MOTION},
    {"factor", "NUMBER", "multiply the ground motion", THUD_WORD_TEXT, false, MOTION},
    {"sign", "+|-", "- reverses the polarity of the ground motion", THUD_WORD_CHOICE, false, MOTION},
    {"from", "TIME", "discard the record before this time", THUD_WORD_TEXT, false, MOTION},
    {"to", "TIME", "discard the record after this time", THUD_WORD_TEXT, false, MOTION},
    {"baseline", "mean|linear|N", "remove the mean, a linear trend or a polynomial", THUD_WORD_CHOICE, false,
     RECORD_VERBS},
    {"taper", "TIME", "apply a cosine taper at both ends", THUD_WORD_TEXT, false, RECORD_VERBS},
    {"high-pass", "FREQUENCY", "remove lower frequencies, e.g. 0.1Hz", THUD_WORD_TEXT, false, RECORD_VERBS},
    {"band-pass", "FROM:TO", "keep the frequencies between, e.g. 0.1Hz:25Hz", THUD_WORD_TEXT, false, RECORD_VERBS},
    {"order", "N", "order of the Butterworth filter, default 4", THUD_WORD_TEXT, false, RECORD_VERBS},
    {"resample", "TIME", "change the time step by linear interpolation", THUD_WORD_TEXT, false, RECORD_VERBS},
    {"damping", "RATIO", "damping of the spectrum, default 5 %", THUD_WORD_TEXT, false, RECORD_VERBS},
    {"periods", "FROM:TO:COUNT", "periods of the spectrum, default 0.02s:10s:200", THUD_WORD_TEXT, false,
     RECORD_VERBS | RUN},
    {"preset", "PRESET", "mark the periods of its structures", THUD_WORD_PRESET, false, RECORD},
    {"method", "NAME", "one of `thud methods`, or auto", THUD_WORD_METHOD, false,
     STUDY | SCREEN | EXPORT | REPORT | STIFFNESS | SOLVE},
    {"step", "TIME", "step of a fixed-step method, e.g. 1e-4s", THUD_WORD_TEXT, false, STUDY | SCREEN},
    {"tolerance", "NUMBER", "1e-6: every peak within 1e-5 of the converged one", THUD_WORD_TEXT, false,
     STUDY | SCREEN | EXPORT | REPORT | STIFFNESS | SOLVE},
    {"modes", "N", "lowest modes of each building only, and the error", THUD_WORD_TEXT, false, STUDY},
    {"sensitivity", "[=CHANGE]", "peaks if gap, motion or stiffness change by 0.1 %", THUD_WORD_NONE, false,
     RUN | 1 << THUD_COMMAND_SWEEP},
    {"events", NULL, "every event instead of the peaks", THUD_WORD_NONE, false, RUN},
    {"floor-spectra", "RATIO", "floor response spectra at this damping, e.g. 5%", THUD_WORD_TEXT, false, RUN},
    {"floor", "NAME.FLOOR", "floor, e.g. A.4; default all", THUD_WORD_TEXT, true, RUN},
    {"vary", "KEY=FROM:TO:STEP", "vary a value; several make a grid", THUD_WORD_KEY, true, SWEEP},
    {"records", "FILE,...", "files, a folder or a .list, e.g. a.AT2:peak=0.9g", THUD_WORD_FILE, false,
     SWEEP | GAP | FIGURES | REPORT | SOLVE},
    {"signs", "both", "every ground motion in both polarities", THUD_WORD_CHOICE, false, SWEEP | GAP | REPORT | SOLVE},
    {"for", "CRITERION", "criterion: \"force < 10 MN\", \"no pounding\"", THUD_WORD_TEXT, false, SOLVE_ALONE},
    {"within", "RATIO", "accuracy to keep, default 5 %", THUD_WORD_TEXT, false, SIMPLIFY},
    {"by", "KEY=FROM:TO", "key that may change, and its range", THUD_WORD_KEY, false, SOLVE_ALONE},
    {"share", "RATIO", "fraction of the ground motions, e.g. 84%", THUD_WORD_TEXT, false, SOLVE_ALONE},
    {"code", "KEY=NUMBER,...", "q=1.5, cd=4, r=8, intensity=8", THUD_WORD_TEXT, true, 1 << THUD_COMMAND_GAP},
    {"cases", "CASE,CASE", "run each of these cases", THUD_WORD_CASE, false, RUN | SWEEP | SIMPLIFY},
    {"event", "EVENT", "pounding, worse, drift:1%, ductility:2", THUD_WORD_TEXT, true, FRAGILITY},
    {"hazard", "FILE", "intensity and annual rate, as CSV", THUD_WORD_FILE, false, FRAGILITY},
    {"samples", "N", "samples or bootstrap draws, default 200 (report 100)", THUD_WORD_TEXT, false,
     FRAGILITY | UNCERTAINTY | REPORT},
    {"sampling", "WAY", "of the inputs: latin-hypercube or sobol", THUD_WORD_CHOICE, false, UNCERTAINTY | REPORT},
    {"seed", "N", "seed of the random samples, default 1", THUD_WORD_TEXT, false, FRAGILITY | UNCERTAINTY | REPORT},
    {"uncertain", "INPUT=SIZE", "gap=5%, stiffness.A=9%, restitution=0.1", THUD_WORD_TEXT, true, UNCERTAINTY | REPORT},
    {"indices", NULL, "Sobol indices, first and total", THUD_WORD_NONE, false, UNCERTAINTY},
    {"check", NULL, "run the script and compare its peaks", THUD_WORD_NONE, false, EXPORT},
    {"strict", NULL, "refuse what the other program cannot represent", THUD_WORD_NONE, false, EXPORT},
    {"best", "KEY", "best value of a varied key, for each other setting", THUD_WORD_VARIED, false,
     1 << THUD_COMMAND_SWEEP},
    {"shard", "K/N", "every N-th point, starting with the K-th", THUD_WORD_TEXT, false, SWEEP},
    {"merge", NULL, "join the folders of all shards", THUD_WORD_NONE, false, SWEEP},
    {"without", "SHORTCUT", "turn off: free, start, levels or same", THUD_WORD_CHOICE, true, SWEEP},
    {"slab", "AREA,LENGTH,MODULUS", "E A/L of a slab, e.g. 3m2,15m,30GPa", THUD_WORD_TEXT, true, STIFFNESS},
    {"pad", "AREA,MODULUS,THICKNESS", "alpha A K_r/d^n, e.g. 0.5m2,5MPa,5cm", THUD_WORD_TEXT, false, STIFFNESS},
    {"update", NULL, "write new expectations and show the difference", THUD_WORD_NONE, false, VERIFY},
    {"published", NULL, "compare with numbers of books and manuals", THUD_WORD_NONE, false, VERIFY},
    {"methods", "NAME,NAME", "only these methods", THUD_WORD_METHOD, false, BENCH},
    {"patience", "TIME", "skip what takes longer, default 12 s", THUD_WORD_TEXT, false, BENCH},
    {"target", "SPECTRUM", "design spectrum, e.g. en1998:0.3g,B, or a CSV", THUD_WORD_TEXT, false, SUITE | REPORT},
    {"count", "N", "number of motions to select, default all allowed", THUD_WORD_TEXT, false, SUITE},
    {"scale", "each|common", "each to its least misfit, or all by one factor", THUD_WORD_CHOICE, false, SUITE},
    {"range", "FROM:TO", "range of periods, default 0.2 to 2 first periods", THUD_WORD_TEXT, false, SUITE},
    {"factor-most", "NUMBER", "largest factor and its inverse, default 4", THUD_WORD_TEXT, false, SUITE},
    {"per-event", "N", "motions of one event, default 2", THUD_WORD_TEXT, false, SUITE},
    {"vertical", NULL, "allow vertical components", THUD_WORD_NONE, false, SUITE},
    {"json", NULL, "JSON on standard output", THUD_WORD_NONE, false,
     PICTURES | RECORD | LISTS | VERIFY | REPORT | SOLVE | EXPORT | STIFFNESS | BUILDING},
    {"csv", NULL, "CSV on standard output", THUD_WORD_NONE, false,
     STUDY | SUITE | MEASURE | RECORD | LISTS | VERIFY | SOLVE | STIFFNESS | BUILDING},
    {"o", "DIR", "folder for CSV, PNG and gnuplot scripts", THUD_WORD_FOLDER, false,
     FILES | EXPORT | REPORT | SIMPLIFY},
    {"replace", NULL, "remove another scene's results from that folder", THUD_WORD_NONE, false,
     PICTURES | EXPORT | REPORT | SIMPLIFY},
    {"no-figures", NULL, "no figures, only tables and data", THUD_WORD_NONE, false, STUDY | MEASURE | SUITE},
    {"format", "FORMAT", "format of pictures: png, svg or pdf", THUD_WORD_CHOICE, false, FILES},
    {"no-title", NULL, "pictures without a title; NAME.txt has it", THUD_WORD_NONE, false, FILES},
    {"size", "WIDTHxHEIGHT", "size of pictures, in pixels", THUD_WORD_TEXT, false, FILES | REPORT},
    {"width", "LENGTH", "width of pictures on paper, e.g. 90mm", THUD_WORD_TEXT, false, FILES | REPORT},
    {"font", "NAME[,PIXELS]", "font of pictures", THUD_WORD_TEXT, false, FILES | REPORT},
    {"j", "N", "number of runs at a time; does not change results", THUD_WORD_TEXT, false, STUDY | FIGURES | REPORT},
    {"quiet", NULL, "no progress and no remarks", THUD_WORD_NONE, false, ALL & ~SCREEN},
    {"beside", "PRESET,...", "variants to list in one table with the scene", THUD_WORD_FILE, false, REPORT},
    {"figures", "FILE|DIR,...", "SVG pictures for the last pages", THUD_WORD_FILE, false, REPORT},
    {"code", "NAME", "code of the recommended gap: en1998, asce7, exact84", THUD_WORD_TEXT, false, REPORT},
    {"limit", "NAME=VALUE", "limit of a criterion, e.g. drift=1%", THUD_WORD_TEXT, true, REPORT},
    {"detail", "N", "load case shown in detail; default: governing", THUD_WORD_TEXT, false, REPORT},
    {"project", "TEXT", "project named in the title block", THUD_WORD_TEXT, false, REPORT},
    {"author", "NAME", "author named in the title block", THUD_WORD_TEXT, false, REPORT},
    {"checker", "NAME", "checker named in the title block", THUD_WORD_TEXT, false, REPORT},
    {"date", "DATE", "date printed on the report", THUD_WORD_TEXT, false, REPORT},
    {"revision", "TEXT", "revision of the report", THUD_WORD_TEXT, false, REPORT},
    {"pdf", NULL, "an error if report.pdf cannot be made", THUD_WORD_NONE, false, REPORT},
    {"no-simplify", NULL, "nothing on what the model needs", THUD_WORD_NONE, false, REPORT},
    {"no-pdf", NULL, "no report.pdf, which takes longest", THUD_WORD_NONE, false, REPORT},
    {"play", "FILE", "play a session of :log, also without a terminal", THUD_WORD_FILE, false, SCREEN},
    {"ascii", NULL, "draw with ASCII characters only", THUD_WORD_NONE, false, SCREEN},
    {"no-color", NULL, "use no colour", THUD_WORD_NONE, false, SCREEN},
    {"words", "LIST", "the words of a list, for shells", THUD_WORD_TEXT, false, 1 << THUD_COMMAND_HELP},
    {"complete", "LINE", "the words allowed at its end, for shells", THUD_WORD_TEXT, false, 1 << THUD_COMMAND_HELP},
    {"mdoc", "PART", "a part of thud-preset(5), from the tables", THUD_WORD_TEXT, false, 1 << THUD_COMMAND_HELP},
    {"completion", "SHELL", "a completion script: bash, zsh, fish", THUD_WORD_CHOICE, false, 1 << THUD_COMMAND_HELP},
    {"help", NULL, "the options of the command", THUD_WORD_NONE, false, ALL},
    {"version", NULL, "the version, and how the program was built", THUD_WORD_NONE, false, SCREEN},
};

const struct thud_command *thud_command_at(enum thud_command_id id)
{
    return &commands[id];
}

enum thud_command_id thud_command_find(const char *name)
{
    for (int i = 0; i < THUD_COMMANDS; i++)
        if (commands[i].name[0] && strcmp(commands[i].name, name) == 0)
            return (enum thud_command_id)i;
    return THUD_COMMANDS;
}

int thud_option_count(void)
{
    return (int)(sizeof options / sizeof *options);
}

const struct thud_option *thud_option_at(int index)
{
    return &options[index];
}

const char *thud_option_part(int index)
{
    /* each begins with an option and goes on to the next one's */
    static const char *const parts[][2] = {{"set", "model"},
                                           {"record", "ground motion"},
                                           {"baseline", "processing of the record"},
                                           {"damping", "response spectrum"},
                                           {"method", "analysis"},
                                           {"sensitivity", "study"},
                                           {"json", "output"},
                                           {"beside", "report"},
                                           {"play", "terminal interface"},
                                           {"words", "help"}};
    const char *part = "";
    for (int i = 0; i <= index; i++)
        for (size_t k = 0; k < sizeof parts / sizeof *parts; k++)
            if (strcmp(options[i].name, parts[k][0]) == 0)
                part = parts[k][1];
    return part;
}

const struct thud_option *thud_option_find(enum thud_command_id command, const char *name)
{
    for (int i = 0; i < thud_option_count(); i++)
        if (thud_option_belongs(&options[i], command) && strcmp(options[i].name, name) == 0)
            return &options[i];
    return NULL;
}

const char *thud_option_choice(const struct thud_option *option, int i)
{
    static const struct {
        const char *option, *choice[6];
    } choices[] = {{"unit", {"g", "m/s2", "cm/s2", "mm/s2", "gal"}},
                   {"sign", {"+", "-"}},
                   {"sampling", {"latin-hypercube", "sobol"}},
                   {"signs", {"both"}},
                   {"scale", {"each", "common"}},
                   {"baseline", {"mean", "linear"}},
                   {"without", {"free", "start", "levels", "same", "all"}},
                   {"format", {"png", "svg", "pdf"}},
                   {"completion", {"bash", "zsh", "fish"}}};
    for (size_t k = 0; k < sizeof choices / sizeof *choices; k++)
        if (strcmp(choices[k].option, option->name) == 0)
            return choices[k].choice[i];
    return NULL;
}

const char *thud_word_list_name(enum thud_word word)
{
    static const char *const names[THUD_WORDS] = {
        [THUD_WORD_PRESET] = "presets",
        [THUD_WORD_KEY] = "keys",
        [THUD_WORD_CASE] = "cases",
        [THUD_WORD_METHOD] = "methods",
        [THUD_WORD_FIGURE] = "figures",
        [THUD_WORD_RECORD_VERB] = "verbs",
        [THUD_WORD_BUILDING_VERB] = "building-verbs",
        [THUD_WORD_PROGRAM] = "programs",
        [THUD_WORD_COMMAND] = "commands",
        [THUD_WORD_VARIED] = "varied",
    };
    return names[word];
}

/* --format, --size, --font, for every command that draws. */
#ifndef THUD_CLI_PICTURE_OPTIONS_H
#define THUD_CLI_PICTURE_OPTIONS_H

#include "cli/args.h"
#include "ground/record.h"
#include "plot/gnuplot/gnuplot.h"

struct thud_picture_choice {
    struct thud_picture_options options; /* points into `font`: do not copy */
    char font[128];
};

/* With the gnuplot that THUD_GNUPLOT names. Errors: THUD_USAGE. */
enum thud_status thud_picture_options_read(const struct thud_args *args, struct thud_picture_choice *choice,
                                           struct thud_error *err);
/* Every title says how many of the ground motions drawn from are synthetic. */
void thud_picture_options_motions(struct thud_picture_choice *choice, const struct thud_record *const *record, int n);

#endif

/* One line per command that is there. */
THUD_COMMAND(RUN, run)
THUD_COMMAND(FIGURES, figures)
THUD_COMMAND(RECORD, record)
THUD_COMMAND(LAWS, laws)
THUD_COMMAND(METHODS, methods)
THUD_COMMAND(SWEEP, sweep)
THUD_COMMAND(HELP, help)
THUD_COMMAND(BENCH, bench)

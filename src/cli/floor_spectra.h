/* thud run --floor-spectra: in place of the peaks. */
#ifndef THUD_CLI_FLOOR_SPECTRA_H
#define THUD_CLI_FLOOR_SPECTRA_H

#include "app/run/session.h"
#include "cli/args.h"

enum thud_status thud_cli_floor_spectra(const struct thud_args *args, struct thud_session *session,
                                        struct thud_error *err);
/* Errors: THUD_USAGE where an option of floor spectra stands without them. */
enum thud_status thud_cli_no_floor_spectra(const struct thud_args *args, struct thud_error *err);

#endif

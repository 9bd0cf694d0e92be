/* The screens, in the order of their numbers: THUD_SCREEN(enumerator, object of its view). */
THUD_SCREEN(MODEL, model)
THUD_SCREEN(CONTACT, contact)
THUD_SCREEN(RECORD, record)
THUD_SCREEN(RESULTS, results)
THUD_SCREEN(PLOTS, plots)
THUD_SCREEN(SWEEP, sweep)
THUD_SCREEN(HELP, help)

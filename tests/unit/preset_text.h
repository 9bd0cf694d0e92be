/* A preset for the tests: every kind of value, comments, a block list and a flow one. */
#pragma once

static const char preset_text[] = "# head\n"                                                /* 1 */
                                  "title: \"Towers: # two\"   # a title\n"                  /* 2 */
                                  "record:\n"                                               /* 3 */
                                  "  file: kobe.csv\n"                                      /* 4 */
                                  "  peak: 0.821 g  # scaled\n"                             /* 5 */
                                  "  sign: +\n"                                             /* 6 */
                                  "structures:\n"                                           /* 7 */
                                  "  - name: A      # left\n"                               /* 8 */
                                  "    kind: shear\n"                                       /* 9 */
                                  "    mass: [320 t, 320000 kg, 320 t, 250 t] # four\n"     /* 10 */
                                  "    stiffness: 600 MN/m\n"                               /* 11 */
                                  "    height: 3 m\n"                                       /* 12 */
                                  "    damping: 0.05\n"                                     /* 13 */
                                  "  - name: B\n"                                           /* 14 */
                                  "    storeys: 3\n"                                        /* 15 */
                                  "    mass:\n"                                             /* 16 */
                                  "      - 320 t   # first\n"                               /* 17 */
                                  "      - 310 t\n"                                         /* 18 */
                                  "      - 250 t\n"                                         /* 19 */
                                  "    stiffness: 6e8 N/m\n"                                /* 20 */
                                  "  - {kind: rigid, mass: 320 t, velocity: -0.5 m/s}\n"    /* 21 */
                                  "\n"                                                      /* 22 */
                                  "interfaces:\n"                                           /* 23 */
                                  "  - gap: 100 mm   # wide\n"                              /* 24 */
                                  "    contact:\n"                                          /* 25 */
                                  "      law: kelvin-voigt-no-tension\n"                    /* 26 */
                                  "      stiffness: 2500 kN/mm\n"                           /* 27 */
                                  "      restitution: 60 %\n"                               /* 28 */
                                  "    bumper:       # rubber\n"                            /* 29 */
                                  "      law: rubber\n"                                     /* 30 */
                                  "      stiffness: 0.36 kN/mm^2.65 # eq. 4\n"              /* 31 */
                                  "      exponent: 2.65\n"                                  /* 32 */
                                  "      thickness: 5 cm\n"                                 /* 33 */
                                  "      unloading: paper  # or continuous\n"               /* 34 */
                                  "  - gap: 3 in\n"                                         /* 35 */
                                  "    contact: {law: linear, stiffness: 1 MN/mm} # flow\n" /* 36 */
                                  "analysis:\n"                                             /* 37 */
                                  "  tolerance: 1e-8\n"                                     /* 38 */
                                  "study:\n"                                                /* 39 */
                                  "  vary: interfaces.1.gap\n"                              /* 40 */
                                  "  from: 5 cm\n"                                          /* 41 */
                                  "  to: 25 cm\n"                                           /* 42 */
                                  "  step: 0.5 cm\n"                                        /* 43 */
                                  "  cases: [none, bumper]  # two\n";                       /* 44 */

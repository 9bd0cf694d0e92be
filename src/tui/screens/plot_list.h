/* The figures of the Plots screen: THUD_PLOT(enumerator, title, name of its files, figure of a run that it is). Those
 * of a contact or floor show one, with the cases over each other. */
THUD_PLOT(FORCE, "Impact force", "impact-force", FORCE)
THUD_PLOT(APPROACH, "Approach velocity", "approach-velocity", VELOCITY)
THUD_PLOT(ACCELERATION, "Floor acceleration", "acceleration", ACCELERATION)
THUD_PLOT(DRIFT, "Storey drift", "drift", DRIFT)
THUD_PLOT(DISPLACEMENT, "Floor displacement", "displacement", DISPLACEMENT)
THUD_PLOT(LOOP, "Force against indentation", "loop", LOOP)
THUD_PLOT(ENVELOPE, "Peaks over the height", "envelope", ENVELOPE)
THUD_PLOT(ENERGY, "Energies", "energy", ENERGY)
THUD_PLOT(HYSTERESIS, "Loops of storeys and links", "hysteresis", HYSTERESIS)

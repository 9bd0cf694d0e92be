/* The tables of everything a preset may say, but for the laws' own parameters. */
#include <math.h>
#include <string.h>

#include "ground/target.h"
#include "study/scene/scene_slot.h"

/* clang-format off */
#define NUMBER(name_, title_, help_, dimension_, unit_, fallback_) \
    .name = (name_), .title = (title_), .help = (help_), .kind = THUD_PARAM_QUANTITY, .dimension = (dimension_), .unit = (unit_), .fallback = (fallback_)
#define COUNT(name_, title_, help_, fallback_) \
    .name = (name_), .title = (title_), .help = (help_), .kind = THUD_PARAM_INTEGER, .unit = "", .fallback = (fallback_)
#define WORD(name_, title_, help_) \
    {.name = (name_), .title = (title_), .help = (help_), .kind = THUD_PARAM_TEXT, .unit = "", .fallback = NAN, \
     .least = NAN, .most = NAN, .soft_least = NAN, .soft_most = NAN}
#define CHOICE(name_, title_, help_, choices_, fallback_) \
    {.name = (name_), .title = (title_), .help = (help_), .kind = THUD_PARAM_CHOICE, .unit = "", .fallback = (fallback_), \
     .least = NAN, .most = NAN, .soft_least = NAN, .soft_most = NAN, .choices = (choices_)}
#define PLACE(store_, member_) .store = THUD_STORE_##store_, .offset = AT(member_)
#define MAYBE(member_, ...)     {PLACE(NUMBER, member_), .absent = NAN, __VA_ARGS__}
#define PERHAPS(member_, kinds_) {PLACE(NUMBER, member_), .kinds = (kinds_), .optional = true}
#define FLOORS(member_, kinds_) {PLACE(FLOORS, member_), .kinds = (kinds_), .optional = true}
#define TEXT(member_, ...) {.store = THUD_STORE_TEXT, .offset = AT(member_), .size = __VA_ARGS__}
#define POSITIVE      .least = 0, .least_open = true
#define UP_TO(value)  .most = (value)
#define FROM(value)   .least = (value)
#define BELOW(value)  .most = (value), .most_open = true
#define USUAL(a, b)   .soft_least = (a), .soft_most = (b)
#define ANY_USUAL     .soft_least = NAN, .soft_most = NAN

/* A key of a preset: what it is, and where its value stands. */
struct row {
    struct thud_param param;
    struct thud_place place;
};

enum { SHEAR = 1 << THUD_SHEAR, RIGID = 1 << THUD_RIGID, ISOLATED = 1 << THUD_ISOLATED, WALL = 1 << THUD_WALL,
       MATRIX = 1 << THUD_MATRIX, MODES = 1 << THUD_MODES, ESTIMATED = 1 << THUD_ESTIMATED, READ = MATRIX | MODES, SPRINGS = SHEAR | ISOLATED,
       STOREYS = SPRINGS | READ | ESTIMATED,
       ALL = (1 << THUD_KINDS) - 1 };

static const char *const kinds[] = {"shear", "rigid", "isolated", "wall", "matrix", "modes", "estimated", NULL};
static const char *const systems[] = {"concrete-frame", "steel-frame", "wall", "masonry", NULL};
static const char *const orders[] = {"ask", "lowest-first", "roof-first", NULL};
static const char *const signs[] = {"+", "-", NULL};
static const char *const one_or_both[] = {"one", "both", NULL};
static const char *const columns[] = {"all", NULL};
static const char *const switches[] = {"off", "on", NULL};
static const char *const no_or_yes[] = {"no", "yes", NULL};
static const char *const levels[] = {"all", "aligned", NULL};
static const char *const isolators[] = {"linear", "lead-rubber", "pendulum", NULL};
static const char *const shapes[] = {"clamped", "linear", NULL};
static const char *const link_laws[] = {"spring", "dashpot", "friction", "restrainer", "strut", NULL};
enum { LEAD = 1 << THUD_ISOLATOR_LEAD_RUBBER, DISH = 1 << THUD_ISOLATOR_PENDULUM };
enum { LINKS = (1 << THUD_LINK_LAWS) - 1 };

#define AT(member) offsetof(struct thud_scene, member)
static const struct row scene_rows[] = {
    {WORD("title", "title", "Title of the scene, for headings of tables and figures."), TEXT(title, THUD_TEXT_MAX)},
    {CHOICE("p-delta", "P-Delta", "yes: P-Delta effects are included, and a storey whose drift reaches a tenth of its height has collapsed.", no_or_yes, 0),
     {PLACE(SWITCH, p_delta)}},
};
#undef AT

#define AT(member) offsetof(struct thud_record_choice, member)
static const struct row record_rows[] = {
    {WORD("file", "file", "The ground motion. It is looked up in the working folder, beside the preset, and in the records folder."),
     TEXT(file, THUD_TEXT_MAX)},
    {{NUMBER("peak", "peak", "Scales the motion to this largest acceleration; by default it is as recorded.",
     THUD_ACCELERATION, "g", NAN), POSITIVE, UP_TO(100 * THUD_GRAVITY), .soft_least = NAN, .soft_most = 2 * THUD_GRAVITY}, {PLACE(NUMBER, peak_mps2), .absent = NAN}},
    {{NUMBER("sa", "spectral acceleration", "Scales the motion to this pseudo spectral acceleration at `period` and 5 % damping, instead of a peak.",
     THUD_ACCELERATION, "g", NAN), POSITIVE, UP_TO(100 * THUD_GRAVITY), ANY_USUAL}, {PLACE(NUMBER, sa_mps2), .absent = NAN}},
    {{NUMBER("period", "period", "Period of `sa`; default: the mean of the buildings' fundamental periods.", THUD_TIME, "s", NAN), POSITIVE, UP_TO(100), ANY_USUAL},
     {PLACE(NUMBER, period_s), .absent = NAN}},
    {WORD("target", "target spectrum",
     "Scales the motion to a design spectrum over 0.2 to 2 times the buildings' first periods, instead of a peak: " THUD_TARGET_ALLOWED "."),
     TEXT(target, 128)},
    {CHOICE("sign", "sign", "-: the motion with reversed polarity; in a preset as \"-\".", signs, 0), {PLACE(SIGN, sign)}},
    {{NUMBER("factor", "factor", "Multiplies the motion.", THUD_NUMBER, "", 1), POSITIVE, UP_TO(1e6), ANY_USUAL}, {PLACE(NUMBER, factor)}},
    {{NUMBER("from", "beginning", "Discards the motion before this time of the file; the run starts there.", THUD_TIME, "s", NAN), FROM(0), UP_TO(1e5), ANY_USUAL},
     {PLACE(NUMBER, from_s), .absent = NAN}},
    {{NUMBER("to", "end", "Discards the motion after this time of the file; peak and sa scale the rest.", THUD_TIME, "s", NAN), POSITIVE, UP_TO(1e5), ANY_USUAL},
     {PLACE(NUMBER, to_s), .absent = NAN}},
    {{NUMBER("dt", "step", "Time between samples, if the file does not state it.", THUD_TIME, "s", NAN), POSITIVE, UP_TO(10), ANY_USUAL},
     {PLACE(NUMBER, dt_s), .absent = NAN}},
    {WORD("unit", "unit", "Unit of the samples, if the file does not state it: g, m/s2, cm/s2, gal, ..."), TEXT(unit, 16)},
    {WORD("channel", "channel", "Channel of a file with several, by name or number."), TEXT(channel, 32)},
    {WORD("component", "component",
     "Direction: NS, EW, 090, N28W; rotd50 or rotd100 of two components at `period`; rot30: rotated by degrees; governs: the direction with the widest required gap."),
     TEXT(component, 32)},
    {WORD("event", "event", "Event, instead of that in the file."), TEXT(event, 96)},
    {WORD("station", "station", "Station; two motions of one event and station are one recording."), TEXT(station, 96)},
    {WORD("licence", "licence", "Licence under which the motion may be passed on."), TEXT(licence, 96)},
    {{COUNT("column", "column", "Column of a table, from 1; all: each line continues the previous one.", NAN), .least = 1, UP_TO(1000), ANY_USUAL, .choices = columns},
     {PLACE(COUNT, column), .none = 0}},
    {{COUNT("skip", "skipped lines", "Number of lines to skip at the beginning of the file.", NAN), .least = 0, UP_TO(100000), ANY_USUAL},
     {PLACE(COUNT, skip), .none = -1}},
    {{COUNT("every", "samples kept", "Keeps every second sample (2), every third (3), ... of the scaled motion, after a low-pass filter at half their rate.",
     NAN), .least = 2, UP_TO(1000), ANY_USUAL}, {PLACE(COUNT, every), .none = 0}},
};
#undef AT

#define AT(member) offsetof(struct thud_structure, member)
static const struct row structure_rows[] = {
    {WORD("name", "name", "Name in tables and figures; default: A, B, ... from the left."), TEXT(name, THUD_NAME_MAX, .kinds = ALL)},
    {CHOICE("kind", "kind",
     "shear: storeys; rigid: a free body; isolated: storeys on an isolated slab; wall: moves with the ground; matrix, modes: by a file; estimated: by area.", kinds, THUD_SHEAR),
     {PLACE(KIND, kind), .kinds = ALL}},
    {{COUNT("storeys", "storeys", "Number of storeys; if omitted, taken from a list of masses, stiffnesses or heights.", NAN), .least = 1, UP_TO(THUD_STOREYS_MAX), ANY_USUAL},
     {PLACE(STOREYS, storeys), .kinds = STOREYS, .reads = true}},
    {{NUMBER("mass", "floor mass", "Mass of each floor, or of the body.", THUD_MASS, "t", NAN), POSITIVE, UP_TO(1e9), USUAL(1e4, 5e6)},
     {PLACE(FLOORS, mass_kg), .kinds = ALL & ~(WALL | ESTIMATED)}},
    {{NUMBER("stiffness", "storey stiffness", "Lateral (shear) stiffness of each storey.", THUD_STIFFNESS, "MN/m", NAN), POSITIVE, UP_TO(1e12), USUAL(1e7, 1e10)},
     {PLACE(FLOORS, stiffness_npm), .kinds = SPRINGS}},
    {{NUMBER("period", "first period",
     "First period of the building, if it is known: the storey stiffnesses (equal if not given) are scaled to it.", THUD_TIME, "s", NAN), POSITIVE, UP_TO(100), USUAL(0.05, 10)},
     MAYBE(period_s, .kinds = SHEAR)},
    {{NUMBER("period", "first period",
     "First period of an estimated building, if it is known, instead of that of the code.", THUD_TIME, "s", NAN), POSITIVE, UP_TO(100), USUAL(0.05, 10)},
     PERHAPS(period_s, ESTIMATED)},
    {{NUMBER("cracked", "cracked stiffness",
     "Factor of the stiffness of the storeys and of the EI of their columns: 0.5 for cracked concrete by EN 1998-1, 4.3.1(7).", THUD_NUMBER, "", NAN), POSITIVE, UP_TO(1), USUAL(0.3, 1)},
     PERHAPS(cracked, SPRINGS)},
    {WORD("stiffness-matrix", "stiffness matrix",
     "CSV file of the lateral stiffness of the floors, n rows of n values. It is looked up in the working folder, beside the preset, and in the presets folder."),
     TEXT(stiffness_file, THUD_TEXT_MAX, .kinds = MATRIX, .reads = true)},
    {WORD("flexibility-matrix", "flexibility matrix", "CSV file of the displacements under unit forces, instead of stiffness-matrix."),
     TEXT(flexibility_file, THUD_TEXT_MAX, .kinds = MATRIX, .reads = true)},
    {WORD("periods", "periods and shapes", "CSV file with one row per mode: its period, and its shape at every floor; at most as many modes as floors."),
     TEXT(periods_file, THUD_TEXT_MAX, .kinds = MODES, .reads = true)},
    {WORD("unit", "unit of the file", "Unit of the matrix (kN/m, mm/kN) or of the periods (s), if the file does not state it."),
     TEXT(unit, 16, .kinds = READ, .reads = true)},
    {CHOICE("order", "order of the floors", "Order in the file; ask: a file whose floors seem to be listed from the roof down is refused.", orders, THUD_ORDER_ASK),
     {PLACE(NUMBER, order), .kinds = READ, .reads = true}},
    {CHOICE("system", "structural system", "Structural system of an estimated building; gives its first period, with the height.", systems, THUD_CONCRETE_FRAME),
     {PLACE(NUMBER, system), .kinds = ESTIMATED}},
    {{NUMBER("area", "floor area",
     "Area of each floor of an estimated building, which weighs 1 t/m2 without a load.", THUD_AREA, "m2", NAN), POSITIVE, UP_TO(1e6), USUAL(30, 5000)},
     {PLACE(NUMBER, area_m2), .kinds = ESTIMATED}},
    {{NUMBER("area", "floor area",
     "Area of each floor; with `load` it gives the masses, instead of `mass`.", THUD_AREA, "m2", NAN), POSITIVE, UP_TO(1e6), USUAL(30, 5000)},
     PERHAPS(area_m2, SPRINGS | READ)},
    {{NUMBER("load", "load of the floors",
     "Weight of each floor over its area: permanent load and the seismic part of the variable load; a list for a lighter roof.",
     THUD_PRESSURE, "kPa", NAN), POSITIVE, UP_TO(1e6), USUAL(2e3, 2e4)},
     FLOORS(load_pa, STOREYS)},
    {{NUMBER("period-factor", "factor of the periods", "Multiplies all periods of the building.", THUD_NUMBER, "", 1), POSITIVE, UP_TO(100), USUAL(0.5, 2)},
     {PLACE(NUMBER, period_factor), .kinds = READ | ESTIMATED}},
    {{NUMBER("height", "storey height", "Height of each storey, from floor to floor; gives the elevations of contacts.",
     THUD_LENGTH, "m", 3), FROM(0.5), UP_TO(20), USUAL(2.5, 6)}, {PLACE(FLOORS, height_m), .kinds = STOREYS}},
    {{NUMBER("height", "elevation", "Elevation of the body's contact; default: its neighbours' first floor.", THUD_LENGTH, "m", NAN), FROM(0), UP_TO(4000), ANY_USUAL},
     MAYBE(height_m, .kinds = RIGID)},
    {{NUMBER("height", "height of the wall",
     "Height up to which floors can touch the wall; default: all of them.", THUD_LENGTH, "m", NAN), FROM(0), UP_TO(4000), ANY_USUAL},
     {PLACE(NUMBER, height_m), .absent = INFINITY, .kinds = WALL}},
    {{NUMBER("base", "elevation of the ground", "Elevation of the ground under the building, from the same level for all buildings.",
     THUD_LENGTH, "m", 0), FROM(-200), UP_TO(4000), ANY_USUAL}, {PLACE(NUMBER, base_m), .kinds = STOREYS}},
    {{NUMBER("slab-depth", "depth of the slab",
     "Depth of slab and beam at each floor's face. Neighbouring faces that overlap collide; others strike columns at mid-depth.",
     THUD_LENGTH, "cm", 0.3), FROM(0), UP_TO(3), .soft_least = NAN, .soft_most = 1.5}, {PLACE(FLOORS, slab_depth_m), .kinds = STOREYS}},
    {{NUMBER("yield", "yield drift", "Drift at which a storey yields (bilinear, kinematic hardening); not given, or `none` in a list: elastic.",
     THUD_LENGTH, "mm", NAN), .least = 1e-6, .least_open = true, UP_TO(10), ANY_USUAL}, FLOORS(yield_m, SPRINGS)},
    {{NUMBER("yield-shear", "yield shear", "Storey shear at yield, instead of yield.", THUD_FORCE, "MN", NAN), POSITIVE, UP_TO(1e12), ANY_USUAL},
     FLOORS(yield_shear_n, SPRINGS)},
    {{NUMBER("yield-coefficient", "yield coefficient",
     "Yield shear over the weight of the floors above the storey, instead of yield.", THUD_RATIO, "%", NAN), POSITIVE, UP_TO(10), ANY_USUAL},
     FLOORS(yield_coefficient, SPRINGS)},
    {{NUMBER("hardening", "hardening ratio", "Ratio of stiffness beyond yield to elastic stiffness; 0: none, 1: elastic.",
     THUD_RATIO, "%", 0), FROM(0), UP_TO(1), .soft_least = NAN, .soft_most = 0.2}, FLOORS(hardening, SPRINGS)},
    {{NUMBER("gravity", "weight",
     "Weight of each floor for P-Delta, if larger than that of its mass (the default).", THUD_FORCE, "kN", NAN), POSITIVE, UP_TO(1e12), ANY_USUAL},
     FLOORS(gravity_n, STOREYS)},
    {{NUMBER("damping", "damping ratio", "Damping ratio, the same in every mode.", THUD_RATIO, "%", 0.05), FROM(0), BELOW(1), USUAL(0.01, 0.2)},
     {PLACE(NUMBER, damping), .kinds = STOREYS}},
    {{COUNT("modes", "modes", "Number of lowest modes kept; default: analysis.modes.", NAN), .least = 1, UP_TO(THUD_STOREYS_MAX + 1), ANY_USUAL},
     {PLACE(COUNT, modes), .kinds = STOREYS}},
    {{NUMBER("base-mass", "mass of the base slab", "Mass of the isolated slab below the first storey.", THUD_MASS, "t", NAN), POSITIVE, UP_TO(1e9), USUAL(1e4, 5e6)},
     {PLACE(NUMBER, base_mass_kg), .kinds = ISOLATED}},
    {{NUMBER("isolation-stiffness", "isolation stiffness", "Stiffness of all linear isolators together.", THUD_STIFFNESS, "MN/m", NAN), POSITIVE, UP_TO(1e12), ANY_USUAL},
     MAYBE(isolation_stiffness_npm, .kinds = ISOLATED)},
    {{NUMBER("isolation-damping", "isolation damping ratio",
     "Damping ratio of the isolators with the whole mass and their stiffness before yield; 0 if they yield or slide.",
     THUD_RATIO, "%", 0.1), FROM(0), BELOW(1), .soft_least = NAN, .soft_most = 0.4}, MAYBE(isolation_damping, .kinds = ISOLATED)},
    {{NUMBER("width", "width between isolators",
     "Distance from the first to the last row of isolators; if given, the overturning moment is compared with the restoring moment of the weight.",
     THUD_LENGTH, "m", NAN), POSITIVE, UP_TO(1000), USUAL(4, 200)},
     MAYBE(width_m, .kinds = ISOLATED)},
    {{NUMBER("velocity", "velocity at the start", "Initial velocity, positive to the right.", THUD_VELOCITY, "m/s", 0), FROM(-1000), UP_TO(1000), USUAL(-5, 5)},
     {PLACE(NUMBER, velocity_mps), .kinds = RIGID}},
    {{NUMBER("mass", "mass", "Mass of a flexible wall; without a mass it moves with the ground.", THUD_MASS, "t", NAN), POSITIVE, UP_TO(1e9), USUAL(1e3, 5e6)},
     MAYBE(wall_mass_kg, .kinds = WALL)},
    {{NUMBER("stiffness", "stiffness", "Stiffness of a flexible wall against the ground.", THUD_STIFFNESS, "MN/m", NAN), POSITIVE, UP_TO(1e12), ANY_USUAL},
     MAYBE(wall_stiffness_npm, .kinds = WALL)},
    {{NUMBER("damping", "damping ratio", "Damping ratio of a flexible wall; default 5 %.", THUD_RATIO, "%", NAN), FROM(0), BELOW(1), .soft_least = NAN, .soft_most = 0.2},
     MAYBE(wall_damping, .kinds = WALL)},
};

static const struct row column_rows[] = {
    {{NUMBER("EI", "bending stiffness", "Bending stiffness of all struck columns of a storey; without EI and stiffness they do not deflect.",
     THUD_BENDING, "MN m2", NAN), POSITIVE, UP_TO(1e15), USUAL(1e6, 1e10)}, FLOORS(column_ei_nm2, STOREYS)},
    {{NUMBER("stiffness", "stiffness",
     "Instead of EI: the struck columns' part of the storey stiffness, 12 EI/L^3.", THUD_STIFFNESS, "MN/m", NAN), POSITIVE, UP_TO(1e12), ANY_USUAL},
     FLOORS(column_stiffness_npm, STOREYS)},
    {{NUMBER("capacity", "shear capacity",
     "Shear capacity of all struck columns of a storey together, with which their shear is compared.", THUD_FORCE, "kN", NAN), POSITIVE, UP_TO(1e12), ANY_USUAL},
     FLOORS(column_capacity_n, STOREYS)},
    {CHOICE("shape", "shape", "clamped: struck columns deform and transmit the force as members fixed at both floors; linear: as hinged members.", shapes, THUD_COLUMN_CLAMPED),
     {PLACE(NUMBER, column_shape), .kinds = STOREYS}},
};

static const struct row isolator_rows[] = {
    {CHOICE("law", "law of the isolators", "linear: isolation-stiffness; lead-rubber: strength, post-yield and yield; pendulum: radius and friction.", isolators, THUD_ISOLATOR_LINEAR),
     {PLACE(NUMBER, isolator_law), .kinds = ISOLATED}},
    {{NUMBER("strength", "characteristic strength", "Q_d of all lead-rubber bearings together: the force at zero displacement.",
     THUD_FORCE, "kN", NAN), POSITIVE, UP_TO(1e12), ANY_USUAL}, MAYBE(isolator_strength_n, .kinds = ISOLATED, .laws = LEAD, .needed = LEAD)},
    {{NUMBER("post-yield", "stiffness beyond yield", "K_d of all lead-rubber bearings together.", THUD_STIFFNESS, "MN/m", NAN), POSITIVE, UP_TO(1e12), ANY_USUAL},
     MAYBE(isolator_post_yield_npm, .kinds = ISOLATED, .laws = LEAD, .needed = LEAD)},
    {{NUMBER("yield", "yield displacement", "u_y of lead-rubber bearings, or elastic displacement of a pendulum before it slides (default 1 mm).",
     THUD_LENGTH, "mm", NAN), .least = 1e-6, .least_open = true, UP_TO(1), USUAL(1e-4, 0.05)}, MAYBE(isolator_yield_m, .kinds = ISOLATED, .laws = LEAD | DISH, .needed = LEAD)},
    {{NUMBER("radius", "radius", "Radius R of the pendulum; its period is 2 pi sqrt(R/g).", THUD_LENGTH, "m", NAN), POSITIVE, UP_TO(100), USUAL(0.5, 10)},
     MAYBE(isolator_radius_m, .kinds = ISOLATED, .laws = DISH, .needed = DISH)},
    {{NUMBER("friction", "friction coefficient", "mu of the pendulum.", THUD_RATIO, "%", NAN), POSITIVE, UP_TO(1), USUAL(0.01, 0.2)},
     MAYBE(isolator_friction, .kinds = ISOLATED, .laws = DISH, .needed = DISH)},
};

static const struct row backfill_rows[] = {
    {{NUMBER("stiffness", "initial stiffness",
     "K_max of the soil behind the wall: F = x/(1/K_max + ratio x/strength), in compression only; it unloads with K_max and leaves a gap.",
     THUD_STIFFNESS, "MN/m", NAN), POSITIVE, UP_TO(1e12), ANY_USUAL}, MAYBE(backfill_stiffness_npm, .kinds = WALL)},
    {{NUMBER("strength", "ultimate force", "F_ult of that soil.", THUD_FORCE, "kN", NAN), POSITIVE, UP_TO(1e12), ANY_USUAL},
     MAYBE(backfill_strength_n, .kinds = WALL)},
    {{NUMBER("ratio", "failure ratio", "R_f of that soil: the force tends to strength/ratio; default 0.7.", THUD_NUMBER, "", NAN), POSITIVE, UP_TO(1), USUAL(0.5, 1)},
     MAYBE(backfill_ratio, .kinds = WALL)},
    {{NUMBER("gap", "gap to the soil", "Gap between wall and soil; default 0.", THUD_LENGTH, "mm", NAN), FROM(0), UP_TO(5), ANY_USUAL},
     MAYBE(backfill_gap_m, .kinds = WALL)},
};

static const struct row foundation_rows[] = {
    {{NUMBER("mass", "mass of the foundation", "Mass of the foundation, which sways and rocks on the soil.", THUD_MASS, "t", NAN), POSITIVE, UP_TO(1e9), USUAL(1e3, 1e8)},
     MAYBE(foundation_mass_kg, .kinds = STOREYS)},
    {{NUMBER("inertia", "moment of inertia", "Moment of inertia of the foundation about its axis of rocking; default: that of a disk, m a^2/4.",
     THUD_INERTIA, "t m2", NAN), POSITIVE, UP_TO(1e13), ANY_USUAL}, MAYBE(foundation_inertia_kgm2, .kinds = STOREYS)},
    {{NUMBER("sway-stiffness", "stiffness against sway", "K_x of the soil; default 8 G a/(2 - nu).", THUD_STIFFNESS, "MN/m", NAN), POSITIVE, UP_TO(1e15), ANY_USUAL},
     MAYBE(sway_npm, .kinds = STOREYS)},
    {{NUMBER("sway-damping", "dashpot against sway",
     "C_x of the soil; default rho V_s A, or 0 without vs.", THUD_DASHPOT, "MN s/m", NAN), FROM(0), UP_TO(1e12), ANY_USUAL},
     MAYBE(sway_nspm, .kinds = STOREYS)},
    {{NUMBER("rocking-stiffness", "stiffness against rocking", "K_t of the soil; default 8 G a^3/(3 (1 - nu)).",
     THUD_ROCKING, "GN m/rad", NAN), POSITIVE, UP_TO(1e18), ANY_USUAL}, MAYBE(rocking_nmprad, .kinds = STOREYS)},
    {{NUMBER("rocking-damping", "dashpot against rocking", "C_t of the soil; default rho V_p I, or 0 without vs.",
     THUD_ROCKING_DASHPOT, "MN m s/rad", NAN), FROM(0), UP_TO(1e15), ANY_USUAL}, MAYBE(rocking_nmsprad, .kinds = STOREYS)},
    {{NUMBER("vs", "shear-wave velocity", "V_s of the soil; gives the default stiffnesses and dashpots, those of a disk on a half-space.",
     THUD_VELOCITY, "m/s", NAN), POSITIVE, UP_TO(5000), USUAL(80, 1500)}, MAYBE(soil_vs_mps, .kinds = STOREYS)},
    {{NUMBER("density", "density of the soil", "Density rho of the soil.", THUD_DENSITY, "t/m3", NAN), POSITIVE, UP_TO(1e4), USUAL(1400, 2600)},
     MAYBE(soil_density_kgpm3, .kinds = STOREYS)},
    {{NUMBER("poisson", "Poisson's ratio", "Poisson's ratio nu of the soil; default 1/3.", THUD_NUMBER, "", NAN), FROM(0), UP_TO(0.49), ANY_USUAL},
     MAYBE(soil_poisson, .kinds = STOREYS)},
    {{NUMBER("radius", "radius of the foundation", "Radius a of the disk.", THUD_LENGTH, "m", NAN), POSITIVE, UP_TO(200), USUAL(2, 40)},
     MAYBE(foundation_radius_m, .kinds = STOREYS)},
};
#undef AT

#define AT(member) offsetof(struct thud_interface, member)
static const struct row interface_rows[] = {
    {{NUMBER("gap", "gap", "Distance between bare faces.", THUD_LENGTH, "cm", NAN), FROM(0), UP_TO(5), ANY_USUAL}, {PLACE(NUMBER, gap_m)}},
    {{NUMBER("gap-by-level", "gap by level",
     "Gaps from the lowest pair that can collide upwards, for setbacks; none: `gap`.", THUD_LENGTH, "cm", NAN), FROM(0), UP_TO(5), ANY_USUAL},
     {PLACE(LEVELS, gap)}},
    {CHOICE("levels", "levels", "all: floors between the neighbour's floors strike its columns; aligned: only floors at the same elevation collide.", levels, THUD_LEVELS_ALL),
     {PLACE(NUMBER, levels)}},
    {{NUMBER("contact-levels", "levels that meet", "Floors of the left building (of the right one beside a wall or a body) that can touch the neighbour; default: all.",
     THUD_NUMBER, "", NAN), FROM(1), UP_TO(THUD_STOREYS_MAX + 1), ANY_USUAL}, {PLACE(LEVELS, contact_levels)}},
};

static const struct row contact_rows[] = {
    {WORD("law", "impact law of the bare contact", "One of `thud laws`; the keys after it are those of the law."), {PLACE(LAW, contact)}},
};

static const struct row bumper_rows[] = {
    {WORD("law", "impact law of the bumper", "One of `thud laws`; the keys after it are those of the law."), {PLACE(LAW, bumper)}},
    {{NUMBER("thickness", "thickness", "Thickness of the bumper, from the wall behind it.", THUD_LENGTH, "cm", NAN), POSITIVE, UP_TO(1), USUAL(0.01, 0.2)},
     {PLACE(NUMBER, bumper_thickness_m)}},
    {{NUMBER("thickness-by-level", "thickness by level",
     "Thicknesses from the lowest pair that can collide upwards; 0 cm: no bumper; none: `thickness`. The cavity is the same at every level.", THUD_LENGTH, "cm", NAN), FROM(0), UP_TO(1), ANY_USUAL},
     {PLACE(LEVELS, thickness)}},
    {{NUMBER("cavity", "cavity depth",
     "Depth to which the bumper is recessed into the wall; less than its thickness.", THUD_LENGTH, "cm", 0), FROM(0), BELOW(1), ANY_USUAL},
     {PLACE(NUMBER, bumper_cavity_m)}},
    {CHOICE("fitted", "fitted", "off: the bumper is removed and its values are kept.", switches, 1), {PLACE(SWITCH, has_bumper)}},
};
#undef AT

#define AT(member) offsetof(struct thud_link, member)
static const struct row link_rows[] = {
    {CHOICE("law", "law",
     "spring: stiffness and damping; dashpot: damping; friction: stiffness up to its slip force; restrainer: holds beyond its slack; strut: pushes beyond its slack.", link_laws, THUD_LINK_SPRING),
     {PLACE(LINK, law), .kinds = LINKS}},
    {WORD("from", "one end", "A.4: floor 4 of A, counted as in the results; a body or a wall by its name only."),
     TEXT(from, THUD_NAME_MAX + 8, .kinds = LINKS)},
    {WORD("to", "other end", "A floor of the neighbour, likewise."), TEXT(to, THUD_NAME_MAX + 8, .kinds = LINKS)},
    {{NUMBER("stiffness", "stiffness", "Stiffness of the spring (0: dashpot only), of friction before it slips, or of a restrainer or a strut beyond its slack.",
     THUD_STIFFNESS, "MN/m", NAN), FROM(0), UP_TO(1e12), .soft_least = NAN, .soft_most = 1e10}, {PLACE(NUMBER, stiffness_npm), .kinds = LINKS & ~(1 << THUD_LINK_DASHPOT)}},
    {{NUMBER("damping", "damping", "Force of the dashpot per relative velocity of its ends.",
     THUD_DASHPOT, "kN s/m", NAN), FROM(0), UP_TO(1e12), .soft_least = NAN, .soft_most = 1e9}, {PLACE(NUMBER, damping_nspm), .kinds = 1 << THUD_LINK_SPRING | 1 << THUD_LINK_DASHPOT}},
    {{NUMBER("slip", "slip force",
     "Force at which friction slips, in both directions.", THUD_FORCE, "kN", NAN), POSITIVE, UP_TO(1e12), .soft_least = NAN, .soft_most = 1e9},
     {PLACE(NUMBER, slip_n), .kinds = 1 << THUD_LINK_FRICTION}},
    {{NUMBER("slack", "slack", "Movement before the link engages: opening for a restrainer, closing for a strut.", THUD_LENGTH, "cm", 0), FROM(0), UP_TO(5), ANY_USUAL},
     {PLACE(NUMBER, slack_m), .kinds = 1 << THUD_LINK_RESTRAINER | 1 << THUD_LINK_STRUT}},
};
#undef AT

#define AT(member) offsetof(struct thud_analysis, member)
static const struct row analysis_rows[] = {
    {WORD("method", "method", "One of `thud methods`, or auto: the exact one."), TEXT(method, 32, .usual = "auto")},
    {{NUMBER("tolerance", "tolerance", "1e-6: every peak within 1e-5 of the converged value.", THUD_NUMBER, "", 1e-6), FROM(1e-13), UP_TO(0.1), USUAL(1e-12, 1e-3)},
     {PLACE(NUMBER, tolerance)}},
    {{NUMBER("step", "step", "Step of fixed-step methods; default: a twentieth of the shortest period of a mode or contact, and at most that of the record.",
     THUD_TIME, "ms", NAN), POSITIVE, UP_TO(10), ANY_USUAL}, {PLACE(NUMBER, step_s), .absent = NAN}},
    {{NUMBER("tail", "tail", "Duration of free vibration after the ground motion; without one, the whole duration.", THUD_TIME, "s", 5), FROM(0), UP_TO(100), ANY_USUAL},
     {PLACE(NUMBER, tail_s)}},
    {CHOICE("locate", "event location", "Whether fixed-step methods locate contact onset and release.", switches, 1),
     {PLACE(SWITCH, locate)}},
    {{COUNT("modes", "modes", "Number of lowest modes kept of each building; default: all.", NAN), .least = 1, UP_TO(THUD_STOREYS_MAX + 1), ANY_USUAL},
     {PLACE(COUNT, modes), .none = 0}},
};
#undef AT

#define AT(member) offsetof(struct thud_study_choice, member)
static const struct row study_rows[] = {
    {WORD("vary", "varied key", "What `thud sweep` varies; a list of up to 4 keys makes a grid."), {.store = THUD_STORE_STUDY}},
    {WORD("from", "first value", "First value of the varied key; a list if several are varied."), {.store = THUD_STORE_STUDY}},
    {WORD("to", "last value", "Last value of the varied key."), {.store = THUD_STORE_STUDY}},
    {WORD("step", "step", "Step of the varied key."), {.store = THUD_STORE_STUDY}},
    {WORD("values", "values", "Instead of from, to and step: a list, or one list for each varied key."), {.store = THUD_STORE_STUDY}},
    {WORD("cases", "cases", "List of none, bumper, cavity, link, as-written."), {.store = THUD_STORE_STUDY}},
    {{NUMBER("sensitivity", "sensitivity", "Change of gap, ground motion and stiffness for which the spread of every peak is computed; 0: none.",
     THUD_RATIO, "%", 0), FROM(0), UP_TO(0.1), USUAL(0, 0.02)}, {PLACE(NUMBER, sensitivity)}},
    {WORD("records", "ground motions", "Ground motions as for --records: files with their settings, a folder, a .list; one, or several in brackets."),
     TEXT(records, THUD_VARY_TEXT)},
    {CHOICE("signs", "signs", "both: every ground motion also with reversed polarity.", one_or_both, 0), {PLACE(SWITCH, both_signs)}},
    {WORD("events", "events", "Events of `thud fragility`, as for --event: pounding, worse, \"force:5 MN\", ...; default: pounding, worse."),
     TEXT(events, THUD_VARY_TEXT)},
};
#undef AT

#define AT(member) offsetof(struct thud_title_block, member)
static const struct row document_rows[] = {
    {WORD("project", "project", "Project of the report."), TEXT(project, 128)},
    {WORD("author", "author", "Author of the report."), TEXT(author, 64)},
    {WORD("checker", "checker", "Checker of the report."), TEXT(checker, 64)},
    {WORD("date", "date", "Date printed on the report."), TEXT(date, 32)},
    {WORD("revision", "revision", "Revision of the report."), TEXT(revision, 32)},
    {WORD("number", "number", "Number of the report among the project's documents."), TEXT(number, 32)},
    {WORD("approver", "approver", "Approver of the report."), TEXT(approver, 64)},
    {WORD("code", "code",
     "Code of the recommended gap: en1998, asce7, or exact84 (sufficient for 84 % of the ground motions); default: that of the target spectrum, or en1998."),
     TEXT(code, 32)},
    {WORD("limits", "limits", "Limits of the criteria of the report, named like events: {drift: 1 %, ductility: 4, force: 5 MN}."), TEXT(limits, 256)},
};
#undef AT
/* clang-format on */

/* Beside any group of keys that describe what is built or computed: where their values are from. */
static const struct thud_param source_param =
    WORD("source", "source", "Source of these values, for reports: a drawing, a standard.");
#define GROUP(word_, key_, in_)                                                                                        \
    .key = (key_), .rows = word_##_rows, .count = sizeof word_##_rows / sizeof *word_##_rows, .in = THUD_GROUP_##in_
#define PART(member_) .base = offsetof(struct thud_scene, member_)
#define SOURCE(of_, member_, kinds_)                                                                                   \
    .source = {                                                                                                        \
        .store = THUD_STORE_TEXT,                                                                                      \
        .offset = offsetof(struct of_, member_),                                                                       \
        .size = THUD_SOURCE_MAX,                                                                                       \
        .kinds = (kinds_),                                                                                             \
    }
static const struct {
    const char *key;
    const struct row *rows;
    int count;
    enum thud_group in;       /* what its key stands in */
    size_t base;              /* in the scene, of what it has one of */
    struct thud_place source; /* size 0: the group has none */
} groups[THUD_GROUPS] = {
    [THUD_GROUP_SCENE] = {GROUP(scene, "", SCENE)},
    [THUD_GROUP_RECORD] = {GROUP(record, "record", SCENE), PART(record), SOURCE(thud_record_choice, source, 0)},
    [THUD_GROUP_STRUCTURE] = {GROUP(structure, "structures", SCENE), SOURCE(thud_structure, source[0], ALL)},
    [THUD_GROUP_COLUMN] = {GROUP(column, "column", STRUCTURE), SOURCE(thud_structure, source[1], STOREYS)},
    [THUD_GROUP_ISOLATOR] = {GROUP(isolator, "isolator", STRUCTURE), SOURCE(thud_structure, source[2], ISOLATED)},
    [THUD_GROUP_FOUNDATION] = {GROUP(foundation, "foundation", STRUCTURE), SOURCE(thud_structure, source[3], STOREYS)},
    [THUD_GROUP_BACKFILL] = {GROUP(backfill, "backfill", STRUCTURE), SOURCE(thud_structure, source[4], WALL)},
    [THUD_GROUP_INTERFACE] = {GROUP(interface, "interfaces", SCENE), SOURCE(thud_interface, source[0], 0)},
    [THUD_GROUP_CONTACT] = {GROUP(contact, "contact", INTERFACE), SOURCE(thud_interface, source[1], 0)},
    [THUD_GROUP_BUMPER] = {GROUP(bumper, "bumper", INTERFACE), SOURCE(thud_interface, source[2], 0)},
    [THUD_GROUP_LINK] = {GROUP(link, "links", SCENE), SOURCE(thud_link, source, LINKS)},
    [THUD_GROUP_ANALYSIS] = {GROUP(analysis, "analysis", SCENE), PART(analysis), SOURCE(thud_analysis, source, 0)},
    [THUD_GROUP_STUDY] = {GROUP(study, "study", SCENE), PART(study)},
    [THUD_GROUP_DOCUMENT] = {GROUP(document, "document", SCENE), PART(document)},
};

const struct thud_param *thud_group_param(enum thud_group group, int i)
{
    if (i == groups[group].count && groups[group].source.size > 0)
        return &source_param;
    return i < groups[group].count ? &groups[group].rows[i].param : NULL;
}

const struct thud_place *thud_group_place(enum thud_group group, int i)
{
    if (i == groups[group].count && groups[group].source.size > 0)
        return &groups[group].source;
    return i < groups[group].count ? &groups[group].rows[i].place : NULL;
}

enum thud_group thud_group_in(enum thud_group group)
{
    return groups[group].in;
}

enum thud_group thud_group_find(enum thud_group in, const char *key)
{
    for (enum thud_group group = THUD_GROUP_SCENE + 1; group < THUD_GROUPS; group++)
        if (groups[group].in == in && strcmp(groups[group].key, key) == 0)
            return group;
    return THUD_GROUPS;
}

size_t thud_group_base(enum thud_group group)
{
    return groups[group].base;
}

const char *thud_group_key(enum thud_group group)
{
    return groups[group].key;
}

const char *thud_kind_name(enum thud_structure_kind kind)
{
    return kinds[kind];
}

const char *thud_isolator_name(enum thud_isolator_law law)
{
    return isolators[law];
}

bool thud_structure_has(enum thud_structure_kind kind, int param)
{
    return (thud_group_place(THUD_GROUP_STRUCTURE, param)->kinds & 1u << kind) != 0;
}

bool thud_link_has(enum thud_link_law law, int param)
{
    return (thud_group_place(THUD_GROUP_LINK, param)->kinds & 1u << law) != 0;
}

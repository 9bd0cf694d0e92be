#include "towers.h"

#include <assert.h>
#include <math.h>
#include <stdarg.h>
#include <string.h>

void thud_test_law(struct thud_law_choice *choice, const char *law, ...)
{
    struct thud_law_setup setup;
    memset(&setup, 0, sizeof setup);
    choice->law = thud_law_find(law);
    assert(choice->law);
    thud_law_defaults(choice->law, &setup);
    memcpy(choice->value, setup.value, sizeof choice->value);
    va_list list;
    va_start(list, law);
    for (const char *name; (name = va_arg(list, const char *)) != NULL;) {
        int i = thud_law_param(choice->law, name);
        assert(i >= 0);
        choice->value[i] = va_arg(list, double);
    }
    va_end(list);
}

static void tower(struct thud_structure *s, const char *name, int storeys)
{
    thud_structure_init(s, THUD_SHEAR);
    s->slab_depth_m[0] = 0;
    strcpy(s->name, name);
    s->storeys = storeys;
    s->damping = 0.05;
    for (int i = 0; i < storeys; i++) {
        s->mass_kg[i] = i + 1 < storeys ? 320e3 : 250e3;
        s->stiffness_npm[i] = 600e6;
        s->height_m[i] = 3;
    }
}

void thud_test_towers(struct thud_scene *scene)
{
    thud_scene_init(scene);
    strcpy(scene->name, "towers");
    scene->nstructures = 2;
    tower(&scene->structure[0], "A", 4);
    tower(&scene->structure[1], "B", 6);
    struct thud_interface *i = &scene->interface[0];
    i->gap_m = 0.1;
    thud_test_law(&i->contact, "kelvin-voigt-no-tension", "stiffness", 2.5e9, "restitution", 0.6, NULL);
    i->has_bumper = true;
    thud_test_law(&i->bumper, "rubber", "stiffness", 0.36e3 * pow(1000, 2.65), "exponent", 2.65, "max-strain", 0.8,
                  "post-yield", 2.5e9, "restitution", 0.5, NULL);
    i->bumper_thickness_m = 0.05;
}

struct thud_record *thud_test_motion(double factor)
{
    enum { SAMPLES = 801 };
    double a[SAMPLES];
    for (int i = 0; i < SAMPLES; i++) {
        double t = 0.02 * i, first = (t - 4) / 1.2, second = (t - 10) / 1.5;
        a[i] = factor *
               (3 * exp(-0.5 * first * first) * sin(10.8 * t) + 6 * exp(-0.5 * second * second) * sin(14 * t + 1));
    }
    struct thud_record *record = NULL;
    enum thud_status status = thud_record_create(a, SAMPLES, 0.02, &record, NULL);
    assert(status == THUD_OK);
    (void)status;
    strcpy(record->file, "bursts.csv");
    return record;
}

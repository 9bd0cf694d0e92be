/* Each switch is over all words of an enumeration, so that a new one does not compile before it has its element. */
#include "study/scene/scene_elements.h"

#include <math.h>

#include "study/scene/level.h"

static enum thud_element of_isolator(const struct thud_structure *s)
{
    switch ((enum thud_isolator_law)s->isolator_law) {
    case THUD_ISOLATOR_LINEAR:
        return THUD_ELEMENT_ISOLATOR;
    case THUD_ISOLATOR_LEAD_RUBBER:
        return THUD_ELEMENT_LEAD_RUBBER;
    case THUD_ISOLATOR_PENDULUM:
        return THUD_ELEMENT_PENDULUM;
    }
    return THUD_ELEMENTS;
}

static enum thud_element of_link(const struct thud_link *link)
{
    switch ((enum thud_link_law)link->law) {
    case THUD_LINK_SPRING:
        return THUD_ELEMENT_SPRING;
    case THUD_LINK_DASHPOT:
        return THUD_ELEMENT_DASHPOT;
    case THUD_LINK_FRICTION:
        return THUD_ELEMENT_FRICTION;
    case THUD_LINK_RESTRAINER:
        return THUD_ELEMENT_RESTRAINER;
    case THUD_LINK_STRUT:
        return THUD_ELEMENT_STRUT;
    case THUD_LINK_LAWS:
        break;
    }
    return THUD_ELEMENTS;
}

static void add_storeys(struct thud_element_sum *sum, const struct thud_structure *s)
{
    int yielding = 0;
    for (int i = 0; i < s->storeys; i++)
        yielding += isfinite(thud_structure_yield(s, i)) && s->hardening[i] < 1;
    thud_element_add(sum, THUD_ELEMENT_YIELDING_STOREY, yielding);
    thud_element_add(sum, THUD_ELEMENT_STOREY, s->storeys - yielding);
}

static void add_structure(struct thud_element_sum *sum, const struct thud_structure *s)
{
    switch (s->kind) {
    case THUD_ISOLATED:
        thud_element_add(sum, of_isolator(s), 1);
        add_storeys(sum, s);
        break;
    case THUD_SHEAR:
    case THUD_ESTIMATED:
        add_storeys(sum, s);
        break;
    case THUD_MATRIX:
    case THUD_MODES:
        thud_element_add(sum, THUD_ELEMENT_FLOOR, thud_structure_floors(s));
        break;
    case THUD_RIGID:
        thud_element_add(sum, s->velocity_mps != 0 ? THUD_ELEMENT_MOVING_BODY : THUD_ELEMENT_BODY, 1);
        break;
    case THUD_WALL:
        thud_element_add(sum, thud_wall_gives(s) ? THUD_ELEMENT_GIVING_WALL : THUD_ELEMENT_WALL, 1);
        thud_element_add(sum, THUD_ELEMENT_BACKFILL, thud_wall_has_backfill(s));
        break;
    case THUD_KINDS:
        break;
    }
    thud_element_add(sum, THUD_ELEMENT_SOIL, thud_structure_on_soil(s));
}

struct thud_element_sum thud_structure_elements(const struct thud_structure *structure)
{
    struct thud_element_sum sum = {0};
    add_structure(&sum, structure);
    return sum;
}

bool thud_scene_yields(const struct thud_scene *scene)
{
    for (int s = 0; s < scene->nstructures; s++)
        if (thud_structure_elements(&scene->structure[s]).traits & THUD_SLIPS)
            return true;
    return false;
}

bool thud_scene_slips(const struct thud_scene *scene)
{
    for (int i = 0; i < scene->nlinks; i++)
        if (thud_elements[of_link(&scene->link[i])].traits & THUD_SLIPS)
            return true;
    return false;
}

struct thud_element_sum thud_scene_elements(const struct thud_scene *scene)
{
    struct thud_element_sum sum = {0};
    for (int s = 0; s < scene->nstructures; s++)
        add_structure(&sum, &scene->structure[s]);
    for (int i = 0; i < scene->nlinks; i++)
        thud_element_add(&sum, of_link(&scene->link[i]), 1);
    thud_element_add(&sum, THUD_ELEMENT_P_DELTA, scene->p_delta);
    return sum;
}

bool thud_scene_scales(const struct thud_scene *scene)
{
    return !(thud_scene_elements(scene).traits & (THUD_NONLINEAR | THUD_NOT_DEGREE_ONE | THUD_COLLAPSES));
}

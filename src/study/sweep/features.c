/* What of a scene asks for measures: what yields, slides, or has a capacity. */
#include "study/scene/scene_elements.h"
#include "study/sweep/measure.h"

unsigned thud_structure_features(const struct thud_structure *structure)
{
    const bool isolated = structure->kind == THUD_ISOLATED, slides = thud_isolator_slides(structure);
    unsigned has = (isolated ? THUD_HAS_ISOLATORS : 0u) | (slides ? THUD_HAS_SLIDING : 0u);
    if (thud_structure_elements(structure).states > slides)
        has |= THUD_HAS_YIELDING;
    for (int i = 0; i < structure->storeys; i++)
        has |= structure->column_capacity_n[i] > 0 ? THUD_HAS_CAPACITY : 0u;
    return has;
}

unsigned thud_scene_features(const struct thud_scene *scene)
{
    unsigned has = scene->nlinks > 0 ? THUD_HAS_LINK_FORCES : 0u;
    for (int s = 0; s < scene->nstructures; s++)
        has |= thud_structure_features(&scene->structure[s]);
    return has;
}

#include "core/model/element.h"

const struct thud_element_kind thud_elements[] = {
#define THUD_ELEMENT(NAME, word, traits, dofs, states) {word, traits, dofs, states},
    THUD_ELEMENT_LIST(THUD_ELEMENT)
#undef THUD_ELEMENT
};

/* Assigns one colour to each case in all figures of a document; dashes and marks go with the colour. Its name is
 * thud_case_title. */
#pragma once

#include "plot/figure/figure.h"
#include "study/scene/scene.h"

int thud_case_color(enum thud_case which);

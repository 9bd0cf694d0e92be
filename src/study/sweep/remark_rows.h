/* The functions of the list of remarks: what each looks at, at the i-th place of its kind (structure, interface, motion
 * or varied key, from 0). It adds nothing, one remark, or several. */
#pragma once

#include "study/sweep/remark.h"

typedef void thud_remark_row(const struct thud_remark_scope *scope, int i, struct thud_remarks *out);

/* A remark, to be written by thud_error_set and its like. */
struct thud_error *thud_remark_add(struct thud_remarks *remarks);

#define THUD_REMARK(about, at, weight, name, key, allowed, keys) thud_remark_row thud_remark_##name;
#include "study/sweep/remark_list.h"

#include "core/methods/method.h"

#include <string.h>

#define THUD_METHOD(name) extern const struct thud_method thud_method_##name;
#include "core/methods/method_list.h"
#undef THUD_METHOD

static const struct thud_method *const methods[] = {
#define THUD_METHOD(name) &thud_method_##name,
#include "core/methods/method_list.h"
#undef THUD_METHOD
};

int thud_method_count(void)
{
    return (int)(sizeof methods / sizeof *methods);
}

const struct thud_method *thud_method_at(int index)
{
    return methods[index];
}

const struct thud_method *thud_method_find(const char *name)
{
    for (int i = 0; i < thud_method_count(); i++)
        if (strcmp(methods[i]->name, name) == 0)
            return methods[i];
    return NULL;
}

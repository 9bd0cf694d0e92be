#include "io/file/csv_field.h"

#include <stdbool.h>
#include <string.h>

#include "base/text.h"

char thud_csv_field(char **at, const char **field)
{
    char *in = *at, *to = in;
    *field = in;
    bool quoted = *in == '"';
    if (quoted)
        for (in++; *in && !(*in == '"' && in[1] != '"'); in++) {
            in += *in == '"';
            *to++ = *in;
        }
    else
        to = in += strcspn(in, ",\n");
    in += quoted && *in == '"';
    char end = *in;
    *to = '\0';
    *at = end ? in + 1 : in;
    *field = thud_text_csv_plain(*field);
    return end;
}

#include "app/run/command.h"

int thud_exit_status(enum thud_status status)
{
    switch (status) {
    case THUD_MEMORY:
        return THUD_OUTPUT;
    case THUD_COLLAPSED:
        return THUD_DIVERGED;
    case THUD_CANCELLED:
        return 128 + 2;
    case THUD_OK:
    case THUD_CHECK:
    case THUD_USAGE:
    case THUD_INPUT:
    case THUD_DIVERGED:
    case THUD_GNUPLOT:
    case THUD_OUTPUT:
        break;
    }
    return (int)status;
}

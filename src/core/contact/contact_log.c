#include "core/contact/contact_log.h"

#include <stdlib.h>

enum thud_status thud_contact_log_init(struct thud_contact_log *log, struct thud_contact_result *contact, int ncontacts,
                                       bool keep_impacts, struct thud_error *err)
{
    *log = (struct thud_contact_log){.contact = contact, .keep_impacts = keep_impacts};
    log->now = calloc((size_t)ncontacts + 1, sizeof *log->now);
    log->counted = calloc((size_t)ncontacts + 1, sizeof *log->counted);
    return log->now && log->counted ? THUD_OK : thud_error_set(err, THUD_MEMORY, "out of memory");
}

enum thud_status thud_contact_log_add(struct thud_contact_log *log, const struct thud_impact *impact,
                                      struct thud_error *err)
{
    if (!log->keep_impacts)
        return THUD_OK;
    if (log->count == log->capacity) {
        int more = log->capacity ? 2 * log->capacity : 256;
        struct thud_impact *p = realloc(log->impact, (size_t)more * sizeof *p);
        if (!p)
            return thud_error_set(err, THUD_MEMORY, "out of memory for the list of impacts");
        log->impact = p;
        log->capacity = more;
    }
    log->impact[log->count++] = *impact;
    return THUD_OK;
}

void thud_contact_log_clear(struct thud_contact_log *log)
{
    free(log->impact);
    free(log->now);
    free(log->counted);
    *log = (struct thud_contact_log){0};
}

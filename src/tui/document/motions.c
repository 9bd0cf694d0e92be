#include "tui/document/motions.h"

#include <stdio.h>
#include <stdlib.h>

enum thud_status thud_doc_motions(const struct thud_doc *doc, const char *list, bool both, struct thud_record_list *out,
                                  struct thud_error *err)
{
    struct thud_session *session = calloc(1, sizeof *session);
    *out = (struct thud_record_list){0};
    if (!session)
        return thud_error_set(err, THUD_MEMORY, "no memory for the motions");
    session->paths = *doc->paths;
    snprintf(session->preset_path, sizeof session->preset_path, "%s", doc->path);
    session->preset = doc->preset;
    session->scene = doc->scene;
    enum thud_status status = *list ? thud_record_list_read(session, list, NULL, 0, both, out, err)
                                    : thud_record_list_own(session, both, out, err);
    free(session);
    if (status != THUD_OK)
        thud_record_list_clear(out);
    return status;
}

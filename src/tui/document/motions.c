#include "tui/document/motions.h"

#include <stdio.h>
#include <stdlib.h>

struct thud_session *thud_doc_session(const struct thud_doc *doc)
{
    struct thud_session *session = calloc(1, sizeof *session);
    if (!session)
        return NULL;
    session->paths = *doc->paths;
    snprintf(session->preset_path, sizeof session->preset_path, "%s", doc->path);
    session->preset = doc->preset;
    session->scene = doc->scene;
    return session;
}

enum thud_status thud_doc_motions(const struct thud_doc *doc, const char *list, bool both, struct thud_record_list *out,
                                  struct thud_error *err)
{
    struct thud_session *session = thud_doc_session(doc);
    if (out)
        *out = (struct thud_record_list){0};
    enum thud_status status = session ? thud_record_list_named(session, list, both, out, err)
                                      : thud_error_set(err, THUD_MEMORY, "no memory for the motions");
    free(session);
    return status;
}

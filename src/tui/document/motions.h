/* Ground motions named together, as they are found from the preset that is open. */
#pragma once

#include "app/run/record_list.h"
#include "tui/document/doc.h"

/* What is open, as the verbs of app take it; its preset stays the document's. Free with free(); NULL: no memory. */
struct thud_session *thud_doc_session(const struct thud_doc *doc);
/* `list` as --records takes it; empty: the scene's own. `both`: each in both polarities. `out` NULL, errors: as
 * thud_record_list_read; there are none then. */
enum thud_status thud_doc_motions(const struct thud_doc *doc, const char *list, bool both, struct thud_record_list *out,
                                  struct thud_error *err);

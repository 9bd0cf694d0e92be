/* What can be done now, and why not. */
#include <math.h>

#include "tui/loop/loop.h"

int thud_tui_where(const struct thud_tui *tui)
{
    if (tui->dialog.mode == THUD_MODE_TYPING)
        return THUD_AT_TYPING;
    if (tui->dialog.mode == THUD_MODE_CHOOSING)
        return THUD_AT_CHOOSING;
    if (tui->dialog.mode == THUD_MODE_OVER)
        return tui->dialog.over->where;
    const struct thud_view *view = thud_tui_view(tui);
    return view->place ? view->place(tui) : view->where;
}

static bool steps(const struct thud_tui *tui)
{
    const struct thud_field *field = thud_form_focus(&tui->form);
    const struct thud_param *param =
        field && field->kind == THUD_FIELD_VALUE ? thud_scene_param(&tui->doc.scene, field->path, &(int){0}) : NULL;
    return param && param->kind != THUD_PARAM_TEXT;
}

/* Why an action cannot be done now, in words; NULL: it can. */
const char *thud_tui_cannot(struct thud_tui *tui, enum thud_action action)
{
    const struct thud_view *view = thud_tui_view(tui);
    const char *own = view->cannot ? view->cannot(tui, action) : NULL;
    const struct thud_field *field = thud_form_focus(&tui->form);
    switch (action) {
    case THUD_DO_UNDO:
        return tui->doc.undo.at > 0 ? NULL : "Nothing to undo";
    case THUD_DO_REDO:
        return tui->doc.undo.at < tui->doc.undo.count ? NULL : "Nothing to do again";
    case THUD_DO_EDIT:
        if (!field && view->take && view->read(tui))
            return isnan(tui->reading[tui->screen]) ? "Left and Right read a value first, Enter takes it" : NULL;
        return field ? NULL : "There is nothing to edit in this pane";
    case THUD_DO_EDIT_OLD:
    case THUD_DO_TOGGLE:
        return field && field->kind == THUD_FIELD_VALUE ? NULL : "The cursor is on no value";
    case THUD_DO_SOLVE:
    case THUD_DO_STEP_UP:
    case THUD_DO_STEP_DOWN:
    case THUD_DO_LEAP_UP:
    case THUD_DO_LEAP_DOWN:
        return steps(tui) ? NULL : "The cursor is on no number";
    case THUD_DO_REPORT:
        return thud_doc_unsaved(&tui->doc) ? "A report is of the file, and there are changes: w saves them first"
                                           : NULL;
    case THUD_DO_ZOOM:
    case THUD_DO_UNZOOM:
        return tui->chart.plot.w > 1 ? own : "There is no chart to be read here";
    case THUD_DO_SAVE:
        return thud_doc_unsaved(&tui->doc) ? NULL : "Nothing to save: the file has all of this";
    case THUD_DO_REMARKS:
        return thud_tui_cannot_list_remarks(tui);
    case THUD_DO_PICTURE:
        if (tui->files.work || tui->files.command)
            return "Files are being written; Esc stops that";
        return view->figure && view->figure(tui) ? own : "There is no figure on this screen now";
    case THUD_DO_EXPORT:
        return (view->export_csv && !view->figure) || (view->figure && view->figure(tui))
                   ? own
                   : "There is no figure on this screen now";
    case THUD_DO_PICTURES:
        if (tui->files.work || tui->files.command)
            return "Files are being written; Esc stops that";
        return tui->run.live.running || tui->run.revision != tui->doc.revision ? "There are no results yet: r runs"
                                                                               : own;
    default:
        return own;
    }
}

/* Parts of a study, computed apart, joined into what one run would have given. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "app/sweep_study_private.h"
#include "io/file.h"
#include "io/preset.h"

enum { DESCRIPTION_MAX = 16 << 20 };

static enum thud_status fill_plan(struct thud_sweep_parts *parts, const struct thud_sweep_head *head,
                                  const struct thud_scene *scene, struct thud_error *err)
{
    struct thud_sweep_plan *plan = &parts->plan;
    thud_sweep_plan_init(plan, scene);
    parts->records = calloc((size_t)head->nrecords + 1, sizeof *parts->records);
    parts->record = calloc((size_t)head->nrecords + 1, sizeof *parts->record);
    if (!parts->records || !parts->record)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    for (int i = 0; i < head->nrecords; i++) {
        snprintf(parts->records[i].file, sizeof parts->records[i].file, "%s", head->record[i]);
        parts->record[i] = head->record[i][0] ? &parts->records[i] : NULL;
    }
    plan->record = parts->record;
    plan->nrecords = head->nrecords;
    if (head->sensitivity)
        (void)thud_number_parse(head->sensitivity, &(const char *){NULL}, &plan->sensitivity);
    enum thud_status status = thud_sweep_cases(plan, head->cases, err);
    for (int i = 0; i < head->nvary && status == THUD_OK; i++)
        status = thud_sweep_vary(plan, head->vary[i], err);
    return status;
}

enum thud_status thud_sweep_parts_plan(const char *folder, struct thud_sweep_parts **out, struct thud_error *err)
{
    struct thud_sweep_journal *journal;
    struct thud_sweep_head head;
    struct thud_preset *preset = NULL;
    *out = NULL;
    enum thud_status status = thud_sweep_journal_read(folder, &journal, &head, err);
    if (status != THUD_OK)
        return status;
    struct thud_sweep_parts *parts = calloc(1, sizeof *parts);
    if (!parts)
        status = thud_error_set(err, THUD_MEMORY, "out of memory");
    if (status == THUD_OK)
        status = thud_preset_parse(head.preset, strlen(head.preset), "sweep.journal", &preset, err);
    if (status == THUD_OK)
        status = fill_plan(parts, &head, thud_preset_scene(preset), err);
    thud_preset_free(preset);
    thud_sweep_head_clear(&head);
    thud_sweep_journal_close(journal, false);
    if (status == THUD_OK)
        *out = parts;
    else
        thud_sweep_parts_free(parts);
    return status;
}

void thud_sweep_parts_free(struct thud_sweep_parts *parts)
{
    if (!parts)
        return;
    thud_sweep_plan_clear(&parts->plan);
    free(parts->records);
    free(parts->record);
    free(parts);
}

static enum thud_status refuse(struct thud_error *err, const char *folder, const char *what)
{
    thud_error_set(err, THUD_INPUT, "%s", what);
    thud_error_place(err, folder, 0, 0);
    return THUD_INPUT;
}

/* Puts the journal of one folder where it belongs. */
static enum thud_status place(const struct thud_sweep_plan *plan, const char *folder,
                              struct thud_sweep_journal **journal, int n, unsigned long long *fingerprint,
                              struct thud_error *err)
{
    struct thud_sweep_journal *one;
    struct thud_sweep_head head;
    enum thud_status status = thud_sweep_journal_read(folder, &one, &head, err);
    if (status != THUD_OK)
        return status;
    struct thud_sweep_shard shard = head.shard;
    unsigned long long own = head.fingerprint;
    thud_sweep_head_clear(&head);
    if (*fingerprint == 0)
        *fingerprint = own;
    if (own != *fingerprint)
        status = refuse(err, folder, "is a part of another study");
    else if (shard.count != n || journal[shard.index - 1]) {
        char what[160];
        snprintf(what, sizeof what, "is part %d of %d, but %d folders are named or this part is named twice",
                 shard.index, shard.count, n);
        status = refuse(err, folder, what);
    }
    struct thud_sweep_point *point;
    long points = thud_sweep_shard_points(plan, shard), done = 0;
    while (status == THUD_OK && done < points) {
        status = thud_sweep_journal_next(one, &point, err);
        if (status != THUD_OK || !point)
            break;
        free(point);
        done++;
    }
    if (status == THUD_OK && done < points) {
        char what[160];
        snprintf(what, sizeof what, "part %d of %d has %ld of its %ld points: its command goes on from there",
                 shard.index, shard.count, done, points);
        status = refuse(err, folder, what);
    }
    if (status != THUD_OK) {
        thud_sweep_journal_close(one, false);
        return status;
    }
    journal[shard.index - 1] = one;
    return THUD_OK;
}

/* What the study was made of is the same in every part, and stands beside its journal; older ones have none. */
static enum thud_status copy_description(const char *from, const char *folder, struct thud_error *err)
{
    char path[4096];
    struct thud_text text = {0};
    size_t size;
    if (snprintf(path, sizeof path, "%s/" THUD_SWEEP_STUDY_FILE, from) >= (int)sizeof path || access(path, F_OK) != 0)
        return THUD_OK;
    enum thud_status status = thud_file_read(path, DESCRIPTION_MAX, &text.data, &size, err);
    text.size = size;
    return status == THUD_OK ? thud_text_write_in(&text, folder, THUD_SWEEP_STUDY_FILE, err) : status;
}

enum thud_status thud_sweep_study_merge(const struct thud_sweep_study *study, const char *const *part, int nparts,
                                        struct thud_sweep_outcome *out, struct thud_error *err)
{
    unsigned long long fingerprint = 0;
    enum thud_status status = thud_sweep_outcome_init(study->plan, out, err);
    struct thud_sweep_journal **journal = calloc((size_t)nparts + 1, sizeof(struct thud_sweep_journal *));
    if (!journal)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    for (int i = 0; i < nparts && status == THUD_OK; i++)
        status = place(study->plan, part[i], journal, nparts, &fingerprint, err);
    if (status == THUD_OK)
        status = thud_folder_make(study->folder, err);
    if (status == THUD_OK)
        status = copy_description(part[0], study->folder, err);
    if (status == THUD_OK)
        status = thud_sweep_study_finish(study, journal, nparts, out, err);
    for (int i = 0; i < nparts; i++)
        thud_sweep_journal_close(journal[i], false);
    free(journal);
    return status;
}

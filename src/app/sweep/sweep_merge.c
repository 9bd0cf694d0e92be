/* Parts of a study, computed apart, joined into what one run would have given. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "app/sweep/sweep_study_private.h"
#include "io/file/file.h"
#include "io/preset/preset.h"

enum { DESCRIPTION_MAX = 16 << 20 };

/* The samples of a ground motion, where the head has them. */
static enum thud_status read_motion(const char *step, const char *motion, struct thud_record *out,
                                    struct thud_error *err)
{
    long samples, same;
    if (!step || !motion)
        return THUD_OK;
    if (!thud_sweep_numbers_read(step, &samples, &out->dt_s, 1) || samples < 1 || (size_t)samples > strlen(motion))
        return thud_error_set(err, THUD_INPUT, "a ground motion is damaged");
    out->a_mps2 = malloc((size_t)samples * sizeof *out->a_mps2);
    if (!out->a_mps2)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    bool whole = thud_sweep_numbers_read(motion, &same, out->a_mps2, (size_t)samples) && same == samples &&
                 out->dt_s > 0 && isfinite(out->dt_s);
    for (long i = 0; i < samples && whole; i++)
        whole = isfinite(out->a_mps2[i]);
    if (!whole)
        return thud_error_set(err, THUD_INPUT, "a ground motion is damaged");
    out->samples = (size_t)samples;
    return THUD_OK;
}

static enum thud_status fill_plan(struct thud_sweep_parts *parts, const struct thud_sweep_head *head,
                                  const struct thud_scene *scene, struct thud_error *err)
{
    struct thud_sweep_plan *plan = &parts->plan;
    thud_sweep_plan_init(plan, scene);
    parts->records = calloc((size_t)head->nrecords + 1, sizeof *parts->records);
    parts->record = calloc((size_t)head->nrecords + 1, sizeof *parts->record);
    if (!parts->records || !parts->record)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    parts->nrecords = head->nrecords;
    enum thud_status status = THUD_OK;
    for (int i = 0; i < head->nrecords && status == THUD_OK; i++) {
        const struct thud_sweep_head_record *said = &head->record[i];
        struct thud_record *record = &parts->records[i];
        status = read_motion(said->step, said->motion, record, err);
        snprintf(record->file, sizeof record->file, "%s", said->name);
        snprintf(record->event, sizeof record->event, "%s", said->event ? said->event : "");
        snprintf(record->station, sizeof record->station, "%s", said->station ? said->station : "");
        record->synthetic = said->synthetic != NULL;
        record->scale = 1;
        if (said->scale)
            (void)thud_sweep_numbers_read(said->scale, &(long){0}, &record->scale, 1);
        parts->record[i] = record->file[0] ? record : NULL;
    }
    plan->record = parts->record;
    plan->nrecords = head->nrecords;
    if (head->sensitivity)
        (void)thud_number_parse(head->sensitivity, &(const char *){NULL}, &plan->sensitivity);
    if (head->name)
        snprintf(plan->scene.name, sizeof plan->scene.name, "%s", head->name);
    if (status == THUD_OK)
        status = thud_sweep_cases(plan, head->cases, err);
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
    for (int i = 0; i < parts->nrecords; i++)
        free(parts->records[i].a_mps2);
    free(parts->records);
    free(parts->record);
    free(parts);
}

static enum thud_status refuse(struct thud_error *err, const char *folder, const char *what)
{
    return thud_error_in(err, THUD_INPUT, folder, 0, "%s", what);
}

/* A file of a folder, whole; *text is NULL where there is none. */
static enum thud_status read_beside(const char *folder, const char *name, char **text, size_t *size,
                                    struct thud_error *err)
{
    char path[4096];
    *text = NULL;
    *size = 0;
    if (snprintf(path, sizeof path, "%s/%s", folder, name) >= (int)sizeof path || access(path, F_OK) != 0)
        return THUD_OK;
    return thud_file_read(path, DESCRIPTION_MAX, text, size, err);
}

/* What all parts have in common, from the first one. */
struct common {
    unsigned long long fingerprint, sum; /* of a journal's head */
    char *description;                   /* study.json; NULL: none */
    size_t size;
};

static enum thud_status compare(const char *folder, const struct thud_sweep_head *head, struct common *common,
                                bool first, struct thud_error *err)
{
    char *text;
    size_t size;
    enum thud_status status = read_beside(folder, THUD_SWEEP_STUDY_FILE, &text, &size, err);
    if (status != THUD_OK)
        return status;
    if (first) {
        *common = (struct common){head->fingerprint, head->sum, text, size};
        return THUD_OK;
    }
    bool described = !text || !common->description || /* parts may be without one */
                     (size == common->size && memcmp(text, common->description, size) == 0);
    free(text);
    if (head->fingerprint != common->fingerprint || head->sum != common->sum)
        return refuse(err, folder, "is a part of another study");
    if (!described)
        return refuse(err, folder, "its " THUD_SWEEP_STUDY_FILE " describes another study than that of the first part");
    return THUD_OK;
}

/* A point of this study has its cases and its buildings. */
static bool belongs(const struct thud_sweep_plan *plan, const struct thud_sweep_point *point)
{
    bool fits = point->nstructures == plan->scene.nstructures && point->ncases >= plan->ncases &&
                point->ncases <= plan->ncases + 1;
    for (int i = 0; fits && i < plan->ncases; i++)
        fits = point->which[i] == plan->cases[i];
    return fits;
}

/* Reads a part through: its points are whole and of this study. */
static enum thud_status check_points(const struct thud_sweep_plan *plan, const char *folder,
                                     struct thud_sweep_journal *journal, struct thud_sweep_shard shard,
                                     struct thud_error *err)
{
    long points = thud_sweep_shard_points(plan, shard), done = 0;
    for (bool fits = true; done < points; done++) {
        struct thud_sweep_point *point;
        enum thud_status status = thud_sweep_journal_next(journal, &point, err);
        if (status != THUD_OK)
            return status;
        if (!point)
            break;
        fits = belongs(plan, point);
        free(point);
        if (!fits)
            return refuse(err, folder, "has points of another study");
    }
    if (done == points)
        return THUD_OK;
    char what[160];
    snprintf(what, sizeof what, "part %d of %d has %ld of its %ld points: its command goes on from there", shard.index,
             shard.count, done, points);
    return refuse(err, folder, what);
}

/* Puts the journal of one folder where it belongs. */
static enum thud_status place(const struct thud_sweep_plan *plan, const char *folder,
                              struct thud_sweep_journal **journal, int n, struct common *common, bool first,
                              struct thud_error *err)
{
    struct thud_sweep_journal *one;
    struct thud_sweep_head head;
    enum thud_status status = thud_sweep_journal_read(folder, &one, &head, err);
    if (status != THUD_OK)
        return status;
    struct thud_sweep_shard shard = head.shard;
    status = compare(folder, &head, common, first, err);
    thud_sweep_head_clear(&head);
    if (status == THUD_OK && (shard.count != n || journal[shard.index - 1])) {
        char what[160];
        snprintf(what, sizeof what, "is part %d of %d, but %d folders are named or this part is named twice",
                 shard.index, shard.count, n);
        status = refuse(err, folder, what);
    }
    if (status == THUD_OK)
        status = check_points(plan, folder, one, shard, err);
    if (status != THUD_OK) {
        thud_sweep_journal_close(one, false);
        return status;
    }
    journal[shard.index - 1] = one;
    return THUD_OK;
}

/* The folder is ours. What the study was made of is the same in every part; older ones have no description. */
static enum thud_status write_merged(const struct thud_sweep_study *study, struct thud_sweep_journal **journal,
                                     int nparts, const struct common *common, struct thud_sweep_outcome *out,
                                     struct thud_error *err)
{
    struct thud_text text = {0};
    enum thud_status status = study->by ? thud_made_by_enter(study->by, err) : THUD_OK;
    if (status == THUD_OK && common->description) {
        thud_text_bytes(&text, common->description, common->size);
        status = thud_text_save(&text, study->folder, THUD_SWEEP_STUDY_FILE, status, err);
    }
    if (status == THUD_OK)
        status = thud_sweep_study_finish(study, journal, nparts, out, err);
    return status == THUD_OK && study->by ? thud_made_by_keep(study->by, err) : status;
}

enum thud_status thud_sweep_study_merge(const struct thud_sweep_study *study, const char *const *part, int nparts,
                                        struct thud_sweep_outcome *out, struct thud_error *err)
{
    struct common common = {0};
    struct thud_folder_lock lock = {.fd = -1};
    enum thud_status status = thud_sweep_outcome_init(study->plan, out, err);
    struct thud_sweep_journal **journal = calloc((size_t)nparts + 1, sizeof(struct thud_sweep_journal *));
    if (!journal)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    for (int i = 0; i < nparts && status == THUD_OK; i++)
        status = place(study->plan, part[i], journal, nparts, &common, i == 0, err);
    if (status == THUD_OK)
        status = thud_folder_make(study->folder, err);
    if (status == THUD_OK)
        status = thud_folder_lock(study->folder, &lock, err);
    if (status == THUD_OK)
        status = write_merged(study, journal, nparts, &common, out, err);
    thud_folder_unlock(&lock);
    for (int i = 0; i < nparts; i++)
        thud_sweep_journal_close(journal[i], false);
    free(common.description);
    free(journal);
    return status;
}

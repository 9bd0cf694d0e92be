/* From the journals of a study to its files. */
#include <stdio.h>
#include <stdlib.h>

#include "app/run/figure_files.h"
#include "app/sweep/sweep_study_private.h"
#include "io/file/output.h"
#include "io/result/sweep_csv.h"

enum { CHUNK = 1 << 16 };

struct files {
    struct thud_output output[THUD_SWEEP_CSVS];
    struct thud_text text[THUD_SWEEP_CSVS];
};

static void abandon(struct files *files)
{
    for (int i = 0; i < THUD_SWEEP_CSVS; i++) {
        thud_output_abandon(&files->output[i]);
        thud_text_clear(&files->text[i]);
    }
}

static enum thud_status open_files(const struct thud_sweep_study *study, struct files *files, struct thud_error *err)
{
    enum thud_status status = THUD_OK;
    for (int i = 0; i < THUD_SWEEP_CSVS && status == THUD_OK; i++) {
        char path[4096];
        if (snprintf(path, sizeof path, "%s/%s", study->folder, thud_sweep_csv_name((enum thud_sweep_csv)i)) >=
            (int)sizeof path)
            return thud_error_set(err, THUD_OUTPUT, "the folder's name is too long");
        status = thud_output_open(path, &files->output[i], err);
        thud_sweep_csv_header(study->plan, (enum thud_sweep_csv)i, &files->text[i]);
    }
    return status;
}

static enum thud_status put(const struct thud_sweep_study *study, const struct thud_sweep_point *point,
                            struct files *files, struct thud_error *err)
{
    enum thud_status status = THUD_OK;
    for (int i = 0; i < THUD_SWEEP_CSVS && status == THUD_OK && !study->no_rows; i++) {
        status = thud_sweep_csv_rows(study->plan, (enum thud_sweep_csv)i, point, &files->text[i], err);
        if (status == THUD_OK)
            status = thud_output_drain(&files->output[i], &files->text[i], CHUNK, err);
    }
    return status;
}

static enum thud_status next_point(struct thud_sweep_journal *journal, struct thud_sweep_point **point,
                                   struct thud_error *err)
{
    enum thud_status status = thud_sweep_journal_next(journal, point, err);
    if (status == THUD_OK && !*point)
        status = thud_error_set(err, THUD_INPUT, "a point is missing in the journal");
    return status;
}

static enum thud_status copy_points(const struct thud_sweep_study *study, struct thud_sweep_journal **journal, int n,
                                    struct files *files, struct thud_sweep_outcome *out, struct thud_error *err)
{
    enum thud_status status = THUD_OK;
    for (int i = 0; i < n; i++)
        thud_sweep_journal_rewind(journal[i]);
    for (long i = 0; i < thud_sweep_points(study->plan) && status == THUD_OK; i++) {
        struct thud_sweep_point *point = NULL;
        if (study->cancel && *study->cancel)
            return thud_error_set(err, THUD_CANCELLED,
                                  "stopped while the files were written; the same command writes them");
        status = next_point(journal[i % n], &point, err);
        if (status == THUD_OK)
            status = put(study, point, files, err);
        if (status == THUD_OK)
            status = thud_sweep_study_deliver(study, point, out, err);
        free(point);
    }
    return status;
}

enum thud_status thud_sweep_study_deliver(const struct thud_sweep_study *study, const struct thud_sweep_point *point,
                                          struct thud_sweep_outcome *out, struct thud_error *err)
{
    thud_sweep_total_add(&out->total, point);
    enum thud_status status = study->emit ? study->emit(study->context, point, err) : THUD_OK;
    if (status == THUD_OK)
        status = thud_sweep_watch_add(&out->watch, study->plan, point, err);
    if (status == THUD_OK && study->suite)
        status = thud_suite_add(study->suite, point, err);
    if (status != THUD_OK || !study->table || out->too_many)
        return status;
    if (out->rows.table.nrows > THUD_SWEEP_ROWS_MAX) {
        out->too_many = true;
        thud_sweep_collector_clear(&out->rows);
        return THUD_OK;
    }
    return thud_sweep_collector_add(&out->rows, study->plan, point, err);
}

enum thud_status thud_sweep_study_finish(const struct thud_sweep_study *study, struct thud_sweep_journal **journal,
                                         int n, struct thud_sweep_outcome *out, struct thud_error *err)
{
    struct files *files = calloc(1, sizeof *files);
    if (!files)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    for (int i = 0; i < THUD_SWEEP_CSVS; i++)
        files->output[i].fd = -1;
    enum thud_status status = study->no_rows ? THUD_OK : open_files(study, files, err);
    if (status == THUD_OK)
        status = copy_points(study, journal, n, files, out, err);
    for (int i = 0; i < THUD_SWEEP_CSVS && status == THUD_OK && !study->no_rows; i++)
        status = thud_output_drain(&files->output[i], &files->text[i], 0, err);
    for (int i = 0; i < THUD_SWEEP_CSVS && status == THUD_OK && !study->no_rows; i++)
        status = thud_output_commit(&files->output[i], err);
    abandon(files);
    free(files);
    if (status == THUD_OK && study->table && study->figures && !out->too_many)
        out->pictures = thud_sweep_figures_save(&out->rows.table, study->folder, study->pictures, &out->picture_error);
    if (status == THUD_OK && study->conclude)
        status = study->conclude(study->owner, err);
    return status;
}

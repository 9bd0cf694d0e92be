/* From the journals of a study to its files. */
#include <stdio.h>
#include <stdlib.h>

#include "app/run/figure_files.h"
#include "app/run/threads.h"
#include "app/sweep/sweep_study_private.h"
#include "io/file/file.h"
#include "io/result/sweep_csv.h"

/* Points are read one after the other; their rows are written by several threads, each those of some points. */
enum { SHARES_MAX = 64, POINTS = 32 };

struct share {
    const struct thud_sweep_study *study;
    struct thud_sweep_point *point[POINTS];
    int points;
    struct thud_text text[THUD_SWEEP_CSVS];
};

struct files {
    struct thud_file_draft output[THUD_SWEEP_CSVS];
    int shares;
    struct share share[SHARES_MAX];
};

static void free_points(struct share *share)
{
    for (int i = 0; i < share->points; i++)
        free(share->point[i]);
    share->points = 0;
}

static void abandon(struct files *files)
{
    for (int i = 0; i < THUD_SWEEP_CSVS; i++)
        thud_file_drop(&files->output[i]);
    for (int k = 0; k < files->shares; k++) {
        free_points(&files->share[k]);
        for (int i = 0; i < THUD_SWEEP_CSVS; i++)
            thud_text_clear(&files->share[k].text[i]);
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
        status = thud_file_begin(path, &files->output[i], err);
        thud_sweep_csv_header(study->plan, (enum thud_sweep_csv)i, &files->share[0].text[i]);
    }
    return status;
}

static enum thud_status write_rows(void *context, long k, struct thud_error *err)
{
    struct share *share = &((struct files *)context)->share[k];
    (void)err;
    for (int i = 0; i < THUD_SWEEP_CSVS; i++)
        for (int p = 0; p < share->points; p++)
            thud_sweep_csv_rows(share->study->plan, (enum thud_sweep_csv)i, share->point[p], &share->text[i]);
    return THUD_OK;
}

/* The rows of all shares at hand into the files, in the order of points. */
static enum thud_status put(const struct thud_sweep_study *study, struct files *files, struct thud_error *err)
{
    const struct thud_threads_jobs jobs = {
        .n = files->shares, .threads = files->shares, .context = files, .job = write_rows};
    enum thud_status status = study->no_rows ? THUD_OK : thud_threads_run(&jobs, NULL, err);
    for (int k = 0; k < files->shares && !study->no_rows; k++)
        for (int i = 0; i < THUD_SWEEP_CSVS && status == THUD_OK; i++)
            status = thud_file_add(&files->output[i], &files->share[k].text[i], 0, err);
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

/* Points from `*next` on, shared out. */
static enum thud_status read_points(const struct thud_sweep_study *study, struct thud_sweep_journal **journal, int n,
                                    long *next, struct files *files, struct thud_error *err)
{
    const long count = thud_sweep_points(study->plan);
    enum thud_status status = THUD_OK;
    for (int k = 0; k < files->shares; k++)
        for (struct share *share = &files->share[k]; share->points < POINTS && *next < count && status == THUD_OK;
             share->points += status == THUD_OK)
            status = next_point(journal[(*next)++ % n], &share->point[share->points], err);
    return status;
}

static enum thud_status copy_points(const struct thud_sweep_study *study, struct thud_sweep_journal **journal, int n,
                                    struct files *files, struct thud_sweep_outcome *out, struct thud_error *err)
{
    enum thud_status status = THUD_OK;
    for (int i = 0; i < n; i++)
        thud_sweep_journal_rewind(journal[i]);
    for (long next = 0; next < thud_sweep_points(study->plan) && status == THUD_OK;) {
        if (study->cancel && *study->cancel)
            return thud_error_set(err, THUD_CANCELLED,
                                  "stopped while the files were written; the same command writes them");
        status = read_points(study, journal, n, &next, files, err);
        if (status == THUD_OK)
            status = put(study, files, err);
        for (int k = 0; k < files->shares; k++) {
            for (int i = 0; i < files->share[k].points && status == THUD_OK; i++)
                status = thud_sweep_study_deliver(study, files->share[k].point[i], out, err);
            free_points(&files->share[k]);
        }
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
    files->shares = thud_threads_count(study->threads, (thud_sweep_points(study->plan) - 1) / POINTS + 1, SHARES_MAX);
    for (int k = 0; k < files->shares; k++)
        files->share[k].study = study;
    enum thud_status status = study->no_rows ? THUD_OK : open_files(study, files, err);
    if (status == THUD_OK)
        status = copy_points(study, journal, n, files, out, err);
    for (int i = 0; i < THUD_SWEEP_CSVS && status == THUD_OK && !study->no_rows; i++)
        status = thud_file_keep(&files->output[i], err);
    abandon(files);
    free(files);
    if (status == THUD_OK && study->table && study->figures && !out->too_many)
        out->pictures = thud_sweep_figures_save(&out->rows.table, study->folder, study->pictures, &out->picture_error);
    if (status == THUD_OK && study->conclude)
        status = study->conclude(study->owner, err);
    return status;
}

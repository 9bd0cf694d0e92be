#include "io/result/sweep_journal.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/scan.h"
#include "io/file/file.h"
#include "io/result/sweep_journal_private.h"

#define JOURNAL "sweep.journal"
#define SAMPLES "uncertainty.journal"

/* The study that a journal has to be of. */
struct key {
    const char *name; /* of the file */
    unsigned long long fingerprint;
    struct thud_sweep_shard shard;
    double *row; /* (rows x numbers), where its lines are rows of numbers; else NULL */
    long rows;
    size_t numbers;
    struct thud_text body;
};

static enum thud_status file_failed(const struct thud_sweep_journal *journal, enum thud_status status, const char *what,
                                    struct thud_error *err)
{
    return thud_error_in(err, status, journal->path, 0, "%s", what);
}

enum thud_status thud_sweep_shard_parse(const char *text, struct thud_sweep_shard *out, struct thud_error *err)
{
    const char *at = text;
    if (thud_scan_count(&at, &out->index) && thud_scan_word(&at, "/") && thud_scan_count(&at, &out->count) && !*at &&
        out->index >= 1 && out->index <= out->count)
        return THUD_OK;
    return thud_error_refuse(err, THUD_USAGE, "shard", "K/N, K from 1 to N, e.g. 2/3",
                             "\"%.40s\" is not a part of a study", text);
}

long thud_sweep_shard_points(const struct thud_sweep_plan *plan, struct thud_sweep_shard shard)
{
    long points = thud_sweep_points(plan);
    return points >= shard.index ? (points - shard.index) / shard.count + 1 : 0;
}

/* NULL: out of memory. `file` is NULL, with errno, where it could not be opened. */
static struct thud_sweep_journal *open_file(const char *folder, const char *name, const char *mode,
                                            struct thud_error *err)
{
    struct thud_sweep_journal *journal = calloc(1, sizeof *journal);
    if (!journal) {
        thud_error_set(err, THUD_MEMORY, "out of memory");
        return NULL;
    }
    snprintf(journal->path, sizeof journal->path, "%s/%s", folder, name);
    journal->file = fopen(journal->path, mode);
    return journal;
}

/* The next line without its end; NULL at the end of what is done. */
static enum thud_status next_line(struct thud_sweep_journal *journal, char **line, struct thud_error *err)
{
    *line = NULL;
    errno = 0;
    ssize_t n = getline(&journal->buffer, &journal->capacity, journal->file);
    if (n <= 0 && !feof(journal->file)) {
        if (errno == ENOMEM)
            return thud_error_set(err, THUD_MEMORY, "out of memory");
        journal->unreadable = true;
        return file_failed(journal, THUD_INPUT, strerror(errno), err);
    }
    if (n <= 0)
        return THUD_OK;
    journal->line_number++;
    if (journal->buffer[n - 1] != '\n')
        return thud_error_in(err, THUD_INPUT, journal->path, journal->line_number, "the last line is incomplete");
    journal->buffer[n - 1] = '\0';
    *line = journal->buffer;
    return THUD_OK;
}

/* The place of the line that was read is that of the next one. */
static enum thud_status check_place(struct thud_sweep_journal *journal, long index, struct thud_error *err)
{
    if (index == thud_sweep_shard_point(journal->shard, journal->read++))
        return THUD_OK;
    return thud_error_set(err, THUD_INPUT, "a point is missing");
}

/* A row of numbers; *there: it was not the end. */
static enum thud_status next_row(struct thud_sweep_journal *journal, bool *there, struct thud_error *err)
{
    char *line;
    long index;
    double *row = journal->row + (size_t)journal->read * journal->numbers;
    enum thud_status status = next_line(journal, &line, err);
    *there = status == THUD_OK && line;
    if (!*there)
        return status;
    bool whole = journal->read < journal->rows && thud_sweep_numbers_read(line, &index, row, journal->numbers);
    return whole ? check_place(journal, index, err) : thud_error_set(err, THUD_INPUT, "a line is damaged");
}

static enum thud_status pass_line(struct thud_sweep_journal *journal, bool *there, struct thud_error *err)
{
    struct thud_sweep_point *point;
    if (journal->row)
        return next_row(journal, there, err);
    enum thud_status status = thud_sweep_journal_next(journal, &point, err);
    *there = status == THUD_OK && point;
    free(point);
    return status;
}

/* Counts the whole lines and cuts off what comes after them. */
static enum thud_status find_end(struct thud_sweep_journal *journal, struct thud_error *err)
{
    bool there;
    struct thud_error damage;
    enum thud_status status;
    thud_sweep_journal_rewind(journal);
    while ((status = pass_line(journal, &there, &damage)) == THUD_OK && there) {
        journal->done++;
        journal->end = ftello(journal->file);
    }
    if (status == THUD_MEMORY)
        return thud_error_set(err, status, "out of memory");
    if (journal->unreadable) /* what could not be read may be whole: nothing is cut off */
        return file_failed(journal, THUD_INPUT, damage.what, err);
    fflush(journal->file);
    if (ftruncate(fileno(journal->file), journal->end) != 0)
        return file_failed(journal, THUD_OUTPUT, strerror(errno), err);
    return THUD_OK;
}

static enum thud_status create(struct thud_sweep_journal *journal, const struct key *key, const char *folder,
                               struct thud_error *err)
{
    struct thud_text text = {0};
    thud_sweep_head_write(key->fingerprint, key->shard, &key->body, &text);
    enum thud_status status = thud_text_save(&text, folder, key->name, THUD_OK, err);
    if (status != THUD_OK)
        return status;
    FILE *file = fopen(journal->path, "r+");
    if (!file)
        return file_failed(journal, THUD_OUTPUT, strerror(errno), err);
    journal->file = file;
    return THUD_OK;
}

static enum thud_status open_journal(struct thud_sweep_journal *journal, const struct key *key, const char *folder,
                                     struct thud_error *err)
{
    struct thud_sweep_head head = {0};
    enum thud_status status = journal->file ? THUD_OK : create(journal, key, folder, err);
    if (status == THUD_OK)
        status = thud_sweep_head_read(journal, &head, err);
    if (status == THUD_OK && (head.fingerprint != key->fingerprint || head.shard.index != key->shard.index ||
                              head.shard.count != key->shard.count)) {
        status = file_failed(journal, THUD_INPUT, "the folder holds the beginning of another study", err);
        thud_error_allow(err, "the same study, another folder, or --replace");
    }
    thud_sweep_head_clear(&head);
    return status == THUD_OK ? find_end(journal, err) : status;
}

/* A journal of this study in `folder`, new or gone on with. */
static enum thud_status open_study(const char *folder, const struct key *key, struct thud_sweep_journal **out,
                                   struct thud_error *err)
{
    *out = open_file(folder, key->name, "r+", err);
    if (!*out)
        return THUD_MEMORY;
    (*out)->shard = key->shard;
    (*out)->row = key->row;
    (*out)->rows = key->rows;
    (*out)->numbers = key->numbers;
    enum thud_status status = THUD_OK;
    if (!(*out)->file && errno != ENOENT)
        status = file_failed(*out, THUD_OUTPUT, strerror(errno), err);
    return status == THUD_OK ? open_journal(*out, key, folder, err) : status;
}

/* Clears the key. */
static enum thud_status open_or_replace(const char *folder, struct key *key, bool replace,
                                        struct thud_sweep_journal **out, long *done, struct thud_error *err)
{
    struct thud_sweep_journal *journal;
    *out = NULL;
    *done = 0;
    enum thud_status status = open_study(folder, key, &journal, err);
    if (status == THUD_INPUT && replace) { /* another study's, or none that can be read */
        thud_sweep_journal_close(journal, true);
        status = open_study(folder, key, &journal, err);
    }
    thud_text_clear(&key->body);
    if (status != THUD_OK) {
        thud_sweep_journal_close(journal, false);
        return status;
    }
    *done = journal->done;
    *out = journal;
    return THUD_OK;
}

enum thud_status thud_sweep_journal_open(const char *folder, const struct thud_sweep_plan *plan, const char *preset,
                                         struct thud_sweep_shard shard, bool replace, struct thud_sweep_journal **out,
                                         long *done, struct thud_error *err)
{
    struct key key = {JOURNAL, thud_sweep_fingerprint(plan), shard, NULL, 0, 0, {0}};
    thud_sweep_head_body(plan, preset, shard.count > 1, &key.body);
    return open_or_replace(folder, &key, replace, out, done, err);
}

enum thud_status thud_sample_journal_open(const char *folder, unsigned long long fingerprint, double *row, long rows,
                                          size_t numbers, bool replace, struct thud_sweep_journal **out, long *done,
                                          struct thud_error *err)
{
    struct key key = {SAMPLES, fingerprint, {1, 1}, row, rows, numbers, {0}};
    return open_or_replace(folder, &key, replace, out, done, err);
}

/* journal->line, in one write. */
static enum thud_status add_line(struct thud_sweep_journal *journal, struct thud_error *err)
{
    struct thud_text *line = &journal->line;
    thud_text_append(line, "\n");
    if (line->failed)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    int fd = fileno(journal->file);
    for (size_t written = 0; written < line->size;) { /* after a part of it, the rest says why there is no room */
        ssize_t n = pwrite(fd, line->data + written, line->size - written, journal->end + (off_t)written);
        if (n < 0 && errno == EINTR)
            continue;
        if (n <= 0) {
            int why = n < 0 ? errno : ENOSPC;
            if (ftruncate(fd, journal->end) != 0)
                why = errno;
            return file_failed(journal, THUD_OUTPUT, strerror(why), err);
        }
        written += (size_t)n;
    }
    journal->end += (off_t)line->size;
    journal->done++;
    return THUD_OK;
}

enum thud_status thud_sweep_journal_add(struct thud_sweep_journal *journal, const struct thud_sweep_point *point,
                                        struct thud_error *err)
{
    journal->line.size = 0;
    thud_sweep_point_write(point, &journal->line);
    return add_line(journal, err);
}

enum thud_status thud_sample_journal_add(struct thud_sweep_journal *journal, struct thud_error *err)
{
    journal->line.size = 0;
    thud_sweep_numbers_write(journal->done, journal->row + (size_t)journal->done * journal->numbers, journal->numbers,
                             &journal->line);
    return add_line(journal, err);
}

long thud_sweep_journal_done(const struct thud_sweep_journal *journal)
{
    return journal->done;
}

void thud_sweep_journal_rewind(struct thud_sweep_journal *journal)
{
    clearerr(journal->file);
    fseeko(journal->file, journal->start, SEEK_SET);
    journal->read = 0;
    journal->line_number = journal->head_lines;
    if (journal->end < journal->start)
        journal->end = journal->start;
}

enum thud_status thud_sweep_journal_next(struct thud_sweep_journal *journal, struct thud_sweep_point **out,
                                         struct thud_error *err)
{
    char *line;
    *out = NULL;
    enum thud_status status = next_line(journal, &line, err);
    if (status != THUD_OK || !line)
        return status;
    status = thud_sweep_point_read(line, out, err);
    if (status == THUD_OK)
        status = check_place(journal, (*out)->index, err);
    if (status != THUD_OK) {
        free(*out);
        *out = NULL;
        thud_error_place(err, journal->path, journal->line_number, 0);
    }
    return status;
}

void thud_sweep_journal_close(struct thud_sweep_journal *journal, bool remove)
{
    if (!journal)
        return;
    if (remove)
        unlink(journal->path);
    if (journal->file)
        fclose(journal->file);
    thud_text_clear(&journal->line);
    free(journal->buffer);
    free(journal);
}

enum thud_status thud_sweep_journal_read(const char *folder, struct thud_sweep_journal **out,
                                         struct thud_sweep_head *head, struct thud_error *err)
{
    *head = (struct thud_sweep_head){0};
    struct thud_sweep_journal *journal = open_file(folder, JOURNAL, "r", err);
    *out = NULL;
    if (!journal)
        return THUD_MEMORY;
    enum thud_status status = THUD_OK;
    if (!journal->file) {
        status = file_failed(journal, THUD_INPUT, strerror(errno), err);
        thud_error_allow(err, "a folder that `thud sweep --shard K/N -o` wrote");
    }
    if (status == THUD_OK)
        status = thud_sweep_head_read(journal, head, err);
    if (status != THUD_OK) {
        thud_sweep_head_clear(head);
        thud_sweep_journal_close(journal, false);
        return status;
    }
    journal->shard = head->shard;
    thud_sweep_journal_rewind(journal);
    *out = journal;
    return THUD_OK;
}

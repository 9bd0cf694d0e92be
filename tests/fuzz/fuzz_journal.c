/* Any bytes as the journal of a study: refused with place and reason, or a plan whose points all become rows. The sums
 * that only chance would hit are put right first: the size of the head (which ends at a line `===`), and at the end of
 * each point's line the sum over it. A first byte `!` leaves everything as it is. */
#define _GNU_SOURCE /* memmem */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "app/sweep/sweep_study.h"
#include "base/version.h"
#include "io/result/sweep_csv.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static char folder[64], path[96];

static void must(int holds)
{
    if (!holds)
        abort();
}

static void clean(void)
{
    remove(path);
    remove(folder);
}

/* A folder in memory where there is one. */
static void prepare(void)
{
    if (folder[0])
        return;
    strcpy(folder, "/dev/shm/thud-fuzz-XXXXXX");
    if (!mkdtemp(folder)) {
        strcpy(folder, "/tmp/thud-fuzz-XXXXXX");
        must(mkdtemp(folder) != NULL);
    }
    snprintf(path, sizeof path, "%s/sweep.journal", folder);
    atexit(clean);
}

static void put_point(FILE *to, const char *line, size_t length)
{
    unsigned long long sum = 0xcbf29ce484222325ULL; /* FNV-1a */
    size_t n = length;
    while (n > 0 && line[n - 1] != ' ')
        n--;
    for (size_t i = 0; i < n; i++)
        sum = (sum ^ (unsigned char)line[i]) * 0x100000001b3ULL;
    fwrite(line, 1, n, to);
    fprintf(to, "%016llx\n", sum);
}

static void put(FILE *to, const char *text, size_t size)
{
    const char *end = memmem(text, size, "\n===\n", 5), *stop = text + size;
    if (size > 0 && text[0] == '!') {
        fwrite(text + 1, 1, size - 1, to);
        return;
    }
    size_t head = end ? (size_t)(end - text) + 1 : size;
    fprintf(to, "thud-sweep-journal 5 %s 0123456789abcdef 1 1 %zu\n", THUD_VERSION, head);
    fwrite(text, 1, head, to);
    for (const char *line = end ? end + 5 : stop; line < stop;) {
        const char *newline = memchr(line, '\n', (size_t)(stop - line));
        put_point(to, line, (size_t)((newline ? newline : stop) - line));
        line = newline ? newline + 1 : stop;
    }
}

static void read_points(const struct thud_sweep_plan *plan)
{
    struct thud_sweep_journal *journal;
    struct thud_sweep_head head;
    struct thud_sweep_point *point = NULL;
    struct thud_error err = {0};
    struct thud_text rows = {0};
    must(thud_sweep_journal_read(folder, &journal, &head, &err) == THUD_OK);
    thud_sweep_head_clear(&head);
    enum thud_status status;
    while ((status = thud_sweep_journal_next(journal, &point, &err)) == THUD_OK && point) {
        if (point->index < thud_sweep_points(plan))
            for (int i = 0; i < THUD_SWEEP_CSVS; i++)
                thud_sweep_csv_rows(plan, (enum thud_sweep_csv)i, point, &rows);
        free(point);
        rows.size = 0;
    }
    must(status == THUD_OK || (status == THUD_INPUT && err.what[0] && err.line > 1));
    thud_text_clear(&rows);
    thud_sweep_journal_close(journal, false);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    struct thud_sweep_parts *parts;
    struct thud_error err = {0};
    prepare();
    FILE *to = fopen(path, "w");
    must(to != NULL);
    put(to, (const char *)data, size);
    fclose(to);
    enum thud_status status = thud_sweep_parts_plan(folder, &parts, &err);
    if (status != THUD_OK) {
        must((status == THUD_INPUT || status == THUD_USAGE) && !parts && err.what[0]);
        return 0;
    }
    read_points(&parts->plan);
    thud_sweep_parts_free(parts);
    return 0;
}

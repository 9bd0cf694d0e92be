/* The head of a study's journal: lines `cases`, `vary`, `record`, then the preset. */
#include <stdlib.h>
#include <string.h>

#include "io/sweep_journal_private.h"

enum { FORMAT = 1 };

static void put_body(const struct thud_sweep_plan *plan, const char *preset, struct thud_text *out)
{
    thud_text_append(out, "cases ");
    for (int i = 0; i < plan->ncases; i++)
        thud_text_append(out, "%s%s", i > 0 ? "," : "", thud_case_name(plan->cases[i]));
    for (int i = 0; i < plan->naxes; i++) {
        thud_text_append(out, "\nvary %s=", plan->axis[i].key);
        for (int v = 0; v < plan->axis[i].n; v++)
            thud_text_append(out, "%s%s", v > 0 ? "," : "", plan->axis[i].text[v]);
    }
    for (int i = 0; i < plan->nrecords; i++)
        thud_text_append(out, "\nrecord %s", plan->record[i] ? plan->record[i]->file : "");
    thud_text_append(out, "\npreset\n%s\n", preset);
}

void thud_sweep_head_write(const struct thud_sweep_plan *plan, const char *preset, struct thud_sweep_shard shard,
                           struct thud_text *out)
{
    struct thud_text body = {0};
    put_body(plan, preset, &body);
    thud_text_append(out, "thud-sweep-journal %d %016llx %d %d %zu\n", FORMAT, thud_sweep_fingerprint(plan),
                     shard.index, shard.count, body.size);
    if (body.data)
        thud_text_bytes(out, body.data, body.size);
    out->failed |= body.failed;
    thud_text_clear(&body);
}

static enum thud_status damaged(const struct thud_sweep_journal *journal, struct thud_error *err)
{
    thud_error_set(err, THUD_INPUT, "is no journal of a study that this program can read");
    thud_error_place(err, journal->path, 1, 0);
    return THUD_INPUT;
}

/* Takes the body apart in place. */
static bool split(struct thud_sweep_head *head)
{
    int records = 0;
    for (const char *p = head->text; (p = strstr(p, "\nrecord ")) != NULL; p++)
        records++;
    head->record = calloc((size_t)records + 1, sizeof *head->record);
    for (char *line = head->text, *end; head->record && (end = strchr(line, '\n')) != NULL; line = end + 1) {
        *end = '\0';
        if (strncmp(line, "cases ", 6) == 0)
            head->cases = line + 6;
        else if (strncmp(line, "vary ", 5) == 0 && head->nvary < THUD_VARY_MAX)
            head->vary[head->nvary++] = line + 5;
        else if (strncmp(line, "record ", 7) == 0 && head->nrecords < records)
            head->record[head->nrecords++] = line + 7;
        else if (strcmp(line, "preset") == 0) {
            head->preset = end + 1;
            return head->cases != NULL;
        } else {
            return false;
        }
    }
    return false;
}

enum thud_status thud_sweep_head_read(struct thud_sweep_journal *journal, struct thud_sweep_head *head,
                                      struct thud_error *err)
{
    enum { LARGEST = 64 << 20 };
    int format;
    size_t size;
    char newline;
    rewind(journal->file);
    if (fscanf(journal->file, "thud-sweep-journal %d %16llx %d %d %zu%c", &format, &head->fingerprint,
               &head->shard.index, &head->shard.count, &size, &newline) != 6 ||
        newline != '\n' || format != FORMAT || size > LARGEST || head->shard.index < 1 ||
        head->shard.index > head->shard.count)
        return damaged(journal, err);
    head->text = malloc(size + 1);
    if (!head->text)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    if (fread(head->text, 1, size, journal->file) != size)
        return damaged(journal, err);
    head->text[size] = '\0';
    journal->start = ftello(journal->file);
    journal->head_lines = 1;
    for (size_t i = 0; i < size; i++)
        journal->head_lines += head->text[i] == '\n';
    return split(head) ? THUD_OK : damaged(journal, err);
}

void thud_sweep_head_clear(struct thud_sweep_head *head)
{
    free(head->text);
    free(head->record);
    *head = (struct thud_sweep_head){0};
}

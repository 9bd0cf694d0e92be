/* The head of a study's journal: lines `name` (of the preset), `cases`, `vary`, `record`, `sensitivity` where it is
 * asked for, then the preset. Each record of a part is followed by its samples, with which the program that joins the
 * parts runs motions too. Then follow its event and station, which tell motions of one recording, and what else remarks
 * on motions read. */
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/scan.h"
#include "base/version.h"
#include "io/result/sweep_journal_private.h"

enum { FORMAT = 5 };

/* A file may have ends of lines in its name. */
static void put_line(const char *word, const char *text, struct thud_text *out)
{
    if (!strchr(text, '\n')) {
        thud_text_append(out, "\n%s %s", word, text);
        return;
    }
    thud_text_append(out, "\n%s-escaped ", word);
    for (; *text; text++)
        if (*text == '\n' || *text == '\\')
            thud_text_append(out, *text == '\n' ? "\\n" : "\\\\");
        else
            thud_text_append(out, "%c", *text);
}

/* Back to the name, in place. */
static const char *unescape(char *text)
{
    char *to = text;
    for (const char *from = text; *from; from++) {
        bool escaped = *from == '\\' && from[1];
        from += escaped;
        *to++ = escaped && *from == 'n' ? '\n' : *from;
    }
    *to = '\0';
    return text;
}

static void put_motion(const struct thud_record *record, struct thud_text *out)
{
    if (record->event[0])
        put_line("event", record->event, out);
    if (record->station[0])
        put_line("station", record->station, out);
    if (record->synthetic)
        thud_text_append(out, "\nsynthetic yes");
    thud_text_append(out, "\nscale ");
    thud_sweep_numbers_write(0, &record->scale, 1, out);
    thud_text_append(out, "\nstep ");
    thud_sweep_numbers_write((long)record->samples, &record->dt_s, 1, out);
    thud_text_append(out, "\nmotion ");
    thud_sweep_numbers_write((long)record->samples, record->a_mps2, record->samples, out);
}

void thud_sweep_head_body(const struct thud_sweep_plan *plan, const char *preset, bool motions, struct thud_text *out)
{
    if (!strchr(plan->scene.name, '\n'))
        thud_text_append(out, "name %s\n", plan->scene.name);
    thud_text_append(out, "cases ");
    for (int i = 0; i < plan->ncases; i++)
        thud_text_append(out, "%s%s", i > 0 ? "," : "", thud_case_name(plan->cases[i]));
    for (int i = 0; i < plan->naxes; i++) {
        thud_text_append(out, "\nvary %s=", plan->axis[i].key);
        for (int v = 0; v < plan->axis[i].n; v++)
            thud_text_append(out, "%s%s", v > 0 ? "," : "", plan->axis[i].text[v]);
    }
    for (int i = 0; i < plan->nrecords; i++) {
        put_line("record", plan->record[i] ? plan->record[i]->file : "", out);
        if (motions && plan->record[i])
            put_motion(plan->record[i], out);
    }
    if (plan->sensitivity > 0) {
        thud_text_append(out, "\nsensitivity ");
        thud_text_number(out, plan->sensitivity);
    }
    thud_text_append(out, "\npreset\n%s\n", preset);
}

void thud_sweep_head_write(unsigned long long fingerprint, struct thud_sweep_shard shard, const struct thud_text *body,
                           struct thud_text *out)
{
    thud_text_append(out, "thud-sweep-journal %d %s %016llx %d %d %zu\n", FORMAT, THUD_VERSION, fingerprint,
                     shard.index, shard.count, body->size);
    if (body->data)
        thud_text_bytes(out, body->data, body->size);
    out->failed |= body->failed;
}

static enum thud_status refuse(const struct thud_sweep_journal *journal, struct thud_error *err)
{
    thud_error_place(err, journal->path, 1, 0);
    return THUD_INPUT;
}

static enum thud_status refuse_damaged(const struct thud_sweep_journal *journal, struct thud_error *err)
{
    thud_error_set(err, THUD_INPUT, "is not a study journal that this program can read");
    thud_error_allow(err, "remove it to start again");
    return refuse(journal, err);
}

static enum thud_status refuse_unreadable(const struct thud_sweep_journal *journal, struct thud_error *err)
{
    thud_error_set(err, THUD_INPUT, "%s", strerror(errno));
    return refuse(journal, err);
}

/* Another version may give in other digits; a study is of one. */
static enum thud_status check_version(const struct thud_sweep_journal *journal, const char *version,
                                      struct thud_error *err)
{
    if (strcmp(version, THUD_VERSION) == 0)
        return THUD_OK;
    thud_error_set(err, THUD_INPUT, "the study was begun by thud %s, this is thud %s", version, THUD_VERSION);
    thud_error_allow(err, "that version to continue; another folder, or this file removed, to start again");
    return refuse(journal, err);
}

static bool scan_next(const char **text, int *out)
{
    return thud_scan_word(text, " ") && thud_scan_count(text, out);
}

static bool scan_version(const char **text, char *out, size_t size)
{
    size_t length = thud_scan_word(text, " ") ? strcspn(*text, " \n") : 0;
    if (length == 0 || length >= size)
        return false;
    snprintf(out, size, "%.*s", (int)length, *text);
    *text += length;
    return true;
}

static bool scan_hexadecimal(const char **text, unsigned long long *out)
{
    size_t length = thud_scan_word(text, " ") ? strspn(*text, "0123456789abcdef") : 0;
    if (length == 0 || length > 16)
        return false;
    *out = strtoull(*text, NULL, 16);
    *text += length;
    return true;
}

/* The first line: format, version, fingerprint, part, size of the body. */
static enum thud_status read_start(struct thud_sweep_journal *journal, struct thud_sweep_head *head, size_t *size,
                                   struct thud_error *err)
{
    int bytes;
    enum { LARGEST = 256 << 20 };
    char line[160], version[32];
    const char *at = line;
    int format;
    rewind(journal->file);
    errno = 0;
    if (!fgets(line, sizeof line, journal->file))
        return ferror(journal->file) ? refuse_unreadable(journal, err) : refuse_damaged(journal, err);
    if (!thud_scan_word(&at, "thud-sweep-journal ") || !thud_scan_count(&at, &format))
        return refuse_damaged(journal, err);
    if (format != FORMAT) {
        thud_error_set(err, THUD_INPUT, "the study was begun by another version of thud (journal %d, not %d)", format,
                       FORMAT);
        thud_error_allow(err, "that version to continue; another folder, or this file removed, to start again");
        return refuse(journal, err);
    }
    if (!scan_version(&at, version, sizeof version) || !scan_hexadecimal(&at, &head->fingerprint) ||
        !scan_next(&at, &head->shard.index) || !scan_next(&at, &head->shard.count) || !scan_next(&at, &bytes) ||
        strcmp(at, "\n") != 0 || bytes > LARGEST || head->shard.index < 1 || head->shard.index > head->shard.count)
        return refuse_damaged(journal, err);
    *size = (size_t)bytes;
    return check_version(journal, version, err);
}

/* What stands behind a word, or behind it and "-escaped" with ends of lines in it; false: another word. */
static bool scan_line(char *line, const char *word, const char **to)
{
    char *text = line + strlen(word);
    if (strncmp(line, word, strlen(word)) != 0 || (*text != ' ' && strncmp(text, "-escaped ", 9) != 0))
        return false;
    *to = *text == ' ' ? text + 1 : unescape(text + 9);
    return true;
}

/* Takes the body apart in place. */
static bool split_body(struct thud_sweep_head *head)
{
    int records = 0;
    for (const char *p = head->text; (p = strstr(p, "\nrecord")) != NULL; p++)
        records++;
    head->record = calloc((size_t)records + 1, sizeof *head->record);
    struct thud_sweep_head_record *r = NULL; /* the last one */
    for (char *line = head->text, *end; head->record && (end = strchr(line, '\n')) != NULL; line = end + 1) {
        *end = '\0';
        if (strcmp(line, "preset") == 0) {
            head->preset = end + 1;
            return head->cases != NULL;
        }
        if (head->nvary < THUD_VARY_MAX && scan_line(line, "vary", &head->vary[head->nvary]))
            head->nvary++;
        else if (head->nrecords < records && scan_line(line, "record", &head->record[head->nrecords].name))
            r = &head->record[head->nrecords++];
        else if (!scan_line(line, "cases", &head->cases) && !scan_line(line, "name", &head->name) &&
                 !scan_line(line, "sensitivity", &head->sensitivity) &&
                 !(r && (scan_line(line, "event", &r->event) || scan_line(line, "station", &r->station) ||
                         scan_line(line, "synthetic", &r->synthetic) || scan_line(line, "scale", &r->scale) ||
                         scan_line(line, "step", &r->step) || scan_line(line, "motion", &r->motion))))
            return false;
    }
    return false;
}

enum thud_status thud_sweep_head_read(struct thud_sweep_journal *journal, struct thud_sweep_head *head,
                                      struct thud_error *err)
{
    size_t size = 0;
    enum thud_status status = read_start(journal, head, &size, err);
    if (status != THUD_OK)
        return status;
    head->text = malloc(size + 1);
    if (!head->text)
        return thud_error_set(err, THUD_MEMORY, "out of memory");
    errno = 0;
    if (fread(head->text, 1, size, journal->file) != size)
        return ferror(journal->file) ? refuse_unreadable(journal, err) : refuse_damaged(journal, err);
    head->text[size] = '\0';
    journal->start = ftello(journal->file);
    journal->head_lines = 1;
    for (size_t i = 0; i < size; i++)
        journal->head_lines += head->text[i] == '\n';
    head->sum = thud_hash(THUD_HASH_START, head->text, strlen(head->text));
    return journal->row || split_body(head) ? THUD_OK : refuse_damaged(journal, err);
}

void thud_sweep_head_clear(struct thud_sweep_head *head)
{
    free(head->text);
    free(head->record);
    *head = (struct thud_sweep_head){0};
}

/* thud help WORDS: the paragraphs of the installed manual pages that a question is about, by plain search. A paragraph
 * counts by the words of the question that begin words of it. A rarer word counts more. */
#include <dirent.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/ascii.h"
#include "base/grow.h"
#include "cli/help.h"
#include "io/file/file.h"
#include "io/file/paths.h"

enum { WORDS_MAX = 16, SHOWN = 4, COLUMNS = 76, PAGE_MOST = 4 << 20 };

struct paragraph {
    size_t at; /* of its text in the pages' */
    char page[24], section[64];
    double score;
    int hits[WORDS_MAX];
};

struct pages {
    struct thud_text text; /* paragraphs, each ended by a NUL */
    struct paragraph *list;
    int n;
    char page[24], section[64]; /* that is read now */
    size_t from;                /* of the paragraph that grows */
    bool failed;
};

static void end_paragraph(struct pages *p)
{
    if (p->text.size == p->from)
        return;
    thud_text_bytes(&p->text, "", 1);
    struct paragraph *more = thud_grow(p->list, (size_t)p->n, sizeof *more);
    p->failed = !more;
    if (!more)
        return;
    p->list = more;
    struct paragraph *to = &more[p->n++];
    *to = (struct paragraph){.at = p->from};
    memcpy(to->page, p->page, sizeof to->page);
    memcpy(to->section, p->section, sizeof to->section);
    p->from = p->text.size;
}

/* A word of a page, without the escapes of roff. */
static void put_word(struct thud_text *out, const char *word, size_t n)
{
    for (size_t i = 0; i < n; i++) {
        if (word[i] != '\\')
            thud_text_bytes(out, word + i, 1);
        else if (i + 1 < n && word[i + 1] == '(')
            i += 3;
        else if (i + 1 < n && word[++i] == 'e')
            thud_text_bytes(out, "\\", 1);
    }
}

/* The words of a line; of a line of macros without these, but for what they write themselves. */
static void put_line(struct pages *p, const char *line, bool macros)
{
    static const char writes[] =
        " Ar Aq Bq Cm Dl Dq Dv Em Fa Fl Fn Fo Fc Ft In Li Nd Nm No Ns Oc Oo Op Pa Pq Ql Qq Sq Sx "
        "Sy Va Vt Xr ";
    bool joined = false, page = false;
    for (const char *word = line + strspn(line, " "); *word; word += strspn(word, " ")) {
        const size_t n = strcspn(word, " ");
        char known[8];
        snprintf(known, sizeof known, " %.*s ", n == 2 ? 2 : 0, word);
        const bool is = macros && n == 2 && strstr(writes, known);
        joined |= is && strcmp(known, " Ns ") == 0;
        if (!is && p->text.size > p->from && !joined && !page && !(n == 1 && strchr(".,;:)", *word)))
            thud_text_bytes(&p->text, " ", 1);
        if (is && strcmp(known, " Fl ") == 0)
            thud_text_append(&p->text, "%s-", p->text.size > p->from && !joined ? " " : "");
        else if (is && strcmp(known, " Nm ") == 0)
            thud_text_append(&p->text, "%sthud", p->text.size > p->from ? " " : "");
        else if (page)
            thud_text_append(&p->text, "(%.*s)", (int)n, word);
        else if (!is)
            put_word(&p->text, word, n);
        joined = is && (joined || strcmp(known, " Fl ") == 0);
        page = macros && !is && !page && word - line >= 3 && strncmp(word - 3, "Xr ", 3) == 0;
        word += n;
    }
}

/* One line of mdoc. */
static void read_line(struct pages *p, const char *line)
{
    static const char *const ends[] = {".Pp", ".It", ".Sh", ".Ss", ".Bl", ".El", ".Bd", ".Ed"};
    if (strncmp(line, ".\\\"", 3) == 0 || strncmp(line, ".Dd", 3) == 0 || strncmp(line, ".Dt", 3) == 0)
        return;
    if (*line != '.') {
        put_line(p, line, false);
        return;
    }
    for (size_t i = 0; i < sizeof ends / sizeof *ends; i++)
        if (strncmp(line, ends[i], 3) == 0) {
            end_paragraph(p);
            if (strncmp(line, ".S", 2) == 0)
                snprintf(p->section, sizeof p->section, "%.60s", line[3] ? line + 4 : "");
            else if (strcmp(ends[i], ".It") == 0 && line[3])
                put_line(p, line + 4, true);
            return;
        }
    put_line(p, line + 1, true);
}

static void read_page(struct pages *p, const char *folder, const char *file)
{
    char path[1024], *text;
    size_t size;
    snprintf(path, sizeof path, "%s/%s", folder, file);
    if (thud_file_read(path, PAGE_MOST, &text, &size, NULL) != THUD_OK)
        return;
    const char *dot = strrchr(file, '.');
    snprintf(p->page, sizeof p->page, "%.*s(%.1s)", (int)(dot - file < 16 ? dot - file : 16), file, dot + 1);
    for (char *line = text, *end; line && *line; line = end) {
        end = strchr(line, '\n');
        if (end)
            *end++ = '\0';
        read_line(p, line);
    }
    end_paragraph(p);
    free(text);
}

/* man/thud.1 of a checkout; man1/thud.1 beside share/thud where it is installed. */
static void read_pages(struct pages *p)
{
    static const char *const places[] = {"man", "../man/man1", "../man/man3", "../man/man5", "../man/man7"};
    struct thud_paths paths;
    char folder[600];
    thud_paths_find(&paths);
    for (size_t i = 0; i < sizeof places / sizeof *places; i++) {
        snprintf(folder, sizeof folder, "%.*s%s", (int)(strlen(paths.presets) - strlen("presets")), paths.presets,
                 places[i]);
        struct dirent **file;
        const int n = scandir(folder, &file, NULL, alphasort);
        for (int k = 0; k < n; k++) {
            const char *name = file[k]->d_name, *dot = strrchr(name, '.');
            if (strncmp(name, "thud", 4) == 0 && dot && dot[1] >= '1' && dot[1] <= '8' && !dot[2])
                read_page(p, folder, name);
            free(file[k]);
        }
        if (n >= 0)
            free(file);
    }
}

/* How often words of the text begin with the word; one of two letters or fewer has to be all of it. */
static int count(const char *text, const char *word)
{
    int hits = 0;
    const size_t n = strlen(word);
    for (const char *at = text; (at = thud_ascii_find(at, word)) != NULL; at += n)
        hits += (at == text || !thud_ascii_is_alnum(at[-1])) && (n > 2 || !thud_ascii_is_alnum(at[n]));
    return hits;
}

/* The words that tell what it is about, without what ends them: "records" finds "record". */
static int split(const char *question, char word[WORDS_MAX][32])
{
    static const char small[] =
        " a an and are as at be by can do does for from has have how i if in into is it its me my of "
        "on one only or that the there they this to under what when where which who with you your ";
    int n = 0;
    for (const char *at = question; *at && n < WORDS_MAX;) {
        const size_t skip = strspn(at, " ,.;:?!\"'()"), length = strcspn(at + skip, " ,;:?!\"'()");
        size_t kept = length;
        char whole[40];
        at += skip;
        while (kept > 0 && at[kept - 1] == '.')
            kept--;
        snprintf(whole, sizeof whole, " %.*s ", (int)(kept < 36 ? kept : 36), at);
        for (char *c = whole; *c; c++)
            *c = thud_ascii_lower(*c);
        at += length;
        if (kept == 0 || strstr(small, whole))
            continue;
        kept -= kept > 3 && whole[kept] == 's';
        snprintf(word[n++], sizeof word[0], "%.*s", (int)(kept < 30 ? kept : 30), whole + 1);
    }
    return n;
}

static int higher(const void *a, const void *b)
{
    const struct paragraph *x = a, *y = b;
    return x->score != y->score ? (x->score < y->score) - (x->score > y->score) : (x->at > y->at) - (x->at < y->at);
}

/* A paragraph that has more of the question's words comes first, the rare ones before all. Rows of tables, and long
 * paragraphs, come behind. */
static void rank(struct pages *p, char word[WORDS_MAX][32], int words)
{
    double weight[WORDS_MAX], all = 0;
    for (int k = 0; k < words; k++) {
        int has = 0;
        for (int i = 0; i < p->n; i++) {
            p->list[i].hits[k] = count(p->text.data + p->list[i].at, word[k]) + count(p->list[i].section, word[k]);
            has += p->list[i].hits[k] > 0;
        }
        weight[k] = has ? log(1 + (double)p->n / has) : 0;
        all += weight[k];
    }
    for (int i = 0; i < p->n; i++) {
        double found = 0, sum = 0;
        for (int k = 0; k < words; k++) {
            found += p->list[i].hits[k] > 0 ? weight[k] : 0;
            sum += weight[k] * p->list[i].hits[k] / (0.3 + p->list[i].hits[k]);
        }
        const double length = (double)strlen(p->text.data + p->list[i].at);
        p->list[i].score = 3 * found < all ? 0 : sum * found / ((1 + length / 1000) * (1 + 40 / length));
    }
    qsort(p->list, (size_t)p->n, sizeof *p->list, higher);
}

static void show(const struct pages *p, const struct paragraph *it, struct thud_text *out)
{
    thud_text_append(out, "%s%s, %s\n  ", out->size ? "\n" : "", it->page, it->section);
    thud_text_wrap(out, p->text.data + it->at, 2, COLUMNS);
    thud_text_append(out, "\n");
}

bool thud_help_search(struct thud_text *out, const char *question)
{
    struct pages p = {0};
    char word[WORDS_MAX][32];
    const int words = split(question, word);
    read_pages(&p);
    if (p.n > 0 && words > 0 && !p.failed && !p.text.failed)
        rank(&p, word, words);
    int shown = 0;
    for (; shown < SHOWN && shown < p.n && p.list[shown].score > 0; shown++)
        show(&p, &p.list[shown], out);
    free(p.list);
    thud_text_clear(&p.text);
    return shown > 0;
}

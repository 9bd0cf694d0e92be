#include "study/scene/scene_words.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "base/nearest.h"
#include "base/text.h"
#include "study/scene/scene_slot.h"

void thud_words_add(struct thud_words *words, const char *word)
{
    if (words->count < THUD_WORDS_KNOWN)
        words->known[words->count++] = word;
}

enum thud_status thud_words_unknown(const struct thud_words *words, const char *what, const char *word,
                                    struct thud_error *err)
{
    /* a word of one or two letters is near to everything */
    const char *nearest = strlen(word) > 2 ? thud_nearest(word, words->known, words->count) : NULL;
    char list[sizeof(struct thud_error){0}.allowed] = "";
    for (int i = 0; i < words->count; i++)
        thud_append(list, sizeof list, "%s%s", i ? ", " : "", words->known[i]);
    if (nearest)
        thud_error_set(err, THUD_INPUT, "unknown %s \"%.80s\"; did you mean \"%s\"?", what, word, nearest);
    else
        thud_error_set(err, THUD_INPUT, "unknown %s \"%.80s\"", what, word);
    thud_error_allow(err, "%s", list);
    return THUD_INPUT;
}

enum thud_status thud_scene_refuse(struct thud_error *err, const char *allowed, const char *key, ...)
{
    char path[sizeof(struct thud_error){0}.key];
    va_list args;
    va_start(args, key);
    vsnprintf(path, sizeof path, key, args);
    va_end(args);
    thud_error_key(err, "%s", path);
    if (allowed)
        thud_error_allow(err, "%s", allowed);
    return THUD_INPUT;
}

int thud_list_split(char *text, char **item, int most)
{
    size_t length = strlen(text);
    if (length < 2 || text[0] != '[' || text[length - 1] != ']')
        return -1;
    text[length - 1] = '\0';
    int n = 0;
    for (char *next = text + 1; next && n <= most;) {
        char *comma = next;
        for (int depth = 0; *comma && (depth > 0 || *comma != ','); comma++)
            depth += (*comma == '[') - (*comma == ']');
        comma = *comma ? comma : NULL;
        if (comma)
            *comma = '\0';
        next += strspn(next, " \t");
        size_t end = strlen(next);
        while (end > 0 && (next[end - 1] == ' ' || next[end - 1] == '\t'))
            next[--end] = '\0';
        if (n < most)
            item[n] = next;
        n++;
        next = comma ? comma + 1 : NULL;
    }
    return n;
}

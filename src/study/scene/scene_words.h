/* The words that could stand where an unknown one does, for its message; a list taken apart. */
#pragma once

#include "base/status.h"

enum { THUD_WORDS_KNOWN = 64 };

struct thud_words {
    const char *known[THUD_WORDS_KNOWN];
    int count;
};

void thud_words_add(struct thud_words *words, const char *word);

/* `unknown WHAT "WORD"; did you mean "KNOWN"?`, the question only where one is near; allowed: all of them.
 * Returns THUD_INPUT. */
enum thud_status thud_words_unknown(const struct thud_words *words, const char *what, const char *word,
                                    struct thud_error *err);

/* "[a, b]" taken apart, in place, lists within it kept whole: items (at most `most`) into item[]; the count, or -1 when
 * it is no list. */
int thud_list_split(char *text, char **item, int most);

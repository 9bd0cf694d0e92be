#include "base/nearest.h"

#include <string.h>

enum { LETTERS = 64 };

static int least(int a, int b)
{
    return a < b ? a : b;
}

/* Optimal string alignment distance; words of LETTERS and more letters are far from everything. */
static int distance(const char *a, const char *b)
{
    int row[3][LETTERS + 1];
    size_t n = strlen(a), m = strlen(b);
    if (n >= LETTERS || m >= LETTERS)
        return LETTERS;
    int *before = row[0], *last = row[1], *now = row[2];
    for (size_t j = 0; j <= m; j++)
        last[j] = before[j] = (int)j;
    for (size_t i = 1; i <= n; i++) {
        now[0] = (int)i;
        for (size_t j = 1; j <= m; j++) {
            now[j] = least(least(last[j], now[j - 1]) + 1, last[j - 1] + (a[i - 1] != b[j - 1]));
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                now[j] = least(now[j], before[j - 2] + 1);
        }
        int *free_row = before;
        before = last;
        last = now;
        now = free_row;
    }
    return last[m];
}

const char *thud_nearest(const char *word, const char *const *words, int count)
{
    const char *best = NULL;
    int fewest = LETTERS;
    for (int i = 0; i < count; i++) {
        int d = distance(word, words[i]);
        if (d < fewest) {
            fewest = d;
            best = words[i];
        }
    }
    int letters = (int)strlen(word);
    return fewest <= (letters > 3 ? letters / 3 + (letters > 8) : 1) ? best : NULL;
}

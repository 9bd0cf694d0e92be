/* What somebody may have meant. */
#ifndef THUD_BASE_NEAREST_H
#define THUD_BASE_NEAREST_H

/* The one of `count` words that takes the fewest changes of a letter (put in, left out, replaced, two swapped) to
 * become `word`; NULL where even that takes more than a third of its letters. */
const char *thud_nearest(const char *word, const char *const *words, int count);

#endif

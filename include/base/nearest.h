/* What somebody may have meant. */
#pragma once

/* The one of `count` words that takes the fewest changes of a letter (put in, left out, replaced, two swapped) to
 * become `word`; NULL where even that takes more than a third of its letters. */
const char *thud_nearest(const char *word, const char *const *words, int count);

/* Finds the word that a mistyped one may stand for. */
#pragma once

/* Returns the one of `count` words with the fewest changes of a letter (inserted, omitted, replaced, two swapped) from
 * `word`; NULL if these exceed a third of its letters. */
const char *thud_nearest(const char *word, const char *const *words, int count);

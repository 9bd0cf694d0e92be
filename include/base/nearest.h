/* Finds the word that a mistyped one may stand for. */
#pragma once

/* Returns the word with the fewest changed letters from `word` (inserted, omitted, replaced, two swapped), of `count`;
 * NULL if the changes exceed a third of its letters. */
const char *thud_nearest(const char *word, const char *const *words, int count);

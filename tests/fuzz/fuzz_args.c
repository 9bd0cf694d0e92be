/* Any words after `thud`, one a line: what is taken names options that the command has, each with the value it needs;
 * what is refused says why. */
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "cli/args.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

enum { WORDS_MAX = 400 };

static void must(int holds)
{
    if (!holds)
        abort();
}

static void look_at(const struct thud_args *args)
{
    must(args->noperands <= THUD_OPERANDS_MAX && args->ngiven <= THUD_GIVEN_MAX);
    for (int i = 0; i < args->ngiven; i++) {
        must(thud_option_belongs(args->given[i].option, args->command));
        const char *argument = args->given[i].option->argument;
        if (!argument || argument[0] != '[') /* one that may be left out */
            must((argument != NULL) == (args->given[i].value != NULL));
    }
    int jobs = 1;
    if (thud_args_integer(args, "j", 1, 64, 1, &jobs, NULL) == THUD_OK)
        must(jobs >= 1 && jobs <= 64);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    char *text = malloc(size + 1);
    memcpy(text, data, size);
    text[size] = '\0';
    char *words[WORDS_MAX + 1] = {"thud"};
    int n = 1;
    for (char *word = text; word && n < WORDS_MAX;) {
        char *end = strchr(word, '\n');
        if (end)
            *end++ = '\0';
        words[n++] = word;
        word = end;
    }
    struct thud_args args;
    struct thud_error err = {0};
    if (thud_args_parse(n, words, &args, &err) == THUD_OK)
        look_at(&args);
    else
        must(err.status == THUD_USAGE && err.what[0] != '\0');
    free(text);
    return 0;
}

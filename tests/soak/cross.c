/* Random scenes by every way that must give the same result: tolerances, methods, the mirror, other units, halved
 * intervals, histories kept, a study with and without its shortcuts.  usage: cross [FIRST [COUNT [WORD]]]    seeds;
 * only the checks with this word in their names.  Seeds from SCENES_WIDE (1000000000) on are wide scenes,
 * those from SCENES_YIELDING (2000000000) on have storeys that yield, those from SCENES_COLUMNS (3000000000) on slabs
 * against columns, some with storeys that yield; from SCENES_MATRICES (6000000000) on buildings by their matrix or modes,
 * from SCENES_SOIL (8000000000) on soil; from SCENES_MIXED (9000000000) on all of it together; from SCENES_EQUAL
 * (10000000000) on the same with most neighbours equal and in touch; from SCENES_COARSE (100000000000) on the same again
 * with samples far apart.  A line for each
 * disagreement that the scene's own sensitivity does not explain. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "../unit/scenes_check.h"

int main(int argc, char **argv)
{
    unsigned long long first = argc > 1 ? strtoull(argv[1], NULL, 10) : 1;
    long count = argc > 2 ? strtol(argv[2], NULL, 10) : 500;
    struct scenes_tally tally = {.only = argc > 3 ? argv[3] : "", .slow = true};
    for (long i = 0; i < count; i++) {
        clock_t before = clock();
        scenes_check(first + (unsigned long long)i, &tally);
        double took_s = (double)(clock() - before) / CLOCKS_PER_SEC;
        if (took_s > 20)
            printf("# %llu: %.0f s\n", first + (unsigned long long)i, took_s);
        fflush(stdout);
    }
    scenes_tally_print(&tally, stdout);
    return tally.wrong > 0;
}

/* The jobs of a stability study in threads: each writes a row of its own. */
#include "app/run/threads.h"
#include "lab/bench/stability_report.h"

struct work {
    struct thud_stability *stability;
    void (*progress)(int done, int jobs);
};

static enum thud_status do_job(void *context, long i, struct thud_error *err)
{
    return thud_stability_job(((struct work *)context)->stability, (int)i, err);
}

static void show(void *context, long done, long n, double elapsed_s)
{
    (void)elapsed_s;
    ((struct work *)context)->progress((int)done, (int)n);
}

enum thud_status thud_stability_run(struct thud_stability *stability, const atomic_int *cancel,
                                    void (*progress)(int done, int jobs), struct thud_error *err)
{
    struct work work = {stability, progress};
    const struct thud_threads_jobs jobs = {
        .n = thud_stability_jobs(stability), .cancel = cancel, .context = &work, .job = do_job, .progress = show};
    return thud_threads_run(&jobs, NULL, err);
}

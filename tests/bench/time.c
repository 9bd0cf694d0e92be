/* How long one run of a scene takes: least of 15 of processor time, in ms.  usage: time PRESET CASE KEY=VALUE... */
#include <stdio.h>

#include "scene.h"

int main(int argc, char **argv)
{
    static struct bench_scene scene;
    static struct bench_solution solution;
    bench_scene_open(&scene, argc, argv);
    bench_scene_run(&scene, "exact", scene.options.tolerance, 15, &solution);
    printf("%.4g ms  %d impacts  %ld steps  %ld forces  %.2f s of motion\n", 1e3 * solution.seconds, solution.impacts,
           solution.work.steps, solution.work.force_evaluations, solution.end_s);
    bench_scene_close(&scene);
    return 0;
}

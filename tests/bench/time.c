/* How long one run of a scene takes: least of 15 of processor time, in ms.  usage: time PRESET CASE KEY=VALUE... */
#include <stdio.h>

#include "scene.h"

int main(int argc, char **argv)
{
    static struct bench_scene scene;
    static struct bench_answer answer;
    bench_scene_open(&scene, argc, argv);
    bench_scene_run(&scene, "exact", scene.options.tolerance, 15, &answer);
    printf("%.4g ms  %d impacts  %ld steps  %ld forces  %.2f s of motion\n", 1e3 * answer.seconds, answer.impacts,
           answer.work.steps, answer.work.force_evaluations, answer.end_s);
    bench_scene_close(&scene);
    return 0;
}

/* The exact method over its tolerances: method, tolerance, seconds of processor time and error, as the peers print
 * them; first how far the reference can be trusted.  usage: exact PRESET CASE KEY=VALUE... */
#include <stdio.h>

#include "../scene.h"

int main(int argc, char **argv)
{
    static struct bench_scene scene;
    static struct bench_solution reference, other, solution;
    static const double tolerances[] = {1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10};
    bench_scene_open(&scene, argc, argv);
    printf("reference,,,%.3e\n", bench_scene_reference(&scene, &reference, &other));
    for (int i = 0; i < 9; i++) {
        bench_scene_run(&scene, "exact", tolerances[i], 9, &solution);
        printf("exact,%.0e,%.6g,%.3e\n", tolerances[i], solution.seconds,
               bench_scene_error(&scene, solution.acceleration_mps2, &other));
    }
    bench_scene_close(&scene);
    return 0;
}

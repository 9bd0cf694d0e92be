/* Runs the scene of a preset and prints its peaks.  Build: cc -std=c17 peaks.c $(pkg-config --cflags --libs thud) */
#include <stdio.h>

#include "io/preset/preset.h"
#include "io/record/record_file.h"
#include "study/scene/answer.h"

int main(int argc, char **argv)
{
    struct thud_error err = {0};
    struct thud_preset *preset = NULL;
    struct thud_record *record = NULL; /* stays NULL for a scene without a ground motion */
    struct thud_answer answer = {0};
    enum thud_status status = argc == 3 ? thud_preset_read(argv[1], &preset, &err)
                                        : thud_error_set(&err, THUD_USAGE, "usage: peaks PRESET.yaml RECORD|-");
    const struct thud_scene *scene = preset ? thud_preset_scene(preset) : NULL;
    if (status == THUD_OK && argv[2][0] != '-')
        status = thud_record_file_read(argv[2], &scene->record, &record, &err);
    if (status == THUD_OK)
        status = thud_scene_answer(scene, record, NULL, &answer, &err);
    if (status == THUD_OK) {
        const struct thud_result *result = thud_run_result(answer.run);
        for (int s = 0; s < result->nstructures; s++)
            for (int i = 0; i < result->structure[s].floors; i++)
                printf("%s floor %d: %.6g m/s2\n", scene->structure[s].name, i + 1,
                       result->structure[s].floor[i].acceleration.value);
    } else {
        fprintf(stderr, "peaks: %s\n", thud_error_text(&err, (char[1600]){""}, 1600));
    }
    thud_answer_clear(&answer);
    thud_record_free(record);
    thud_preset_free(preset);
    return (int)status;
}

/* Runs a scene and prints its peaks: usage: peaks PRESET [KEY=VALUE...]; or, as the program prints it: peaks --json ...
 * Build: cc peaks.c $(pkg-config --cflags --libs thud) */
#include <stdio.h>
#include <string.h>
#include <thud.h>

/* KEY=VALUE, as --set takes it. */
static enum thud_status assign(struct thud *scene, const char *word, struct thud_error *err)
{
    char key[128];
    const char *sign = strchr(word, '=');
    snprintf(key, sizeof key, "%.*s", sign ? (int)(sign - word) : (int)strlen(word), word);
    return thud_set(scene, key, sign ? sign + 1 : "", err);
}

static enum thud_status print_floors(const struct thud_results *results, struct thud_error *err)
{
    const double *floor, *peak;
    size_t rows;
    enum thud_status status = thud_column(results, "floors", "floor", &floor, &rows, err);
    if (status == THUD_OK)
        status = thud_column(results, "floors", "acceleration_mps2", &peak, &rows, err);
    for (size_t i = 0; status == THUD_OK && i < rows; i++)
        printf("%s floor %.0f: %.6g m/s2\n", thud_cell(results, "floors", i, 0), floor[i], peak[i]);
    return status;
}

int main(int argc, char **argv)
{
    struct thud_error err = {0};
    struct thud *scene = NULL;
    struct thud_results *results = NULL;
    int json = argc > 1 && strcmp(argv[1], "--json") == 0;
    if (argc < 2 + json) {
        fprintf(stderr, "usage: peaks [--json] PRESET [KEY=VALUE...]\n");
        return THUD_USAGE;
    }
    enum thud_status status = thud_open(argv[1 + json], &scene, &err);
    for (int i = 2 + json; i < argc && status == THUD_OK; i++)
        status = assign(scene, argv[i], &err);
    if (status == THUD_OK)
        status = thud_run(scene, NULL, &results, &err);
    if (status == THUD_OK && json)
        fputs(thud_json(results), stdout);
    else if (status == THUD_OK)
        status = print_floors(results, &err);
    if (status != THUD_OK)
        fprintf(stderr, "peaks: %s\n", thud_error_text(&err, (char[1600]){""}, 1600));
    thud_free(results);
    thud_close(scene);
    return (int)status;
}

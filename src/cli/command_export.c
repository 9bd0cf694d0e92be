/* thud export: a scene for another program. */
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "cli/commands.h"
#include "cli/options.h"
#include "cli/study_output.h"
#include "io/file/file.h"
#include "io/file/json.h"
#include "io/result/opensees.h"
#include "plot/gnuplot/child.h"

/* Its standard input is `script`, its output is thud's. Returns how it ended, 127 where there is no such program. */
static int run_python(FILE *script)
{
    char *argv[] = {"python3", "-", NULL};
    const int fd[] = {fileno(script)};
    pid_t pid = 0;
    int status = 0, number = thud_child_start(argv[0], argv, fd, 1, NULL, false, &pid);
    while (number == 0 && waitpid(pid, &status, 0) < 0)
        number = errno == EINTR ? 0 : errno;
    return number == ENOENT ? 127 : number || !WIFEXITED(status) ? -1 : WEXITSTATUS(status);
}

/* The script as a file to read from: the one in the folder, or one without a name. NULL: there is none. */
static FILE *open_script(const struct thud_text *text, const char *path)
{
    if (path)
        return fopen(path, "r");
    FILE *file = text->failed ? NULL : tmpfile();
    if (!file)
        return NULL;
    if (fwrite(text->data, 1, text->size, file) == text->size && fflush(file) == 0 && fseek(file, 0, SEEK_SET) == 0)
        return file;
    fclose(file);
    return NULL;
}

/* --check: OpenSeesPy's peaks beside thud's. */
static enum thud_status check(const struct thud_text *text, const char *path, struct thud_error *err)
{
    FILE *script = open_script(text, path);
    fflush(stdout);
    const int ended = script ? run_python(script) : -1;
    if (script)
        fclose(script);
    switch (ended) {
    case 0:
        return THUD_OK;
    case THUD_OPENSEES_DIFFERS:
        return thud_error_set(err, THUD_CHECK, "OpenSees and thud differ by more than 1 %% in an acceleration");
    case THUD_OPENSEES_DIVERGED:
        return thud_error_set(err, THUD_DIVERGED, "OpenSees found no equilibrium of a step");
    case THUD_OPENSEES_MISSING:
        return thud_error_refuse(err, THUD_OUTPUT, "--check", "python3 -m pip install openseespy",
                                 "the scene was not checked: python3 has no OpenSeesPy");
    case 127:
        return thud_error_refuse(err, THUD_OUTPUT, "--check", "a Python with OpenSeesPy",
                                 "the scene was not checked: there is no python3");
    default:
        return thud_error_set(err, THUD_OUTPUT, "the scene was not checked: python3 did not finish");
    }
}

/* The script as a member of an object. */
static enum thud_status print_json(const struct thud_scene *scene, struct thud_text *script, struct thud_error *err)
{
    struct thud_text out = {0};
    thud_text_append(&out, "{");
    thud_json_head(&out, scene->name);
    thud_text_append(&out, ", \"program\": \"opensees\", \"script\": ");
    thud_json_string(&out, script->data ? script->data : "");
    thud_text_append(&out, "}\n");
    out.failed |= script->failed;
    thud_text_clear(script);
    return thud_text_print(&out, err);
}

static enum thud_status deliver(const struct thud_args *args, const struct thud_session *session,
                                const struct thud_scene *scene, struct thud_text *text, struct thud_error *err)
{
    static const char *const asked[] = {"case", NULL};
    struct thud_made_by by;
    const char *folder = thud_args_value(args, "o");
    char name[THUD_NAME_MAX + 16];
    if (thud_args_has(args, "check") && thud_cli_form(args) == THUD_AS_JSON)
        return thud_error_refuse(err, THUD_USAGE, "--check", "without --json", "prints a table");
    if (!folder && thud_args_has(args, "check"))
        return check(text, NULL, err);
    if (!folder && thud_cli_form(args) == THUD_AS_JSON)
        return print_json(scene, text, err);
    if (!folder)
        return thud_cli_print(text, err);
    snprintf(name, sizeof name, "%s.opensees.py", scene->name[0] ? scene->name : "scene");
    enum thud_status status = thud_made_by_scene(
        args, "export", &session->scene, (const struct thud_record *const *)&session->record, 1, asked, &by, err);
    if (status == THUD_OK)
        status = thud_made_by_begin(&by, err);
    status = thud_text_save(text, folder, name, status, err);
    if (status == THUD_OK)
        status = thud_made_by_keep(&by, err);
    thud_text_append(text, "%s/%s\n", folder, name);
    if (status == THUD_OK && thud_args_has(args, "check")) {
        char path[1200];
        snprintf(path, sizeof path, "%s/%s", folder, name);
        status = check(text, path, err);
    }
    if (status == THUD_OK && thud_cli_form(args) == THUD_AS_JSON)
        return thud_cli_print_files(args, text, err);
    thud_text_clear(text);
    return status;
}

/* The scene and its run by the nearest that OpenSees has; what that is stands at the head of the script and on standard
 * error. */
static enum thud_status replace(const struct thud_args *args, const struct thud_session *session,
                                struct thud_scene *scene, const struct thud_run_options *options,
                                struct thud_solution *solution, struct thud_text *head, struct thud_error *err)
{
    struct thud_text what = {0};
    struct thud_solution full = *solution;
    struct thud_scene *nearest = malloc(sizeof *nearest);
    *solution = (struct thud_solution){0};
    enum thud_status status =
        nearest ? thud_opensees_nearest(scene, full.model, thud_run_result(full.run), nearest, &what, err)
                : thud_error_set(err, THUD_MEMORY, "out of memory");
    if (status == THUD_OK)
        status = thud_scene_solve(nearest, session->record, options, solution, err);
    if (status == THUD_OK) {
        thud_opensees_compare(scene, thud_run_result(full.run), thud_run_result(solution->run), &what);
        if (what.failed)
            status = thud_error_set(err, THUD_MEMORY, "out of memory");
        char *rest = what.data, *line;
        while (rest && (line = thud_text_line(&rest)) != NULL) {
            thud_text_append(head, "# %s\n", line);
            if (!thud_args_has(args, "quiet"))
                fprintf(stderr, "thud: %s\n", line);
        }
        *scene = *nearest;
    }
    thud_text_clear(&what);
    thud_solution_clear(&full);
    free(nearest);
    return status;
}

static enum thud_status opensees(const struct thud_args *args, struct thud_session *session, struct thud_scene *scene,
                                 struct thud_error *err)
{
    struct thud_solution solution = {0};
    struct thud_text text = {0};
    struct thud_model *model = NULL;
    struct thud_run_options options;
    enum thud_status status = thud_scene_options_of_case(args, session, scene, err);
    if (status == THUD_OK)
        status = thud_scene_check(scene, err);
    if (status == THUD_OK)
        status = thud_session_read_record(session, err);
    if (status == THUD_OK)
        status = thud_scene_assemble(scene, &model, err);
    const bool whole = status == THUD_OK && thud_opensees_check(scene, model, err) == THUD_OK;
    thud_model_free(model);
    if (status == THUD_OK && !whole && thud_args_has(args, "strict"))
        status = THUD_INPUT;
    if (status == THUD_OK)
        status = thud_scene_options(scene, &options, err);
    if (status == THUD_OK)
        status = thud_scene_solve(scene, session->record, &options, &solution, err);
    if (status == THUD_OK && !whole)
        status = replace(args, session, scene, &options, &solution, &text, err);
    if (status == THUD_OK) {
        thud_opensees_script(scene, solution.model, session->record, thud_run_result(solution.run), &text);
        status = deliver(args, session, scene, &text, err);
    }
    thud_text_clear(&text);
    thud_solution_clear(&solution);
    return status;
}

enum thud_status thud_command_export(const struct thud_args *args, struct thud_error *err)
{
    struct thud_args rest = *args;
    if (args->noperands == 0 || strcmp(args->operand[0], "opensees") != 0)
        return thud_error_refuse(err, THUD_USAGE, NULL, "opensees",
                                 args->noperands == 0 ? "thud export needs a program" : "no export to \"%.40s\"",
                                 args->operand[0]);
    rest.noperands--;
    for (int i = 0; i < rest.noperands; i++)
        rest.operand[i] = args->operand[i + 1];
    return thud_scene_options_with(&rest, opensees, err);
}

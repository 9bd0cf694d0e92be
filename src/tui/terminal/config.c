#include "tui/terminal/config.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "io/file/file.h"

void thud_config_init(struct thud_config *config)
{
    *config = (struct thud_config){.color = true, .live = true, .mouse = true};
}

void thud_config_path(char *path, unsigned long size)
{
    const char *base = getenv("XDG_CONFIG_HOME"), *home = getenv("HOME");
    *path = '\0';
    if (base && *base == '/')
        snprintf(path, size, "%s/thud/config", base);
    else if (home && *home)
        snprintf(path, size, "%s/.config/thud/config", home);
}

static enum thud_status set(struct thud_config *config, const char *word, const char *value, struct thud_error *err)
{
    bool *const flag[] = {&config->color, &config->ascii, &config->live, &config->mouse};
    static const char *const name[] = {"color", "ascii", "live", "mouse"};
    bool on = strcmp(value, "on") == 0;
    if (strcmp(word, "folder") == 0 && *value) {
        snprintf(config->folder, sizeof config->folder, "%s", value);
        return THUD_OK;
    }
    for (int i = 0; strcmp(word, "theme") == 0 && i < THUD_THEMES; i++)
        if (strcmp(value, thud_theme_name((enum thud_theme)i)) == 0) {
            config->theme = (enum thud_theme)i;
            return THUD_OK;
        }
    for (int i = 0; strcmp(word, "images") == 0 && i < THUD_IMAGES_CHOICES; i++)
        if (strcmp(value, thud_image_choice_name((enum thud_image_choice)i)) == 0) {
            config->images = (enum thud_image_choice)i;
            return THUD_OK;
        }
    for (size_t i = 0; i < sizeof name / sizeof *name; i++)
        if (strcmp(word, name[i]) == 0 && (on || strcmp(value, "off") == 0)) {
            *flag[i] = on;
            return THUD_OK;
        }
    thud_error_set(err, THUD_INPUT, "\"%.40s %.40s\" is not understood", word, value);
    thud_error_allow(
        err, "color, ascii, live, mouse, each on or off; theme auto, dark, light, mono or 16; images auto, kitty, "
             "sixel or none; folder DIR");
    return THUD_INPUT;
}

enum thud_status thud_config_read(struct thud_config *config, const char *path, struct thud_error *err)
{
    enum { BYTES_MAX = 1 << 16 };
    char *text, *rest, *line;
    int number = 0;
    if (!*path || access(path, F_OK) != 0)
        return THUD_OK;
    enum thud_status status = thud_text_read(path, BYTES_MAX, &text, err);
    if (status != THUD_OK)
        return status;
    for (rest = text; status == THUD_OK && (line = thud_text_line(&rest)) != NULL;) {
        number++;
        line[strcspn(line, "#")] = '\0';
        line += strspn(line, " \t");
        for (size_t n = strlen(line); n > 0 && (line[n - 1] == ' ' || line[n - 1] == '\t'); n--)
            line[n - 1] = '\0';
        if (!*line)
            continue;
        char *value = line + strcspn(line, " \t");
        if (*value) {
            *value++ = '\0';
            value += strspn(value, " \t");
        }
        status = set(config, line, value, err);
        if (status != THUD_OK)
            thud_error_place(err, path, number, 0);
    }
    free(text);
    return status;
}

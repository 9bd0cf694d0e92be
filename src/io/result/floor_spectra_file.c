#include "io/result/floor_spectra_file.h"

#include "io/file/json.h"
#include "io/result/result_rows.h"

static const struct thud_column spectra[] = {
    THUD_STANDS_FOR("structure", "Name of the structure."),
    THUD_STANDS_FOR("floor", "Floor, from 1."),
    THUD_STANDS_FOR("period_s", "Period of the oscillator, s."),
    THUD_STANDS_FOR("no_pounding_mps2", "Peak pseudo-acceleration without pounding (links act), m/s2: omega^2 times "
                                        "the peak displacement relative to the floor."),
    THUD_STANDS_FOR("none_mps2", "Peak pseudo-acceleration without the bumper, m/s2."),
    THUD_STANDS_FOR("bumper_mps2", "Peak pseudo-acceleration with the bumper, m/s2; if there is one.")};
const struct thud_schema thud_floor_spectrum_schema = THUD_SCHEMA(
    "floor-spectra.csv",
    "Written by\n.Cm run Fl -floor-spectra Fl o ,\nalso to standard output with\n.Fl -csv :\na row for each "
    "structure, floor and period.\n",
    spectra);

void thud_floor_spectra_csv(const struct thud_scene *scene, const struct thud_floor_spectra *s, struct thud_text *out)
{
    int largest;
    thud_text_append(out, "structure,floor,period_s");
    for (int i = 0; i < s->ncases; i++)
        thud_text_append(out, ",%s_mps2", thud_floor_case_column(i));
    thud_text_append(out, "\n");
    for (int f = 0; f < s->nfloors; f++)
        for (int k = 0; k < s->nperiods; k++) {
            thud_text_csv(out, scene->structure[s->floor[f].structure].name);
            thud_text_append(out, ",%d,", s->floor[f].floor + 1);
            thud_text_number(out, s->period_s[k]);
            for (int i = 0; i < s->ncases; i++) {
                thud_text_append(out, ",");
                thud_text_number(out, thud_floor_spectrum(s, i, f, &largest)[k]);
            }
            thud_text_append(out, "\n");
        }
}

static void numbers(const double *value, int n, struct thud_text *out)
{
    thud_text_append(out, "[");
    for (int k = 0; k < n; k++) {
        thud_text_append(out, k ? ", " : "");
        thud_json_number(out, value[k]);
    }
    thud_text_append(out, "]");
}

void thud_floor_spectra_json(const struct thud_scene *scene, const struct thud_floor_spectra *s, struct thud_text *out)
{
    int largest;
    thud_text_append(out, "{");
    thud_json_head(out, scene->name);
    thud_text_append(out, ",\n \"record\": ");
    thud_json_string(out, scene->record.file);
    thud_text_append(out, ",\n ");
    thud_json_field(out, "damping", s->damping);
    thud_text_append(out, ",\n \"periods_s\": ");
    numbers(s->period_s, s->nperiods, out);
    thud_text_append(out, ",\n \"floors\": [");
    for (int f = 0; f < s->nfloors; f++) {
        thud_text_append(out, "%s\n  {\"structure\": ", f ? "," : "");
        thud_json_string(out, scene->structure[s->floor[f].structure].name);
        thud_text_append(out, ", \"floor\": %d, \"cases\": [", s->floor[f].floor + 1);
        for (int i = 0; i < s->ncases; i++) {
            thud_text_append(out, "%s\n   {\"case\": \"%s\", ", i ? "," : "", thud_case_name(thud_case_compared(i)));
            thud_json_field(out, "acceleration_mps2", s->peak_mps2[i * s->nfloors + f]);
            thud_text_append(out, ", \"pseudo_acceleration_mps2\": ");
            numbers(thud_floor_spectrum(s, i, f, &largest), s->nperiods, out);
            thud_text_append(out, "}");
        }
        thud_text_append(out, "]}");
    }
    thud_text_append(out, "]}\n");
}

/* Two free bodies meeting: figures from an independent solver (1e-5 s steps, bisected events), closed forms, and
 * momentum. */
#include <check.h>
#include <math.h>

#include "plot/figures/figures_paper.h"
#include "study/scene/two_body.h"

START_TEST(the_papers_four_cases)
{
    static const struct {
        double closing, force_kn, depth_mm, duration_ms, e, residual_mm;
    } want[THUD_PAPER_PAIRS] = {{0.5, 8379.6, 3.1807, 22.850, 0.63229, 0.8118},
                                {0.5, 2566.5, 28.443, 203.86, 0.50953, 0.0},
                                {1.0, 16759.2, 6.3613, 22.850, 0.63229, 1.6237},
                                {1.0, 9643.6, 41.323, 148.07, 0.50177, 0.0}};
    struct thud_paper_pair got[THUD_PAPER_COLLISIONS];
    ck_assert_int_eq(thud_paper_pairs(got, NULL), THUD_OK);
    for (int i = 0; i < THUD_PAPER_PAIRS; i++) {
        ck_assert(got[i].approach_mps == want[i].closing);
        ck_assert(fabs(1e-3 * got[i].force_n / want[i].force_kn - 1.0) < 1e-4);
        ck_assert(fabs(1e3 * got[i].indentation_m / want[i].depth_mm - 1.0) < 1e-4);
        ck_assert(fabs(1e3 * got[i].duration_s / want[i].duration_ms - 1.0) < 1e-4);
        ck_assert(fabs(got[i].restitution - want[i].e) < 1e-5);
        ck_assert(fabs(1e3 * got[i].residual_m - want[i].residual_mm) < 1e-4);
    }
}
END_TEST

/* Unequal bodies: what they part with follows from momentum and the restitution obtained; the impulse from both. */
START_TEST(momentum_is_kept)
{
    struct thud_two_body pair;
    struct thud_solution solution;
    thud_two_body_concrete(&pair);
    pair.mass_kg[1] = 200e3;
    ck_assert_int_eq(thud_two_body_run(&pair, 1e-3, &solution, NULL), THUD_OK);
    const struct thud_contact_result *contact = &thud_run_result(solution.run)->contact[0];
    const struct thud_history *h = thud_run_history(solution.run);
    const double *last = h->value + (h->rows - 1) * (size_t)h->columns;
    double left = last[thud_history_velocity(h, 0)], right = last[thud_history_velocity(h, 1)];
    ck_assert(fabs(320e3 * left + 200e3 * right - 320e3 * 0.5) < 1e-6 * 320e3);
    ck_assert(fabs(right - left - contact->separation_mps) < 1e-7);
    ck_assert(fabs(contact->impulse_ns - 200e3 * right) < 1e-5 * contact->impulse_ns);
    thud_solution_clear(&solution);
}
END_TEST

static double largest(const struct thud_series *series, const double *value)
{
    double most = -INFINITY;
    for (size_t i = 0; i < series->n; i++)
        most = fmax(most, value[i]);
    return most;
}

START_TEST(figures_show_the_numbers)
{
    struct thud_figure *figure;
    ck_assert_int_eq(thud_figure_paper3(&figure, NULL), THUD_OK);
    ck_assert_int_eq(figure->panel[0].nseries, 3);
    /* past the ultimate strain on approach: F_u = k du^n, then the line to where the energy is used up; the same for
     * all three */
    double u = 40.0, n = 2.65, fu = 0.36 * pow(u, n),
           rest = 0.5 * 160e3 * 1.2 * 1.2 - fu * u / (n + 1.0); /* J = kN mm */
    double past = (-fu + sqrt(fu * fu + 2.0 * 2500.0 * rest)) / 2500.0;
    for (int i = 0; i < 3; i++) {
        const struct thud_series *loop = figure->panel[1].series[i];
        ck_assert_double_eq_tol(largest(loop, loop->y), 1e-3 * (fu + 2500.0 * past), 2e-3);
        ck_assert(fabs(largest(loop, loop->x) - (u + past)) < 2e-3);
    }
    thud_figure_free(figure);
    ck_assert_int_eq(thud_figure_paper4(&figure, NULL), THUD_OK);
    const struct thud_series *loop = figure->panel[0].series[0]; /* no bumper, 0.5 m/s: F jumps to c v */
    ck_assert(fabs(loop->y[1] - 3.210) < 1e-3 && loop->x[1] == 0.0 && loop->y[0] == 0.0);
    ck_assert(fabs(largest(loop, loop->y) - 8.3796) < 2e-3);
    ck_assert(fabs(loop->x[loop->n - 1] - 0.8118) < 1e-3 && fabs(loop->y[loop->n - 1]) < 1e-6);
    thud_figure_free(figure);
    ck_assert_int_eq(thud_figure_paper5(&figure, NULL), THUD_OK);
    for (int p = 0; p < 6; p++)
        ck_assert_int_eq(figure->panel[p].nseries, 2);
    const struct thud_series *velocity = figure->panel[3].series[1]; /* bumper, 1 m/s */
    ck_assert(velocity->y[0] == 1.0 && fabs(velocity->y[velocity->n - 1] + 0.50177) < 1e-4);
    thud_figure_free(figure);
}
END_TEST

/* Figures 2 and 3 call one thing by one name, and symbols are set as symbols. */
START_TEST(the_bumpers_figures_share_a_term)
{
    static enum thud_status (*const make[])(struct thud_figure **, struct thud_error *) = {thud_figure_paper2,
                                                                                           thud_figure_paper3};
    for (int f = 0; f < 2; f++) {
        struct thud_figure *figure;
        struct thud_text words = {0};
        ck_assert_int_eq(make[f](&figure, NULL), THUD_OK);
        const struct thud_panel *panel = &figure->panel[f];
        ck_assert_int_eq(panel->nmarks, 1);
        ck_assert(panel->mark[0].from == 40.0);
        ck_assert_str_eq(panel->mark[0].text, "ultimate strain 0.8: 𝛿ᵤ = 40 mm");
        thud_text_append(&words, "%s %s", figure->title, figure->note);
        for (int i = 0; i < panel->nseries; i++)
            thud_text_append(&words, " %s", panel->series[i]->name);
        ck_assert_ptr_nonnull(strstr(words.data, "𝑒"));
        ck_assert(!strstr(words.data, "COR") && !strstr(words.data, "F =") && !strstr(words.data, "δ"));
        thud_text_clear(&words);
        thud_figure_free(figure);
    }
}
END_TEST

Suite *thud_suite(void);
Suite *thud_suite(void)
{
    Suite *suite = suite_create("pair");
    TCase *tcase = tcase_create("pair");
    tcase_add_test(tcase, the_papers_four_cases);
    tcase_add_test(tcase, momentum_is_kept);
    tcase_add_test(tcase, figures_show_the_numbers);
    tcase_add_test(tcase, the_bumpers_figures_share_a_term);
    suite_add_tcase(suite, tcase);
    return suite;
}

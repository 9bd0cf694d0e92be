#include "core/motion/nodes.h"

void thud_nodes_set(struct thud_nodes *nodes, int count, const double *s, double scale, int terms)
{
    for (int i = 0; i < THUD_BATCH; i++) {
        nodes->power[0][i] = 1;
        nodes->power[1][i] = i < count ? scale * s[i] : 0;
    }
    for (int k = 2; k < terms; k++)
        for (int i = 0; i < THUD_BATCH; i++)
            nodes->power[k][i] = nodes->power[k - 1][i] * nodes->power[1][i];
}

void thud_nodes_values(const struct thud_nodes *nodes, const double *c, int stride, int n, double *value)
{
    struct thud_batch v = {0};
    for (int k = n - 1; k >= 0; k--)
        thud_batch_add(&v, c[k * stride], nodes->power[k]);
    thud_batch_put(&v, value);
}

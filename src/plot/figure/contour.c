/* Contours of a map by marching triangles: each cell is cut in four at its middle, so that no case is ambiguous. */
#include <math.h>

#include "plot/figure/figure.h"

struct corner {
    double x, y, z;
};

bool thud_map_range(const struct thud_map *map, double *least, double *most)
{
    *least = INFINITY;
    *most = -INFINITY;
    for (size_t i = 0; i < map->nx * map->ny; i++) {
        if (!isfinite(map->z[i]))
            continue;
        *least = fmin(*least, map->z[i]);
        *most = fmax(*most, map->z[i]);
    }
    return *least <= *most;
}

/* Where the level crosses the edge from a to b; false when it does not. */
static bool crossing(struct corner a, struct corner b, double level, double *x, double *y)
{
    if ((a.z > level) == (b.z > level))
        return false;
    double t = (level - a.z) / (b.z - a.z);
    *x = a.x + t * (b.x - a.x);
    *y = a.y + t * (b.y - a.y);
    return true;
}

static bool cut(const struct corner *p, double level, double *piece)
{
    int n = 0;
    for (int i = 0; i < 3 && n < 2; i++)
        n += crossing(p[i], p[(i + 1) % 3], level, &piece[2 * n], &piece[2 * n + 1]);
    return n == 2;
}

static struct corner at(const struct thud_map *map, size_t i, size_t j)
{
    return (struct corner){map->x[i], map->y[j], map->z[j * map->nx + i]};
}

size_t thud_map_contour(const struct thud_map *map, double (*piece)[4], size_t most)
{
    size_t n = 0;
    for (size_t j = 0; j + 1 < map->ny; j++) {
        for (size_t i = 0; i + 1 < map->nx; i++) {
            struct corner c[4] = {at(map, i, j), at(map, i + 1, j), at(map, i + 1, j + 1), at(map, i, j + 1)};
            struct corner mid = {0.25 * (c[0].x + c[1].x + c[2].x + c[3].x), 0.25 * (c[0].y + c[1].y + c[2].y + c[3].y),
                                 0.25 * (c[0].z + c[1].z + c[2].z + c[3].z)};
            bool on = false; /* a plain that lies at the level has no line around it */
            for (int k = 0; k < 4; k++)
                on = on || fabs(c[k].z - map->level) <= 1e-9 * fabs(map->level);
            if (!isfinite(mid.z) || on)
                continue;
            for (int k = 0; k < 4; k++) {
                double found[4];
                if (!cut((struct corner[]){c[k], c[(k + 1) % 4], mid}, map->level, found))
                    continue;
                for (int m = 0; m < 4 && n < most; m++)
                    piece[n][m] = found[m];
                n++;
            }
        }
    }
    return n;
}

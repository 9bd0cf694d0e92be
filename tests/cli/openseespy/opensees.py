"""In place of OpenSeesPy: prints what a script builds, and ends its analysis as asked.

analyze() prints period and damping ratio of every mode of the springs and dashpots, and for each node without mass by which
parts its springs hold it to others. It leaves the peaks that the script expects, times STAND_IN; it fails where that is
"stuck", and there is no such module where it is "none".
"""
import math
import os
import sys

STAND_IN = os.environ.get("STAND_IN", "1")
if STAND_IN == "none":
    raise ImportError("left out")
masses, fixed, materials, springs, files = {}, set(), {}, [], {}


def node(tag, *_):
    masses[tag] = 0.0


def fix(tag, *_):
    fixed.add(tag)


def mass(tag, value):
    masses[tag] = value


def uniaxialMaterial(kind, tag, *values):
    stiffness = values[1] if kind == "Steel01" else values[0] if kind == "Elastic" else 0.0  # contacts are open
    materials[tag] = (stiffness, values[1] if kind == "Elastic" and len(values) > 1 else 0.0)


def element(_kind, _tag, i, j, _mat, material, *_):
    springs.append((i, j, *materials[material]))


def matrix(nodes, which):
    """K (which 2) or C (3) of the nodes that move."""
    at = {tag: i for i, tag in enumerate(nodes)}
    out = [[0.0] * len(nodes) for _ in nodes]
    for spring in springs:
        ends = [at[tag] for tag in spring[:2] if tag in at]
        for i in ends:
            for j in ends:
                out[i][j] += spring[which] if i == j else -spring[which]
    return out


def condense(k, kept):
    """Without the rows behind `kept`, which carry no mass."""
    for p in range(len(k) - 1, kept - 1, -1):
        for i in range(p):
            part = k[i][p] / k[p][p]
            for j in range(p):
                k[i][j] -= part * k[p][j]
    return [row[:kept] for row in k[:kept]]


def modes(a):
    """Eigenvalues and vectors (columns) of a symmetric matrix, by Jacobi's rotations."""
    n = len(a)
    v = [[float(i == j) for j in range(n)] for i in range(n)]
    for _ in range(60):
        for p in range(n):
            for q in range(p + 1, n):
                if abs(a[p][q]) <= 1e-15 * math.sqrt(abs(a[p][p] * a[q][q])):
                    continue
                theta = 0.5 * math.atan2(2 * a[p][q], a[q][q] - a[p][p])
                c, s = math.cos(theta), math.sin(theta)
                for rows in (a, v):
                    for row in rows:
                        row[p], row[q] = c * row[p] - s * row[q], s * row[p] + c * row[q]
                a[p], a[q] = [c * x - s * y for x, y in zip(a[p], a[q])], [s * x + c * y for x, y in zip(a[p], a[q])]
    return [a[i][i] for i in range(n)], v


def tell():
    moving = sorted((tag for tag in masses if tag not in fixed), key=lambda tag: (masses[tag] == 0, tag))
    heavy = sum(masses[tag] > 0 for tag in moving)
    k, c = matrix(moving, 2), matrix(moving, 3)
    for p in range(heavy, len(moving)):
        print("place %d" % moving[p], *("%d %.6f" % (tag, -k[p][i] / k[p][p]) for i, tag in enumerate(moving[:heavy]) if k[p][i]))
    root = [math.sqrt(masses[tag]) for tag in moving[:heavy]]
    k = condense(k, heavy)
    squares, shape = modes([[k[i][j] / root[i] / root[j] for j in range(heavy)] for i in range(heavy)])
    for square, m in sorted((square, m) for m, square in enumerate(squares)):
        damping = sum(shape[i][m] * c[i][j] / root[i] / root[j] * shape[j][m] for i in range(heavy) for j in range(heavy))
        print("mode: T %.5f s, %.3f %%" % (2 * math.pi / math.sqrt(square), 50 * damping / math.sqrt(square)))


def recorder(_kind, _file, path, *_):
    files[os.path.basename(path)] = path


def analyze(*_):
    if STAND_IN == "stuck":
        return -3
    tell()
    expected = sys.modules["__main__"].EXPECTED
    for quantity, path in files.items():
        values = {place: float(STAND_IN) * value for _, of, place, value in expected if of == quantity}
        with open(path, "w") as file:
            file.write("0\n0\n" + " ".join(repr(values.get(i, 0.0)) for i in range(max(values) + 1)) + "\n")
    return 0


def __getattr__(_name):
    return lambda *_arguments: None

#!/usr/bin/env python3
"""The README's pictures from results of thud: pictures.py story|impact THUD OUT.svg

story: two towers at the moment of their strongest impact, and the largest acceleration against the gap.
impact: the same towers moving, before and after it."""
import csv
import io
import subprocess
import sys
import tempfile

TIMES = 12  # displacements and gap are drawn so many times as large
SCALE = 14  # px for a metre
WIDTH = 5.0  # of a tower, m
GREY, BLUE, ORANGE = "#666", "#0072B2", "#C04E00"


def table(text):
    return list(csv.DictReader(io.StringIO(text)))


def told(thud, *words):
    return table(subprocess.run([thud, *words, "--csv", "--quiet"], check=True, capture_output=True, text=True).stdout)


def motion(thud):
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([thud, "run", "towers", "--case", "none", "--quiet", "-o", folder], check=True, capture_output=True)
        rows = [table(open(f"{folder}/{name}.csv").read()) for name in ("histories", "impacts")]
    return rows[0], max(rows[1], key=lambda impact: float(impact["force_n"]))


def shapes(row, left, ground, gap):
    """Both towers at one time: a path each."""
    out = []
    for name, floors, x0 in (("A", 4, left), ("B", 6, left + (WIDTH + TIMES * gap) * SCALE)):
        x = [x0] + [x0 + TIMES * SCALE * float(row[f"{name}.{k}.displacement_m"]) for k in range(1, floors + 1)]
        y = [ground - 3 * SCALE * k for k in range(floors + 1)]
        w = WIDTH * SCALE
        columns = ["M" + "L".join(f"{a + side:.1f} {b}" for a, b in zip(x, y)) for side in (0, w)]
        out.append("".join(columns + [f"M{a:.1f} {b}h{w:.0f}" for a, b in zip(x[1:], y[1:])]))
    return out


def text(x, y, words, size=13, color="#222", anchor="start", more=""):
    return f'<text x="{x:.1f}" y="{y:.1f}" font-size="{size}" fill="{color}" text-anchor="{anchor}"{more}>{words}</text>\n'


def page(width, height, title, body):
    return (f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" viewBox="0 0 {width} {height}" '
            f'font-family="DejaVu Sans, Verdana, sans-serif">\n<title>{title}</title>\n'
            f'<rect width="100%" height="100%" fill="#fff"/>\n{body}</svg>\n')


def ground_line(left, right, ground):
    return f'<path d="M{left} {ground}H{right}" stroke="#444" stroke-width="3"/>\n'


def strike(row, left, ground, gap, floor, more=""):
    x = left + WIDTH * SCALE + TIMES * SCALE * (float(row[f"A.{floor}.displacement_m"]))
    y = ground - 3 * SCALE * floor
    rays = "".join(f"M{x + 8 * a} {y + 8 * b}L{x + 22 * a} {y + 22 * b}" for a, b in
                   ((0, -1), (.7, -.7), (-.7, -.7), (.7, .7), (-.7, .7), (0, 1)))
    return f'<path d="{rays}" stroke="#D00000" stroke-width="3" fill="none"{more}/>\n'


def nearest(rows, time):
    return min(rows, key=lambda row: abs(float(row["time_s"]) - time))


def towers(row, left, ground, gap):
    return "".join(f'<path d="{d}" stroke="{color}" stroke-width="4" fill="none"/>\n'
                   for d, color in zip(shapes(row, left, ground, gap), (BLUE, ORANGE)))


def curves(thud, left, top, width, height):
    runs = told(thud, "sweep", "towers", "--vary", "gap=5cm:25cm:0.25cm", "--cases", "none,bumper")
    most, free = {"none": {}, "bumper": {}}, 0.0
    for run in runs:
        if run["floor"] != "0":
            a, at = float(run["acceleration_mps2"]) / 9.80665, float(run["gap_m"]) * 100
            most[run["case"]][at] = max(a, most[run["case"]].get(at, 0))
            free = max(free, a / float(run["acceleration_free_ratio"]))
    need = 100 * max(float(row["relative_displacement_m"]) for row in told(thud, "gap", "towers"))
    top_g = 5 * (1 + int(max(max(m.values()) for m in most.values()) / 5))

    def at(gap, g):
        return left + width * (gap - 5) / 20, top + height * (1 - g / top_g)
    out = ""
    for g in range(0, top_g + 1, 5):
        out += f'<path d="M{left} {at(5, g)[1]:.1f}h{width}" stroke="#ddd"/>\n' + text(left - 8, at(5, g)[1] + 4, g, anchor="end")
    for gap in range(5, 26, 5):
        out += text(at(gap, 0)[0], top + height + 18, gap, anchor="middle")
    out += text(left + width / 2, top + height + 38, "gap between the towers (cm)", anchor="middle")
    out += text(left, top - 12, "largest floor acceleration (g)")
    x = at(need, 0)[0]
    out += f'<path d="M{x:.1f} {top}v{height}" stroke="#222" stroke-dasharray="2 3"/>\n'
    for i, word in enumerate(("no contact", "from here on")):
        out += text(x + 7, top + 14 + 16 * i, word, 12)
    for k, (color, dash, points, word) in enumerate((
            (GREY, "7 4", [at(5, free), at(25, free)], "no pounding"),
            (BLUE, "none", [at(*p) for p in sorted(most["none"].items())], "pounding, no bumper"),
            (ORANGE, "12 3", [at(*p) for p in sorted(most["bumper"].items())], "pounding, 5 cm bumper"))):
        line = " ".join(f"{a:.1f},{b:.1f}" for a, b in points)
        out += f'<polyline points="{line}" stroke="{color}" stroke-width="2.5" stroke-dasharray="{dash}" fill="none"/>\n'
        y = top + height + 60
        dx = (0, 128, 300)[k]
        out += f'<path d="M{left - 45 + dx} {y}h26" stroke="{color}" stroke-width="3" stroke-dasharray="{dash}"/>\n'
        out += text(left - 14 + dx, y + 4, word, 12)
    return out


def story(thud):
    rows, impact = motion(thud)
    left, ground, gap, floor = 70, 325, 0.10, int(impact["left_floor"])
    row = nearest(rows, float(impact["start_s"]) + float(impact["duration_s"]) / 2)
    body = text(30, 28, "Two towers, 10 cm apart, in an earthquake", 15, more=' font-weight="bold"')
    body += ground_line(30, 315, ground) + towers(row, left, ground, gap) + strike(row, left, ground, gap, floor)
    body += text(30, 352, f'The strongest impact: {float(impact["force_n"]) / 1e6:.0f} MN, floor {floor},', 12)
    body += text(30, 369, f'{1e3 * float(impact["duration_s"]):.0f} ms long (movements and gap drawn {TIMES} times)', 12)
    return page(880, 385, "Two towers at the moment of impact, and their largest acceleration against the gap",
                body + curves(thud, 440, 50, 410, 250))


def moving(thud):
    rows, impact = motion(thud)
    left, ground, gap, floor = 70, 290, 0.10, int(impact["left_floor"])
    hit = float(impact["start_s"])
    frames = [nearest(rows, hit - 1.2 + 0.025 * k) for k in range(97)]
    paths = list(zip(*(shapes(row, left, ground, gap) for row in frames)))
    body = text(20, 24, f'Strongest impact of two towers: {float(impact["force_n"]) / 1e6:.0f} MN (slow motion)', 12)
    body += ground_line(20, 330, ground)
    for values, color in zip(paths, (BLUE, ORANGE)):
        body += (f'<path d="{values[48]}" stroke="{color}" stroke-width="4" fill="none"><animate attributeName="d" '
                 f'dur="9.6s" repeatCount="indefinite" values="{";".join(values)}"/></path>\n')
    flash = strike(nearest(rows, hit), left, ground, gap, floor, ' opacity="0"')
    body += flash.replace("/>\n", '><animate attributeName="opacity" dur="9.6s" repeatCount="indefinite" '
                          'values="0;0;1;0;0" keyTimes="0;0.495;0.5;0.56;1"/></path>\n')
    return page(350, 310, "The strongest impact of two towers, moving", body)


drawn = {"story": story, "impact": moving}[sys.argv[1]](sys.argv[2])
with open(sys.argv[3], "w") as out:
    out.write(drawn)

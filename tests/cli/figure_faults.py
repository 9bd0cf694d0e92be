"""usage: figure_faults.py FOLDER...: what is wrong with the texts of every SVG of thud in these folders: cut, outside the
picture, over each other (so an axis' title through the numbers of its ticks), or smaller than the 7 points that journals
ask for. A line for each fault."""
import os
import re
import sys

# Advance of the characters from space to ~ in DejaVu Sans, hundredths of an em; others are as wide as a digit.
ADVANCE = [int(n) for n in """
32 40 46 84 64 95 78 27 39 39 50 84 32 36 32 34 64 64 64 64 64 64 64 64 64 64 34 34 84 84 84 53 100 68 69 70 77 63 58 77
75 29 29 66 56 86 75 79 60 79 69 63 61 73 68 99 69 61 69 39 34 39 84 50 50 61 63 55 63 62 35 63 63 28 28 58 28 97 63 61
63 63 41 52 39 63 59 82 59 59 52 64 34 64 84""".split()]
TEXT = re.compile(r'translate\(([-\d.]+),([-\d.]+)\)( rotate\([-\d.]+\))?"[^>]*font-size="([\d.]+)"[^>]*'
                  r'text-anchor="(\w+)">\s*<text>(.*?)</text>', re.S)


def boxes(svg):
    """(text, left, top, right, bottom, points) of each; the letters alone, without the room that a font keeps around them."""
    for x, y, turned, size, anchor, text in TEXT.findall(svg):
        text = re.sub(r"<!\[CDATA\[|\]\]>|<[^>]*>", "", text)
        text = text.replace("&lt;", "<").replace("&gt;", ">").replace("&amp;", "&").strip()
        x, y, em = float(x), float(y), float(size)
        width = em * sum(ADVANCE[ord(c) - 32] if " " <= c <= "~" else 64 for c in text) / 100
        from_x = {"start": 0, "middle": -width / 2, "end": -width}[anchor]
        if turned:
            yield text, x - 0.72 * em, y - from_x - width, x, y - from_x, 0.75 * em
        else:
            yield text, x + from_x, y - 0.72 * em, x + from_x + width, y, 0.75 * em


def faults(path):
    with open(path, encoding="utf-8") as file:
        svg = file.read()
    width, height = (float(n) for n in re.search(r'viewBox="0 0 ([\d.]+) ([\d.]+)"', svg).groups())
    every = [box for box in boxes(svg) if box[0]]
    if not every:
        yield "no text"
    for i, (text, left, top, right, bottom, points) in enumerate(every):
        if "\u2026" in text:
            yield f"cut: {text}"
        if left < -1 or top < -1 or right > width + 1 or bottom > height + 1:
            yield f"outside: {text}"
        if points < 6.95:
            yield f"letters of {points:.2f} points: {text}"
        for other, l, t, r, b, _ in every[:i]:
            if min(right, r) - max(left, l) > 1 and min(bottom, b) - max(top, t) > 1:
                yield f"over each other: {other} | {text}"


count = 0
for folder in sys.argv[1:]:
    for name in sorted(os.listdir(folder)):
        if name.endswith(".svg"):
            for fault in faults(os.path.join(folder, name)):
                print(f"{os.path.join(folder, name)}: {fault}")
                count += 1
sys.exit(count > 0)

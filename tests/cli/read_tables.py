"""usage: read_tables.py FOLDER...: whether every table of a folder reads in one line, as datapackage.json says: names,
types, units; and whether the scenes of its JSON are the same as texts and as SI numbers."""
import csv
import json
import os
import re
import sys

UNIT = {"m": 1, "cm": 0.01, "mm": 1e-3, "t": 1e3, "kg": 1, "s": 1, "g": 9.80665, "m/s": 1, "mm/s": 1e-3, "m/s2": 1,
        "%": 0.01, "MN/m": 1e6, "kN/mm": 1e6, "MN": 1e6, "kN": 1e3, "kN m2": 1e3, "MN m2": 1e6, "kg/m3": 1, "t/m3": 1e3}
END = {"m": "_m", "s": "_s", "m/s": "_mps", "m/s2": "_mps2", "N": "_n", "N s": "_ns", "J": "_j", "N m": "_nm"}


def cells(path, comments):
    with open(path, encoding="utf-8", newline="") as file:
        return list(csv.reader(line for line in file if not (comments and line.startswith("#"))))


def tables(folder):
    with open(os.path.join(folder, "datapackage.json"), encoding="utf-8") as file:
        package = json.load(file)
    described = {r["path"]: r for r in package["resources"]}
    assert set(described) == {name for name in os.listdir(folder) if name.endswith(".csv")}, folder
    for path, resource in described.items():
        fields = resource["schema"]["fields"]
        head, *rows = cells(os.path.join(folder, path), "dialect" in resource)
        assert head == [f["name"] for f in fields] and len(set(head)) == len(head), (path, head)
        for field in fields:
            assert field.get("unit") not in END or field["name"].endswith(END[field["unit"]]), field
        for row in rows:
            assert len(row) == len(fields), (path, row)
            for cell, field in zip(row, fields):
                if cell:
                    {"number": float, "integer": int, "string": str}[field["type"]](cell)


def same(text, si, where):
    """A value as a text with its unit, and as a number; how many numbers there are."""
    if isinstance(text, list):
        return sum(same(a, b, where) for a, b in zip(text, si, strict=True))
    if isinstance(text, dict):
        return scene(text, si)
    if isinstance(si, str):
        assert si == text, where
        return 0
    number, unit = re.fullmatch(r"(\S+) ?(.*)", text).groups()
    if unit and unit not in UNIT:
        return 0  # of a bumper: its unit has an exponent
    assert abs(float(number) * UNIT.get(unit, 1) - si) <= 1e-12 * abs(si), (where, text, si)
    return 1


def scene(text, si):
    assert [k for k in text] == [re.sub("_[a-z0-9]+$", "", k) for k in si], (list(text), list(si))
    return sum(same(a, b, k) for (k, a), b in zip(text.items(), si.values()))


for folder in sys.argv[1:]:
    tables(folder)
    for name in ("result.json", "study.json", "scene.json"):
        path = os.path.join(folder, name)
        if os.path.exists(path):
            with open(path, encoding="utf-8") as file:
                answer = json.load(file)
            assert scene(answer["scene"], answer["scene_si"]) > 20 or name == "scene.json", path

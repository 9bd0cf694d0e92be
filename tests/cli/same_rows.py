"""usage: same_rows.py FILE.csv FILE.json LIST[/LIST] [LACKS,...]: whether the rows of the CSV are the objects of the list,
those of an inner list behind what they belong to, in one order of columns. With a last argument in any order: it names
the columns that the list lacks (",": none), and the list may have more than the table."""
import csv
import json
import sys


def cell(value):
    if value is None:
        return ""
    return repr(float(value)) if isinstance(value, (bool, int, float)) else value


def number(text):
    try:
        return "" if text == "inf" else repr(float(text))
    except ValueError:
        return text[1:] if text[:1] == "'" else text


def flat(objects, path):
    for item in objects:
        if isinstance(item, list):  # of a fragility: value, motions, count
            item = {"x": item[0], "motions": item[1], "count": item[2]}
        if isinstance(item.get("record"), dict):
            item = {**item, "record": item["record"]["file"]}
        own = {k: v for k, v in item.items() if not isinstance(v, (list, dict))}
        inner = flat(item[path[0]], path[1:]) if path else [{}]
        yield from ({**own, **row} for row in inner)


path = sys.argv[3].split("/")
with open(sys.argv[2], encoding="utf-8") as file:
    rows = list(flat(json.load(file)[path[0]], path[1:]))
with open(sys.argv[1], encoding="utf-8", newline="") as file:
    table = list(csv.reader(line for line in file if not line.startswith("#")))
if path[0] == "structures":  # what is told of the whole structure is in the JSON alone
    rows = [{n: {**r, "structure": r["name"]}[n] for n in table[0]} for r in rows]
if len(sys.argv) > 4:
    for r in rows:  # the value that a fragility is drawn against
        r.update({n: r["x"] for n in table[0] if "x" in r and n.startswith(r["against"])})
    lacks = [n for n in table[0] if n not in rows[0]]
    assert lacks == [n for n in sys.argv[4].split(",") if n], lacks
    keep = [i for i, n in enumerate(table[0]) if n not in lacks]
    table = [[line[i] for i in keep] for line in table]
    rows = [{n: r[n] for n in table[0]} for r in rows]
names = list(rows[0])
names = names[len(names) - len(table[0]):] if path[0] == "spectra" else names  # the file and the damping are comments
assert table[0] == names, (table[0], names)
assert [[number(c) for c in line] for line in table[1:]] == [[cell(r[n]) for n in names] for r in rows]

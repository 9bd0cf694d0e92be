"""Holds what `thud run`, its remarks and `thud run --cases` say against the JSON beside it, over forty scenes.

A number of a sentence is looked for among the values of the keys that have its unit, to the digits that are shown, never by
the words around it. Impacts add up, and contact is said where there are impacts.
usage: sentences.py THUD
"""
import json
import re
import subprocess
import sys

VARIATIONS = [
    ("towers", "", "--set gap=7.5cm", "--set gap=19.7cm", "--set gap=19.8cm --case none", "--case cavity", "--sign=-",
     "--set record.peak=0.2g", "--set contact.law=hertz-damp --set contact.stiffness=2500kN/mm^1.5 --case none"),
    ("towers-northridge", "", "--set gap=6cm", "--case none --set gap=14.3cm", "--set structures.2.damping=2%"),
    ("towers-san-fernando", "", "--set gap=12cm"),
    ("three-in-a-row", "", "--set interfaces.1.gap=20cm --set interfaces.2.gap=10cm", "--case none", "--sign=-"),
    ("isolated-moat", "", "--set interfaces.1.gap=40cm", "--set structures.1.mass=27t --set structures.1.stiffness=1e6MN/m"),
    ("isolated-moat-backfill", "", "--set interfaces.2.gap=20cm"),
    ("isolated-lead-rubber", "", "--set record.factor=1.5"),
    ("isolated-pendulum", "", "--set record.factor=0.5"),
    ("mixed-row", "", "--sign=-"),
    ("slab-against-columns", "", "--case none", "--set structures.2.slab-depth=50cm"),
    ("towers-linked", "", "--set links.1.stiffness=50MN/m", "--case link"),
    ("towers-on-soil", "", "--set gap=8cm"),
    ("towers-yielding", "", "--set gap=6cm", "--set p-delta=yes"),
    ("frame-beside-wall", ""),
    ("beside-unknown", ""),
    ("rigid-bumper", ""),
    ("rigid-concrete", ""),
]
# How the keys of a unit end, and what their SI values are multiplied by; "%" and "1": of any key.
UNITS = {"cm": ("_m", 100), "mm": ("_m", 1e3), "m": ("_m", 1), "MN": ("_n", 1e-6), "kN": ("_n", 1e-3), "kJ": ("_j", 1e-3), "s": ("_s", 1),
         "ms": ("_s", 1e3), "m/s2": ("_mps2", 1), "m/s": ("_mps", 1), "g": ("_mps2", 1 / 9.80665), "t": ("_kg", 1e-3), "MN/m": ("_npm", 1e-6),
         "Hz": ("_hz", 1), "%": ("", 100), "1": ("", 1), "": None}


def thud(*arguments):
    """Standard output and standard error of the program."""
    done = subprocess.run([sys.argv[1], *arguments], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise RuntimeError(f"{' '.join(arguments)}: {done.returncode} {done.stderr[:200]}")
    return done.stdout, done.stderr


def numbers(value, key=""):
    """All numbers of a JSON value, each with the key that it stands under."""
    if isinstance(value, dict):
        return [x for name, part in value.items() for x in numbers(part, name)]
    if isinstance(value, list):
        return [x for part in value for x in numbers(part, key)]
    return [(key, float(value))] if isinstance(value, (int, float)) and not isinstance(value, bool) else []


def is_among(shown, unit, known):
    """Whether a number is that of a key of its unit, to the decimals that are shown; a gap may be rounded up."""
    if not unit: # its unit stands at another number of the sentence
        return any(is_among(shown, other, known) for other in UNITS if other)
    ending, factor = UNITS[unit]
    last = 10.0 ** -len(shown.partition(".")[2])
    return any(key.endswith(ending) and abs(abs(x) * factor - float(shown)) <= 1.0001 * last * (1 if unit == "cm" else 0.5)
               for key, x in known)


def sentences_of(text, remarks):
    """The head of a run's text, up to its first table, and its remarks, without clauses of codes and names of files."""
    head = text.split("\n\n")[0] + "\n" + remarks
    return re.sub(r"\d+(\.\d+){2,}|[\w-]+\.(csv|yaml)|structures\.\S+|interfaces\.\S+|\([^()]*(usually|buildings yield|EN 1998)[^()]*\)", "",
                  head)


def check(preset, settings):
    """What is wrong with the sentences of one scene."""
    scene = [preset, *settings.split()]
    text, remarks = thud("run", *scene)
    result = json.loads(thud("run", *scene, "--json", "--quiet")[0])
    known = numbers(result)
    contacts = result["contacts"]
    if not preset.startswith("rigid"):
        bare = re.sub("--case (none|cavity|link)", "", settings).split()
        known += numbers(json.loads(thud("gap", preset, *bare, "--json", "--quiet")[0]))
    # sums and shares of two keys: a gap with its bumper, what is left of a gap, drifts over the heights of storeys
    lengths = [x for key, x in known if key.endswith("_m") and 0 < x < 3]
    bumpers = {x for key, x in known if key == "thickness_m"}
    known += [("made_m", x + sign * b) for x in lengths for b in bumpers for sign in (1, -1)]
    masses = {x for key, x in known if key == "mass_kg"}
    known += [("made_kg", x * y / (x + y)) for x in masses for y in masses]
    heights = {x for key, x in known if key == "height_m"}
    known += [("drift_angle", x / h) for key, x in known if key == "drift_m" for h in heights if h > 0]
    shown = re.findall(r"(?<![\w.])(\d+\.\d+)(?![\w.]*\d) ?(m/s2|m/s|MN/m|MN|kN|kJ|cm|mm|ms|m|s|g|t|Hz|%)?(?!\w)", sentences_of(text, remarks))
    wrong = [f"{x} {unit} is no number of the JSON" for x, unit in shown if not is_among(x, unit, known)]
    impacts = {}
    for c in contacts:
        impacts[c["interface"]] = impacts.get(c["interface"], 0) + c["impacts"]
    said = [int(x) for x in re.findall(r"^summary .*?(?:POUNDS at [^:]*: (\d+)|NO CONTACT)", text, re.M) if x]
    if sorted(said) != sorted(n for n in impacts.values() if n > 0):
        wrong.append(f"impacts said {said}, counted {impacts}")
    rows = re.findall(r"^  (\d+) (\S+) +(\d+) +(?:no contact|(\S+))", text, re.M)
    for row, c in zip(rows, contacts):
        if int(row[0]) != c["interface"] or int(row[2]) != c["impacts"]:
            wrong.append(f"row {row} is not {c['interface']}, {c['impacts']}")
        elif re.match(r"[\d.]+$", row[3]) and c["force_n"] is not None and not is_among(row[3], "MN", [("force_n", c["force_n"])]):
            wrong.append(f"row {row}: force {c['force_n']}")
    return wrong


scenes = [(preset, settings) for preset, *varied in VARIATIONS for settings in varied]
print("ok - forty scenes" if len(scenes) >= 40 else f"not ok - {len(scenes)} scenes")
for name, setting in scenes:
    try:
        faults = check(name, setting)
    except RuntimeError as error:
        faults = [str(error)]
    print(f"{'not ' if faults else ''}ok - {name} {setting}: sentences are those of the JSON")
    for fault in faults:
        print(f"# {fault}")

"""Holds the sentences of `thud run`, `thud run --cases`, `thud gap` and `thud report` against the JSON beside them, over forty scenes.

A sentence is held by the keys that its maker declares, never by its words: a remark's `keys` of the JSON, a rule's `column`,
and for the lines of a run and of its cases the keys listed here by the label that begins them. Every number with decimals or
a unit has to be the value of one of these keys, to the digits shown. Impacts add up, and contact is said where there are some.
usage: sentences.py THUD [SCENES]     SCENES: no more than so many, spread over all (`make test` takes eight)
"""
import json
import re
import subprocess
import sys
import tempfile

VARIATIONS = [
    ("towers", "", "--set gap=7.5cm", "--set gap=19.7cm", "--set gap=19.8cm --case none", "--case cavity", "--sign=-",
     "--set bumper.thickness-by-level=[5cm,5cm,5cm,3cm]", "--set gap=22cm --set bumper.thickness-by-level=[8cm,5cm,4cm,3cm]",
     "--set gap-by-level=[10cm,12cm,17cm,20cm]"),
    ("slab-against-columns", "", "--case none", "--set structures.2.slab-depth=50cm"),
    ("towers-northridge", "", "--set gap=6cm", "--case none --set gap=14.3cm", "--set structures.2.damping=2%"),
    ("towers-san-fernando", "", "--set gap=12cm"),
    ("three-in-a-row", "", "--set interfaces.1.gap=20cm --set interfaces.2.gap=10cm", "--case none", "--sign=-"),
    ("isolated-moat", "", "--set interfaces.1.gap=40cm", "--set structures.1.mass=27t --set structures.1.stiffness=1e6MN/m"),
    ("isolated-moat-backfill", "", "--set interfaces.2.gap=20cm"),
    ("isolated-lead-rubber", "", "--set record.factor=1.5"),
    ("isolated-pendulum", "", "--set record.factor=5"),
    ("mixed-row", "", "--sign=-"),
    ("towers-linked", "", "--set links.1.stiffness=50MN/m", "--case link"),
    ("towers-on-soil", "", "--set gap=8cm"),
    ("towers-yielding", "", "--set gap=6cm", "--set p-delta=yes"),
    ("frame-beside-wall", ""),
    ("beside-unknown", ""),
    ("rigid-bumper", ""),
    ("rigid-concrete", ""),
    ("towers", "--set record.peak=0.2g", "--set contact.law=hertz-damp --set contact.stiffness=2500kN/mm^1.5 --case none"),
]
# How the keys of a unit end, and what their SI values are multiplied by; "%", "times" and none: any key.
UNITS = {"cm": ("_m", 100), "mm": ("_m", 1e3), "m": ("_m", 1), "MN": ("_n", 1e-6), "kN": ("_n", 1e-3), "kJ": ("_j", 1e-3), "s": ("_s", 1),
         "ms": ("_s", 1e3), "m/s2": ("_mps2", 1), "g": ("_mps2", 1 / 9.80665), "t": ("_kg", 1e-3), "MN/m": ("_npm", 1e-6), "MN m": ("_nm", 1e-6),
         "kN s": ("_ns", 1e-3), "impacts": ("impacts", 1), "impulses": ("impacts", 1), "%": ("", 100), "": ("", 1)}
NUMBER = re.compile(r"(?<![\w./-])(\d+(?:\.\d+)?)(?![\w.]*\d)(?: ?(m/s2|MN/m|MN m|MN|kN s|kN|kJ|cm|mm|ms|m|s|g|t|%|impacts|impulses)(?![\w/]))?")
# The keys of a line that begins so, for what JSON has no sentence of.
LINES = {"ground motion": "peak_mps2 dt_s scale factor", "interface": "gap_m thickness_m cavity_m clearance_m",
         "summary": "gap_m impacts force_n impulse_ns needs_m needs_with_bumper_m abs_m srss_m",
         "": "needs_m needs_with_bumper_m", "structure": "periods_s base_shear_n base_shear_time_s overturning_nm overturning_time_s"}


def thud(*arguments):
    """Standard output and standard error of the program."""
    done = subprocess.run([sys.argv[1], *arguments], capture_output=True, text=True, check=False)
    if done.returncode not in (0, 4): # 4: a storey collapses
        raise RuntimeError(f"{' '.join(arguments)}: {done.returncode} {done.stderr[:200]}")
    return done.stdout, done.stderr


def of_json(*arguments):
    """What the program writes with --json."""
    return json.loads(thud(*arguments, "--json", "--quiet")[0])


def under(part, key):
    """All numbers of a JSON value under a key, or under that of its values by level."""
    if isinstance(part, dict):
        return [x for name, inner in part.items() for x in (numbers(inner) if name.replace("-by-level", "") == key else under(inner, key))]
    return [x for inner in part for x in under(inner, key)] if isinstance(part, list) else []


def numbers(value):
    """The numbers of a value, or of a list of values."""
    if isinstance(value, list):
        return [x for part in value for x in numbers(part)]
    return [float(value)] if isinstance(value, (int, float)) and not isinstance(value, bool) else []


def parts_at(document, place):
    """What of a run's JSON is of a place, such as interfaces.1.bumper."""
    kind, _, rest = place.partition(".")
    index = int(rest.split(".")[0]) - 1 if rest[:1].isdigit() else -1
    if kind == "interfaces" and index >= 0:
        contacts = [c for c in document["contacts"] if c["interface"] == index + 1]
        return [contacts, {"impacts": sum(c["impacts"] for c in contacts)}, document["scene_si"]["interfaces"][index]]
    if kind == "structures" and index >= 0:
        own = document["structures"][index]
        columns = [c for c in document.get("columns", []) if c["structure"] == own["name"]]
        return [own, columns, document.get("collapse", {}), document["scene_si"]["structures"][index]]
    return [document]


def values(document, place, key):
    """The values of a key (or of a/b, a*b, a||b) at a place, and their unit's ending; those of all places where it has none."""
    for sign, of in (("||", lambda a, b: a * b / (a + b)), ("/", lambda a, b: a / b), ("*", lambda a, b: a * b)):
        if sign in key:
            first, second = (values(document, place if sign != "||" else "", k)[0] for k in key.split(sign))
            ending = key.split(sign)[-1] if sign != "/" else ""
            return [of(a, b) for a in first for b in second if a > 0 and b > 0], ending
    found = under(parts_at(document, place), key)
    return found or under(document, key), key


def is_value(shown, unit, known):
    """Whether a number is a value of a key of its unit, to the digits that are shown; a gap may be rounded up."""
    ending, factor = UNITS[unit]
    last = 10.0 ** -len(shown.partition(".")[2])
    return any((not ending or key.endswith(ending)) and abs(abs(x) * factor - float(shown)) <= 1.0001 * last * (1 if unit == "cm" or key == "gap_m" else 0.5)
               for xs, key in known for x in xs)


def not_of(keys, text, document, place=""):
    """What is wrong with the numbers of a text whose maker declares these keys."""
    known = [values(document, place, key) for key in keys.split()]
    wrong = [f"no key {key}: {text}" for (xs, _), key in zip(known, keys.split()) if not xs and keys != LINES.get(place)]
    shown = [(x, unit or ("cm" if "needs_m" in keys else "")) for x, unit in NUMBER.findall(text) if unit or "." in x]
    return wrong + [f"{x} {unit} is no value of {keys}: {text}" for x, unit in shown if not is_value(x, unit, known)]


def check_remarks(document, said):
    """Remarks by the keys that each declares, and each is said."""
    wrong = []
    for remark in document["remarks"]:
        if remark["keys"]:
            own = not_of(remark["keys"], remark["sentence"], document, remark["place"])
            if own and remark["weight"] == "unusual": # of a value and its neighbour's
                own = not_of(remark["keys"], remark["sentence"], document)
            wrong += own
        elif " is unusual" in remark["sentence"]:
            at = document["scene"]
            for step in remark["place"].split("."):
                at = at if isinstance(at, str) else at[int(step) - 1] if isinstance(at, list) else at.get(step, at)
            if remark["sentence"].split(" is unusual")[0] not in str(at):
                wrong.append(f"{remark['place']} is {at}: {remark['sentence']}")
        if remark["weight"] not in ("motion", "failure") and remark["sentence"] not in said:
            wrong.append(f"not said: {remark['sentence']}")
    return wrong


def needs_of(document, needed, index):
    """What the lines of an interface are made of, by the keys of LINES."""
    scene = document["scene_si"]["interfaces"][index]
    bumper = scene.get("bumper", {})
    gaps, thick = numbers(scene.get("gap-by-level_m", scene["gap_m"])), numbers(bumper.get("thickness-by-level_m", bumper.get("thickness_m", 0)))
    cavity = bumper.get("cavity_m", 0)
    contacts = [c for c in document["contacts"] if c["interface"] == index + 1]
    levels = [v for v in needed["records"][0]["levels"] if v["interface"] == index + 1] if needed else []
    most = {to: [max(v[of] for v in levels)] if levels else []
            for to, of in (("needs_m", "relative_displacement_m"), ("abs_m", "abs_m"), ("srss_m", "srss_m"))}
    with_bumper = [v["relative_displacement_m"] + t - cavity for v, t in zip(levels, thick * (len(levels) if len(thick) == 1 else 1))]
    return {"gap_m": gaps, "clearance_m": [g - t + cavity for g in gaps for t in thick], **most, "needs_with_bumper_m": [max(with_bumper, default=0)],
            "thickness_m": under(bumper, "thickness_m"), "cavity_m": under(bumper, "cavity_m"),
            "impacts": [sum(c["impacts"] for c in contacts)], "impulse_ns": [sum(under(contacts, "impulse_ns"))],
            "force_n": [max(under(contacts, "force_n"), default=0)]}


def check_lines(document, needed, text):
    """The lines before the first table, by the label that begins each."""
    wrong, interface, pounding = [], 0, []
    names = [s["name"] for s in document["structures"]]
    for line in text.split("\n\nenergy")[0].split("\n")[1:]:
        label = re.match(r"(ground motion|interface|summary| {15}|)", line).group(1).strip()
        if label in ("interface", "summary") and re.match(label + r" +\d+ ", line):
            interface = int(re.match(label + r" +(\d+) ", line).group(1)) - 1
            line = re.sub(label + r" +\d+ ", label + " ", line)
        name = next((n for n in names if line.startswith(n + ": T1")), None)
        if label == "ground motion" and document.get("record"):
            wrong += not_of(LINES[label], re.sub(r"\S+\.csv", "", line), {**document, "scene": {}}, "")
        elif label in ("interface", "summary") or line.startswith(" " * 15 + "needs"):
            if not any(s["kind"] == "rigid" for s in document["scene_si"]["structures"]):
                of = needs_of(document, needed, interface)
                wrong += [w for w in not_of(LINES[label], line, of) if not w.startswith("no key")]
        elif name:
            own = re.sub(r"\bT\d", "", line[len(name):]).split("; overturning")[0]
            wrong += [w for w in not_of(LINES["structure"], own, document["structures"][names.index(name)]) if not w.startswith("no key")]
        if label == "summary":
            pounding.append("POUNDS" in line)
    counted = [needs_of(document, needed, i)["impacts"][0] > 0 for i in range(len(pounding))]
    return wrong + ([f"contact said {pounding}, counted {counted}"] if pounding != counted else [])


def check_rows(document, text):
    """The table of contacts row by row: interface, impacts and force."""
    rows = re.findall(r"^  (\d+) (\S+) +(\d+) +(?:no contact|(\S+))", text, re.M)
    return [f"row {row} is not {c['interface']}, {c['impacts']}, {c['force_n']}" for row, c in zip(rows, document["contacts"])
            if int(row[0]) != c["interface"] or int(row[2]) != c["impacts"] or
            (re.match(r"[\d.]+$", row[3]) and c["force_n"] is not None and not is_value(row[3], "MN", [([c["force_n"]], "force_n")]))]


def peaks(case, key):
    """A peak of every floor by the name of its structure and its number."""
    return {(s["name"], f["floor"] - (s["kind"] == "isolated" and key == "drift_m")): f[key] for s in case["structures"] for f in s["floors"]}


def check_cases(scene, names):
    """The sentences under the tables of several cases: contacts in the order of the cases, then what each lowers and raises."""
    cases = of_json("run", *scene, "--cases", names)["cases"][1:]
    said = re.sub(r"\n  +(?!Largest link force)", " ", thud("run", *scene, "--cases", names)[0].split("\n\n")[-1])  # unwrapped
    text = [line for line in said.split("\n") if line]
    wrong, bare = [], next(c for c in cases if c["case"] == "none")
    for case in cases:
        line, of = text.pop(0), {key: [] for key in ("impacts", "force_n", "force_time_s", "change")}
        hardest = max(case["contacts"], key=lambda c: c["force_n"] or 0)
        before = max(under(bare["contacts"], "force_n"), default=0)
        of["impacts"] = [sum(c["impacts"] for c in case["contacts"])]
        of["force_n"], of["force_time_s"] = [hardest["force_n"]], [hardest["force_time_s"]]
        of["change"] = [abs((hardest["force_n"] or 0) / before - 1)] if before else []
        wrong += [w for w in not_of("impacts force_n force_time_s change", line, of) if not w.startswith("no key")]
        if str(of["impacts"][0]) not in re.findall(r"\d+", line) and of["impacts"][0] > 0:
            wrong.append(f"{of['impacts'][0]} impacts: {line}")
        while text and text[0].startswith("  "):
            wrong += not_of("force_n force_time_s", text.pop(0), {"force_n": under(case.get("links", []), "force_n"),
                                                                    "force_time_s": under(case.get("links", []), "force_time_s")})
    for case in cases:
        if case is bare or not any(c["impacts"] for c in case["contacts"] + bare["contacts"]):
            continue
        for key, sign in (("acceleration_mps2", -1), ("acceleration_mps2", 1), ("drift_m", -1), ("drift_m", 1)):
            line, own, none = text.pop(0), peaks(case, key), peaks(bare, key)
            walls = [s["name"] for s in case["structures"] if s["kind"] == "wall" and key == "drift_m"]
            changed = {at: x / none[at] - 1 for at, x in own.items()
                       if none[at] and sign * (x / none[at] - 1) > 0.01 and at[1] > 0 and at[0] not in walls}
            said = re.findall(r"(?: of (?:floors|storeys)|,) (.+?) (\d+) \(([+-][\d.]+) %\)", line)
            told = {(name, int(floor)): float(x) for name, floor, x in said}
            if set(told) != set(changed) or any(abs(told[at] - 100 * changed[at]) > 0.51 for at in told):
                wrong.append(f"{key} of {case['case']}: {changed} but: {line}")
    return wrong


def check_gap(scene, needed):
    """The rules of the required gap: values by the key that each names, and formulas with numbers in them evaluate to it."""
    wrong, text = [], thud("gap", *scene)[0]
    shown = re.findall(r"^\S.{53} +([\d.]+) +(\d+) of (\d+)(?: +([\d.]+))?$", text.split("by rule")[1], re.M) if "by rule" in text else []
    rules = [r for r in needed["rules"] if r["interface"] == 1 and r["gap_m"] is not None]
    for rule in rules:
        levels = [v for v in needed["records"][0]["levels"] if v["interface"] == rule["interface"]]
        if len(needed["records"]) == 1 and abs(max(v[rule["column"]] for v in levels) - rule["gap_m"]) > 1e-12:
            wrong.append(f"{rule['rule']}: {rule['gap_m']} is not the largest {rule['column']}")
        formula = rule["numbers"].replace("^", "**").replace(" x ", "*").replace(" cm", "")
        if formula and re.fullmatch(r"[\d.+*/(), -]*(?:(?:sqrt|max)\([\d.+*/(), -]*)*[\d.+*/(), -]*", formula):
            made = eval(formula, {"sqrt": lambda x: x ** 0.5, "max": max}) # pylint: disable=eval-used
            if abs(made - 100 * rule["gap_m"]) > 0.003 + 5e-4 * made: # its numbers have three digits
                wrong.append(f"{rule['rule']}: {rule['numbers']} is {made:.4f} cm, not {100 * rule['gap_m']:.4f}")
    for row, rule in zip(shown, rules):
        if not is_value(row[0], "mm", [([rule["gap_m"]], "gap_m")]) or [int(row[1]), int(row[2])] != [rule["pounding"], rule["motions"]]:
            wrong.append(f"{row} is not {rule['rule']}, {rule['gap_m']}, {rule['pounding']} of {rule['motions']}")
    return wrong + ([] if len(shown) >= len(rules) > 0 else [f"{len(shown)} rows of {len(rules)} rules"])


def check_report(scene, names, needed):
    """The verdicts of a report on one motion, and its tables of floors and storeys cell by cell."""
    with tempfile.TemporaryDirectory() as folder:
        thud("report", *scene, "-o", folder, "--samples", "0", "--no-simplify", "--no-pdf", "--quiet")
        with open(folder + "/report.md", encoding="utf-8") as file:
            text = file.read()
    if "Pounding over the suite" in text: # the motion that is shown in detail need not be the preset's
        return []
    cases, wrong, gaps, cells = of_json("run", *scene, "--cases", names)["cases"], [], 0, 0
    for label, line in re.findall(r"^\| ((?:pounding|gap between|largest) [^|]*)(\|.*)", text.split("## Verdicts")[1].split("\n## ")[0], re.M):
        case = cases[1 if "without" in label else -1]
        of = {key: under(case, key) for key in ("acceleration_mps2", "drift_m", "ductility", "force_n", "force_time_s")}
        if label.startswith("gap"):
            of, gaps = needs_of(case, needed, gaps), gaps + 1
        of["impacts"] = [sum(c["impacts"] for c in case["contacts"])]
        wrong += [w for w in not_of(" ".join(of), re.sub(r", \S+ % of the height", "", line), of) if not w.startswith("no key")]
    for key, name, unit, rows in re.findall(r"Largest (acceleration|drift) of the (?:floors|storeys) of (.*?)(?: and of its isolators)?, (g|mm) \(a: .*\n\n.*\n.*\n((?:\|.*\n)+)", text):
        key = {"acceleration": "acceleration_mps2", "drift": "drift_m"}[key]
        for label, *shown in re.findall(r"^\| (\d+|isolators)[^|]* \|" + r" ([^|]*) \|" * len(cases), rows, re.M):
            for case, cell in zip(cases, shown):
                value = peaks(case, key)[name, int(label) if label != "isolators" else 0]
                cells += 1
                if value is not None and not is_value(cell, unit, [([value], key)]):
                    wrong.append(f"{key} of {name} {label}, {case['case']}: {value} but {cell} {unit}")
    return wrong + ([] if gaps and cells else [f"{gaps} verdicts on gaps, {cells} cells"])


def check(preset, settings):
    """What is wrong with the sentences of one scene."""
    scene, bodies = [preset, *settings.split()], preset.startswith("rigid")
    text, said = thud("run", *scene)
    document = of_json("run", *scene)
    bare = [preset, *re.sub("--case (none|cavity|link)", "", settings).split()]
    needed = None if bodies else of_json("gap", *bare)
    wrong = check_remarks(document, said + text) + check_lines(document, needed, text) + check_rows(document, text)
    if not bodies and "--case" not in settings:
        names = ["none"] + ["bumper"] * any("bumper" in i for i in document["scene_si"]["interfaces"]) + ["link"] * ("links" in document["scene_si"])
        wrong += check_cases(scene, ",".join(names)) + check_gap(bare, needed)
        wrong += check_report(scene, ",".join(names), needed) if len(names) < 3 else [] # with three, a report has a fourth case
    return wrong


scenes = [(preset, settings) for preset, *varied in VARIATIONS for settings in varied]
print("ok - forty scenes" if len(scenes) >= 40 else f"not ok - {len(scenes)} scenes")
many = int(sys.argv[2]) if len(sys.argv) > 2 else len(scenes)
for name, setting in scenes[::-(-len(scenes) // many)]:
    try:
        faults = check(name, setting)
    except RuntimeError as error:
        faults = [str(error)]
    print(f"{'not ' if faults else ''}ok - {name} {setting}: sentences are those of the JSON")
    for fault in faults:
        print(f"# {fault}")

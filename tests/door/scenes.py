"""Random scenes and a sweep from Python against the program, byte by byte; what thud.py promises of its arrays. TAP."""
import gc
import locale
import os
import random
import subprocess

import thud

locale.setlocale(locale.LC_ALL, "")
PROGRAM = os.environ["THUD"]


def ok(what, holds):
    print(("ok - " if holds else "not ok - ") + what)


def program(*words):
    return subprocess.run([PROGRAM, *words], capture_output=True, check=False).stdout.decode()


def scene(draw):
    """Preset, case and values of a random scene."""
    which = draw.choice(["none", "bumper", "cavity"])
    values = {"gap": f"{draw.uniform(6, 20):.3f} cm", "structures.1.stiffness": f"{draw.uniform(300, 900):.1f} MN/m",
              "structures.2.damping": f"{draw.uniform(2, 8):.2f} %", "record.peak": f"{draw.uniform(0.2, 1.2):.3f} g",
              "record.sign": draw.choice("+-")}
    return draw.choice(["towers", "towers-northridge"]), which, values


draw, same, count = random.Random(1), 0, int(os.environ["SCENES"])
for _ in range(count):
    preset, which, values = scene(draw)
    words = [word for key, value in values.items() for word in ("--set", f"{key}={value}")]
    same += thud.run(preset, which=which, set=values).json == program("run", preset, "--case", which, "--json", "--quiet", *words)
ok(f"{same} of {count} scenes give the bytes of the program", same == count)

results = thud.Scene("towers").sweep({"gap": "6cm:12cm:2cm"}, which="none,bumper", threads=2)
rows = program("sweep", "towers", "--vary", "gap=6cm:12cm:2cm", "--cases", "none,bumper", "--csv", "--quiet")
ok("a sweep gives the rows of the program", results.csv("sweep") == rows)
table = results.sweep
ok("its columns are as long as each other", len({len(column) for column in table.values()}) == 1 and len(table["gap_m"]) == 96)

floors = thud.run("towers", gap="12 cm").floors["A"]
acceleration = floors.acceleration
gc.collect()  # the results are held by the arrays alone
again = thud.run("towers", gap=0.12).floors
ok("a number in SI is the quantity", list(acceleration) == list(again.acceleration)[:4])
ok("a structure's rows are its own", list(floors["floor"]) == [1, 2, 3, 4] and set(floors["structure"]) == {"A"})
view = memoryview(acceleration)
ok("an array is a buffer of doubles", view.format == "d" and view.contiguous and view.nbytes == 32)

try:
    thud.run("towers", gap="12")
    ok("an error is raised", False)
except thud.Error as error:
    ok("an error is raised", error.status == 3 and error.key == "gap" and "no unit" in error.what)
seen = []
try:
    thud.run("towers", progress=lambda part: seen.append(part) or part > 0.1)
    ok("a function stops a run", False)
except thud.Error as error:
    ok("a function stops a run", error.status == 8 and 0.1 < seen[-1] < 1)

bodies = thud.Scene("rigid-concrete")
bodies.law("spring", lambda mass, restitution: {"k_npm": 2.5e9}, lambda mass, d: 1.25e9 * d * d)
contact = bodies.run().contacts
ok("a law of one's own loses nothing", abs(contact["separation_mps"][0] / contact["approach_mps"][0] - 1) < 1e-12)

again, ends = bodies.copy(), []
again["structures.1.velocity"] = 1
ok("a copy has the law and its own values", again.run().contacts["approach_mps"][0] == 1 and bodies.run().contacts["approach_mps"][0] == 0.5)
try:
    bodies.run(step=lambda moment: ends.append(moment.force_n[0]) or len(ends) == 3)
    ok("a step ends the run", False)
except thud.Error as error:
    ok("a step ends the run", error.status == 8 and len(ends) == 3)


def raised(what, **how):
    """What a function raises comes out of the run that calls it."""
    try:
        bodies.run(**how)
        ok(what, False)
    except ZeroDivisionError:
        ok(what, True)


raised("what a step raises is raised", step=lambda moment: 1 / 0)
raised("what a function of progress raises", progress=lambda part: 1 / 0)
bodies.law("broken", lambda mass, restitution: {"k_npm": 1 / 0}, lambda mass, d: 0.0)
raised("and what a law raises")
yielding = {f"structures.{i}.hardening": "0 %" for i in (1, 2)}
try:
    thud.run("towers-yielding", which="none", set={**yielding, "p-delta": "yes"})
    ok("a collapse is raised", False)
except thud.Error as error:
    ok("a collapse has the results up to it", error.status == 9 and abs(error.results.floors["B"].drift[0] - 0.3) < 1e-12)


def turn(_mass, restitution, d_m, memory):
    """What lies beyond 1 mm is left."""
    if restitution and d_m > memory[0] + 1e-3:
        memory[0] = d_m - 1e-3


bodies.law("plastic", lambda mass, r, left: {"k_npm": 2.5e9, "f0_n": -2.5e9 * left[0]}, lambda mass, d, left: 1.25e9 * min(max(d - left[0], 0), 1e-3) ** 2,
           reversal=turn, ultimate=lambda mass, r, left: float("inf") if r else left[0] + 1e-3, past=lambda mass, r, left: {"f0_n": 2.5e6})
contact = bodies.run().contacts  # all but 1.25 kJ of the 20 kJ is lost
ok("a law of two branches leaves an indentation", abs((contact["separation_mps"][0] / 0.5) ** 2 - 1250 / 20000) < 1e-9)
kinds = thud.Scene("towers").sweep({"contact.law": "kelvin-voigt,kelvin-voigt-no-tension"}, which="none").sweep
ok("a varied word is a text", set(kinds["contact.law"]) == {"kelvin-voigt", "kelvin-voigt-no-tension"})

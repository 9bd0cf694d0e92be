"""The towers by OpenSeesPy: shear buildings of elastic springs, modal damping, Newmark's average acceleration.

The contact is ViscoelasticGap: F = k d + c v while d > 0, pulling at the end, which is the classical Kelvin-Voigt law
(`kelvin-voigt`), so that is the scene to give.  Of the others, ElasticPPGap has no dashpot; Viscous beside ENT would damp
before the touch and after the release; ImpactMaterial is a bilinear loop with an energy of its own.  None is cut at zero
force.  The time of a touch is the end of a step: events are not located, as anywhere in OpenSees.

usage: opensees_peer.py SCENE.json [LEAST_STEP]"""
import os
import sys
import tempfile

import numpy as np
import openseespy.opensees as ops

from peer import clock, row, scene_from_arguments


def node(floor):
    return 100 + floor


def build(scene):
    """Returns the nodes of the floors."""
    ops.wipe()
    ops.model("basic", "-ndm", 1, "-ndf", 1)
    for i in range(scene.floors):
        ops.node(node(i), 0.0)
        ops.mass(node(i), float(scene.mass[i]))
    tag = 1
    for number, building in enumerate(scene.data["structures"]):
        ground = number + 1
        ops.node(ground, 0.0)
        ops.fix(ground, 1)
        below = ground
        for i, stiffness in enumerate(building["stiffness_npm"]):
            above = node(building["first"] + i)
            ops.uniaxialMaterial("Elastic", tag, stiffness)
            ops.element("zeroLength", tag, below, above, "-mat", tag, "-dir", 1)
            below = above
            tag += 1
    ops.eigen("-fullGenLapack", scene.floors)  # before there are contacts
    ops.modalDamping(scene.data["structures"][0]["damping"])
    for contact in scene.contacts:
        ops.uniaxialMaterial("ViscoelasticGap", tag, contact["k_npm"], contact["c_nspm"], -contact["clearance_m"])
        ops.element("zeroLength", tag, node(contact["left"]), node(contact["right"]), "-mat", tag, "-dir", 1)
        tag += 1
    ops.timeSeries("Path", 1, "-dt", scene.dt, "-values", *scene.ground, "-factor", 1.0)
    ops.pattern("UniformExcitation", 1, 1, "-accel", 1)
    return [node(i) for i in range(scene.floors)]


def all_in(scene, step):
    """Steps of one size to the end; False where one does not converge."""
    return ops.analyze(int(round(scene.end / step)), step) == 0


def near(scene, step, ratio):
    """Steps `ratio` times as long wherever nothing can touch within one: as an expert would drive it."""
    contacts = [(node(c["left"]), node(c["right"]), c["clearance_m"]) for c in scene.contacts]
    long, t = ratio * step, 0.0
    reach = 0.5 * long * long * 30.0  # m, under 30 m/s2 of relative acceleration
    while t < scene.end - 0.5 * long:
        least = min(
            clearance
            - max(0.0, ops.nodeDisp(left, 1) - ops.nodeDisp(right, 1))
            - max(0.0, ops.nodeVel(left, 1) - ops.nodeVel(right, 1)) * long
            for left, right, clearance in contacts
        )
        if (ops.analyze(1, long) if least > reach else ops.analyze(ratio, step)) != 0:
            return False
        t += long
    return True


def run(scene, advance):
    """Peaks of the floors' total accelerations; None where it does not converge."""
    nodes = build(scene)
    folder = tempfile.mkdtemp()
    path = os.path.join(folder, "peaks")
    ops.recorder("EnvelopeNode", "-file", path, "-timeSeries", 1, "-node", *nodes, "-dof", 1, "accel")
    ops.constraints("Plain")
    ops.numberer("Plain")
    ops.system("FullGeneral")
    ops.test("NormUnbalance", 1e-3, 50)  # N, of forces of 1e7 N
    ops.algorithm("Newton")
    ops.integrator("Newmark", 0.5, 0.25)
    ops.analysis("Transient")
    whole = advance()
    ops.wipe()  # writes the envelope
    peaks = np.loadtxt(path)[2] if whole else None
    os.remove(path)
    os.rmdir(folder)
    return peaks


def measure(scene, name, step, advance):
    start = clock()
    peaks = run(scene, advance)
    if peaks is not None:
        row(name, step, clock() - start, scene.error(peaks))
    else:
        print(f"{name}: no convergence at a step of {step:g} s", file=sys.stderr)


def main():
    scene = scene_from_arguments()
    least = float(sys.argv[2]) if len(sys.argv) > 2 else 1e-4
    for step in (1e-2, 5e-3, 2e-3, 1e-3, 5e-4, 2e-4, 1e-4, 5e-5, 2e-5):
        if step < 0.999 * least:
            break
        measure(scene, "openseespy", step, lambda: all_in(scene, step))
    for step, ratio in ((5e-4, 4), (2e-4, 5), (1e-4, 10), (5e-5, 20), (5e-5, 10), (2e-5, 25)):
        measure(scene, "openseespy-near", step, lambda: near(scene, step, ratio))


if __name__ == "__main__":
    main()

"""What the Python peers share: the scene that `peer-export` wrote, the error of an answer, and rows of the table."""
import json
import sys
import time

import numpy as np


class Scene:
    """Matrices (floors x floors), contacts as rows of `reach` (contacts x floors), ground motion linear in time."""

    def __init__(self, path):
        with open(path, encoding="utf-8") as file:
            data = json.load(file)
        self.data = data
        self.mass = np.array(data["mass_kg"])
        self.stiffness = np.array(data["stiffness_npm"])
        self.damping = np.array(data["damping_nspm"])
        self.ground = np.array(data["ground_mps2"])
        self.dt = data["dt_s"]
        self.end = data["end_s"]
        self.reference = np.array(data["acceleration_mps2"])
        self.contacts = data["contacts"]
        self.floors = len(self.mass)
        self.reach = np.zeros((len(self.contacts), self.floors))
        for row, contact in zip(self.reach, self.contacts):
            if contact["left"] >= 0:
                row[contact["left"]] = 1
            if contact["right"] >= 0:
                row[contact["right"]] = -1
        self.clearance = np.array([c["clearance_m"] for c in self.contacts])
        self.k = np.array([c["k_npm"] for c in self.contacts])
        self.c = np.array([c["c_nspm"] for c in self.contacts])

    def error(self, peaks):
        """Largest relative error of the floors' peak accelerations."""
        return float(np.max(np.abs(np.asarray(peaks) / self.reference - 1)))


def row(name, setting, seconds, error):
    print(f"{name},{setting:.0e},{seconds:.6g},{error:.3e}", flush=True)


def clock():
    """Processor time: what else the machine does stays out."""
    return time.process_time()


def scene_from_arguments():
    if len(sys.argv) < 2:
        sys.exit(f"usage: {sys.argv[0]} SCENE.json")
    return Scene(sys.argv[1])

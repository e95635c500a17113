#!/usr/bin/python3
"""Discharges of a Samsung 30Q cell as a platform experiment: battery.py OUT [--data DIR]

DIR is battery_samsung_30q of the shared data (its SOURCE.txt says what was measured). Declared is the source's battery:
the data sheet's 3.6 V until 3.0 Ah are spent, and a thermal resistance of 5 C/W to the room for the power that is
drawn. C/10, 1C and 3C are fitted, 2C and 4C are held out. Noise is the instruments': 5 mV, 0.2 C. Readings are thinned
to about 150 a discharge.
"""

import json
import sys

sys.dont_write_bytecode = True
import numpy as np

from recordings import asked_for

FITTED, HELD_OUT = ["C10", "1C", "3C"], ["2C", "4C"]


def recorded(file, samples=150):
    rows = [line.split(",") for line in file.read_text(encoding="utf-8-sig").splitlines() if line]
    table = np.array([[float(x) for x in row[:7]] for row in rows])
    table = table[table[:, 1] < -0.05]  # while it discharges
    return table[np.unique(np.linspace(0, len(table) - 1, samples).astype(int))]


def main():
    asked = asked_for(__doc__, "battery_samsung_30q")
    ambient = {}
    for name in FITTED + HELD_OUT:
        table = recorded(asked.data / "S001" / f"Q30_S001_{name}.csv")
        ambient[name] = round(float(table[:, 6].mean()), 2)
        rows = "\n".join(f"{r[0]:.2f},{-r[1]:.5f},{r[2]:.5f},{-r[3]:.5f},{r[4]:.4f}" for r in table)
        (asked.out / f"{name}.csv").write_text("time_s,current_A,voltage_V,power_W,temperature_C\n" + rows + "\n")
    columns = {key: key for key in ("time_s", "current_A", "voltage_V", "power_W", "temperature_C")}
    for file, names in (("experiment.json", FITTED), ("heldout.json", HELD_OUT)):
        (asked.out / file).write_text(json.dumps({
            "format": "glisson-experiment/1", "kind": "platform", "title": "Samsung 30Q, discharged at several rates",
            "declared": {"law": "constant", "nominal_voltage_V": 3.6, "capacity_Ah": 3.0, "idle_W": 0,
                         "thermal_resistance_C_per_W": 5.0},
            "noise": {"voltage_V": 0.005, "temperature_C": 0.2},
            "trials": [{"id": n, "file": f"{n}.csv", "columns": columns, "ambient_C": ambient[n]} for n in names]},
            indent=1) + "\n")


if __name__ == "__main__":
    main()

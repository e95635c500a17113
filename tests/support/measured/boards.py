#!/usr/bin/python3
"""Power of boards at work as platform experiments: boards.py OUT [--data DIR]

Makes OUT/xavier and OUT/odroid from mlperf_edge_power and OUT/tx2 from jetson_tx2_rail_power of the shared data (their
SOURCE.txt say what was measured). The load is 1 while the board works and 0 while it rests. Declared is a board that
draws nothing at rest and, at work, what the fitted runs took above their own rest on average; noise is the scatter of
power within a run. Xavier: mode 0 with two libraries and mode 3 with one fitted, mode 3 with the other held out; odroid:
two libraries fitted, the third held out; TX2: three videos in 1080p fitted, two held out.
"""

import datetime
import json
import re
import sys

sys.dont_write_bytecode = True
import numpy as np

from recordings import asked_for

XAVIER = "v1.1/Krai/xavier-power.{}"
ODROID = "v2.0/Krai/odroid-{}"


def moment(text):
    return datetime.datetime.strptime(text, "%m-%d-%Y %H:%M:%S.%f").timestamp()


def recorded(folder, every=5):
    """Seconds, watts, whether it works, over the run and what was recorded around it."""
    folder = folder / "resnet50" / "singlestream"
    rows = [line.split(",") for line in (folder / "spl.txt").read_text().splitlines() if line.startswith("Time")]
    time, watts = np.array([(moment(r[1]), float(r[3])) for r in rows]).T
    detail = (folder / "mlperf_log_detail.txt").read_text()
    begin, end = (moment(re.search(rf'"power_{k}", "value": "([^"]+)"', detail)[1]) for k in ("begin", "end"))
    # The clocks of analyser and board differ by whole hours in some logs; where the run is not inside, it is the
    # stretch of high power that is as long.
    if not (time[0] - 5 < begin and end < time[-1] + 5):
        length = end - begin
        threshold = (watts.min() + np.median(watts)) / 2
        busy = np.flatnonzero(watts > threshold)
        begin = time[busy[0]]
        end = min(begin + length, time[busy[-1]])
    good = watts > 0
    inside = (time > begin + 3) & (time < end - 3)
    edge = ((np.abs(time - begin) < 4) | (np.abs(time - end) < 4))
    keep = good & ~edge
    time, watts, load = time[keep], watts[keep], np.where(inside[keep], 1.0, 0.0)
    if keep.sum() > 400:
        busy, idle = np.flatnonzero(load > 0)[::every], np.flatnonzero(load == 0)
        kept = np.sort(np.concatenate([busy, idle]))
        time, watts, load = time[kept], watts[kept], load[kept]
    return time - time[0], watts, load


def playing(folder, title):
    """TX2: one reading after another, their sum over cpu, gpu, ddr, soc and wifi."""
    rails = [np.loadtxt(folder / f"{title}_{rail}.txt") / 1000 for rail in ("cpu", "gpu", "ddr", "soc", "wifi")]
    shortest = min(len(np.atleast_1d(r)) for r in rails)
    return sum(np.atleast_1d(r)[:shortest] for r in rails)


def write(out, title, trials, fitted):
    """`trials` by name: seconds, watts, load."""
    declared_W_per_load = float(np.mean([above_rest(trials[name]) for name in fitted]))
    out.mkdir(parents=True, exist_ok=True)
    busy = [np.std(w[x > 0]) for n in fitted for _, w, x in [trials[n]] if (x > 0).sum() > 5]
    noise = float(np.sqrt(np.mean(np.square(busy))))
    print(f"{title}: {declared_W_per_load:.3f} W at work, power scatters by {noise:.3f} W within a run")
    for name, (time, watts, load) in trials.items():
        rows = "\n".join(f"{t:.2f},{w:.5f},{x:.5f}" for t, w, x in zip(time, watts, load))
        (out / f"{name}.csv").write_text("time_s,power_W,load\n" + rows + "\n")
    columns = {key: key for key in ("time_s", "power_W", "load")}
    for file, names in (("experiment.json", fitted), ("heldout.json", [n for n in trials if n not in fitted])):
        (out / file).write_text(json.dumps({
            "format": "glisson-experiment/1", "kind": "platform", "title": title,
            "declared": {"law": "constant", "idle_W": 0, "full_load_W": round(declared_W_per_load, 4)},
            "noise": {"power_W": round(noise, 4)},
            "trials": [{"id": n, "file": f"{n}.csv", "columns": columns} for n in names]}, indent=1) + "\n")


def above_rest(trial):
    _, watts, load = trial
    return float(watts[load > 0].mean() - watts[load == 0].mean())


def main():
    asked = asked_for(__doc__, ".")
    mlperf, tx2 = asked.data / "mlperf_edge_power", asked.data / "jetson_tx2_rail_power"
    if mlperf.is_dir():
        runs = {f"mode{m}-{lib.split('-')[0]}": recorded(mlperf / XAVIER.format(f"{m}-fan.cool-{lib}"))
                for m in (0, 3) for lib in ("armnn-v21.05-neon", "tflite-v2.5.0-ruy")}
        write(asked.out / "xavier", "Jetson AGX Xavier, wall power", runs, ["mode0-armnn", "mode0-tflite", "mode3-tflite"])
        runs = {name: recorded(mlperf / ODROID.format(name))
                for name in ("armnn-v21.11-neon", "armnn-v21.11-opencl", "tflite-v2.7.1-ruy")}
        write(asked.out / "odroid", "Odroid N2+, wall power", runs, ["armnn-v21.11-neon", "tflite-v2.7.1-ruy"])
    if tx2.is_dir():
        idle = playing(tx2 / "idle", "idle")
        trials = {}
        for i, title in enumerate(("roller", "rhino", "nyc", "elephant", "paris")):
            watts = playing(tx2 / "1080p", title)
            rest = idle[i * len(idle) // 5:(i + 1) * len(idle) // 5]
            both = np.concatenate([rest, watts])
            load = np.concatenate([np.zeros(len(rest)), np.ones(len(watts))])
            trials[title] = (np.arange(len(both), dtype=float), both, load)
        write(asked.out / "tx2", "Jetson TX2, power of its rails", trials, ["roller", "rhino", "nyc"])


if __name__ == "__main__":
    main()

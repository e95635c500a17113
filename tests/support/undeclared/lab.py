#!/usr/bin/python3
"""A laboratory that makes the trials which `explain` asks for, on specimens whose undeclared effect is known, and counts them.

    lab.py OUT --cli build/release/bin/glisson-cli [--sorts material,platform,palpation] [--kinds a,b] [--sizes 4]
           [--seeds 1,2] [--rules information,separation,chance] [--at-most 6]

A specimen begins with one trial alone (a slow ramp, steps of load, one press). Then one is made after the other, until
the true explanation has 90 % of the probability or more. The next one is, by the rule of

    information   the first that `explain` asks for
    separation    the one that parts most rivals from the likeliest by 4 noises, of these the clearest: the rule that
                  `explain` had before, with its four variations of a palpation
    chance        any that is possible

Where nothing is possible any more the case has failed. Rules see the same noise at the same step. What was done is kept in
OUT with the SHA-256 of the program: asked again, the rest is done.
"""

import argparse
import dataclasses
import json
import os
import pathlib
import sys

sys.dont_write_bytecode = True
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
import numpy as np

import calculix
import make_material
import make_palpation
import make_platform
import material
import palpation
from judge import cli, sha256

SURE = 0.9
CLEAR_NOISES = 4
BEFORE = {"palpation": 4}  # of possible trials the first, where more came with information
ONE = dict.fromkeys(("material", "palpation"), ("stiffness-scale", "force-bias"))  # no trial tells a gain from a stiffer specimen
SPECIMEN, MARKERS = "tiny", 12


def main():
    ask = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    ask.add_argument("out", type=pathlib.Path)
    ask.add_argument("--cli", type=pathlib.Path, required=True)
    ask.add_argument("--sorts", default="material,platform,palpation")
    ask.add_argument("--kinds", default="", help="usually all of the catalogue")
    ask.add_argument("--sizes", default="4", help="of the effect over all trials of the maker, in noises")
    ask.add_argument("--seeds", default="1", help="comma")
    ask.add_argument("--rules", default=",".join(RULES))
    ask.add_argument("--at-most", type=int, default=6)
    ask.add_argument("--threads", default="1")
    asked = ask.parse_args()
    rules = asked.rules.split(",")
    results = []
    for sort in asked.sorts.split(","):
        bench = BENCHES[sort]
        for kind in asked.kinds.split(",") if asked.kinds else bench.maker.INSIDE:
            for size in map(float, asked.sizes.split(",")):
                for seed in map(int, asked.seeds.split(",")):
                    results.append(case(asked, bench, sort, kind, size, seed, rules))
    (asked.out / "lab.json").write_text(json.dumps(results, indent=1) + "\n")
    print("\n".join(table(results, rules, asked.at_most)))


def case(asked, bench, sort, kind, size, seed, rules):
    """How many trials each rule took; none where it failed."""
    took, specimen = {}, None
    program = sha256([asked.cli])
    for rule in rules:
        folder = asked.out / f"{sort}-{kind}-{size:g}x-s{seed}" / rule
        kept = folder / "took.json"
        if kept.exists() and (said := json.loads(kept.read_text()))["program"] == program and said["at_most"] == asked.at_most:
            took[rule] = said
            continue
        folder.mkdir(parents=True, exist_ok=True)
        specimen = specimen or bench(kind, size, seed)
        took[rule] = {"program": program, "at_most": asked.at_most,
                      **made_until_named(asked, specimen, sort, kind, folder, RULES[rule], seed)}
        kept.write_text(json.dumps(took[rule]) + "\n")
    print(f"{sort} {kind} {size:g}x s{seed}: " + ", ".join(
        f"{rule} {'failed' if said['took'] is None else said['took']}" for rule, said in took.items()), flush=True)
    return {"sort": sort, "kind": kind, "size": size, "seed": seed,
            "took": {rule: said["took"] for rule, said in took.items()},
            "trials": {rule: said["trials"] for rule, said in took.items()}}


def made_until_named(asked, specimen, sort, kind, folder, rule, seed):
    chance = np.random.default_rng([seed, *map(ord, sort + kind)])
    trials, sentences, said = [specimen.first(folder)], [], []
    for made in range(asked.at_most + 1):
        specimen.write(folder, [t["written"] for t in trials])
        report, problem = cli(asked, ["explain", folder / "experiment.json", "--out", folder / "answer"])
        if problem:
            return {"took": None, "trials": sentences, "said": said, "problem": problem}
        likeliest = report["posterior"]["explanations"][0]
        said.append([likeliest["kinds"], likeliest["probability"]])
        if probability_of(kind, sort, report["posterior"]["explanations"]) >= SURE:
            return {"took": made, "trials": sentences, "said": said}
        asks = json.loads((folder / "answer" / "next_trials.json").read_text())
        done = [without_name(t["asked"]) for t in trials]
        possible = [t for t in asks["possible"] if without_name(t["trial"]) not in done]
        if not possible or made == asked.at_most:
            return {"took": None, "trials": sentences, "said": said}
        chosen = rule(asks["trials"], possible, sort, chance)
        sentences.append(chosen["sentence"])
        trials.append(specimen.made(folder, chosen["trial"], f"n{made + 1}"))


def probability_of(kind, sort, explanations):
    one = ONE.get(sort, ())
    truths = one if kind in one else (kind,)
    return sum(e["probability"] for e in explanations if e["kinds"] is not None and len(e["kinds"]) == 1 and e["kinds"][0] in truths)


def without_name(trial):
    return {k: v for k, v in trial.items() if k != "id"}


# Rules: of the trials asked for and of those possible, the one to make.

def by_information(asked_for, possible, _sort, _chance):
    first = [t for t in possible if asked_for and t["trial"] == asked_for[0]["trial"]]
    return first[0] if first else max(possible, key=lambda t: t["doubt_removed"])


def by_separation(_asked_for, possible, sort, chance):
    def parted(trial):
        clear = [s["noises"] for s in trial["separations"] if s["noises"] is not None and s["noises"] >= CLEAR_NOISES]
        return len(clear), min(clear, default=0)
    best = max(possible[:BEFORE.get(sort, len(possible))], key=parted)
    return best if parted(best)[0] else by_chance(_asked_for, possible, sort, chance)  # it proposed nothing then


def by_chance(_asked_for, possible, _sort, chance):
    return possible[int(chance.integers(len(possible)))]


RULES = {"information": by_information, "separation": by_separation, "chance": by_chance}


# Specimens: what a machine measures of them in any trial.

class MaterialBench:
    maker = make_material

    def __init__(self, kind, size, seed):
        rng = np.random.default_rng([seed, *map(ord, "compression" + kind)])
        self.effects = make_material.INSIDE[kind](rng)
        plan = make_material.protocol(-1, kind == "tension-compression-asymmetry", rng)
        plain = make_material.curves(material.Effects(), plan)
        self.noise = make_material.size_kPa(make_material.curves(self.effects, plan), plain) / size
        self.begin, self.seed = plan["slow"], seed

    def first(self, folder):
        return self.made(folder, {"time_s": self.begin[0], "stretch": self.begin[1]}, "n0")

    def made(self, folder, trial, name):
        times, stretches = trial["time_s"], trial["stretch"]
        stress = material.stresses(self.effects, make_material.YOUNGS_KPA, times, stretches)
        noisy = stress + rng_of(self.seed, name).normal(0, self.noise, len(times))
        return {"asked": trial, "written": make_material.write_trial(folder, name, times, stretches, noisy)}

    def write(self, folder, trials):
        make_material.write_experiment(folder, "experiment.json", "compression", self.noise, trials)


class PlatformBench:
    maker = make_platform

    def __init__(self, kind, size, seed):
        rng = np.random.default_rng([seed, *map(ord, kind)])
        self.kind, draw = make_platform.INSIDE[kind]
        self.effects, self.seed = draw(rng), seed
        plan = make_platform.patterns(self.kind, rng)
        self.begin = plan[next(iter(plan))]
        found, plain = ({t: self.kind(e, p) for t, p in plan.items()} for e in (self.effects, make_platform.Effects()))
        self.factor = make_platform.size_in_noises(found, plain) / size

    def first(self, folder):
        return self.recorded(folder, self.begin, make_platform.AMBIENT_C, "n0", {})

    def made(self, folder, trial, name):
        asked = trial["current_A"] if self.kind is make_platform.cell else trial["load"]
        times = np.array(trial["time_s"])
        seconds = np.arange(int(times[-1]) + 1)
        each = np.array(asked)[np.searchsorted(times, seconds, side="right") - 1]
        if self.kind is make_platform.board:
            each = np.minimum(each, 1.0)  # no board does more than all
        return self.recorded(folder, each.tolist(), trial["ambient_C"], name, trial)

    def recorded(self, folder, pattern, ambient_C, name, trial):
        columns, rows = self.kind(self.effects, pattern, ambient_C)
        rng = rng_of(self.seed, name)
        for quantity in (q for q in columns if q in make_platform.NOISE):
            rows[:, columns[quantity]] += rng.normal(0, self.factor * make_platform.NOISE[quantity], len(rows))
        return {"asked": trial, "written": make_platform.write_trial(folder, name, columns, rows, ambient_C)}

    def write(self, folder, trials):
        make_platform.write_experiment(folder, "experiment.json", self.kind, self.factor, trials)


class PalpationBench:
    maker = make_palpation

    def __init__(self, kind, size, seed):
        if not calculix.available():
            sys.exit("CalculiX (ccx) is not installed: apt-get install calculix-ccx")
        self.scene = make_palpation.scene_of(SPECIMEN, kind == "strain-stiffening")
        self.effects = make_palpation.INSIDE[kind](self.scene, np.random.default_rng([seed, *map(ord, kind)]))
        self.noise = round(max(make_palpation.added_mm(self.scene, [self.effects]) / size, make_palpation.MINIMUM_NOISE_MM), 4)
        self.seed = seed
        few = np.random.default_rng([seed, 1]).choice(len(self.scene.markers_mm), MARKERS, replace=False)
        self.scene = dataclasses.replace(self.scene, markers_mm=self.scene.markers_mm[few],
                                         elements=self.scene.elements[few], weights=self.scene.weights[few])

    def first(self, folder):
        site = self.scene.sites[0]
        return self.pressed(folder, dataclasses.replace(site, name="n0", times_s=[0.0, 2.0], levels=[0.0, 1.0],
                                                        measured=[False, True]), {})

    def made(self, folder, trial, name):
        tool, samples = trial["tool"], trial["samples"]
        # The load cell is read while the tool is pushed, so that its own bias comes in; unloaded it is off.
        levels = [(s["force_N"] - self.effects.zero_N) / self.effects.gain if s["force_N"] else 0.0 for s in samples]
        return self.pressed(folder, palpation.Site(
            name, np.array(tool["center_mm"]), tool["radius_mm"], np.array(tool["direction"]),
            [s["time_s"] for s in samples], levels, [True] * len(samples), largest_N=1.0), trial)

    def pressed(self, folder, site, trial):
        scene = dataclasses.replace(self.scene, sites=[site])
        path = palpation.truth(scene, self.effects)[0]
        written = palpation.write_trial(folder, scene, self.effects, site, path, self.noise, rng_of(self.seed, site.name), "stated")
        return {"asked": trial, "written": written}

    def write(self, folder, trials):
        palpation.write_experiment(folder, "experiment.json", self.scene, self.noise, trials)


BENCHES = {"material": MaterialBench, "platform": PlatformBench, "palpation": PalpationBench}


def rng_of(seed, name):
    return np.random.default_rng([seed, *map(ord, name)])


# What came of it.

def table(results, rules, at_most):
    """A row a sort: trials until the name was right, a failure counting as one more than were allowed."""
    sorts = list(dict.fromkeys(r["sort"] for r in results))
    head = "| specimens | cases | " + " | ".join(f"{rule}: mean, failed" for rule in rules) + " |"
    yield from ["", head, "|---" * (2 + len(rules)) + "|"]
    for sort in [*sorts, "all"] if len(sorts) > 1 else sorts:
        # Where one trial was enough no rule was asked.
        of = [r["took"] for r in results if sort in (r["sort"], "all") and any(t != 0 for t in r["took"].values())]
        cells = []
        for rule in rules:
            took = [at_most + 1 if t[rule] is None else t[rule] for t in of]
            cells.append(f"{np.mean(took):.2f}, {sum(t[rule] is None for t in of)}" if of else "")
        yield f"| {sort} | {len(of)} | " + " | ".join(cells) + " |"


if __name__ == "__main__":
    main()

"""The command line that the makers of experiments share: which kinds of effect, how large, on what, from which seed."""

import argparse
import pathlib

from noise import KINDS


def asked_cases(doc, kinds, pairs=(), choice=None, usual=""):
    """Yields (folder, chosen, kinds, size, seed, noise) of each case asked for; no kinds: a null, of size 0. `choice` names
    what cases may differ in besides ("specimens"), `usual` is chosen where nothing is asked for; `noise` is one of noise.py."""
    ask = argparse.ArgumentParser(description=doc)
    ask.add_argument("out", type=pathlib.Path)
    ask.add_argument("--kinds", default=",".join(["null", *kinds]), help="comma; a+b is a pair"
                     + ("; 'pairs'" if pairs else ""))
    ask.add_argument("--sizes", default="4", help="of the effect, in noises")
    ask.add_argument("--seed", type=int, default=1)
    ask.add_argument("--count", type=int, default=1, help="of seeds, from that on")
    ask.add_argument("--noise", default="stated", choices=KINDS, help="what it is, whatever the file states")
    if choice:
        ask.add_argument(f"--{choice}", default=usual)
    asked = ask.parse_args()
    names = asked.kinds.replace("pairs", ",".join("+".join(p) for p in pairs)).split(",")
    for seed in range(asked.seed, asked.seed + asked.count):
        for chosen in getattr(asked, choice).split(",") if choice else [""]:
            prefix = (f"{chosen}-" if chosen else "") + (f"{asked.noise}-" if asked.noise != "stated" else "")
            for name in names:
                if name == "null":
                    yield asked.out / f"{prefix}null-s{seed}", chosen, [], 0.0, seed, asked.noise
                    continue
                for size in map(float, asked.sizes.split(",")):
                    yield asked.out / f"{prefix}{name}-{size:g}x-s{seed}", chosen, name.split("+"), size, seed, asked.noise

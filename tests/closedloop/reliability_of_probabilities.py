#!/usr/bin/python3
"""Does the reliability of probabilities (tests/support/undeclared/reliability.py) tell honest ones from boasting? On draws
whose truth is made to follow them, and on the same draws said with more confidence."""

import pathlib
import random
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "support" / "undeclared"))
from reliability import error, is_truth, reliability


def case(probability, right, said):
    truth = ["creep"] if right else ["capsule"]
    return {"truth": truth, "outside": False, "size": 3, "verdict": "explained", "right": right,
            "posterior": [{"kinds": ["creep"], "probability": said}, {"kinds": ["capsule"], "probability": 1 - said}]}


def main():
    draw = random.Random(5)
    drawn = [(p, draw.random() < p) for p in (draw.uniform(0.5, 1) for _ in range(4000))]
    leading = lambda cases: [(c["posterior"][0]["probability"], is_truth(c["posterior"][0], c)) for c in cases]
    honest = [case(p, right, p) for p, right in drawn]
    boasting = [case(p, right, 0.99) for p, right in drawn]
    assert error(leading(honest)) < 0.03, error(leading(honest))
    assert error(leading(boasting)) > 0.2, error(leading(boasting))
    other = {"kinds": None, "probability": 1.0}
    assert is_truth(other, {"truth": ["cut"], "outside": True}) and not is_truth(other, honest[0])
    assert is_truth({"kinds": [], "probability": 1.0}, {"truth": [], "outside": False})
    print("\n".join(reliability(honest)))
    assert any(line.startswith("| 90 to 100 %") for line in reliability(honest))
    right = sum(of_truth for _, of_truth in drawn)
    assert f"| 2 noises and more | {right} | {len(drawn) - right} | 0 | 0 |" in reliability(honest)
    assert reliability([{"posterior": []}]) == []


if __name__ == "__main__":
    main()

#!/usr/bin/python3
"""Draws what cells, or meshfree nodes, cost, log-log: set-up, step and the matrix, from one run of the benchmark or from
what it wrote as JSON. The step of cells is CPU time of the calling thread, all times of nodes are CPU time of all threads.

    tests/benchmarks/cost_of_cells.py build/release/bin/bench_mechanics resources/manual/pictures/cost-of-cells.svg
    tests/benchmarks/cost_of_cells.py build/release/bin/bench_mechanics resources/manual/pictures/cost-of-nodes.svg nodes
"""
import json
import math
import subprocess
import sys

WIDTH, HEIGHT, LEFT, BOTTOM = 640, 400, 70, 50
CURVES = [("set-up, s", "#1f5fa8", lambda run: run["setup_s"]),
          ("step, ms", "#b5361c", lambda run: run["cpu_time"]),
          ("matrix, MB", "#3d7d32", lambda run: run["matrix_MB"])]


def main(benchmark, picture, of="cells"):
    if benchmark.endswith(".json"):
        with open(benchmark, encoding="utf-8") as file:
            answer = file.read()
    else:
        answer = subprocess.run([benchmark, "--benchmark_filter=CostOf" + of.capitalize(), "--benchmark_format=json"],
                                check=True, capture_output=True, text=True).stdout
    runs = sorted(json.loads(answer)["benchmarks"], key=lambda run: run[of])
    for run in runs:
        print("{cells:8.0f} cells {nodes:7.0f} nodes {matrix_MB:7.1f} MB {setup_s:8.3f} s {iterations:5.0f} gradients "
              "{cpu_time:8.1f} ms".format(**run))
    with open(picture, "w", encoding="utf-8") as file:
        file.write(drawing(runs, of))


def drawing(runs, of):
    first, last, decades = (1, 5, 8) if of == "nodes" else (3, 6, 7)

    def x(count):
        return LEFT + (math.log10(count) - first) / (last - first) * (WIDTH - LEFT - 20)

    def y(value):
        return HEIGHT - BOTTOM - (math.log10(value) + 3) / decades * (HEIGHT - BOTTOM - 20)

    parts = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{HEIGHT}" font-family="sans-serif" '
             'font-size="13"><rect width="100%" height="100%" fill="white"/>']
    for power in range(first, last + 1):
        parts.append(f'<line x1="{x(10 ** power):.1f}" x2="{x(10 ** power):.1f}" y1="20" y2="{HEIGHT - BOTTOM}" '
                     f'stroke="#ddd"/><text x="{x(10 ** power):.1f}" y="{HEIGHT - 30}" text-anchor="middle">'
                     f'{10 ** power:,}</text>')
    for power in range(-3, decades - 2):
        parts.append(f'<line x1="{LEFT}" x2="{WIDTH - 20}" y1="{y(10 ** power):.1f}" y2="{y(10 ** power):.1f}" '
                     f'stroke="#ddd"/><text x="{LEFT - 6}" y="{y(10 ** power) + 4:.1f}" text-anchor="end">'
                     f'{10.0 ** power:g}</text>')
    parts.append(f'<text x="{WIDTH / 2}" y="{HEIGHT - 8}" text-anchor="middle">'
                 f'{"tetrahedra" if of == "cells" else "meshfree nodes"}</text>')
    for k, (name, colour, value) in enumerate(CURVES):
        points = " ".join(f"{x(run[of]):.1f},{y(value(run)):.1f}" for run in runs)
        parts.append(f'<polyline points="{points}" fill="none" stroke="{colour}" stroke-width="2"/>'
                     f'<text x="{LEFT + 14}" y="{40 + 18 * k}" fill="{colour}">{name}</text>')
    return "\n".join(parts) + "\n</svg>\n"


if __name__ == "__main__":
    if len(sys.argv) not in (3, 4) or sys.argv[3:] not in ([], ["nodes"]):
        sys.exit(__doc__)
    main(*sys.argv[1:])

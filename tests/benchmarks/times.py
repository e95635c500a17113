#!/usr/bin/python3
"""Prints the tables of docs/performance.md: what each thing takes, one command a row, medians over repetitions.

    tests/benchmarks/times.py build/release/bin TABLE     # images, bodies, meshfree, matching, poses, rehearsal, large, cells, nodes

Wants an idle machine; `rehearsal` and `large` want the demo patient (glisson-cli demo --out demo). A row names the benchmark
that printed it: it is repeated by `PROGRAM --benchmark_filter=NAME`."""

import json
import os
import pathlib
import re
import subprocess
import sys

MS, S = (lambda ms: f"{ms:.3g} ms"), (lambda ms: f"{ms / 1000:.2g} s")
TIME = "real_time"  # milliseconds

# Program, repetitions, and its rows: benchmark, what it does, what is shown of it (a counter or a time, and how).
IMAGES = [
    ("bench_imaging", 3, [
        ("read_by_glisson/real_time", "read a series of 512 x 512 x 300 (DICOM)", [(TIME, MS)]),
        ("read_by_itk/real_time", "the same files by ITK's series reader", [(TIME, MS)]),
        ("scan_ten_thousand_files/real_time", "scan 10,000 files", [(TIME, MS)])]),
    ("bench_elastography", 3, [
        ("inverting/direct/real_time", "phase images to modulus, 108 x 110 x 5, 3 directions, 8 instants: direct", [(TIME, MS)]),
        ("inverting/lfe/real_time", "the same: local frequency", [(TIME, MS)]),
        ("unwrapping/laplacian/real_time", "unwrap one direction of it: Poisson", [(TIME, MS)]),
        ("unwrapping/quality_guided/real_time", "the same: reliable paths", [(TIME, MS)])]),
    ("bench_vision", 3, [
        ("stereo_720x576/half:1/step:1/real_time", "a stereo pair of 720 x 576 to a cloud, masks and filter included",
         [(TIME, MS)])]),
    ("bench_scene", 3, [
        ("brush_moves", "a 10 mm brush moved once, 256 x 208 x 70", [(TIME, lambda us: f"{us:.2g} us")]),
        ("layer_outlined", "a slice of it outlined", [(TIME, lambda us: f"{us:.3g} us")]),
        ("stroke_saved_and_undone", "a stroke saved as a step of undo, and taken back", [(TIME, MS)])])]
BODIES = [
    ("bench_meshing", 3, [
        ("mesh_a_liver/20000/real_time", "mesh a 2.3-litre liver", [("cells", "{:,.0f} cells".format), (TIME, S)]),
        ("mesh_a_liver/90000/real_time", "the same, finer", [("cells", "{:,.0f} cells".format), (TIME, S)]),
        ("spread_nodes/10000/real_time", "spread 10,000 Voronoi nodes", [(TIME, S)])]),
    ("bench_mechanics", 3, [
        ("SetUp/15/real_time", "set up 20,250 quadratic tetrahedra", [(TIME, S)]),
        ("OneLoad/15/real_time", "one load on it", [(TIME, MS)]),
        ("ChangingTheForce/9/real_time", "a changed force on 4,374 cells: landmarks, surface, strain, reference body",
         [(TIME, MS)]),
        ("ChangingTheForce/15/real_time", "the same on 20,250", [(TIME, MS)])]),
    ("bench_mechanics", 1, [
        ("CorotationalBeamStep/6/iterations:100/real_time", "a step of a soft corotational beam of 19,456 nodes, converged",
         [(TIME, MS)]),
        ("CorotationalBeamStep/60/iterations:100/real_time", "of a stiff one", [(TIME, MS)]),
        ("MeshfreeSetUp/2000/15/iterations:1/process_time/real_time", "set up 2,000 meshfree nodes in 20,250 cells",
         [(TIME, S)]),
        ("MeshfreeSetUp/20000/25/iterations:1/process_time/real_time", "20,000 in 93,750", [(TIME, S)])])]
MESHFREE = [
    ("bench_mechanics", 1, [
        (f"MeshfreeAgainstCells/{nodes}/{fixed}/iterations:1/real_time",
         f"{nodes} nodes, {'points' if fixed else 'springs'}: distance from elements",
         [("mean_mm", "{:.2f} mm on average".format), ("largest_mm", "{:.1f} at most".format),
          ("moved_mm", "of {:.0f}".format)])
        for fixed in (1, 0) for nodes in (30, 100, 300)])]
MATCHING = [
    ("bench_registration", 1, [
        (f"trwls_wolves/n:{n}/threads:2/dynamic:{dynamic}/real_time",
         f"match {n} points, {'dynamic stopping' if dynamic else '20 passes'}",
         [("least_ms", MS), *([("ratio_given", "{:.0f} times TRW-S".format)] if n == 128 else [])])
        for dynamic in (1, 0) for n in (96, 128, 192, 256)] + [
        ("cost_roofline/iterations:1", "costs a second: the kernel of 20 passes", [("kernel_G_a_s", "{:.0f} billion".format)]),
        ("cost_roofline/iterations:1", "costs a second: in registers alone", [("registers_G_a_s", "{:.0f} billion".format)]),
        ("geo_over_a_video/iterations:1/real_time",
         "GEO as a whole, distances included: 128 points of a liver's front, breathing, against a model of 12,488 points",
         [("frames_per_s", "{:.0f} frames a second".format), ("slowest_ms", "slowest {:.0f} ms".format),
          ("error_mm", "{:.1f} mm off on average".format), ("anew_ms", "each anew {:.0f} ms".format),
          ("anew_error_mm", "{:.1f} mm off".format)]),
        ("sirgn_at_full_size/iterations:1/real_time", "SIRGn, 1,155 landmarks in 180 frames, after registration",
         [(TIME, lambda s: f"{s:.2g} s")])])]
POSES = [
    ("bench_registration", 1, [
        (f"correct_matches/{k}/iterations:1/real_time", what,
         [("mean_%", "{:.1f} % off".format), ("at_rest_%", "{:.1f} by sampling".format),
          *((f"within_{limit:02}", f"{{:.0f}} within {limit} %".format) for limit in (5, 10, 15, 25))])
        for k, what in enumerate(("wolf 0 to 1", "wolf 0 to 2", "wolf 1 to 2", "cat 0 to 1", "cat 0 to 2", "cat 1 to 2"))])]
REHEARSAL = [
    ("bench_casefile", 1, [
        ("PlacingATool/bodies:1/real_time", "a force put at another place of the demo patient's surface", [(TIME, MS)]),
        ("PlacingATool/bodies:2/real_time", "the same, the reference body beside it", [(TIME, MS)]),
        *[(f"SessionOnACase/nodes:0/ahead:{ahead}/iterations:160/real_time", what,
         [("steps_per_s", "{:.0f} a second".format), ("slowest_ms", "slowest {:.0f} ms".format),
          ("place_ms", "the retractor's first touch {:.0f} ms".format), ("error_mm", "within {:.2g} mm of rest".format)])
          for ahead, what in enumerate((
              "the demo patient with its structures, and the reference body: retractor held, probe drawn over the front",
              "the same where all that tools may touch was solved for ahead"))],
        *[(f"SessionOnACase/nodes:{nodes}/ahead:0/iterations:160/real_time",
           f"by {nodes} meshfree nodes, finite elements beside them",
           [("steps_per_s", "{:.0f} a second".format), ("slowest_ms", "slowest {:.0f} ms".format),
            ("prepare_s", "prepared in {:.1f} s".format), ("place_ms", "the retractor's first touch {:.0f} ms".format),
            ("apart_mm", "landmarks at most {:.2f} mm from finite elements".format)])
          for nodes in (100, 355, 800)]]),
    ("bench_mechanics", 1, [
        ("RehearsalWithTools/iterations:200/real_time", "a block of 20,250 cells and its reference body, a probe drawn over it",
         [("steps_per_s", "{:.0f} a second".format), ("slowest_ms", "slowest {:.0f} ms".format),
          ("error_mm", "within {:.2g} mm of rest".format)])])]
LARGE = [
    ("bench_casefile", 1, [
        (f"SessionAtLargeStrain/path:{path}/law:{law}/iterations:40/real_time", what,
         [("frames_per_s", "{:.0f} a second".format), ("slowest_ms", "slowest {:.0f} ms".format),
          ("over_0.5_mm", "{:.0f} of 40 with a bound over 0.5 mm".format),
          ("judged", "{:.0f} of 8 came to rest".format),
          ("worst_mm", "those at most {:.2f} mm off".format)])
        for path, law, what in [(0, 0, "retractor and probe, neo-Hookean"), (1, 0, "another path"),
                                (1, 1, "another path, Veronda-Westmann")]])]


def main(programs, table):
    if table in ("cells", "nodes"):
        print(*costs(programs, table), sep="\n")
        return
    tables = {"images": IMAGES, "bodies": BODIES, "meshfree": MESHFREE, "matching": MATCHING, "poses": POSES,
              "rehearsal": REHEARSAL, "large": LARGE}
    if table not in tables:
        sys.exit(f"there is no table {table}: known are {', '.join([*tables, 'cells', 'nodes'])}")
    print(f"| what | {'error' if table in ('meshfree', 'poses') else 'time'} | benchmark |\n|---|---|---|")
    for program, repetitions, rows in tables[table]:
        runs = measured(programs / program, [name for name, *_ in rows], repetitions)
        for name, what, shown in rows:
            values = "; ".join(form(runs[name][value]) for value, form in shown if value in runs[name])
            print(f"| {what} | {values} | `{program}`, `{name.split('/iterations')[0].removesuffix('/real_time')}` |",
                  flush=True)


def measured(program, names, repetitions):
    """Of each benchmark what it printed: the median over repetitions where there are several."""
    several = [f"--benchmark_repetitions={repetitions}", "--benchmark_report_aggregates_only=true"] if repetitions > 1 else []
    done = subprocess.run([program, f"--benchmark_filter=^({'|'.join(map(re.escape, dict.fromkeys(names)))})$", *several,
                           "--benchmark_format=json"], check=True, capture_output=True, text=True,
                          env={"GLISSON_CASE": "demo/demo.glisson", **os.environ})
    runs = {run["run_name"]: run for run in json.loads(done.stdout)["benchmarks"]
            if run.get("aggregate_name", "median") == "median"}
    for name in names:
        if name not in runs or "error_message" in runs[name]:
            sys.exit(f"{program.name} has no {name}: {runs.get(name, {}).get('error_message', 'is it another version?')}")
    return runs


def costs(programs, of):
    """What elements, or meshfree nodes, cost; CPU time, for nodes that of all threads."""
    done = subprocess.run([programs / "bench_mechanics", f"--benchmark_filter=CostOf{of.capitalize()}",
                           "--benchmark_format=json"], check=True, capture_output=True, text=True)
    yield "| nodes | cells | matrix | set-up | conjugate gradients a step | step |\n|---|---|---|---|---|---|"
    for run in sorted(json.loads(done.stdout)["benchmarks"], key=lambda run: run[of]):
        step = S(run["cpu_time"]) if run["cpu_time"] > 999 else MS(run["cpu_time"])
        yield (f"| {run['nodes']:,.0f} | {run['cells']:,.0f} | {run['matrix_MB']:,.3g} MB | {run['setup_s']:.2g} s |"
               f" {run['iterations']:.0f} | {step} |")


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(pathlib.Path(sys.argv[1]), sys.argv[2])

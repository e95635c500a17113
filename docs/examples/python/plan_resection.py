"""What does taking segments VI and VII leave?   plan_resection.py LIVER.nrrd VESSELS.nrrd [TUMOUR.nrrd]

Trees, Couinaud's segments and a plan of one liver, from its masks; portal and hepatic veins stand in one of them.
"""
import sys

import glisson

liver, vessels, *tumours = (glisson.read_mask_file(file) for file in sys.argv[1:])
trees = glisson.vessel_trees(vessels.mask, liver.mask)
segments = glisson.couinaud_segments(liver.mask, trees)
print(f"{len(trees.branches)} branches; segments of", *(f"{ml:.0f}" for ml in segments["volume_ml"][1:]), "ml")

grid = {key: getattr(liver.mask, key) for key in ("spacing_mm", "origin_mm", "direction")}
portal, hepatic = (glisson.LabelMap(glisson.territories(trees, system, liver.mask)["branch"] + 1, **grid)
                   for system in ("portal-vein", "hepatic-vein"))
planner = glisson.Planner(liver.mask, tumours={tumour.name: tumour.mask for tumour in tumours},
                          segments=segments["segment"], trees=trees, portal=portal, hepatic=hepatic)
plan = planner.answer({"segments": [6, 7]})
print(f"{plan['removed_ml']:.0f} ml go, {plan['remnant_percent']:.1f} % stay, {plan['living_ml']:.0f} ml with their blood")
for branch in plan["branches"][:5]:
    print(f"cuts {branch['name']}, {2 * branch['radius_mm']:.1f} mm wide")

"""Where does a tumour go when the liver is lifted?   retract_liver.py labels/liver.nrrd X Y Z

X Y Z is the tumour's place in patient coordinates (LPS), mm. The liver is meshed, held as a liver is held, and hoisted
at segment VI with 2 N.
"""
import sys

import glisson

tumour_mm = [float(word) for word in sys.argv[2:5]]

liver = glisson.mesh_labels(glisson.read_labels_file(sys.argv[1]), target_cells=4000).body
liver = glisson.mark_attachments(liver)
retractor = glisson.hoist_segment_vi(liver)
lifted = glisson.simulate(liver, {
    "youngs_modulus_kPa": 6.1,  # 2.1 kPa in shear
    "supports": glisson.usual_supports(),  # bare area and diaphragm
    "loads": [{"tool": {"center_mm": retractor["center_mm"], "radius_mm": retractor["radius_mm"],
                        "force_N": 2.0 * retractor["direction"]}}],
    "landmarks": [{"id": "tumour", "position_mm": tumour_mm}, {"id": "tool", "position_mm": retractor["center_mm"]}]})
for landmark in lifted.landmarks:
    print(f"{landmark['id']} moves by {landmark['displacement_mm']:.1f} mm")

print(f"{len(liver.cells)} tetrahedra, in equilibrium: relative residual {lifted.relative_residual:.0e}.")

#!/bin/sh
# The closed loop's table: experiments with an undeclared effect of every kind and several sizes, pairs, nulls and effects
# outside the catalogue, through `explain` and then `predict` on trials never shown. Run by hand on a quiet machine:
#
#   tests/benchmarks/closed_loop.sh [FOLDER [SEEDS]]        # build/closed-loop, "1 2 3"; cases made once stay there
#
# The rules were tuned on seeds 1 to 3 (palpation) and 1 to 10 (material, platform): ask for others to judge them. Making all
# cases takes about an hour of one core, judging them longer. Needs calculix-ccx, python3-numpy.
set -e
cd "$(dirname "$0")/../.."
folder=${1:-build/closed-loop}
make=tests/support/undeclared
for seed in ${2:-1 2 3}; do
  $make/make_palpation.py "$folder/palpation" --seed "$seed" --specimens small,block,pillar,lobe --sizes 2,4,8
  $make/make_palpation.py "$folder/palpation" --seed "$seed" --specimens small,block --kinds pairs --sizes 8
  $make/make_material.py "$folder/material" --seed "$seed" --modes compression,tension --sizes 2,4,8,20
  $make/make_material.py "$folder/material" --seed "$seed" --kinds pairs --sizes 8
  $make/make_platform.py "$folder/platform" --seed "$seed" --sizes 2,4,8,20
done
$make/make_palpation.py "$folder/large" --specimens large --kinds stiff-inclusion --sizes 8
for kind in palpation material platform large; do
  echo "== $kind"
  $make/judge.py "$folder/$kind" --cli build/release/bin/glisson-cli --out "$folder/judged-$kind"
done

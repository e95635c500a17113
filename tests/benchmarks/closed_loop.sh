#!/bin/sh
# The closed loop's table: experiments with an undeclared effect of every kind and several sizes, pairs, nulls and effects
# outside the catalogue, through `explain` and then `predict` on trials never shown. Run by hand:
#
#   tests/benchmarks/closed_loop.sh [FOLDER [SEEDS [SIZES [SPECIMENS]]]]    # build/closed-loop "1 2 3" 4,2,8 block,pillar,lobe,small
#
# The rules were tuned on seeds 1 to 3 (palpation), 1 to 10 (material, platform) and 201 to 203 (throttling): ask for others
# to judge them. It may be stopped and taken up again: cases made once stay, and what a program said of a case is
# asked again only of another program (judge.py). The table stands in FOLDER/table-KIND.txt after each specimen. Making the
# cases of one seed takes about an hour of one core (large strain most of it), judging them as long. Needs calculix-ccx,
# python3-numpy.
set -e
cd "$(dirname "$0")/../.."
folder=${1:-build/closed-loop}
sizes=${3:-4,2,8}
make=tests/support/undeclared
judge() {
  echo "== $1"
  $make/judge.py "$folder/$1" --cli build/release/bin/glisson-cli --out "$folder/judged-$1" > "$folder/table-$1.txt"
  sed -n '/^$/,$p' "$folder/table-$1.txt"
}
for seed in ${2:-1 2 3}; do
  $make/make_material.py "$folder/material" --seed "$seed" --modes compression,tension --sizes "$sizes"
  $make/make_material.py "$folder/material" --seed "$seed" --modes compression,tension --kinds pairs --sizes 8
  $make/make_platform.py "$folder/platform" --seed "$seed" --sizes "$sizes"
done
judge material
judge platform
for seed in ${2:-1 2 3}; do
  for specimen in $(echo "${4:-block,pillar,lobe,small}" | tr , ' '); do
    $make/make_palpation.py "$folder/palpation" --seed "$seed" --specimens "$specimen" --sizes "$sizes"
    judge palpation
  done
  $make/make_palpation.py "$folder/palpation" --seed "$seed" --specimens small,block --kinds pairs --sizes 8
  judge palpation
done
$make/make_palpation.py "$folder/large" --specimens large --kinds stiff-inclusion --sizes 8
judge large

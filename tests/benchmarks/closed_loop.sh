#!/bin/sh
# The closed loop's tables: experiments whose undeclared effect is known, through `explain` and then `predict` on trials never
# shown. A set is the cases of one table of docs/closed-loop.md; its seeds were fixed before its cases were made. Run by hand:
#
#   tests/benchmarks/closed_loop.sh SET [FOLDER]     # build/closed-loop
#
#   material | platform | guidance | ties | planes | waves | waves-2     minutes
#   wave-nulls | small | stiffening | forms | livers | palpations        a quarter of an hour to hours
#
# It may be stopped and taken up again: cases made once stay, and what a program said of a case is asked again only of another
# program (judge.py). Other seeds: the makers in tests/support/undeclared, then judge.py. Needs python3-numpy and, for organs,
# calculix-ccx.
set -e
cd "$(dirname "$0")/../.."
set=${1:?which set: material, platform, guidance, ties, planes, waves, waves-2, wave-nulls, small, stiffening, forms, livers or palpations}
cases=${2:-build/closed-loop}/$set
make() { sort=$1; shift; tests/support/undeclared/make_"$sort".py "$cases" "$@" > /dev/null; }

case $set in
  material)
    make material --seed 51 --modes compression,tension --sizes 2,4
    make material --seed 101 --count 3 --modes compression,tension --kinds pairs --sizes 8
    make material --seed 101 --count 6 --modes compression,tension --kinds drifting-cell,ringing-machine,slipping-grip --sizes 2,4 ;;
  platform) make platform --seed 204 --count 2 --sizes 2,4,8 ;;
  guidance)
    for seed in 41 43; do
      make guidance --seed $seed --sizes 4,8 \
        --kinds null,stiffness-scale,support-compliance,frame-misalignment,force-bias,stiff-inclusion,cut
    done ;;
  ties)
    for seed in 8534 43324; do
      make guidance --specimens tied --seed $seed --kinds null,undeclared-attachment,missing-attachment,stiff-inclusion --sizes 2,4
      make guidance --specimens tied --seed $seed --sizes 4 \
        --kinds stiffness-scale,support-compliance,frame-misalignment,force-bias,cut,two-adhesions
    done
    make guidance --specimens tied,tiny --seed 8535 --count 5 --kinds null ;;
  planes) make plane --seed 351 ;;
  waves) make waves --seed 32748 --sizes 2,4,8 ;;
  waves-2) make waves --seed 34552 --sizes 2,4,8 ;;
  wave-nulls) make waves --kinds null,null-free,null-slice --seed 34552 --count 34 ;;
  small)
    make palpation --seed 41 --specimens small --sizes 2,4,8
    make palpation --seed 41 --specimens small --kinds pairs --sizes 8 ;;
  stiffening)
    for seed in 3956 47254; do make palpation --seed $seed --specimens tiny,small --kinds strain-stiffening --sizes 2.4,4; done
    make palpation --seed 3956 --specimens tiny --kinds viscoelastic-creep,stiffness-scale,null --sizes 2.4 ;;
  forms)
    for seed in 52447 64650; do
      make palpation --seed $seed --specimens tiny,small --kinds support-compliance.layer --sizes 2,4,8
      make palpation --seed $seed --specimens tiny --kinds anisotropy.three-moduli --sizes 2,4
      make palpation --seed $seed --specimens tiny --kinds support-compliance,null --sizes 2
    done ;;
  livers)
    make palpation --seed 61 --specimens liver-12 --sizes 4
    make palpation --seed 71 --specimens liver-21 --kinds null,preload,cut,drying --sizes 2,4,8
    make palpation --seed 73 --specimens liver-22 --kinds null,preload,cut,drying --sizes 2,4,8 ;;
  palpations)
    make palpation --seed 41 --specimens small,block,pillar,lobe --sizes 2,4,8
    make palpation --seed 42 --specimens small,block --sizes 2,4,8
    make palpation --seed 41 --specimens small,pillar --kinds pairs --sizes 2,4,8 ;;
  *) echo "closed_loop.sh: there is no set $set" >&2; exit 2 ;;
esac
tests/support/undeclared/judge.py "$cases" --cli build/release/bin/glisson-cli --out "${2:-build/closed-loop}/judged-$set" |
  sed -n '/^$/,$p'

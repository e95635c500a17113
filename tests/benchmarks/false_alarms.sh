#!/bin/sh
# How often `explain` finds something where nothing was put: nulls of each sort, with noise as stated and otherwise (0.7 and
# 1.5 times as large, repeating itself, one in a hundred ten times as large). Run by hand:
#
#   tests/benchmarks/false_alarms.sh [FOLDER [FIRST_SEED [MATERIAL [PLATFORM [PALPATION]]]]]    # build/false-alarms 1001 300 150 300
#
# So many seeds of each sort with noise as stated and a third of that with each other noise (of palpations a tenth); of a
# platform a seed is a cell and a board, of a material test compression and tension alternate. It may be stopped and taken up again (judge.py). Needs
# python3-numpy; palpations calculix-ccx.
set -e
cd "$(dirname "$0")/../.."
folder=${1:-build/false-alarms}
first=${2:-1001}
make=tests/support/undeclared
nulls() {  # SORT COUNT NOISE MORE PART
  count=$2
  test "$3" = stated || count=$((($2 + ${5:-3} - 1) / ${5:-3}))
  test "$count" -gt 0 || return 0
  "$make/make_$1.py" "$folder/$1" --kinds null --seed "$first" --count "$count" --noise "$3" $4
}
for noise in stated x0.7 x1.5 correlated outliers; do
  nulls material "$(((${3:-300} + 1) / 2))" $noise "--modes compression,tension"
  nulls platform "${4:-150}" $noise
  nulls palpation "${5:-300}" $noise "--specimens tiny" 10
done
for sort in material platform palpation; do
  test -d "$folder/$sort" || continue
  $make/judge.py "$folder/$sort" --cli build/release/bin/glisson-cli --out "$folder/judged-$sort" --explain-only --threads 1 \
    > "$folder/table-$sort.txt"
done
$make/false_alarms.py "$folder"/judged-*/judged.json

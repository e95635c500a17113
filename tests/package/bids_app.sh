#!/usr/bin/env bash
# A cohort in the form of a BIDS-App: each participant is a call, the group is another, and what comes of it is what
# the study gives in one.
#
#   bids_app.sh GLISSON_CLI SOURCE_FOLDER
set -euo pipefail
cli=$1 app="$2/packaging/cohort/bids-app"

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"$cli" study cohort --simulated 3 --out "$folder/maker" --quiet
for n in 1 2 3; do
  mkdir -p "$folder/in/sub-0$n/mre"
  cp "$folder/maker/simulated/simulated-00$n-stiffness.nrrd" "$folder/in/sub-0$n/mre/sub-0${n}_stiffness.nrrd"
done
"$app" --glisson-cli "$cli" "$folder/in" "$folder/out" participant --participant-label 01 sub-03
[ "$(cd "$folder/out/patients" && echo *)" = "sub-01_stiffness.json sub-03_stiffness.json" ]
[ ! -f "$folder/out/cohort.csv" ]
"$app" --glisson-cli "$cli" "$folder/in" "$folder/out" participant --participant_label 02
"$app" --glisson-cli "$cli" "$folder/in" "$folder/out" group
cmp <(cut -d, -f2- "$folder/out/cohort.csv") <(cut -d, -f2- "$folder/maker/cohort.csv")
grep -q '"DatasetType": "derivative"' "$folder/out/dataset_description.json"

said=$("$app" --glisson-cli "$cli" "$folder/in" "$folder/out" participant --participant-label 0 2>&1) && exit 1
[[ $said == *"has no participant 0; it has sub-01_stiffness"* ]]
said=$("$app" --glisson-cli "$cli" "$folder/nothing" "$folder/out" group 2>&1) && exit 1
[[ $said == *"is no folder"* ]]

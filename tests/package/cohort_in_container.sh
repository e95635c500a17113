#!/usr/bin/env bash
# A cohort in a container: the image is made of a bare Debian and the package, and gives the table that the program gives.
#
#   cohort_in_container.sh BUILD_FOLDER SOURCE_FOLDER
set -euo pipefail
build=$1 source=$2 cli=$1/bin/glisson-cli

for tool in podman mmdebstrap dpkg-shlibdeps; do
  command -v $tool >/dev/null || { echo "$tool is not installed: skipped"; exit 77; }
done
[ "$(id -u)" = 0 ] || { echo "a bare Debian is made by root: skipped"; exit 77; }

folder=$(mktemp -d)
# Images and limits of its own: a process may not raise what its shell was given.
cat >"$folder/storage.conf" <<CONF
[storage]
driver = "overlay"
graphroot = "$folder/images"
runroot = "$folder/run"
CONF
cat >"$folder/containers.conf" <<CONF
[containers]
default_ulimits = ["nofile=1024:1024", "nproc=4096:4096"]
CONF
export CONTAINERS_STORAGE_CONF=$folder/storage.conf CONTAINERS_CONF=$folder/containers.conf
trap 'umount --recursive --lazy "$folder/images/overlay" "$folder/images" 2>/dev/null || true; rm -rf "$folder"' EXIT
# Where control groups are of the older kind only runc runs containers.
podman run --rm --rootfs /:O /bin/true 2>"$folder/why" || {
  echo '[engine]
runtime = "runc"' >>"$folder/containers.conf"
  podman run --rm --rootfs /:O /bin/true 2>>"$folder/why" || { echo "no container runs here ($(tail -1 "$folder/why")): skipped"; exit 77; }
}

"$cli" study cohort --simulated 2 --out "$folder/maker" --quiet
for n in 1 2; do
  mkdir -p "$folder/in/sub-0$n/mre"
  cp "$folder/maker/simulated/simulated-00$n-stiffness.nrrd" "$folder/in/sub-0$n/mre/sub-0${n}_stiffness.nrrd"
done
(cd "$build" && cpack -G DEB -B "$folder/package" >"$folder/log" 2>&1) || { cat "$folder/log"; exit 1; }
"$source/packaging/cohort/container" --from-mirror "$folder"/package/glisson_*.deb >"$folder/log" 2>&1 || {
  tail -n 20 "$folder/log"
  ! grep -qE "Temporary failure|Could not resolve|Could not connect" "$folder/log" || { echo "no mirror of Debian: skipped"; exit 77; }
  exit 1
}
mkdir "$folder/out"
inside() { podman run --rm --network=none -v "$folder/in:/in:ro" -v "$folder/out:/out" glisson-cohort /in /out "$@"; }
inside participant
inside group
cmp <(cut -d, -f2- "$folder/out/cohort.csv") <(cut -d, -f2- "$folder/maker/cohort.csv")

said=$("$source/packaging/cohort/container" "$folder/nothing.deb" 2>&1) && exit 1
[[ $said == *"is no package; packaging/deb makes one."* ]]

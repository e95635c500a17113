#!/usr/bin/env bash
# A cohort as jobs of a real Slurm (one node, on the loopback), killed on the way: the table is the same, to the byte,
# as that of one run without a cluster.
#
#   cohort_on_slurm.sh GLISSON_CLI SOURCE_FOLDER [PATIENTS PER_JOB]
set -euo pipefail
cli=$1 source=$2 patients=${3:-40} per_job=${4:-5}

for tool in snakemake sbatch slurmctld slurmd munged; do
  PATH=$PATH:/usr/sbin command -v $tool >/dev/null || { echo "$tool is not installed: skipped"; exit 77; }
done
[ "$(id -u)" = 0 ] || { echo "a Slurm of one's own wants root: skipped"; exit 77; }
export PATH=$PATH:/usr/sbin

folder=$(mktemp -d)
stop() {
  for daemon in slurmctld slurmd munged; do
    [ ! -f "$folder/$daemon.pid" ] || kill "$(cat "$folder/$daemon.pid")" 2>/dev/null || true
  done
  sleep 1
  rm -rf "$folder"
}
trap stop EXIT
name=$(hostname -s)
export SLURM_CONF=$folder/slurm.conf
mkdir "$folder/state" "$folder/spool"
head -c 1024 /dev/urandom >"$folder/munge.key"
chmod 600 "$folder/munge.key"
cat >"$SLURM_CONF" <<CONF
ClusterName=glisson
SlurmctldHost=$name(127.0.0.1)
SlurmUser=root
SlurmdUser=root
AuthInfo=socket=$folder/munge.socket
SlurmctldPort=$((20000 + $$ % 10000))
SlurmdPort=$((30000 + $$ % 10000))
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd.pid
SlurmctldLogFile=$folder/slurmctld.log
SlurmdLogFile=$folder/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
MpiDefault=none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
ReturnToService=2
NodeName=$name NodeAddr=127.0.0.1 CPUs=2 RealMemory=$(awk '/MemTotal/ {print int($2 / 1024)}' /proc/meminfo) State=UNKNOWN
PartitionName=main Nodes=ALL Default=YES State=UP
CONF
munged --force --key-file="$folder/munge.key" --socket="$folder/munge.socket" --pid-file="$folder/munged.pid" \
  --log-file="$folder/munged.log" --seed-file="$folder/munge.seed" 2>/dev/null
slurmctld
slurmd
for _ in $(seq 20); do
  [ "$(sinfo --noheader --format %T 2>/dev/null)" = idle ] && break
  sleep 0.5
done
[ "$(sinfo --noheader --format %T 2>/dev/null)" = idle ] || { echo "Slurm does not start here: skipped"; exit 77; }
timeout 60 sbatch --wait --output=/dev/null --wrap true >/dev/null || { echo "Slurm runs no jobs here: skipped"; exit 77; }

"$cli" study cohort --simulated "$patients" --out "$folder/whole" --quiet
cd "$folder"
workflow=(snakemake --snakefile "$source/packaging/cohort/Snakefile" --profile "$source/packaging/cohort/slurm"
  --nolock --rerun-incomplete --latency-wait 10 --quiet
  --config "folder=$folder/whole/simulated" "out=$folder/shared" "per_job=$per_job" "glisson_cli=$cli")
# Whatever has begun is killed, the workflow and the jobs under it, as soon as there is a first result.
"${workflow[@]}" >killed.log 2>&1 &
killed=$!
for _ in $(seq 900); do
  [ -z "$(ls shared/chunks 2>/dev/null)" ] || break
  sleep 0.1
done
kill -KILL $killed
scancel --user root
wait $killed 2>/dev/null || true
[ -n "$(ls shared/chunks)" ] || { echo "no job ran:"; cat killed.log slurm*.log; exit 1; }
[ ! -f shared/cohort.csv ] || { echo "it was done before it was killed"; exit 1; }

"${workflow[@]}" >again.log 2>&1 || { cat again.log; exit 1; }
cmp whole/cohort.csv shared/cohort.csv
cmp whole/summary.json shared/summary.json
[ "$(ls shared/chunks | wc -l)" = $((patients / per_job)) ] || { ls shared/chunks; exit 1; }
echo "$((patients / per_job)) jobs of $per_job patients by Slurm $(sinfo --version | cut -d' ' -f2), killed and taken up again: the same bytes"

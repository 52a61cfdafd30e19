#!/usr/bin/env bash
# An experiment done here, one trial after the other, and by a Slurm cluster of two nodes on loopback, of which slurmd and
# slurmctld, and the run that watches, are killed with SIGKILL on the way: results and tables must be equal, byte for byte.
#   tests/bench/slurm_experiment.sh [AMISS [SPEC]]     [build/release/apps/amiss/amiss share/experiments/small.yaml]
# It needs slurm-wlm and munge: apt-get install --no-install-recommends slurm-wlm munge
set -euo pipefail
top=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
amiss=$(realpath "${1:-$top/build/release/apps/amiss/amiss}")
spec=$(realpath "${2:-$top/share/experiments/small.yaml}")
cluster=$top/tests/experiment/private_slurm.sh
folder=$(mktemp -d)
run=
finish() {
  [ -z "$run" ] || kill "$run" 2>/dev/null || true
  "$cluster" stop "$folder/cluster" || true
  rm -rf "$folder"
}
trap finish EXIT

say() { printf '%s %4d s: %s\n' "$(basename "$0")" "$SECONDS" "$*"; }
results() { find "$folder/slurm/trials" -name '*.json' 2>/dev/null | wc -l; }
begin() { "$amiss" experiment run "$spec" --out "$folder/slurm" --engine slurm --chunk 1 & run=$!; }
wait_for_results() {
  while [ "$(results)" -lt "$1" ] && kill -0 "$run" 2>/dev/null; do sleep 0.2; done
  say "$(results) results"
}

say "here"
"$amiss" experiment run "$spec" --out "$folder/here" -j 1 || [ $? = 1 ]
mkdir "$folder/cluster"
"$cluster" start "$folder/cluster"
export SLURM_CONF=$folder/cluster/slurm.conf
say "Slurm"
begin
wait_for_results 1
for daemon in sim1 slurmctld; do "$cluster" kill "$folder/cluster" $daemon; done
say "slurmd of a node and slurmctld are killed"
sleep 3
for daemon in slurmctld sim1; do "$cluster" resume "$folder/cluster" $daemon; done
wait_for_results 3
kill -KILL "$run"
wait "$run" || true
say "the run is killed"
begin
wait_for_results 4
for daemon in sim1 sim2; do "$cluster" kill "$folder/cluster" $daemon; done
say "slurmd of both nodes is killed"
sleep 3
for daemon in sim1 sim2; do "$cluster" resume "$folder/cluster" $daemon; done
wait "$run" || [ $? = 1 ]
run=
say "compared"
for where in here slurm; do
  "$amiss" experiment merge "$folder/$where" >/dev/null || [ $? = 1 ]
  "$amiss" experiment verify "$folder/$where"
done
diff -r --brief --exclude=times --exclude=clock.tsv --exclude=report.html "$folder/here" "$folder/slurm"
say "equal: $(results) results, $(cd "$folder/slurm" && ls -d ./*.tsv | tr '\n' ' ')"

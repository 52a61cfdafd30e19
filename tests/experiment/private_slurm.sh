#!/usr/bin/env bash
# A Slurm cluster of two nodes on this machine, on loopback, in one folder: with a key, ports and a configuration of its own.
# It needs slurmctld, slurmd, slurm-client and munge, no service of the system, and no root.
#   private_slurm.sh start FOLDER                      then: export SLURM_CONF=FOLDER/slurm.conf
#   private_slurm.sh kill FOLDER slurmctld|sim1|sim2   with SIGKILL
#   private_slurm.sh resume FOLDER slurmctld|sim1|sim2
#   private_slurm.sh stop FOLDER
set -euo pipefail
action=$1
folder=$(realpath "$2")
what=${3:-}
export PATH=$PATH:/usr/sbin:/sbin SLURM_CONF=$folder/slurm.conf

free_ports() {  # the first of three in a row that nobody listens on
  local port=$((20000 + RANDOM % 10000)) i
  for i in 0 1 2; do
    if (exec 3<>"/dev/tcp/127.0.0.1/$((port + i))") 2>/dev/null; then
      free_ports
      return
    fi
  done
  echo "$port"
}

write_configuration() {
  local port user
  port=$(free_ports)
  user=$(id -un)
  cat >"$SLURM_CONF" <<CONF
ClusterName=private
SlurmctldHost=localhost(127.0.0.1)
SlurmctldPort=$port
SlurmUser=$user
SlurmdUser=$user
AuthType=auth/munge
AuthInfo=socket=$folder/munge.socket
CommunicationParameters=NoCtldInAddrAny,NoInAddrAny
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool-%n
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/%n.pid
SlurmctldLogFile=$folder/slurmctld.log
SlurmdLogFile=$folder/%n.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
JobCompType=jobcomp/none
MpiDefault=none
SwitchType=switch/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
ReturnToService=2
SlurmdTimeout=10
KillWait=5
MaxArraySize=4
SchedulerParameters=sched_interval=1,bf_interval=1,batch_sched_delay=0,sched_min_interval=0
NodeName=sim1 NodeHostname=localhost NodeAddr=127.0.0.1 Port=$((port + 1)) CPUs=1 RealMemory=4000
NodeName=sim2 NodeHostname=localhost NodeAddr=127.0.0.1 Port=$((port + 2)) CPUs=1 RealMemory=4000
PartitionName=all Nodes=sim1,sim2 Default=YES MaxTime=INFINITE State=UP
CONF
}

resume() {
  case $1 in
    slurmctld) slurmctld ;;
    *) slurmd -N "$1" ;;
  esac
}

start() {
  chmod 755 "$folder"  # munged wants its socket to be reached by all
  mkdir -p "$folder/state"
  write_configuration
  (umask 077 && head -c 128 /dev/urandom >"$folder/munge.key")
  munged --force --num-threads=2 --key-file="$folder/munge.key" --socket="$folder/munge.socket" \
    --pid-file="$folder/munged.pid" --log-file="$folder/munged.log" --seed-file="$folder/munged.seed"
  slurmctld -i
  resume sim1
  resume sim2
  local i
  for ((i = 0; i < 100; ++i)); do
    [ "$(sinfo --noheader --format=%T 2>/dev/null)" != idle ] || return 0
    sleep 0.1
  done
  echo "private_slurm.sh: the nodes do not come up, see $folder/*.log" >&2
  return 1
}

end_daemon() {  # NAME SIGNAL; only what this folder started
  local pid
  pid=$(cat "$folder/$1.pid" 2>/dev/null) || return 0
  kill "-$2" "$pid" 2>/dev/null || return 0
  while kill -0 "$pid" 2>/dev/null && [ "$(ps -o stat= -p "$pid" | cut -c1)" != Z ]; do sleep 0.05; done
}

stop() {
  if [ -e "/proc/$(cat "$folder/slurmctld.pid" 2>/dev/null)/exe" ]; then
    timeout 10 scancel --user="$(id -un)" || true
    timeout 20 sh -c 'while [ -n "$(squeue --noheader)" ]; do sleep 0.2; done' || true
  fi
  local daemon
  for daemon in sim1 sim2 slurmctld munged; do end_daemon $daemon KILL; done
}

case $action in
  start) start || { stop; exit 1; } ;;
  kill) end_daemon "$what" KILL ;;
  resume) resume "$what" ;;
  stop) stop ;;
  *) sed -n '2,7s/^# //p' "$0"; exit 2 ;;
esac

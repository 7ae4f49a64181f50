#!/bin/sh
# A Slurm array makes the same files as one program: slurm.sh PROGRAM SCRIPTS. Exit 77: no Slurm.
#
# One slurmctld and the slurmd of two nodes, in a network namespace.
set -eu
. "$(dirname "$0")/namespaces.sh"
enter_namespaces "ip munged perl sbatch scontrol sinfo squeue slurmctld slurmd" "$0" "$@"
scripts=$(realpath "$2")
mkdir -p /run/bin /run/here /run/munge /run/state /run/node1 /run/node2
cp "$1" /run/bin/tcbsample
cd /run/here
PATH=/run/bin:$PATH SLURM_CONF=/run/slurm.conf
export PATH SLURM_CONF
# shellcheck disable=SC2046 # names
unset $(env | sed -n 's/^\(\(SLURM\|SBATCH\)_[A-Z_]*\)=.*/\1/p' | grep -v '^SLURM_CONF$')

# The cluster.
ip link set lo up
{ ip link add node type bridge && ip addr add 10.0.0.1/24 dev node && ip link set node up; } || skip "there is no network"
hostname localhost
head -c 64 /dev/urandom >/run/munge/key
chmod -R go= /run/munge
chmod 711 /run/munge
munged --key-file /run/munge/key --socket /run/munge/socket --pid-file /run/munge/pid --log-file /run/munge/log \
  --seed-file /run/munge/seed || skip "munged does not start"
cat >/run/slurm.conf <<END
ClusterName=test
SlurmctldHost=localhost(10.0.0.1)
AuthType=auth/munge
AuthInfo=socket=/run/munge/socket
SlurmUser=root
StateSaveLocation=/run/state
SlurmctldPidFile=/run/slurmctld.pid
SlurmctldLogFile=/run/slurmctld.log
SlurmdPidFile=/run/%n/pid
SlurmdLogFile=/run/%n/log
SlurmdSpoolDir=/run/%n
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
MpiDefault=none
ReturnToService=2
SchedulerParameters=batch_sched_delay=0,sched_min_interval=0
NodeName=node1 NodeHostname=localhost NodeAddr=10.0.0.1 Port=17001 CPUs=1
NodeName=node2 NodeHostname=localhost NodeAddr=10.0.0.1 Port=17002 CPUs=1
PartitionName=all Nodes=ALL Default=YES MaxTime=5 State=UP
END
slurmctld
slurmd -N node1
slurmd -N node2
for _ in $(seq 50); do
  nodes=$(sinfo --noheader --states=idle --format=%D) || skip "slurmctld does not answer: $(cat /run/slurmctld.log)"
  [ "$nodes" != 2 ] || break
  sleep 0.1
done
[ "$nodes" = 2 ] || skip "the nodes do not get ready: $(cat /run/node1/log)"

# A task runs for each part, then the collecting step. A file that is not data fails its task and the collecting step.
make_keys keys
spoil keys
sh "$scripts/split.sh" keys job 7
array=$(sbatch --parsable --array=0-5 "$scripts/array.sbatch" job --count 500)
collect=$(sbatch --parsable --dependency="afterany:$array" "$scripts/collect.sh" job --count 500)
while [ -n "$(squeue --noheader)" ]; do sleep 0.1; done
state_of() { scontrol --oneliner show job "$1" | sed 's/.*JobState=\([A-Z]*\).*/\1/' | sort | uniq -c | tr -s ' \n' ' '; }
[ "$(state_of "$array")" = " 5 COMPLETED 1 FAILED " ] || fail "the tasks:$(state_of "$array"), $(cat slurm-*)"
[ "$(state_of "$collect")" = " 1 FAILED " ] || fail "the collecting:$(state_of "$collect"), $(cat slurm-*)"
grep -q ' 0 done, 39 skipped, 1 failed' "slurm-$collect.out" || fail "collecting had work left: $(cat slurm-*)"
check_collecting --count 500

# Submitted again, the tasks have nothing to do.
sbatch --parsable --array=0-5 --output=again-%a "$scripts/array.sbatch" job --count 500 >id
while [ -n "$(squeue --noheader)" ]; do sleep 0.1; done
[ "$(cat again-* | grep -c ' 0 done, . skipped, 0 failed')" = 6 ] || fail "again: $(cat again-*)"

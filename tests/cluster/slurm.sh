#!/bin/sh
# Whether a Slurm array makes the files that one program makes: slurm.sh PROGRAM SCRIPTS. Exit 77: Slurm cannot run here.
#
# A slurmctld and the slurmd of two nodes, on ports of their own network.
set -eu
. "$(dirname "$0")/namespaces.sh"
enter_namespaces "ip munged sbatch scontrol sinfo slurmctld slurmd" "$0" "$@"
scripts=$(realpath "$2")
mkdir -p /run/bin /run/here /run/munge /run/state /run/node1 /run/node2
cp "$1" /run/bin/tcbsample
cd /run/here
PATH=/run/bin:$PATH SLURM_CONF=/run/slurm.conf
export PATH SLURM_CONF
unset $(env | sed -n 's/^\(\(SLURM\|SBATCH\)_[A-Z_]*\)=.*/\1/p' | grep -v '^SLURM_CONF$')

# The cluster.
ip link set lo up
hostname localhost
head -c 64 /dev/urandom >/run/munge/key
chmod -R go= /run/munge
chmod 711 /run/munge
munged --key-file /run/munge/key --socket /run/munge/socket --pid-file /run/munge/pid --log-file /run/munge/log \
  --seed-file /run/munge/seed || skip "munged does not start"
cat >/run/slurm.conf <<END
ClusterName=test
SlurmctldHost=localhost(127.0.0.1)
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
NodeName=node1 NodeHostname=localhost NodeAddr=127.0.0.1 Port=17001 CPUs=1
NodeName=node2 NodeHostname=localhost NodeAddr=127.0.0.1 Port=17002 CPUs=1
PartitionName=all Nodes=ALL Default=YES MaxTime=5 State=UP
END
slurmctld
slurmd -N node1
slurmd -N node2
for try in $(seq 100); do
  [ "$(sinfo --noheader --states=idle --format=%D 2>/dev/null)" != 2 ] || break
  sleep 0.1
done
sinfo
tail /run/slurmctld.log /run/node1/log

make_keys keys
spoil keys
sh "$scripts/split.sh" keys job 7
id=$(sbatch --parsable --array=0-5 "$scripts/array.sbatch" job --count 500)
sbatch --wait --dependency="afterany:$id" "$scripts/collect.sh" job --count 500 && fail "a bad file was collected"
tail slurm*
check_collecting --count 500

#!/bin/sh
# Three hosts with sshd make the same files as one program: parallel.sh PROGRAM SCRIPTS. Exit 77: no hosts.
#
# A host is a network namespace with its own home and sshd, but without the folder "here" of this test.
set -eu
. "$(dirname "$0")/namespaces.sh"
enter_namespaces "ip parallel rsync ssh ssh-keygen sshd" "$0" "$@"
scripts=$(realpath "$2")
mkdir -p /run/bin /run/here /run/sshd
cp "$1" /run/bin/tcbsample
cd /run/here
HOME=$PWD PATH=/run/bin:$PATH PARALLEL_SSH="ssh -F $PWD/ssh_config"
export HOME PATH PARALLEL_SSH

# The hosts.
{ ip link add hosts type bridge && ip addr add 10.0.0.1/24 dev hosts && ip link set hosts up; } ||
  skip "there is no bridge"
ssh-keygen -q -t ed25519 -N '' -f key && cp key /run/host_key
cat >ssh_config <<END
User root
IdentityFile $PWD/key
UserKnownHostsFile $PWD/known
ControlPath $PWD/%n
ControlMaster auto
ControlPersist yes
END
for n in 1 2 3; do
  mkdir -p "/run/home$n/.ssh"
  chmod -R go= "/run/home$n"
  cp key.pub "/run/home$n/.ssh/authorized_keys"
  ip netns add "host$n"
  ip link add "to$n" type veth peer name eth0 netns "host$n"
  ip link set "to$n" master hosts up
  ip -n "host$n" addr add "10.0.0.1$n/24" dev eth0
  ip -n "host$n" link set eth0 up
  printf 'HostKey /run/host_key\nPidFile /run/pid%s\nSetEnv PATH=%s\n' "$n" "$PATH" >"/run/sshd_config$n"
  ip netns exec "host$n" sh -c "mount --bind /run/home$n ~root && $(command -v sshd) -f /run/sshd_config$n &&
    mount -t tmpfs tmpfs $PWD"
  echo "host$n" >>hosts
  printf 'Host host%s\nHostName 10.0.0.1%s\n' "$n" "$n" >>ssh_config
  echo "10.0.0.1$n $(cat key.pub)" >>known
done
parts_done() { awk 'NR > 1 { print $NF }' job/log | sort | uniq -c | awk '{ print $1 " " $2 }'; }

# All hosts get parts; a file that is not data does not stop them, and its part is not tried again.
make_keys keys
spoil keys
sh "$scripts/split.sh" keys job 7
sh "$scripts/parallel.sh" job hosts --count 500 2>errors || fail "exit $?: $(cat errors)"
grep -q "$spoilt" errors || fail "no word of the bad file: $(cat errors)"
[ "$(cut -f 2 job/log | sort -u | grep -c host)" = 3 ] || fail "not all hosts had a part: $(cat job/log)"
left=$(find /run/home? -type f ! -path '*/.ssh/*')
[ -z "$left" ] || fail "left behind on a host: $left"
check_collecting --count 500

# One host fails, and the machine that starts the work stops before the end; then it continues.
ip netns pids host3 | xargs kill
sh "$scripts/split.sh" keys again 7
setsid sh "$scripts/parallel.sh" again hosts --count 500 2>errors &
until [ -f again/log ] && [ "$(wc -l <again/log)" -ge 3 ]; do sleep 0.05; done
kill -- -$!
wait $! 2>/dev/null || true
cp again/log before
sh "$scripts/parallel.sh" again hosts --count 500 2>errors || fail "after a stop, exit $?: $(cat errors)"
head -n "$(wc -l <before)" again/log | cmp - before || fail "it began from the start"
[ "$(awk 'NR > 1 { print $NF }' again/log | sort | uniq -c | awk '{ print $1 }' | tr -d '\n')" = 111111 ] ||
  fail "not every part once: $(cat again/log)"
same want again/rows

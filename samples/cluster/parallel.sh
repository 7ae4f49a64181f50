#!/bin/sh
# Samples the parts of a job on several hosts with GNU parallel, one part a host: parallel.sh JOB HOSTS [OPTION]...
#
# HOSTS is a file with one ssh login per line; the hosts need tcbsample and rsync in their PATH, but no common file
# system. A part is sent to a host, its rows are returned to JOB/rows, and nothing remains there. JOB/log lists the
# parts that are done: the same command again samples the others. Files that cannot be sampled are reported, and
# collect.sh counts them.
set -eu
[ $# -ge 2 ] || { echo "usage: parallel.sh JOB HOSTS [OPTION]..." >&2; exit 2; }
job=$1 hosts=$(realpath "$2")
shift 2
cd "$job"
# A part has a folder of its own on a host (--workdir ...). If the host fails, two more are tried, but not if data is bad.
# shellcheck disable=SC2016 # for the shell of the host
find parts -mindepth 1 -maxdepth 1 | LC_ALL=C sort |
  parallel --will-cite --quote --sshloginfile "$hosts" --jobs 1 --retries 3 --joblog log --resume-failed \
    --workdir ... --transferfile {} --return rows --cleanup \
    sh -c 'tcbsample "$@" || [ $? = 1 ]' sh --recursive --output-dir rows "$@" {}

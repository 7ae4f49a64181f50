# Runs a test in its own namespaces, so that it has no effect outside and leaves nothing; sourced by the tests.

skip() { echo "skipped: $1"; exit 77; }

# enter_namespaces "TOOL..." "$0" "$@": continues the test in new namespaces, with an empty /run; or skips it.
enter_namespaces() {
  PATH=$PATH:/usr/sbin:/sbin
  if [ "${ENTERED-}" = 1 ]; then
    mount -t tmpfs tmpfs /run
    return
  fi
  [ "$(id -u)" = 0 ] || skip "namespaces need root"
  for tool in unshare $1; do
    command -v "$tool" >/dev/null || skip "there is no $tool"
  done
  shift
  unshare --mount --net --uts --pid --fork --mount-proc mount -t tmpfs tmpfs /run 2>/dev/null ||
    skip "there are no namespaces"
  ENTERED=1 exec unshare --mount --net --uts --pid --fork --kill-child --mount-proc sh "$@"
}

# make_keys FOLDER: 40 files of keys, in folders, with names that need quotes, or that awk could read as assignments.
make_keys() {
  mkdir -p "$1/arm" "$1/leg, \"left\"/foot"
  for i in $(seq 10 49); do
    case $i in 1?) folder=. ;; 2?) folder=arm ;; *) folder='leg, "left"/foot' ;; esac
    seq 0 49 | awk -v i="$i" 'BEGIN { print "time,x,y" } { print $1 "," $1 * i % 17 "," $1 * $1 % i }' \
      >"$1/$folder/key=$i.csv"
  done
}

# spoil FOLDER: writes a cell that is not a number into a file; errors then contain $spoilt.
spoil() {
  cp "$1/arm/key=25.csv" good
  echo '1,o,2' >>"$1/arm/key=25.csv"
  spoilt='key=25.csv:52:3: error'
}

# check_collecting OPTION...: checks that the folder job is not collected with a bad file, but with a good one.
check_collecting() {
  ! sh "$scripts/collect.sh" job "$@" 2>errors || fail "a bad file was collected"
  grep -q "$spoilt" errors || fail "collecting does not name the bad file: $(cat errors)"
  cat good >'keys/arm/key=25.csv'
  tcbsample --recursive --output-dir want "$@" keys 2>/dev/null
  sh "$scripts/collect.sh" job "$@" 2>errors || fail "collecting failed: $(cat errors)"
  grep -q ' 1 done, 39 skipped, 0 failed' errors || fail "collecting did more than the bad file: $(cat errors)"
  same want job/rows
  (
    cd want
    sed 's/^/file,/;q' 'key=10.csv'
    find . -type f | cut -c 3- | LC_ALL=C sort | while IFS= read -r file; do
      case $file in *'"'*) name="\"$(echo "$file" | sed 's/"/""/g')\"" ;; *) name=$file ;; esac
      NAME=$name perl -ne 'print "$ENV{NAME},$_" if $. > 1' "$file"
    done
  ) | cmp - job/rows.csv || fail "the table has other rows"
}

same() { diff -r "$1" "$2" >difference || { head difference; fail "$1 and $2 differ"; }; }
fail() { echo "$1"; exit 1; }

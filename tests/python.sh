#!/bin/sh
# Runs a script by a Python that has a module: python.sh MODULE SCRIPT [ARG]... Exit 77: none has it.
module=$1
shift
for python in python3 /usr/bin/python3; do
  "$python" -c "import $module" 2>/dev/null && exec "$python" "$@"
done
echo "skipped: no Python has $module"
exit 77

#!/bin/sh
# The wheel in new environments, without network: wheel.sh STRIP MAKE_WHEEL... Exit 77: Python lacks what this needs.
set -eu
strip=$1
shift
python=$1
here=$(cd "$(dirname "$0")/../.." && pwd)
for module in wheel numpy venv ensurepip; do
  "$python" -c "import $module" 2>/dev/null || { echo "skipped: $python has no module $module"; exit 77; }
done
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
unset PYTHONPATH
export PIP_ROOT_USER_ACTION=ignore PIP_DISABLE_PIP_VERSION_CHECK=1
wheel=$("$@" --folder "$scratch/wheel" --license "$here/LICENSE" --strip="$strip")
"$@" --folder "$scratch/again" --license "$here/LICENSE" --strip="$strip" >/dev/null
cmp "$wheel" "$scratch/again/$(basename "$wheel")" # the same bytes each time
echo "$wheel: $(wc -c <"$wheel") bytes"
cd "$scratch"

# The lines of the README, with Debian's NumPy.
"$python" -m venv --system-site-packages with_numpy
with_numpy/bin/pip install --quiet --no-index "$wheel"
sed -n '/^```python$/,/^```$/{/^```/!p}' "$here/README.md" >example.py
grep -q tcbsample.resample example.py
mkdir samples && cp "$here/samples/camera.csv" samples
# Notes on keys that an earlier version may have made are no fault of the lines.
with_numpy/bin/python -W error -W ignore:samples/camera.csv -W ignore:keys example.py
with_numpy/bin/python -c 'import tcbsample, os, sys
assert os.path.dirname(tcbsample.program()) == os.path.realpath(sys.prefix) + "/bin", tcbsample.program()
assert tcbsample.resample([[0, 0], [1, 1]], count=2).tolist() == [(0, 0), (1, 1)]'

# The command needs no NumPy, and the program is found where pip puts it for --target.
"$python" -m venv alone
alone/bin/pip install --quiet --no-index --no-deps "$wheel"
case $(basename "$wheel") in
"tcbsample-$(alone/bin/tcbsample --version | cut -d' ' -f2)-py3-none-"*) ;;
*) exit 1 ;;
esac
alone/bin/tcbsample --step 0.5 samples/camera.csv | head -2 >printed
printf '%s\n' 'time,x,y,z,fov' '0,0,-12,1.7,50' >expected
cmp printed expected
"$python" -m pip install --quiet --no-index --no-deps --target folder "$wheel"
PYTHONPATH=folder "$python" -c 'import tcbsample; assert len(tcbsample.resample([[0, 0], [1, 1]], count=9)) == 9
assert "folder" in tcbsample.program(), tcbsample.program()'

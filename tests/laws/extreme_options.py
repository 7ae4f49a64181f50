"""Commands with rates, factors, counts, times and digits from 1e-400 to 1e309 end within ten seconds, with an exit code of
0, 1 or 2, and without a fault of the program's own."""
from keys import Keys
from law import check, require, run

values = """0 1 -1 2 3 24 0.5 -0 1/3 30000/1001 1e-18 1e-100 1e-309 5e-324 1e-400 1e18 1e20 1e308 1.7e308 1e309 2147483648
    4294967296 9223372036854775807 9223372036854775808 18446744073709551615 18446744073709551616 1/1e300 1e-300/1e300
    1000000000 1000000001 nan inf 1e9ms 1ns 1e300h""".split()
numbers = """--step --rate --fps --count --per-segment --at --arc-step --arc-count --arc-at --tolerance --fit --from --to
    --period --skip-lines --input-fps --time-start --max-gap --digits --fixed --time-zero --abs --rel --ulp --corner
    --keep-times --scale=x --limits=speed --limits=jerk --count""".split()
others = """--golden --closed --keys --plot --format=json --explain --time-format=smpte --time-format=frames
    --time-format=clock --time-format=iso --parameter=centripetal --parameter=uniform --extrapolate=repeat
    --extrapolate=linear --end=fit --end=keep --fields=all --time-unit=ms --time-unit=frames --retime --retime=fit
    --tcb-scale=percent --equal-speed --no-overshoot --emit=hermite --emit=poly -fsvg -fnpy -fgltf -ftum -fnerfstudio
    --meta --hex --exact-input""".split()
inputs = [
    "t,x\n0,0\n1,1\n",
    "t,x,y\n0,0,1\n1e307,1,5\n",
    "t,x,y,z\n0,0,1,5\n1,2,5,1e300\n2,1,1,2\n",
    "frame,x\n0,0\n10,5\n",
    "t,x\n00:00:00:00,1\n00:00:01:00,2\n",
    "t,x\n1e-310,1e-310\n2e-310,3e-310\n3e-310,1\n",
    "x,y\n1,2\n3,4\n5,1\n",
    "t,x,y,z,qx,qy,qz,qw\n0,0,0,0,0,0,0,1\n1,1,2,3,0,0,1,0\n2,1,2,3,0,0.6,0.8,0\n",
]


def json_keys(rng):
    member, closed = rng.choice(["fps", "period", "framerate", "rate", "seconds"]), rng.choice(["true", "false"])
    return (f'{{"{member}":{rng.choice(values[:21])},"closed":{closed},"keys":[{{"time":0,"position":[0,1]}},'
            f'{{"time":1,"position":[2,{rng.choice(["3", "1e308", "1e-320"])}]}}]}}')


def law(rng):
    keys = Keys(rng)
    text, of_keys = rng.choice([*[(text, []) for text in inputs], (json_keys(rng), []), (keys.text(), keys.options())])
    options = [f"{rng.choice(numbers)}={rng.choice(values)}" for _ in range(rng.randrange(1, 4))]
    options += rng.sample(others, rng.randrange(0, 3)) + rng.choice([[], ["-n", "7"]])
    done = run(text, "--max-rows", "20000", *of_keys, *options, codes=(0, 1, 2), timeout=10, errors="replace")
    require("of its own" not in done.stderr, done.stderr)


check(law, 40)

"""Scenes of LightWave, in fractions.

Scenes of versions 1, 2 and 5, with TCB, Hermite, linear and stepped spans, are evaluated by the formulas of the
LightWave SDK, with the tangents at ends as LightWave writes them. Golden rows are exactly those numbers, rounded; others
are within 1e-13."""
from fractions import Fraction

from law import blocks, check, near, same, write

TCB, HERMITE, BEZIER, LINEAR, STEPPED = range(5)


def envelope(draw, version, times):
    """Keys: value, time, span, T, C, B, incoming, outgoing, as texts."""
    number = lambda low, high, decimals=3: f"{draw.uniform(low, high):.{decimals}f}"
    kinds = [[TCB], [TCB, LINEAR]][draw.random() < 0.5] if version == 1 else draw.choice(
        [[TCB], [TCB, LINEAR, STEPPED]] if version == 2 else [[TCB], [HERMITE, BEZIER], [TCB, HERMITE, LINEAR, STEPPED]])
    return [(number(-5, 5), t, draw.choice(kinds), *(number(-1, 1, 2) for _ in range(3)), number(-4, 4), number(-4, 4))
            for t in times]


def times_of(draw, count, version):
    times, t = [], Fraction(draw.randint(-2, 2))
    for _ in range(count):
        times.append(f"{float(t):.4f}" if version != 1 else str(int(t * 30)))
        t += Fraction(draw.randint(1, 60), 30) if version == 1 else Fraction(draw.randint(200, 20000), 10000)
    return times


def text_of(version, channels):
    lines = ["LWSC", str(version), "", "FramesPerSecond 30", "LoadObject Objects/My Ship.lwo", "ObjectMotion (unnamed)"]
    if version == 5:
        lines.append(f"NumChannels {len(channels)}")
        for i, keys in enumerate(channels):
            lines += [f"Channel {i}", "{ Envelope", f"  {len(keys)}"]
            lines += ["  Key " + " ".join(map(str, [v, t, span, *tcb, *tangents, 0])) for v, t, span, *tcb_tangents in keys
                      for tcb, tangents in [(tcb_tangents[:3], tcb_tangents[3:])]]
            lines += ["  Behaviors 1 1", "}"]
    elif version == 2:
        lines.append(str(len(channels)))
        for keys in channels:
            lines += [str(len(keys))] + [" ".join(map(str, [v, t, 2 if span == TCB else span, *more[:3]]))
                                         for v, t, span, *more in keys]
        lines.append("Pre/PostBehavior " + "1 " * (2 * len(channels)))
    else:
        lines += [str(len(channels)), str(len(channels[0]))]
        for i, (_, frame, span, t, c, b, *_) in enumerate(channels[0]):
            lines += [" ".join(keys[i][0] for keys in channels), f"{frame} {int(span == LINEAR)} {t} {c} {b}"]
        lines.append("EndBehavior 1")
    return "\r\n".join(lines + ["ShowObject 7 -1 0.3 0.4 0.5", "AddLight", "LightName Light"]) + "\n"


class Channel:
    def __init__(self, keys, version):
        unit = Fraction(1, 30) if version == 1 else Fraction(1)
        self.keys = [[Fraction(v), Fraction(t) * unit, span, *map(Fraction, more)] for v, t, span, *more in keys]

    def chord(self, i):
        return self.keys[i + 1][0] - self.keys[i][0]

    def h(self, i):
        return self.keys[i + 1][1] - self.keys[i][1]

    def outgoing(self, i):
        _, _, span, t, c, b, _, out = self.keys[i]
        if span in (HERMITE, BEZIER):
            return out
        if span == STEPPED:
            return Fraction(0)
        if span == LINEAR:
            t = c = b = Fraction(0)
        own = (1 - t) * (1 - c) * (1 - b) * self.chord(i)
        if i == 0:
            return own * self.h(0) / (self.h(0) + Fraction(1, 3600))
        return (own + (1 - t) * (1 + c) * (1 + b) * self.chord(i - 1)) * self.h(i) / (self.h(i - 1) + self.h(i))

    def incoming(self, i):
        _, _, span, t, c, b, into, _ = self.keys[i]
        if span in (HERMITE, BEZIER):
            return into
        own = (1 - t) * (1 - c) * (1 + b) * self.chord(i - 1)
        if i == len(self.keys) - 1:
            return own * self.h(i - 1) / (self.h(i - 1) + Fraction(1, 3600))
        return (own + (1 - t) * (1 + c) * (1 - b) * self.chord(i)) * self.h(i - 1) / (self.h(i - 1) + self.h(i))

    def at(self, time):
        if time <= self.keys[0][1] or len(self.keys) == 1:
            return self.keys[0][0]
        if time >= self.keys[-1][1]:
            return self.keys[-1][0]
        i = max(k for k, key in enumerate(self.keys) if key[1] <= time)
        p, q, span, u = self.keys[i][0], self.keys[i + 1][0], self.keys[i + 1][2], (time - self.keys[i][1]) / self.h(i)
        if span == LINEAR:
            return p + u * (q - p)
        if span == STEPPED:
            return p
        return ((1 + 2 * u) * (1 - u) ** 2 * p + u * u * (3 - 2 * u) * q + u * (1 - u) ** 2 * self.outgoing(i)
                - u * u * (1 - u) * self.incoming(i + 1))


def law(rng):
    version = rng.choice([1, 2, 5])
    common = times_of(rng, rng.randint(2, 6), version)
    channels = [envelope(rng, version, common if version == 1 or rng.random() < 0.4 else times_of(rng, rng.randint(1, 6), version))
                for _ in range(rng.choice([6, 9]))]
    if version == 1:
        spans = [key[2:6] for key in channels[0]]
        channels = [[(key[0], key[1], *span, *key[6:]) for key, span in zip(keys, spans)] for keys in channels]
    scene = text_of(version, channels)
    write("scene.lws", scene)
    for track in range(len(channels) // 3):
        of_track = [Channel(keys, version) for keys in channels[3 * track:3 * track + 3]]
        first = min(channel.keys[0][1] for channel in of_track)
        last = max(channel.keys[-1][1] for channel in of_track)
        times = sorted({Fraction(round(rng.uniform(float(first), float(last)) * 64), 64) for _ in range(6)})
        times = [t for t in times if first <= t <= last]
        if first == last or not times:
            continue
        options = ["scene.lws", "--only", "My Ship/" + ["position", "rotation", "scale"][track],
                   "--at", ",".join(str(float(t)) for t in times)]
        golden, plain = (blocks(scene, *options, *more)[0] for more in (["--golden", "--exact-input"], []))
        for t, gold, row in zip(times, golden, plain, strict=True):
            for axis, channel in zip("xyz", of_track):
                want = channel.at(t)
                same(float(gold[axis]), float(want), f"{axis} at {t}")
                near(float(row[axis]), want, Fraction(1, 10 ** 13) * max(1, abs(want)), f"{axis} at {t}")


check(law, 20, least=5)

"""Polynomials with fractions as coefficients: their roots by Sturm sequences, and their largest values on [0, 1]."""
import math
from fractions import Fraction as F


def add(a, b):
    n = max(len(a), len(b))
    return [(a[i] if i < len(a) else 0) + (b[i] if i < len(b) else 0) for i in range(n)]


def times(a, b):
    r = [F(0)] * (len(a) + len(b) - 1)
    for i, x in enumerate(a):
        for j, y in enumerate(b):
            r[i + j] += x * y
    return r


def compose(outer, inner):
    r = [outer[-1]]
    for c in reversed(outer[:-1]):
        r = times(r, inner)
        r[0] += c
    return r


def derive(a):
    return [i * a[i] for i in range(1, len(a))] or [F(0)]


def trim(a):
    a = list(a)
    while len(a) > 1 and a[-1] == 0:
        a.pop()
    return a


def value(a, x):
    r = F(0)
    for c in reversed(a):
        r = r * x + c
    return r


def divide(a, b):
    """Quotient and remainder."""
    a, q = list(a), []
    while len(a) >= len(b):
        q.append(F(a[-1]) / b[-1])
        for i in range(len(b)):
            a[len(a) - len(b) + i] -= q[-1] * b[i]
        a.pop()
    return q[::-1] or [F(0)], trim(a or [F(0)])


def whole(a):
    """a times a positive number, with whole coefficients."""
    scale = math.lcm(*(F(c).denominator for c in a))
    numbers = [int(c * scale) for c in a]
    divisor = math.gcd(*numbers) or 1
    return [c // divisor for c in numbers]


def remainder(a, b):
    """A positive multiple of the remainder, for whole coefficients."""
    a, lead = list(a), b[-1]
    while len(a) >= len(b):
        top = a.pop() * (1 if lead > 0 else -1)
        a = [abs(lead) * c for c in a]
        for i in range(len(b) - 1):
            a[len(a) - len(b) + 1 + i] -= top * b[i]
    return trim(a or [0])


def sturm(p):
    chain = [whole(p), whole(trim(derive(p)))]
    while len(chain[-1]) > 1:
        r = remainder(chain[-2], chain[-1])
        if not any(r):
            break
        chain.append(whole([-c for c in r]))
    return chain


def changes(chain, x):
    signs = [s for s in (value(p, x) for p in chain) if s != 0]
    return sum((a < 0) != (b < 0) for a, b in zip(signs, signs[1:]))


def roots(p, bits=80):
    """Points within 2^-bits of each root in (0, 1)."""
    p = trim(p)
    if len(p) < 2:
        return
    chain = sturm(p)
    if len(chain[-1]) > 1:  # roots that are multiple become single
        chain = sturm(trim(divide(p, chain[-1])[0]))
    todo = [(F(0), F(1), changes(chain, F(0)), changes(chain, F(1)))]
    while todo:
        a, b, at_a, at_b = todo.pop()
        if at_a == at_b:
            continue
        if at_a - at_b == 1:
            if value(chain[0], b) == 0:
                yield b
                continue
            falls = value(chain[0], b) < 0
            for _ in range(bits):
                m = (a + b) / 2
                y = value(chain[0], m)
                if y == 0:
                    a = b = m
                    break
                a, b = (a, m) if (y < 0) == falls else (m, b)
            yield (a + b) / 2
            continue
        m = (a + b) / 2
        at_m = changes(chain, m)
        todo += [(a, m, at_a, at_m), (m, b, at_m, at_b)]


def common(a, b):
    """The common divisor of the largest degree."""
    a, b = trim(list(a)), trim(list(b))
    while any(b):
        a, b = b, trim(divide(a, b)[1])
    return a


def largest(over, under):
    """The largest value on [0, 1]."""
    slope = trim(add(times(derive(over), under), [-x for x in times(over, derive(under))]))
    places = [F(0), F(1), *roots(slope)]
    if any(value(under, x) < F(1, 2 ** 100) * sum(abs(c) for c in under) for x in places):  # values change fast there
        places = [F(0), F(1), *roots(slope, 600)]
    return max(value(over, x) / value(under, x) for x in places)



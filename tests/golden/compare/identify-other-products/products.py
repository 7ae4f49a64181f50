#!/usr/bin/env python3
"""Writes what programs of other makes compute from keys.csv, each in its own way of working: products.py FOLDER.

The formulas are those of the products' documentation or source, written down here once more and evaluated by
themselves: Hermite polynomials, Horner's scheme, single precision, other orders of tension, continuity and bias.
"""
import struct
import sys

t = [0, 1, 3, 4, 6]
P = [[0, 1], [2, -1], [-1, 0.5], [3, 2], [1, 4]]
TCB = [(.2, -.3, .4), (0, .5, -.25), (-.5, .25, .5), (.3, -.6, -.2), (.1, .4, .3)]
last = len(t) - 1


def single(x):
    return struct.unpack("f", struct.pack("f", x))[0]


def four(T, C, B):
    return (1 - T) * (1 + C) * (1 + B), (1 - T) * (1 - C) * (1 - B), (1 - T) * (1 - C) * (1 + B), (1 - T) * (1 + C) * (1 - B)


def chord(k, i):
    return P[k + 1][i] - P[k][i]


def gte():
    """Geometric Tools: velocities, averaged; the end value comes once more; powers of u."""
    def out(k, i):
        a, b, _, _ = four(*TCB[k])
        before = 0 if k == 0 else chord(k - 1, i) / (t[k] - t[k - 1])
        return (a * before + b * chord(k, i) / (t[k + 1] - t[k])) / 2

    def into(k, i):
        _, _, c, d = four(*TCB[k])
        behind = 0 if k == last else chord(k, i) / (t[k + 1] - t[k])
        return (c * chord(k - 1, i) / (t[k] - t[k - 1]) + d * behind) / 2

    def at(x, i):
        k = max(j for j in range(last) if t[j] <= x)
        h = t[k + 1] - t[k]
        u = (x - t[k]) / h
        p, m0, m1 = chord(k, i), out(k, i) * h, into(k + 1, i) * h
        return P[k][i] + u * (m0 + u * (3 * p - 2 * m0 - m1 + u * (m0 + m1 - 2 * p)))
    return at


def vtk():
    """VTK: zero at the ends; it takes the three columns for tension, bias, continuity."""
    def tangents(k, i):
        if k in (0, last):
            return 0, 0
        T, B, C = TCB[k]
        a, b, c, d = four(T, C, B)
        h0, h1 = t[k] - t[k - 1], t[k + 1] - t[k]
        return ((c * chord(k - 1, i) + d * chord(k, i)) / 2 * (2 * h0 / (h0 + h1)),
                (a * chord(k - 1, i) + b * chord(k, i)) / 2 * (2 * h1 / (h0 + h1)))

    def at(x, i):
        k = max(j for j in range(last) if t[j] <= x)
        u = (x - t[k]) / (t[k + 1] - t[k])
        m0, m1 = tangents(k, i)[1], tangents(k + 1, i)[0]
        return ((2 * u**3 - 3 * u**2 + 1) * P[k][i] + (3 * u**2 - 2 * u**3) * P[k + 1][i]
                + (u**3 - 2 * u**2 + u) * m0 + (u**3 - u**2) * m1)
    return at


def ogre():
    """OGRE Procedural in single precision: times ignored, the end value comes once more."""
    f = single

    def at(x, i):
        k = max(j for j in range(last) if t[j] <= x)
        u = f((x - t[k]) / (t[k + 1] - t[k]))
        a, b, _, _ = (f(v) for v in four(*TCB[k]))
        _, _, c, d = (f(v) for v in four(*TCB[k + 1]))
        before = f(P[k][i] - P[max(k - 1, 0)][i])
        here = f(chord(k, i))
        behind = f(P[min(k + 2, last)][i] - P[k + 1][i])
        m0 = f(f(f(a * before) + f(b * here)) * f(0.5))
        m1 = f(f(f(c * here) + f(d * behind)) * f(0.5))
        u2, u3 = f(u * u), f(f(u * u) * u)
        terms = [f(f(2 * u3 - 3 * u2 + 1) * f(P[k][i])), f(f(3 * u2 - 2 * u3) * f(P[k + 1][i])),
                 f(f(u3 - 2 * u2 + u) * m0), f(f(u3 - u2) * m1)]
        return f(f(f(terms[0] + terms[1]) + terms[2]) + terms[3])
    return at


def max3ds():
    """3ds Max: interval times, blended by |C|; ends of second derivative 0, slowed by tension; the sign of B turned."""
    def inner(k, i):
        T, C, B = TCB[k]
        a, b, c, d = four(T, C, -B)
        h0, h1 = t[k] - t[k - 1], t[k + 1] - t[k]
        f, g = 2 * h0 / (h0 + h1), 2 * h1 / (h0 + h1)
        return ((c * chord(k - 1, i) + d * chord(k, i)) / 2 * (f + abs(C) * (1 - f)),
                (a * chord(k - 1, i) + b * chord(k, i)) / 2 * (g + abs(C) * (1 - g)))

    def at(x, i):
        k = max(j for j in range(last) if t[j] <= x)
        u = (x - t[k]) / (t[k + 1] - t[k])
        m0 = (1 - TCB[0][0]) * (3 * chord(0, i) - inner(1, i)[0]) / 2 if k == 0 else inner(k, i)[1]
        m1 = ((1 - TCB[last][0]) * (3 * chord(k, i) - inner(k, i)[1]) / 2 if k + 1 == last else inner(k + 1, i)[0])
        return ((1 + 2 * u) * (1 - u)**2 * P[k][i] + u * u * (3 - 2 * u) * P[k + 1][i]
                + u * (1 - u)**2 * m0 - u * u * (1 - u) * m1)
    return at


def threejs():
    """three.js: weights of four keys, half a segment over the time to a neighbour; the inner neighbour beyond an end."""
    def at(x, i):
        k = max(j for j in range(last) if t[j] <= x)
        before, behind = k - 1 if k else 1, k + 2 if k + 2 <= last else k
        half = (t[k + 1] - t[k]) / 2
        w0, w3 = half / (t[k] - t[before]), half / (t[behind] - t[k + 1])
        u = (x - t[k]) / (2 * half)
        s0 = -w0 * u**3 + 2 * w0 * u**2 - w0 * u
        s1 = (1 + w0) * u**3 + (-1.5 - 2 * w0) * u**2 + (w0 - 0.5) * u + 1
        s2 = (-1 - w3) * u**3 + (1.5 + w3) * u**2 + u / 2
        s3 = w3 * u**3 - w3 * u**2
        return s0 * P[before][i] + s1 * P[k][i] + s2 * P[k + 1][i] + s3 * P[behind][i]
    return at


def godot():
    """Godot 4: the pyramid of Barry and Goldman; the end key once more beyond an end."""
    def at(x, i):
        k = max(j for j in range(last) if t[j] <= x)
        ks = [max(k - 1, 0), k, k + 1, min(k + 2, last)]
        level = [P[j][i] for j in ks]
        for width in (1, 2, 3):
            spans = [(ks[j], ks[j + width]) if width < 3 else (k, k + 1) for j in range(4 - width)]
            level = [a + (b - a) * ((x - t[m]) / (t[n] - t[m]) if m != n else (m == 0 and j == 0))
                     for j, (a, b, (m, n)) in enumerate(zip(level, level[1:], spans))]
        return level[0]
    return at


def write(name, at, text):
    with open(f"{sys.argv[1]}/{name}", "w") as file:
        file.write("time,x,y\n")
        for j in range(41):
            x = 0.15 * j if j < 40 else 6
            file.write(f"{x!r},{text(at(x, 0))},{text(at(x, 1))}\n")


write("gte.csv", gte(), repr)
write("vtk.csv", vtk(), lambda v: f"{v:.6f}")
write("ogre.csv", ogre(), lambda v: f"{v:.9g}")
write("3dsmax.csv", max3ds(), lambda v: f"{v:.4g}")
write("threejs.csv", threejs(), lambda v: f"{v:.9g}")
write("godot.csv", godot(), repr)

# Search for doubles that 128 bits of a power of ten cannot distinguish: there are none.
#
# The product X = x g of src/numbers/shortest_decimal.hpp, without its lowest 64 bits, approximates Y = x 10^p 2^k >= X - x.
# The result is wrong only if X mod M < 2^64 for M the weight of the last bit that matters, and Y is not a multiple of M.
# If g is exact to 64 bits (0 <= p <= 27) nothing is lost, and if |p| <= 18 Y is a fraction with a small denominator,
# which keeps it farther away than that; all other p are searched, by the algorithm of Euclid.
import math
from fractions import Fraction


def first_in(a, m, low, high):
    """The least x >= 0 with low <= a x mod m <= high, or None."""
    if low == 0:
        return 0
    if a == 0:
        return None
    if 2 * a > m:
        a, low, high = m - a, m - high, m - low
    x = -(-low // a)
    if x * a <= high:
        return x
    y = first_in(-m % a, a, low % a, high % a)
    return None if y is None else -(-(low + m * y) // a)


def all_below(a, b, m, bound, last):
    """All x from 0 to last with (a x + b) mod m < bound."""
    found, x = [], 0
    while True:
        offset = (a * x + b) % m
        step = 0 if offset < bound else first_in(a % m, m, m - offset, m - offset + bound - 1)
        if step is None or x + step > last:
            return found
        found.append(x + step)
        x += step + 1


def floor_log2(p):
    return (10**p).bit_length() - 1 if p >= 0 else -((10**-p).bit_length())


def significand(p):
    """10^p as a fraction of 2^(floor(log2 10^p) - 127), and rounded up to 128 bits."""
    exact = Fraction(10) ** p * Fraction(2) ** (127 - floor_log2(p))
    return exact, math.ceil(exact)


def misleading(p, scale, offset, m, bound, last):
    """The x that mislead for X = (x + offset) scale g."""
    exact, g = significand(p)
    a, b = scale * g, int(offset * scale * g)
    if exact == g:  # X = Y, so that only 0 is a multiple
        return all_below(a % m, (b - 1) % m, m, bound - 1, last)
    return [x for x in all_below(a % m, b % m, m, bound, last) if ((x + offset) * scale * exact / m).denominator != 1]


def shortest():
    """The ends of the interval must not seem whole, nor the middle half: 70 bits after the point."""
    for q in range(-1074, 972):
        p = -((q * 1262611) >> 22)
        assert 1 <= Fraction(2) ** q * Fraction(10) ** p < 10
        if abs(p) <= 18:
            continue
        scale = 2 ** (q + floor_log2(p) + 1)
        yield from misleading(p, scale, Fraction(1, 2), 2**128, 2**58, 2**53)
        yield from misleading(p, scale, 0, 2**127, 2**58, 2**53)


def rounded():
    """No m 2^q 10^p below 2^60 may seem half."""
    for q in range(-1074, 972):
        for p in range(-308, 341):
            unit = q + floor_log2(p)
            if -54 <= unit <= 8 and not -18 <= p <= 27:
                yield from misleading(p, 1, 0, 2 ** (126 - unit), 2**53, 2**53)


for search in shortest, rounded:
    assert list(search()) == [], search.__doc__
    print(search.__name__, "is proved")

#!/bin/sh
# A test of a program that prints samples, here a few lines of awk: its rows, at times of its own, are compared.
set -eu
LC_ALL=C awk -F, '
  NR > 1 { t[n] = $1; p[n] = $2; T[n] = $4; C[n] = $5; B[n] = $6; ++n }
  function slope(i) { return i < 0 || i > n - 2 ? 0 : (p[i + 1] - p[i]) / (t[i + 1] - t[i]) }
  function tangent(i, side) {
    return (1 - T[i]) / 2 * ((1 + side * C[i]) * (1 + B[i]) * slope(i - 1) + (1 - side * C[i]) * (1 - B[i]) * slope(i))
  }
  END {
    print "time,x"
    for (j = 0; j <= 60; ++j) {
      time = j / 10
      while (k < n - 2 && t[k + 1] <= time) ++k
      h = t[k + 1] - t[k]; u = (time - t[k]) / h
      m0 = h * tangent(k, 1); m1 = h * tangent(k + 1, -1); d = p[k + 1] - p[k]
      printf "%.1f,%.12f\n", time, p[k] + u * (m0 + u * (3 * d - 2 * m0 - m1 + u * (m0 + m1 - 2 * d)))
    }
  }' keys.csv >mine.csv
tcbsample --check mine.csv --preset gte --abs 1e-12 --columns position=x keys.csv

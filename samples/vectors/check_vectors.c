/* Tests the spline in value() with keys.csv and presets/gte.csv; put yours in its place. Exit 1: an error is too large.
   Build: cc -o check_vectors check_vectors.c -lm */
#include <math.h>
#include <stdio.h>
#include <string.h>

struct key { double t, tension, continuity, bias, x[3]; };

static double slope(const struct key* k, int last, int closed, int i, int c) { /* 0 beyond the ends of an open curve */
  if (i < 0 || i >= last) return closed ? slope(k, last, 0, (i + last) % last, c) : 0;
  return (k[i + 1].x[c] - k[i].x[c]) / (k[i + 1].t - k[i].t);
}
static double velocity(const struct key* k, int last, int closed, int i, int side, int c) { /* side 1: out of a key */
  double before = (1 + side * k[i].continuity) * (1 + k[i].bias) * slope(k, last, closed, i - 1, c);
  double after = (1 - side * k[i].continuity) * (1 - k[i].bias) * slope(k, last, closed, i, c);
  return (1 - k[i].tension) / 2 * (before + after);
}
/* The quantity of channel c at time t. Keys 0 to last; in a closed curve the last is the first, a period later. */
static double value(const struct key* k, int last, int closed, const char* quantity, double t, int c) {
  int i = 0, incoming = !strcmp(quantity, "incoming");
  while (i + 1 < last && (incoming ? k[i + 1].t < t : k[i + 1].t <= t)) ++i;
  double out = velocity(k, last, closed, i, 1, c), in = velocity(k, last, closed, i + 1, -1, c);
  if (strcmp(quantity, "position")) return incoming ? in : out;
  double h = k[i + 1].t - k[i].t, u = (t - k[i].t) / h, step = k[i + 1].x[c] - k[i].x[c];
  return k[i].x[c] + u * (h * out + u * (3 * step - h * (2 * out + in) + u * (h * (out + in) - 2 * step)));
}

int main(void) {
  char line[200], name[20], of[20], quantity[20];
  double at, expected, largest = 0;
  int channel, numbers = 0, count, closed, c;
  FILE *vectors = fopen("presets/gte.csv", "r"), *file = fopen("keys.csv", "r");
  while (vectors && file && fgets(line, sizeof line, vectors)) { /* %lf reads also hexadecimal, as in the last column */
    struct key keys[10], k = {0, 0, 0, 0, {0, 0, 0}};
    if (sscanf(line, "%*[^/]/%19[^,],%19[^,],%lf,%d,%*[^,],%lf", name, quantity, &at, &channel, &expected) != 5) continue;
    for (count = closed = 0, rewind(file); fgets(line, sizeof line, file);)
      if (sscanf(line, "%19[^,],%d,%lf,%lf,%lf,%lf,%*f,%*f,%lf,%lf,%lf", of, &c, &k.t, &k.tension, &k.continuity, &k.bias,
                 &k.x[0], &k.x[1], &k.x[2]) > 6 && !strcmp(of, name)) keys[count++] = k, closed = c;
    largest = fmax(largest, fabs(value(keys, count - 1, closed, quantity, at, channel) - expected)), ++numbers;
  }
  printf("%d numbers, largest error %.1g\n", numbers, largest);
  return !(numbers && largest < 1e-13);
}

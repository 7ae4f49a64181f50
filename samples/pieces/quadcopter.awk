# Rows of --emit poly as a duration and eight coefficients of each channel, which files of quadcopters have.
{
  printf "%s", $2
  for (c = 3; c <= NF; c += 4)
    for (k = 0; k < 8; ++k) printf ",%s", k < 4 ? $(c + k) : /\^/ ? substr($c, 1, length($c) - 1) k : 0
  print ""
}

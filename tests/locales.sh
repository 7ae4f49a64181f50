#!/bin/sh
# Runs the cases and the documents' commands where a comma is the decimal mark, and where i is not the small I:
# locales.sh BUILD-FOLDER. Skipped, saying so, where these locales cannot be made.
set -eu
made=$(mktemp -d)
trap 'rm -rf "$made"' EXIT
for locale in de_DE tr_TR; do
  localedef -i $locale -f UTF-8 "$made/$locale.UTF-8" 2>"$made/complaints" || {
    echo "skipped: the locale $locale cannot be made: $(head -1 "$made/complaints")"
    continue
  }
  [ "$(LOCPATH=$made LC_ALL=$locale.UTF-8 locale decimal_point)" = , ]
  LOCPATH=$made LC_ALL=$locale.UTF-8 ctest --test-dir "$1" -R '^(golden|docs)/' -j 2 --output-on-failure --no-tests=error
done

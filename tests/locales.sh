#!/bin/sh
# Runs the cases and the documents' commands in locales with other rules: locales.sh BUILD-FOLDER LOCALE...
#
# In de_DE the decimal mark is a comma; in tr_TR too, and the capital of i is not I. A locale that cannot be made is
# skipped with a message.
set -eu
build=$1
shift
made=$(mktemp -d)
trap 'rm -rf "$made"' EXIT
for locale in "$@"; do
  localedef -i "$locale" -f UTF-8 "$made/$locale.UTF-8" 2>"$made/complaints" || {
    echo "skipped: the locale $locale cannot be created: $(head -1 "$made/complaints")"
    continue
  }
  [ "$(LOCPATH=$made LC_ALL=$locale.UTF-8 locale decimal_point)" = , ]
  LOCPATH=$made LC_ALL=$locale.UTF-8 ctest --test-dir "$build" -R '^(golden|docs)/' -j 2 --output-on-failure --no-tests=error
done

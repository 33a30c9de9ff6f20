#!/bin/sh
# complete.sh LUPDATE ROOT: every string of the sources is translated into every language; else names those that are not.
set -eu
copy=$(mktemp -d)
trap 'rm -rf "$copy"' EXIT
cp "$2"/translations/vignole_*.ts "$copy"
"$2"/translations/update.sh "$1" "$copy" 2>"$copy/said"
# A string whose class lupdate cannot tell is looked for under another name when the program runs, and not found.
if [ -s "$copy/said" ]; then
  cat "$copy/said"
  exit 1
fi
"$2"/translations/untranslated.sh "$copy"

#!/bin/sh
# update.sh LUPDATE FOLDER: brings every vignole_LANG.ts in FOLDER up to date with the sources; run from anywhere.
set -eu
lupdate=$1
folder=$2
root=$(cd "$(dirname "$0")/.." && pwd)
cd "$root"
# File by file and with our root alone to include from: lupdate does not wander off into other libraries' headers.
sources=$(find gui report -name '*.cpp' -o -name '*.h' | sort)
common="-silent -locations none -no-obsolete -I . -source-language en"
files=
for language in es de fr pl zh; do files="$files $folder/vignole_$language.ts"; done
# shellcheck disable=SC2086
"$lupdate" $common $sources -ts $files
# English stands in the sources; only its plurals have to be told.
# shellcheck disable=SC2086
"$lupdate" $common -pluralonly $sources -ts "$folder/vignole_en.ts"

#!/bin/sh
# untranslated.sh [FOLDER]: lists what has no translation yet, as FILE: CONTEXT: SOURCE; fails if there is any.
folder=${1:-$(cd "$(dirname "$0")" && pwd)}
awk '
  /<name>/ { context = $0; gsub(/.*<name>|<\/name>.*/, "", context) }
  /<source>/ { source = $0; gsub(/^ *<source>/, "", source); inside = 1 }
  inside && !/<source>/ { source = source " " $0 }
  /<\/source>/ { inside = 0; gsub(/<\/source>.*/, "", source) }
  /<translation type="unfinished"/ { sub(/.*\//, "", FILENAME); print FILENAME ": " context ": " source; found = 1 }
  END { exit found }' "$folder"/vignole_*.ts

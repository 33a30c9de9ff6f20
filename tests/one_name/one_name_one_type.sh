#!/bin/sh
# Two types of one name in one namespace: the linker merges their functions and the heap breaks, without a word from the
# compiler. Headers whose namespace is a room's own are apart.
cd "$1" || exit 2
twice=$(grep -rLE --include='*.h' '^namespace vignole::' engine calibration report gui cli |
  xargs grep -hE '^(struct|class) [A-Z][A-Za-z0-9]*( final)?( :| \{)' | awk '{print $2}' | sort | uniq -d)
[ -z "$twice" ] && exit 0
for name in $twice; do
  echo "$name is defined twice:" $(grep -rlE --include='*.h' "^(struct|class) $name( final)?( :| \{)" engine calibration report gui cli)
done
exit 1

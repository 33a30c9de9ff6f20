#!/usr/bin/env bash
# Installs what is missing, builds, and runs the main job: with a display the HMI on the virtual rig, without one a
# rail through `vignole-cli inspect`, with a table here and a PDF and a picture in out/.
set -u
root=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
. "$root/setup/prepare.sh"

install tools engine archive calibration camera cli hmi
build release -DVIGNOLE_TESTS=OFF  # GoogleTest is not needed to run
if [ -n "${DISPLAY:-}${WAYLAND_DISPLAY:-}" ]; then
  exec "$root/build/release/bin/vignole" "$@"
fi
mkdir -p "$root/out"
"$root/build/release/bin/vignole-cli" inspect --report "$root/out/rail.pdf" --report "$root/out/rail.png" "$@"
status=$?
[ $status -le 1 ] && say "Report: out/rail.pdf   Picture: out/rail.png   (no display: the HMI opens where there is one)"
exit $status

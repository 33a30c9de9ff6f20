#!/usr/bin/env bash
# Installs what is missing, builds and passes the tests. Without arguments the everyday preset (dev, warnings are
# errors); with arguments those presets: dev, engine (without Qt), asan, tsan.
set -u
root=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
. "$root/setup/prepare.sh"

install tools engine cli hmi test
for preset in "${@:-dev}"; do
  build "$preset"
  cd "$root" || exit 3
  ctest --preset "$preset" -j "$(nproc)" --progress || exit 1
done

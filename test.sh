#!/usr/bin/env bash
# Installs what is missing, builds and passes the tests. Without arguments the everyday preset (dev, warnings are
# errors); with arguments those presets: dev, engine (without Qt), release, asan, tsan.
set -u
root=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
. "$root/setup/prepare.sh"

# runTests PRESET: progress on a terminal, failures in full, the whole story in build/PRESET-tests.log.
runTests() {
  local log="$root/build/$1-tests.log" started=$SECONDS status
  ctest --preset "$1" -j "$(nproc)" 2>&1 | tee "$log" | while IFS= read -r line; do
    [ -t 2 ] && [[ $line =~ ^\ *([0-9]+/[0-9]+)\ Test ]] && printf '\r\033[KTesting (%s) %s' "$1" "${BASH_REMATCH[1]}" >&2
  done
  status=${PIPESTATUS[0]}
  [ -t 2 ] && printf '\r\033[K' >&2
  if [ "$status" -ne 0 ]; then
    sed -n -e '/\*\*\*/,/^ *Start/p' -e '/FAILED/p' "$log" | head -n 80
    say "Tests failed ($1); the whole story is in build/$1-tests.log"
    return 1
  fi
  say "$(grep -E 'tests passed' "$log") ($1, $((SECONDS - started)) s)"
}

install tools engine archive calibration camera cli hmi test
for preset in "${@:-dev}"; do
  build "$preset"
  cd "$root" || exit 3
  runTests "$preset" || exit 1
done

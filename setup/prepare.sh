# Sourced by run.sh and test.sh: installs what is missing, configures and builds one preset. Quiet, with progress.
# Needs: $root, the top of the checkout.

say() { printf '%s\n' "$*" >&2; }

# install GROUP...: the groups of setup/packages.txt; says what it is about to install, asks for nothing but the sudo password.
install() {
  local group missing=()
  for group in "$@"; do
    local package
    for package in $(sed -n "s/^$group: //p" "$root/setup/packages.txt"); do
      [ "$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null)" = installed ] || missing+=("$package")
    done
  done
  [ ${#missing[@]} -eq 0 ] && return 0
  local sudo=()
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null || { say "These Debian packages are missing, and there is no sudo to install them with; as root:"
      say "  apt-get install --no-install-recommends ${missing[*]}"; exit 3; }
    sudo=(sudo)
  fi
  say "Installing ${#missing[@]} Debian packages and what they need: ${missing[*]}"
  mkdir -p "$root/build"
  local log="$root/build/install.log"
  if ! { "${sudo[@]}" apt-get update -q && "${sudo[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -qy \
      --no-install-recommends "${missing[@]}"; } >"$log" 2>&1 </dev/null; then
    tail -n 5 "$log" >&2
    say "The packages could not be installed; the whole story is in build/install.log"
    exit 3
  fi
}

# build PRESET [cmake options]: configure and build; one line of progress on a terminal, the log in build/PRESET.log.
build() {
  local preset=$1 log="$root/build/$1.log" started=$SECONDS
  shift
  mkdir -p "$root/build"
  cd "$root" || exit 3
  if ! cmake --preset "$preset" "$@" >"$log" 2>&1; then
    tail -n 20 "$log" >&2
    say "Configuring failed; the whole story is in build/$preset.log"
    exit 3
  fi
  [ -t 2 ] || say "Building ($preset) ..."
  cmake --build --preset "$preset" 2>&1 | tee -a "$log" | while IFS= read -r line; do
    [ -t 2 ] && [[ $line == \[* ]] && printf '\r\033[KBuilding (%s) %s' "$preset" "${line%%]*}]" >&2
  done
  local status=${PIPESTATUS[0]}
  [ -t 2 ] && printf '\r\033[K' >&2
  if [ "$status" -ne 0 ]; then
    grep -E -A8 'error|FAILED' "$log" | head -n 40 >&2
    say "The build failed; the whole story is in build/$preset.log"
    exit 3
  fi
  local took=$((SECONDS - started))
  [ $took -gt 5 ] && say "Built ($preset) in $took s"
  return 0
}

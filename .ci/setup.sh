#!/usr/bin/env bash
# Installs missing Debian packages, with sudo when not root.
# Usage: setup.sh [tests] [checks] [fuzz] [peers]
# The packages that build the libraries and the command are always included; `tests`, `checks`,
# `fuzz` (libFuzzer) and `peers` (the benchmark against other solvers) add their own.
set -euo pipefail

packages=(g++ cmake ninja-build pkg-config libeigen3-dev libbullet-dev libbullet-extras-dev libcli11-dev
          nlohmann-json3-dev libosmesa6-dev libfreetype-dev libpng-dev libcairo2-dev fonts-dejavu-core
          gnuplot-nox ffmpeg)
for group in "$@"; do
  case "$group" in
    tests) packages+=(libgtest-dev libgmock-dev) ;;
    checks) packages+=(clang-format clang-tidy python3 valgrind) ;;
    fuzz) packages+=(clang libclang-rt-14-dev) ;;
    peers) packages+=(libsiconos-numerics-dev) ;;
    *) echo "setup.sh: no group '$group'; there are tests, checks, fuzz and peers" >&2; exit 2 ;;
  esac
done

missing=()
for package in "${packages[@]}"; do
  dpkg-query -W -f '${Status}' "$package" 2>/dev/null | grep -q '^install ok installed' || missing+=("$package")
done
if [ ${#missing[@]} -eq 0 ]; then
  echo "== set-up: all ${#packages[@]} packages are there"
  exit 0
fi

echo "== set-up: installing ${missing[*]}"
as_root=()
if [ "$(id -u)" -ne 0 ]; then
  command -v sudo >/dev/null || { echo "setup.sh: not root and no sudo: install ${missing[*]}" >&2; exit 1; }
  as_root=(sudo)
fi
log=$(mktemp)
trap 'rm -f "$log"' EXIT
# Quiet unless it fails.
run() {
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive "$@" >"$log" 2>&1 || { cat "$log" >&2; return 1; }
}
run apt-get update
run apt-get install -y --no-install-recommends "${missing[@]}"

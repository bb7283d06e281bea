#!/usr/bin/env bash
# Installs the build given as argument into a temporary prefix. Builds the project beside this
# script against it, outside the tree: with find_package(delassus), with pkg-config, and once with
# the precisions mixed, which must not link.
set -euo pipefail
build=$(realpath "$1")
export CMAKE_GENERATOR=Ninja  # a bare Debian has no make
here=$(dirname "$(realpath "${BASH_SOURCE[0]}")")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

cmake --install "$build" --prefix "$work/first" >/dev/null
# An installed tree may be moved.
mv "$work/first" "$work/prefix"
cp -r "$here" "$work/consumer"
cd "$work"

cmake -S consumer -B build -DCMAKE_BUILD_TYPE=Debug -DCMAKE_PREFIX_PATH="$work/prefix" --log-level=WARNING
cmake --build build
for program in consumer_core consumer_float consumer_float64; do
  "build/$program" || { echo "find_package: $program failed" >&2; exit 1; }
done

# Every installed header finds all that it includes.
(cd prefix/include && find delassus bullet_ext -name '*.h' | sort) | sed 's/.*/#include "&"/' >consumer/box_with_all.cpp
cat consumer/box.cpp >>consumer/box_with_all.cpp

PKG_CONFIG_PATH=$(dirname "$(find "$work/prefix" -name delassus-bullet.pc)")
export PKG_CONFIG_PATH
for module in delassus-bullet delassus-bullet-float64; do
  # shellcheck disable=SC2046 # the flags are words
  g++ -std=c++17 consumer/box_with_all.cpp $(pkg-config --cflags --libs "$module") -o "$module"
  "./$module" || { echo "pkg-config: $module failed" >&2; exit 1; }
done

# The library in one precision, Bullet in the other.
# shellcheck disable=SC2046
if g++ -std=c++17 consumer/box.cpp -Iprefix/include $(pkg-config --cflags bullet eigen3) \
    $(pkg-config --libs delassus-bullet-float64) -o mixed 2>mixed.log; then
  echo "float headers linked with the float64 libraries" >&2
  exit 1
fi
grep -q 'undefined reference' mixed.log || { cat mixed.log >&2; exit 1; }

if grep -qE '^DELASSUS_DEMOS:BOOL=(ON|TRUE|YES|1)$' "$build/CMakeCache.txt"; then
  for command in delassus delassus-float32; do
    "$work/prefix/bin/$command" --help >/dev/null || { echo "bin/$command is missing or fails" >&2; exit 1; }
  done
fi
echo "installed, found and used in both precisions; a mix does not link"

#!/usr/bin/env bash
# Parts that are left out of the build need no dependencies. Each option is configured on its own,
# in an environment that lacks the dependencies of the part that it leaves out. The argument is the
# source tree.
set -euo pipefail
source=$(realpath "$1")
export CMAKE_GENERATOR=Ninja  # a bare Debian has no make
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# Limits pkg-config to the named modules.
only_modules() {
  rm -rf "$work/modules"
  mkdir "$work/modules"
  for module in "$@"; do
    cp "$(pkg-config --variable=pcfiledir "$module")/$module.pc" "$work/modules"
  done
  export PKG_CONFIG_LIBDIR=$work/modules
}

# configures NAME PACKAGES -DOPTION=...: fails unless the build configures without these packages.
configures() {
  local name=$1 hidden=() package
  for package in $2; do hidden+=("-DCMAKE_DISABLE_FIND_PACKAGE_$package=TRUE"); done
  cmake -S "$source" -B "$work/$name" -DCMAKE_BUILD_TYPE=Release --log-level=ERROR "${hidden[@]}" "${@:3}" \
    >"$work/log" 2>&1 || { echo "$name does not configure:" >&2; cat "$work/log" >&2; exit 1; }
}

all=$(pkg-config --list-all | cut -d' ' -f1)
only_modules bullet bullet-float64
configures no_demos "CLI11 nlohmann_json" -DDELASSUS_DEMOS=OFF
configures no_render "" -DDELASSUS_RENDER=OFF
configures no_multibody "" -DDELASSUS_MULTIBODY=OFF -DDELASSUS_RENDER=OFF
unset PKG_CONFIG_LIBDIR
if grep -qx osmesa <<<"$all"; then configures no_tests "GTest" -DDELASSUS_TESTS=OFF; fi
for precision in float double; do
  unset PKG_CONFIG_LIBDIR
  only_modules "$([ $precision = float ] && echo bullet || echo bullet-float64)"
  configures "$precision" "GTest CLI11 nlohmann_json" -DDELASSUS_PRECISIONS=$precision -DDELASSUS_DEMOS=OFF \
    -DDELASSUS_RENDER=OFF -DDELASSUS_TESTS=OFF
done
only_modules
configures core "PkgConfig GTest CLI11 nlohmann_json" -DDELASSUS_BULLET=OFF -DDELASSUS_MULTIBODY=OFF \
  -DDELASSUS_DEMOS=OFF -DDELASSUS_RENDER=OFF -DDELASSUS_TESTS=OFF

# Without the solver for articulated bodies only the tests named after it are left out: no other
# test may need it.
if grep -lE 'support/multibody_|btDelassusMultiBody' "$source"/tests/bullet_ext/*.cpp | grep -v /multibody_; then
  echo "the tests above need the solver for articulated bodies, and are built without it" >&2
  exit 1
fi

# The check can fail: a part that is asked for but cannot be found is an error.
if (configures lacking "GTest" -DDELASSUS_DEMOS=OFF) 2>/dev/null; then
  echo "tests were configured without GoogleTest" >&2
  exit 1
fi
echo "each option leaves its dependencies out"

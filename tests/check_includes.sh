#!/usr/bin/env bash
# Who may include whom. An arrow points at the included folder; every include without an arrow is
# printed.
#
#   Eigen <-- src/delassus <-- bullet_ext <-- demos/scenes
#   demos/scenes <-- demos/{hello, main, render, atlas, report}
#   (src/delassus also sets the processor's control word: xmmintrin.h)
#   demos/process <-- demos/{main, report}; it knows only the system
#   {atlas, report, render} do not include each other
#
# Tests may include everything; nothing includes tests.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

standard='<[a-z_0-9]+>'
core="$standard|<xmmintrin\.h>|<Eigen/[A-Za-z]+>|\"delassus/[a-z_]+\.h\""
bullet='[<"](bt[A-Za-z0-9]+|(LinearMath|BulletCollision|BulletDynamics)/[A-Za-z0-9/]+)\.h[>"]'
door="$core|$bullet|\"bullet_ext/[A-Za-z_]+\.h\""
scenes="$door|<[A-Za-z/]*btBulletWorldImporter\.h>|\"demos/scenes/[a-z0-9_]+\.h\""
pictures='<GL/[a-z]+\.h>|<png\.h>|<ft2build\.h>|<freetype/freetype\.h>'
vectors='<cairo(-svg)?\.h>'
processes="$standard|<sys/[a-z]+\.h>|<(unistd|fcntl|poll|signal)\.h>|\"demos/process/[a-z_]+\.h\""
programs="$scenes|$processes|<(CLI|nlohmann)/[A-Za-z_]+\.(hpp|h)>|<malloc\.h>"

broken=0
# check FILES... -- ALLOWED: prints the includes of FILES that do not match ALLOWED.
check() {
  local allowed="${*: -1}" found
  set -- "${@:1:$#-2}"
  found=$(grep -nHE '^ *# *include' "$@" /dev/null | grep -vE "^[^:]+:[0-9]+: *# *include *($allowed)" || true)
  [ -z "$found" ] || { echo "$found"; broken=1; }
}
shopt -s nullglob globstar
check src/**/*.{h,cpp} -- "$core"
check bullet_ext/**/*.{h,cpp} -- "$door"
check demos/scenes/**/*.{h,cpp} -- "$scenes"
check demos/render/**/*.{h,cpp} -- "$scenes|$pictures|\"demos/render/[a-z_]+\.h\""
check demos/atlas/**/*.{h,cpp} -- "$scenes|$vectors|\"demos/atlas/[a-z_]+\.h\""
check demos/process/**/*.{h,cpp} -- "$processes"
check demos/report/**/*.{h,cpp} -- "$programs|\"demos/(report/(stability/)?)?[a-z_]+\.h\""
check demos/*.{h,cpp} -- "$programs|\"demos/((render|atlas|report|report/stability)/)?[a-z_]+\.h\""

[ "$broken" -eq 0 ] || { echo "the includes above point the wrong way" >&2; exit 1; }
echo "include direction kept"

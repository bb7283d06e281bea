#!/usr/bin/env bash
# Installs what is missing, builds the command in build/, and shows the Delassus solver beside stock Bullet.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

bash .ci/setup.sh
echo "== build: Release, the command alone, in build/"
cmake --preset release -DDELASSUS_TESTS=OFF --log-level=WARNING
cmake --build --preset release --parallel "$(nproc)" --target delassus_command -- --quiet

solvers=delassus,si:10,dantzig:1e-6
echo "== stack_10_heavy_top: a tower of ten boxes, 1 kg each, under 1000 kg"
build/demos/delassus run stack_10_heavy_top --solver "$solvers"
for world in ../shared/worlds/*.bullet; do
  [ -e "$world" ] || continue
  echo "== $(basename "$world")"
  build/demos/delassus run "$world" --solver "$solvers" --seconds 4
done

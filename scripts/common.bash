# Copyright (c) 2026 The Area Projection Transform authors.
#
# This file is part of the Area_projection_transform package.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# Shared by the scripts of this folder: sourced, not run.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

# As many jobs as there are processors and memory for: the heaviest files take up to 2.5 GB each.
number_of_jobs() {
  local processors megabytes limit
  processors=$(nproc 2>/dev/null || echo 1)
  megabytes=$(awk '/^MemAvailable:/ { print int($2 / 1024) }' /proc/meminfo 2>/dev/null || echo 2500)
  limit=$(cat /sys/fs/cgroup/memory.max 2>/dev/null || echo max)
  if [ "$limit" != max ] && [ $((limit / 1048576)) -lt "$megabytes" ]; then
    megabytes=$((limit / 1048576))
  fi
  local fitting=$((megabytes / 2500))
  [ "$fitting" -ge 1 ] || fitting=1
  echo $((fitting < processors ? fitting : processors))
}

# run_quietly WHAT LOG COMMAND…: one line for the terminal, the rest for the log; the end of the log
# too if the command fails.
run_quietly() {
  local what=$1 log=$2 start=$SECONDS
  shift 2
  mkdir -p "$(dirname "$log")"
  printf '%s … ' "$what"
  if "$@" >"$log" 2>&1; then
    echo "done ($((SECONDS - start)) s)"
  else
    local status=$?
    echo "FAILED after $((SECONDS - start)) s; the last lines of $log:"
    tail -n 100 "$log"
    return "$status"
  fi
}

# configure_and_build PRESET [TARGET…]: leaves its logs in build/PRESET. Without targets: all.
configure_and_build() {
  local preset=$1
  shift
  run_quietly "Configuring build/$preset" "$root/build/$preset/configure.log" \
    cmake --preset "$preset"
  run_quietly "Building (log: build/$preset/build.log)" "$root/build/$preset/build.log" \
    cmake --build --preset "$preset" --parallel "$(number_of_jobs)" \
    ${1+--target "$@"}
}

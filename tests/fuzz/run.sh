#!/usr/bin/env bash
# Feeds each reader with changed inputs for a while:   run.sh <build folder> [seconds for each] [input...]
# Starts from tests/corpus, works in <build>/fuzz, and ends with status 1 at the first finding, whose file it names.
set -euo pipefail
build=$1 seconds=${2:-120} inputs=("${@:3}")
here=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd -P)
if ((${#inputs[@]} == 0)); then inputs=(scene configuration case obj ply ies exr image expression table record request); fi
for input in "${inputs[@]}"; do
  work=$build/fuzz/$input
  mkdir -p "$work"
  dictionary=()
  if [[ -e $here/$input.dict ]]; then dictionary=("-dict=$here/$input.dict"); fi
  # New inputs go to the first folder; a finding is a file beside it. A second per input and 1 GB are far too much.
  "$build/orbs-fuzz-$input" "${dictionary[@]}" -max_total_time="$seconds" -max_len=8192 -timeout=10 -rss_limit_mb=2048 \
    -malloc_limit_mb=1024 -artifact_prefix="$work-finding-" -print_final_stats=1 "$work" "$here/../corpus/$input" \
    2>"$work.log" || { tail -n 40 "$work.log" >&2; exit 1; }
  echo "$input: $(grep -E 'number_of_executed_units' "$work.log" | grep -oE '[0-9]+') inputs in $seconds s, no finding"
done

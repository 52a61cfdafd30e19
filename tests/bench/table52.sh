#!/usr/bin/env bash
# Table 5.2 of the thesis from nothing: records the five rooms, reconstructs and annotates every visit, judges all methods.
#   tests/bench/table52.sh AMISS DIR [JOBS [arguments of amiss dataset make...]]
# What DIR has of it already is not made again. About 8 GB; the table is DIR/table/table52.md.
set -euo pipefail
if [ $# -lt 2 ]; then
  echo "table52.sh AMISS DIR [JOBS [arguments of amiss dataset make...]]" >&2
  exit 2
fi
here=$(dirname "$(realpath "$0")") amiss=$(realpath "$1") out=$(realpath -m "$2") jobs=${3:-2}
shift $(($# < 3 ? $# : 3))

"$amiss" dataset make --out "$out/dataset" --no-rawlog -j "$jobs" "$@"
printf '%s\n' "$out"/dataset/recordings/*/*/ | xargs -P "$jobs" -I{} bash "$here/full_room.sh" "$amiss" {} "$out"
"$amiss" evaluate chapter5 "$out/rooms" --methods all --labels forest --out "$out/table" -j "$jobs"

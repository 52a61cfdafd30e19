#!/usr/bin/env bash
# The generality test of 5.3.6: the same recordings by three methods of reconstruction (TSDF of 1 cm, TSDF of 5 mm,
# OctoMap of 1 cm), local verification on each.
#   tests/bench/generality.sh AMISS DIR [JOBS] [ROOM...]
# DIR is the folder of table52.sh: its recordings and its 1 cm rooms are taken where they are there, else made; what is
# there is not made again. All rooms need about 8 GB more; the table is DIR/generality/table/generality.md.
set -euo pipefail
if [ $# -lt 2 ]; then
  echo "generality.sh AMISS DIR [JOBS] [ROOM...]" >&2
  exit 2
fi
here=$(dirname "$(realpath "$0")") amiss=$(realpath "$1") out=$(realpath -m "$2") jobs=${3:-2}
shift $(($# < 3 ? $# : 3))
rooms=("$@")
if [ ${#rooms[@]} -eq 0 ]; then
  rooms=(big_room small_room living_area office_desk kitchen_counter)
fi
"$amiss" dataset make --out "$out/dataset" --no-rawlog -j "$jobs" --rooms "$(IFS=,; echo "${rooms[*]}")"

# reconstructed NAME DIR [arguments of amiss reconstruct...]: the recordings of these rooms, also as chosen/NAME
reconstructed() {
  local name=$1 to=$2 room
  shift 2
  mkdir -p "$out/generality/chosen/$name"
  for room in "${rooms[@]}"; do
    printf '%s\n' "$out/dataset/recordings/$room"/*/ |
      xargs -P "$jobs" -I{} bash "$here/full_room.sh" "$amiss" {} "$to" "$@"
    ln -s "$to/rooms/$room" "$out/generality/chosen/$name/$room"
  done
}
rm -rf "$out/generality/chosen"
reconstructed tsdf_1cm "$out"
reconstructed tsdf_5mm "$out/generality/tsdf_5mm" --voxel 0.005
reconstructed octomap "$out/generality/octomap" --method octomap
cd "$out/generality/chosen"
"$amiss" evaluate reconstructions tsdf_1cm=tsdf_1cm tsdf_5mm=tsdf_5mm octomap=octomap --labels forest \
  --out "$out/generality/table" -j "$jobs"

#!/usr/bin/env bash
# One recording of a visit as a full room in ObChange's layout, with its ground truth; what is there already stays.
#   tests/bench/full_room.sh AMISS RECORDING DIR [arguments of amiss reconstruct...]
# leaves DIR/made/ROOM-SCENE (the reconstruction) and a scene more in DIR/rooms/ROOM.
set -euo pipefail
amiss=$1 recording=${2%/} out=$3
shift 3
scene=$(basename "$recording") room=$(basename "$(dirname "$recording")")
[ -e "$out/rooms/$room/$scene.pcd" ] && exit 0
mkdir -p "$out/made"
rm -rf "$out/made/$room-$scene"
"$amiss" reconstruct "$recording" --out "$out/made/$room-$scene" --quiet "$@"
"$amiss" dataset annotate "$recording" "$out/made/$room-$scene/cloud.ply" --out "$out/rooms"

#!/usr/bin/env bash
# Makes the pictures of the project's README anew, in this folder; needs demens in PATH, ImageMagick and, for the page, chromium.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"
root=$PWD/.. out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT

small() { convert "$1" -trim +repage -bordercolor white -border 8 -resize "$2" +dither -colors 40 -strip "$3"; }

picture() # NAME WIDTH FILE.toml OPTION...
{
    local name=$1 width=$2
    shift 2
    demens try "$@" --picture "$out/$name.png" >/dev/null
    small "$out/$name.png" "$width" "$name.png"
}

picture drum 400x "$root/inputs/drum-quick/campaign.toml" --experiment rpm45 \
    --set contact.mcc_mcc.rolling_friction=0.0493 --set experiment.rpm45.particles=3515
picture heap 400x "$root/inputs/heap/campaign.toml" --experiment cylinder
picture mixer 400x "$root/inputs/two-size-mixer/campaign.toml"

demens new "$root/inputs/sphere-rebound/campaign.toml" --output "$out/rebound.h5" >/dev/null
mpirun -n 2 demens "$out/rebound.h5" >/dev/null
demens report "$out/rebound.h5" --output "$out/rebound.html" >/dev/null
chromium --headless --no-sandbox --disable-gpu --hide-scrollbars --window-size=1100,1750 --screenshot="$out/page.png" \
    "file://$out/rebound.html" 2>/dev/null
small "$out/page.png" 560x page.png

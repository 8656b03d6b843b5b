#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
#
# Recordings by the command line: written, run again, compared, converted, refused.
set -uo pipefail
program=$1
source "$(dirname "$0")/harness.sh"

# What is recorded is run again to the last bit, whatever the scene and the stepper; recording changes nothing.
for scene in wall buggy ragdolls fourbar bridge; do
    for stepper in quick exact; do
        expect 0 record "$scene" -o "$work/$scene.epr" --steps 30 --stepper $stepper --json --quiet
        recorded=$(number energy_end)
        expect 0 replay "$work/$scene.epr" --json --quiet
        has out '"identical": true'
        holds "$(number states_a) == 31 && $(number states_b) == 31"
        expect 0 run "$scene" --steps 30 --stepper $stepper --json --quiet
        [[ $recorded == "$(number energy_end)" ]] || fail "recording $scene changed it"
    done
done
expect 0 run pile --steps 20 --seed 5 --record "$work/five.epr" --record "$work/five.csv" --quiet
expect 0 replay "$work/five.epr"
has out 'the same in all 21 states'
lacks err .
head -n 1 "$work/five.csv" | grep -q '^step,time,body,x,y,z,qw,' || fail 'the table has no line of names'

# Another stepper is no problem: the distances are what was asked for.
expect 0 replay "$work/wall.epr" --stepper quick --json --quiet
has out '"identical": false'
holds "$(number first_step) == 1 && $(number distance_1) > 0"
expect 0 replay "$work/wall.epr" --stepper quick --iterations 40
has out 'farthest body +t = '

# Two recordings that differ: 1, and where.
expect 0 record pile -o "$work/six.epr" --steps 20 --seed 6 --quiet
expect 1 diff "$work/five.epr" "$work/six.epr" --json
holds "$(number first_step) == 0"
expect 0 diff "$work/five.epr" "$work/five.epr"
expect 0 record pile -o "$work/longer.epr" --steps 25 --seed 5 --quiet
expect 1 diff "$work/five.epr" "$work/longer.epr"
has out 'the same in all 21 states that both have'
expect 1 diff "$work/five.epr" "$work/wall.epr"
has out 'cannot be compared'

# Converting loses nothing, and gives the table of --record.
expect 0 convert "$work/five.epr" "$work/again.epr"
expect 0 diff "$work/five.epr" "$work/again.epr"
expect 0 convert "$work/again.epr" "$work/twice.epr"
cmp -s "$work/again.epr" "$work/twice.epr" || fail 'a recording that is read and written differs'
expect 0 convert "$work/five.epr" "$work/table.csv"
cmp -s "$work/five.csv" "$work/table.csv" || fail 'the table of a recording is not that of the run'

expect 0 convert "$work/five.epr" "$work/five.glb" --fps 10
[[ $(head -c 4 "$work/five.glb") == glTF ]] || fail 'the animation is not glTF'
expect 0 run pile --steps 20 --seed 5 --record "$work/run.glb" --fps 10 --quiet
cmp -s "$work/five.glb" "$work/run.glb" || fail 'the animation of a recording is not that of the run'
expect 2 run pile --steps 20 --record "$work/run.glb" --fps 0

# Pages: by the template that EPODE_PAGE names; without one a refusal that says how to get it.
printf '<title>EPODE_TITLE</title><script id="head">EPODE_HEAD</script><script id="data">EPODE_DATA</script>' > "$work/template"
export EPODE_PAGE=$work/template
expect 0 run buggy --steps 20 --html "$work/page" --quiet
has page.html '<title>buggy</title>.*"scene":"buggy".*id="data">[A-Za-z0-9+/]{100,}=*</script>$'
expect 0 record buggy -o "$work/buggy.epr" --steps 20 --quiet
expect 0 convert "$work/buggy.epr" "$work/converted.html"
"$(dirname "$0")/same_page.py" "$work/page.html" "$work/converted.html" || fail 'the page of a recording is not that of the run'
expect 0 run buggy --steps 21 --html "$work/longer" --quiet
! "$(dirname "$0")/same_page.py" "$work/page.html" "$work/longer.html" || fail 'the page of another run is the same'
export EPODE_PAGE=$work/absent
expect 2 run buggy --steps 20 --html "$work/page" --quiet
has err 'no template.*absent.*record/page/build'
unset EPODE_PAGE

# A video: by ffmpeg where it is, else PNG files and a word about it. The same run as without.
code=0
"$program" run buggy --seconds 0.2 --fps 10 --video "$work/run.mp4" --json --quiet > "$work/out" 2> "$work/err" || code=$?
filmed=$(number energy_end)
if [[ $code == 0 ]]; then
    expect 0 run buggy --seconds 0.2 --json --quiet
    [[ $filmed == "$(number energy_end)" ]] || fail 'filming changed the run'
    mkdir "$work/bin"
    PATH=$work/bin expect 0 run buggy --seconds 0.2 --fps 10 --video "$work/still.mp4" --quiet
    has err 'no ffmpeg.*3 pictures.*still-00001.png'
    [[ $(head -c 4 "$work/still-00003.png" | tail -c 3) == PNG && ! -e "$work/still.mp4" ]] || fail 'the pictures are not there'
    if command -v ffmpeg > /dev/null; then
        [[ $(head -c 8 "$work/run.mp4" | tail -c 4) == ftyp ]] || fail 'the video is not an MP4 file'
        expect 1 run buggy --seconds 0.2 --fps 10 --video "$work/absent/run.mp4" --quiet
        has err "absent/run.mp4': No such file or directory"
    fi
else
    has err 'video'
    echo "no video on this machine: $(cat "$work/err")"
fi

# Broken files: 1, and a message with the name.
size=$(wc -c < "$work/five.epr")
head -c $((size / 2)) "$work/five.epr" > "$work/cut.epr"
for command in "replay $work/cut.epr" "diff $work/cut.epr $work/five.epr" "convert $work/cut.epr $work/x.csv"; do
    # shellcheck disable=SC2086
    expect 1 $command
    has err "cut.epr.*breaks off after [0-9]+ whole states.*--partial"
done
expect 0 replay "$work/cut.epr" --partial
has err 'going on with these'
{ head -c 5000 "$work/five.epr"; printf '\xff\xff'; tail -c +5003 "$work/five.epr"; } > "$work/flipped.epr"
expect 1 replay "$work/flipped.epr" --partial
has err 'flipped.epr.*broken at byte'
expect 1 replay "$work/absent.epr"
has err 'absent.epr'
expect 1 replay "$program"
has err 'not a recording'

# One that asks for nonsense under right checksums: two thousand million sweeps a step, or as many as wrap around to few.
for count in 2000000000 4294967297; do
    python3 - "$work/five.epr" $count > "$work/absurd.epr" << 'END'
import struct, sys, zlib
whole = open(sys.argv[1], 'rb').read()
size = struct.unpack('<Q', whole[16:24])[0]
text = lambda s: struct.pack('<I', len(s)) + s
payload = whole[28:28 + size].replace(text(b'iterations') + text(b'0'), text(b'iterations') + text(sys.argv[2].encode()))
head = whole[12:16] + struct.pack('<Q', len(payload))
chunk = head + struct.pack('<I', zlib.crc32(head)) + payload
sys.stdout.buffer.write(whole[:12] + chunk + struct.pack('<I', zlib.crc32(chunk)) + whole[32 + size:])
END
    expect 0 inspect "$work/absurd.epr"
    has out "iterations +$count"
    expect 2 replay "$work/absurd.epr"
    has err 'absurd.epr.*makes no sense'
done

# Wrong usage.
expect 2 record pile
expect 2 record pile -o "$work/x.foo"
has err "x.foo.*\.epr"
expect 2 convert "$work/five.epr" "$work/x.foo"
expect 2 diff "$work/five.epr"
expect 0 inspect "$work/five.epr" --hashes --json
python3 -c 'import json, sys; hashes = json.load(open(sys.argv[1]))["hashes"]; sys.exit(not (len(hashes) > 1 and all(len(h) == 16 for h in hashes)))' \
    "$work/out" || fail 'inspect --hashes --json is not a list of hashes'
expect 2 replay "$work/five.epr" --stepper best
expect 2 replay "$work/five.epr" --iterations 0
expect 1 run pile --steps 2 --record "$work/absent/x.epr"
has err 'absent/x.epr'
if [[ -w /dev/full ]]; then
    ln -s /dev/full "$work/full.epr"
    expect 1 run pile --steps 20 --record "$work/full.epr" --quiet
    has err 'full.epr'
fi

finish

#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
#
# What was captured is run again without the program: with the recorded steppers to the same bits, with another one until
# its bodies part, told by `epode diff` too; what cannot be run again is refused.
#     rerun.sh EPODE CLIENT MACHINE LIBRARY_FOLDER
set -euo pipefail
program=$1 client=$2 machine=$3 libraries=$4
work=$(mktemp -d)
trap 'rm -r "$work"' EXIT
cd "$work"
fail() { echo "FAILED: $*" >&2; cat said err >&2 || true; exit 1; }
captured() { LD_LIBRARY_PATH=$libraries "$program" capture --quiet -o "$@" > /dev/null; }
replayed() { code=0; "$program" replay --quiet --json "$@" > said 2> err || code=$?; }
field() { sed -n 's/^ *"'"$1"'": \(.*[^,]\),*$/\1/p' said; }

captured client.epr -- "$client"
captured machine.epr -- "$machine"
for name in client client-2 machine; do
    replayed $name.epr -o $name-again.epr
    [ $code = 0 ] && [ "$(field identical)" = true ] || fail "$name: run again it is another run"
    cmp <("$program" inspect $name.epr --hashes) <("$program" inspect $name-again.epr --hashes) || fail "$name: hashes"
    echo "$name: $(field states_a) states again, the same bits"
    "$program" diff $name.epr $name-again.epr > said || fail "$name: diff finds a difference"
done

# Other steppers run, answer 0, and part from the recorded run after the first state; diff says where too.
for stepper in exact quick fast hybrid; do
    for name in client machine; do
        replayed $name.epr --stepper $stepper -o other.epr
        [ $code = 0 ] && [ "$(field identical)" = false ] || fail "$name with $stepper: code $code"
        [ "$(field contacts)" = '"found"' ] || fail "contacts were not found again"
        first=$(field first_step) farthest=$(field distance_10)
        code=0
        "$program" diff $name.epr other.epr --json > said || code=$?
        [ $code = 1 ] && [ "$(field first_step)" = "$first" ] && [ "$first" -ge 1 ] || fail "diff says another first step"
        echo "$name with $stepper: parts at state $first, $farthest m apart at the end"
    done
done
# Another stepper on the recorded contacts, and the recorded stepper on found ones.
replayed client.epr --stepper exact --contacts recorded
[ $code = 0 ] && [ "$(field contacts)" = '"recorded"' ] || fail "recorded contacts"
replayed client.epr --contacts found
[ $code = 0 ] || fail "found contacts"

# That is what the program itself does when it is captured with the other stepper, to the same bits: the contacts that
# are found are those that it makes. Such a recording can be run again too.
for stepper in exact quick fast hybrid; do
    captured own.epr --stepper $stepper -- "$client"
    replayed client.epr --stepper $stepper -o other.epr
    "$program" diff own.epr other.epr > said || fail "$stepper: the program goes another way than its recording run again"
    replayed own.epr
    [ $code = 0 ] && [ "$(field identical)" = true ] || fail "captured with $stepper it is not run again"
done

# What the original library did, it does again; ours does nearly the same, which is no fault.
debian=/usr/lib/x86_64-linux-gnu
if [ -e "$debian/libode.so.8" ]; then
    LD_LIBRARY_PATH=$debian "$program" capture -o debian.epr -- "$client" > /dev/null
    LD_LIBRARY_PATH=$debian replayed debian.epr
    [ $code = 0 ] && [ "$(field identical)" = true ] || fail "the original library does not do the same again"
    replayed debian.epr
    [ $code = 0 ] && [ "$(field identical)" = false ] || fail "two libraries have the same bits"
fi

# Ctrl+C in the middle leaves a recording of what has been done.
set -m # in the background of a script SIGINT would be ignored
"$program" replay --quiet machine.epr --stepper quick --iterations 100000 -o stopped.epr > said 2> err &
replaying=$!
sleep 1
kill -INT $replaying
code=0
wait $replaying || code=$?
set +m
[ $code = 130 ] || fail "interrupted: code $code"
grep -q 'interrupted after state [0-9]* of [0-9]*' err && grep -q "'stopped.epr' is whole" err || fail "it is not said where it stopped"
[ "$("$program" inspect stopped.epr --hashes | wc -l)" -lt "$("$program" inspect machine.epr --hashes | wc -l)" ] || fail "it did not stop"

refused() { grep -q "$1" err || fail "it is not said that: $1"; }
captured space.epr -- "$machine" space
replayed space.epr
[ $code = 1 ] || fail "world-managed contacts are not refused"
refused 'dWorldSetContactSpace, which a recording cannot do again'
# A moved callback that only reads is no reason to refuse: the program sees what it sees without the recorder, and its run is
# made again to the last bit. One that changes something in the middle of a step is refused by the name of the call.
LD_LIBRARY_PATH=$libraries "$machine" watch > alone
LD_LIBRARY_PATH=$libraries "$program" capture --quiet -o watch.epr -- "$machine" watch > watched
cmp alone watched || fail "the callback sees something else under the recorder"
[ "$(cat alone)" != 0 ] || fail "the callback was never called"
replayed watch.epr
[ $code = 0 ] && [ "$(field identical)" = true ] || fail "a program whose callback reads is not run again"
captured shove.epr -- "$machine" shove
replayed shove.epr
[ $code = 1 ] || fail "a callback that pushes is not refused"
refused 'dBodyAddForce in a moved callback, which a recording cannot do again'
"$program" record pendulum --seconds 0.1 --quiet -o scene.epr > /dev/null
replayed scene.epr -o scene-again.epr
[ $code = 2 ] || fail "a scene with --output is not refused"
replayed client.epr --stepper slow
[ $code = 2 ] || fail "an unknown stepper is not refused"

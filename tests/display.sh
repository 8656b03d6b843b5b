# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
#
# For tests that drive a program in a window: sourced by them. An X server without screen, and patience. What holds on a
# machine that is slow or busy: keys arrive in the order in which they were sent, however late; so a state is read only
# after a key that was sent last has shown its effect, never after a time. Keys do not repeat (-r): between xdotool's
# press and release more than the delay of repetition may pass.
work=$(mktemp -d)
cd "$work"
server= child=
finish() {
    [ -z "$child" ] || kill "$child" 2> /dev/null || true
    [ -z "$server" ] || kill "$server" 2> /dev/null || true
    rm -rf "$work"
}
trap finish EXIT
fail() { echo "window: $*" >&2; cat out err >&2; exit 1; }
skip() { echo "window: $*"; exit 77; }

# start_display WIDTH HEIGHT: a server of its own, in DISPLAY. Without -noreset it starts again each time that its last client
# leaves, and refuses whoever comes meanwhile: here the program, right after xdotool has asked.
start_display() {
    command -v Xvfb > /dev/null && command -v xdotool > /dev/null || skip "no Xvfb or xdotool"
    exec 3> display.number
    Xvfb -displayfd 3 -screen 0 "$1x$2x24" -nolisten tcp -noreset -r > server.log 2>&1 &
    server=$!
    for _ in $(seq 300); do [ -s display.number ] && break; sleep 0.1; done
    [ -s display.number ] || skip "Xvfb does not start"
    DISPLAY=:$(cat display.number)
    export DISPLAY
    unset WAYLAND_DISPLAY || true
    for _ in $(seq 300); do xdotool getdisplaygeometry > /dev/null 2>&1 && return; sleep 0.1; done
    skip "Xvfb does not answer"
}

# until_true CONDITION: true within a minute, while the program lives, or the test fails.
until_true() {
    local end=$((SECONDS + 60))
    while [ $SECONDS -lt $end ]; do
        if eval "$1"; then return 0; fi
        kill -0 "$child" 2> /dev/null || fail "the program ended while waiting for: $1"
        sleep 0.1
    done
    fail "never came: $1"
}

# find_window NAME: its number, in window.
find_window() {
    window=
    until_true "window=\$(xdotool search --name '$1' 2> /dev/null | head -1); [ -n \"\$window\" ]"
}

# until_key_works KEY CONDITION: the window gets keys: KEY, sent again and again, does something. A window that is not yet
# on the screen cannot have the focus, so this is asked for again too.
until_key_works() {
    until_true "timeout 10 xdotool windowfocus $window > /dev/null 2>&1; xdotool key $1; sleep 1; $2"
}

# until_gone: the program ends by itself, and well.
until_gone() {
    local end=$((SECONDS + 60))
    while kill -0 "$child" 2> /dev/null; do
        [ $SECONDS -lt $end ] || fail "the program does not end"
        sleep 0.1
    done
    wait "$child" || fail "exit code $?"
    child=
}

# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Contestants run in turn on one scene, round by round, and set side by side: what bench/compare and bench/peers share.
A ratio is taken within each round against the first contestant; the median over the rounds counts."""
import json
import os
import subprocess
import sys

import both

COLUMNS = [('contacts', 'contacts', '{:.0f}'), ('penetration_mean', 'pen mean', '{:.2g}'), ('penetration_max', 'pen max', '{:.2g}'),
           ('joint_error_max', 'joint', '{:.2g}'), ('drift_mean', 'drift', '{:.2g}'), ('drift_max', 'drift max', '{:.2g}'),
           ('speed', 'speed', '{:.2g}'),
           ('lost', 'lost', '{}'), ('hits', 'hits', '{}'), ('pairs', 'pairs', '{:.0f}')]


def add_options(made):
    made.add_argument('--only', default='', help='scenes by name or beginning, separated by commas')
    made.add_argument('--rounds', type=int, default=0)
    made.add_argument('--steps', type=int, default=0, help='another length of run')
    made.add_argument('--limit', type=int, default=300, help='seconds one run may take (default 300)')
    made.add_argument('--without', default='', help='contestants to leave out, separated by commas')
    made.add_argument('--save', action='store_true', help='keep the result in bench/results')


def choose(made, options, known):
    """Scenes by --only, S1 to S11 without it; those with a quick setting if quick ones are wanted."""
    wanted = [name for name in options.only.split(',') if name]
    picked = [s for s in known if (any(s['name'] == w or s['name'].startswith(w + '-') for w in wanted) if wanted
                                   else s['name'].startswith('S'))]
    if options.quick:
        picked = [s for s in picked if s['quick_steps']]
    if not picked:
        made.error('no such scene; there are ' + ' '.join(s['name'] for s in known))
    return picked


def scene_words(options, scene):
    return ([scene['name']] + (['--quick'] if options.quick else [])
            + (['--steps', str(options.steps)] if options.steps else []))


def limited(command, seconds, **more):
    """What the command has said as JSON, or the reason why it has not. (A limit on the process's own work was the better
    idea, but under one Linux tells that work in ticks of 4 ms.)"""
    try:
        done = subprocess.run(command, capture_output=True, text=True, check=False, timeout=seconds, **more)
    except subprocess.TimeoutExpired:
        return None, f'not done in {seconds} s'
    try:
        return json.loads(done.stdout.strip().splitlines()[-1]), None
    except (ValueError, IndexError):
        return None, (done.stderr.strip().splitlines() or [f'ended with {done.returncode}'])[-1]


class Contestant:
    """One engine of epode_bench with the libode of a folder."""

    def __init__(self, label, folder, engine, extra=()):
        self.label, self.folder, self.engine, self.extra = label, folder, engine, list(extra)
        self.trouble = None
        self.runs = []

    def run(self, options, scene):
        command = [options.bench, 'run'] + scene_words(options, scene) + ['--engine', self.engine] + self.extra
        if self.runs:  # quality is judged once: equal hashes are equal states
            command.append('--no-quality')
        result, self.trouble = limited(command, options.limit, env=dict(os.environ, LD_LIBRARY_PATH=self.folder))
        if result:
            self.runs.append(result)

    def summary(self):
        last = dict(self.runs[0])
        for key in ('ms', 'ms_median', 'ms_collide', 'ms_solve', 'ms_rest'):
            if key in last:
                last[key] = both.median([r[key] for r in self.runs])
        last['ms_rounds'] = [r['ms'] for r in self.runs]
        last['repeats'] = len({r.get('hash') for r in self.runs}) == 1
        last.pop('ms_steps', None)
        last['version'] = os.path.basename(last['version'])
        return last


def ratio(other, first):
    pairs = zip([r['ms'] for r in other.runs], [r['ms'] for r in first.runs])
    return both.median([a / b for a, b in pairs])


def header():
    return (f'{"":16} {"ms/step":>10} {"collide":>9} {"solve":>9} {"ratio":>7}'
            + ''.join(f' {title:>9}' for _, title, _ in COLUMNS))


def line(contestant, first):
    if not contestant.runs:
        return f'  {contestant.label:14} {contestant.trouble}'
    s = contestant.summary()
    shown = '-' if not first.runs else '' if contestant is first else f'{ratio(contestant, first):.2f}'
    stages = [f'{s[key]:9.4f}' if key in s else ' ' * 9 for key in ('ms_collide', 'ms_solve')]
    cells = [form.format(s[key]) if s.get(key) else '' for key, _, form in COLUMNS]
    note = ('' if s['repeats'] else '  differs from run to run') + ('  NOT FINITE' if s.get('not_finite') else '')
    return (f'  {contestant.label:14} {s["ms"]:10.4f} {stages[0]} {stages[1]} {shown:>7}'
            + ''.join(f' {cell:>9}' for cell in cells) + note)


def hold(options, scene, field):
    """Runs the field on the scene, prints its lines and gives the entry to keep."""
    for number in range(options.rounds):
        for contestant in field:
            if not contestant.trouble:
                print(f'{scene["name"]}: round {number + 1} of {options.rounds}, {contestant.label}'.ljust(60), end='\r',
                      file=sys.stderr)
                contestant.run(options, scene)
    size, steps = (scene['quick_size'], scene['quick_steps']) if options.quick else (scene['size'], scene['steps'])
    print(f'{scene["name"]}: {scene["about"]}, size {size}, {options.steps or steps} steps'.ljust(60))
    for contestant in field:
        print(line(contestant, field[0]), flush=True)
    kept = {c.label: c.summary() for c in field if c.runs}
    for contestant in field[1:]:
        if contestant.runs and field[0].runs:
            kept[contestant.label]['ratio'] = ratio(contestant, field[0])
    kept.update({c.label: {'trouble': c.trouble} for c in field if not c.runs})
    return {'about': scene['about'], 'goal': scene['goal'], 'size': size, 'steps': options.steps or steps,
            'rounds': options.rounds, 'contestants': kept}

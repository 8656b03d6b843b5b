# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""The table of bench/collide --table: our time as a part of the other library's, where both do the same work.

Both are asked first how many contacts each pose has. Poses with as many contacts on both are timed together (touching), and
those with none on both (apart); the least time of all rounds counts, the libraries taking turns."""
import datetime
import sys

import both
import results

SHAPES = {'sphere': 'sphere', 'box': 'box', 'capsule': 'capsule', 'cylinder': 'cylinder', 'plane': 'plane', 'ray': 'ray', 'convex': 'hull20',
          'trimesh': 'mesh', 'terrain': 'ground', 'heightfield': 'field'}
RAYS = {'all hits': 'ray', 'first contact': 'ray-first', 'closest hit': 'ray-closest', 'backface cull': 'ray-cull'}
GROUNDS = ('ground', 'field')
FEW = 0.1  # of the poses that touch on both: a figure from fewer is marked
BEGIN, END = '<!-- bench/collide --write: from here -->\n', '<!-- bench/collide --write: to here -->\n'


def all_pairs():
    """In order; two grounds would lie in each other everywhere, and fields have nothing to say to fields."""
    kinds = list(SHAPES.values())
    pairs = [(a, b) for a in kinds for b in kinds if not (a in GROUNDS and b in GROUNDS)]
    return pairs + [(ray, b) for ray in list(RAYS.values())[1:] for b in kinds if b != 'ray']


def ask(options, folder, lines):
    done = both.run(options, folder, ['pairs', '--listed', '--poses', str(options.poses)], '\n'.join(lines) + '\n')
    if done.returncode:
        sys.exit(f'pairs failed on {folder}: {done.returncode} {done.stderr}')
    return [line.split()[2] for line in done.stdout.splitlines()]


def selections(options, folders):
    """Of each pair those poses that touch with as many contacts, those that do not touch, and the part of the former."""
    pairs = all_pairs()
    counts = [ask(options, folder, [' '.join(pair) for pair in pairs]) for folder in folders]
    chosen = {}
    for pair, ours, other in zip(pairs, *counts):
        alike = list(zip(ours, other))
        touching = sum(a != '0' and b != '0' for a, b in alike)
        same = sum(a == b != '0' for a, b in alike)
        chosen[pair] = (''.join('01'[a == b != '0'] for a, b in alike), ''.join('01'[a == b == '0'] for a, b in alike),
                        same / touching if touching else 0)
    return chosen


def times(options, folders, chosen):
    """The least nanoseconds of both by pair and kind, 0 touching and 1 apart."""
    asked = [(pair, kind) for pair in chosen for kind in (0, 1) if '1' in chosen[pair][kind]]
    lines = [f'{pair[0]} {pair[1]} {chosen[pair][kind]}' for pair, kind in asked]
    rounds = [[[float(ns) for ns in ask(options, folder, lines)] for folder in folders] for _ in range(options.rounds)]
    return {what: [min(side[k][i] for side in rounds) for k in (0, 1)] for i, what in enumerate(asked)}


def cell(pair, chosen, least):
    def part(kind):
        if (pair, kind) not in least:
            return '-'
        ours, other = least[pair, kind]
        return f'{ours / other:.2f}' + ('*' if kind == 0 and chosen[pair][2] < FEW else '')

    return f'{part(0)} {part(1)}' if pair in chosen else ''


def grid(rows, columns, chosen, least):
    lines = ['| | ' + ' | '.join(columns) + ' |', '|---|' + '---|' * len(columns)]
    for name, kind in rows.items():
        lines.append(f'| {name} | ' + ' | '.join(cell((kind, other), chosen, least) for other in columns.values()) + ' |')
    return lines


def spaces(options, folders):
    rounds = [[both.run(options, folder, ['space-table']).stdout.splitlines() for folder in folders] for _ in range(options.rounds)]
    cells = {}
    for lines in zip(*(side for one in rounds for side in one)):
        words = [line.split() for line in lines]
        same = len({line[3] for line in words}) == 1
        ours, other = (min(float(line[2]) for line in words[k::2]) for k in (0, 1))
        cells[tuple(words[0][:2])] = f'{ours / other:.2f}' if same else 'differ'
    columns = list(dict.fromkeys(column for _, column in cells))
    lines = ['| | ' + ' | '.join(q.replace('-', ' ') for q in columns) + ' |', '|---|' + '---|' * len(columns)]
    for space in dict.fromkeys(space for space, _ in cells):
        lines.append(f'| {space} | ' + ' | '.join(cells[space, column] for column in columns) + ' |')
    return lines


def summary(chosen, least):
    """How many figures there are, how many are above 1, and the worst of them."""
    short = {kind: name for name, kind in {**SHAPES, **RAYS}.items()}
    short['ray'] = 'ray'
    parts = sorted(((ours / other, pair, kind) for (pair, kind), (ours, other) in least.items()), reverse=True)
    slower = [part for part in parts if part[0] > 1]
    worst = ', '.join(f'{short[a]}-{short[b]} {"apart " if kind else ""}{ratio:.2f}' for ratio, (a, b), kind in slower[:8])
    return f'{len(parts)} figures, {len(slower)} above 1, {len([p for p in slower if p[0] > 1.1])} above 1.1; the worst: {worst}.'


def make(options):
    folders = options.ours, options.other
    chosen = selections(options, folders)
    least = times(options, folders, chosen)
    columns = {name: kind for name, kind in SHAPES.items() if kind != 'ray'}
    lines = [f'Our time as a part of Debian\'s, {results.commit()}, {datetime.date.today()}, {results.processor()}: touching, then apart. {summary(chosen, least)}', '']
    lines += grid(SHAPES, SHAPES, chosen, least)
    lines += ['', 'Rays, by what is asked of them:', ''] + grid(RAYS, columns, chosen, least)
    lines += ['', 'Spaces of boxes:', ''] + spaces(options, folders)
    text = '\n'.join(lines) + '\n'
    print(text)
    if options.write:
        write(text)
    return 0


def write(text):
    path = both.ROOT + '/docs/collision.md'
    with open(path) as file:
        whole = file.read()
    before, rest = whole.split(BEGIN)
    with open(path, 'w') as file:
        file.write(before + BEGIN + text + END + rest.split(END)[1])

# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Few words of SVG, and one kind of picture: rows of dots on a logarithmic axis."""
import math

GRID, TEXT = '#dddddd', '#333333'
COLOURS = {'ours': '#1f6fb2', 'debian': '#c0504d', 'bullet': '#7a5ba8', 'box3d': '#c0504d', 'rapier': '#d98c21',
           'mujoco': '#4f9d5d', 'jolt (wasm)': '#888888', 'managed': '#14446e'}


def line(x1, y1, x2, y2, colour, extra=''):
    return f'<line x1="{x1:.1f}" y1="{y1:.1f}" x2="{x2:.1f}" y2="{y2:.1f}" stroke="{colour}" {extra}/>'


def text(x, y, words, anchor='start', size=12, colour=TEXT):
    return f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}" font-size="{size}" fill="{colour}">{words}</text>'


def dot(x, y, colour, filled, words):
    fill = colour if filled else 'white'
    return (f'<circle cx="{x:.1f}" cy="{y:.1f}" r="5" fill="{fill}" stroke="{colour}" stroke-width="1.8">'
            f'<title>{words}</title></circle>')


def write(path, width, height, parts):
    body = '\n'.join(parts)
    with open(path, 'w') as out:
        out.write(f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" font-family="sans-serif">\n'
                  f'<rect width="{width}" height="{height}" fill="white"/>\n{body}\n</svg>\n')


def power(k):
    return f'{10 ** k:,}' if k >= 0 else f'{10 ** k:g}'


def dot_rows(path, title, rows, names, goals=None, unit='', one=None):
    """rows: (label, {series: value}); names: series to words; goals: by label; one: what the line at 1 means."""
    width, left, right, top, step = 760, 130, 30, 66, 24
    values = [v for _, row in rows for v in row.values() if v > 0] + [v for v in (goals or {}).values() if v]
    low, high = math.floor(math.log10(min(values))), math.ceil(math.log10(max(values)))
    high = max(high, low + 1)
    bottom = top + step * len(rows)

    def place(value):
        return left + (math.log10(value) - low) / (high - low) * (width - left - right)

    parts = [text(12, 20, title, size=14)]
    at = 12
    for series, words in names.items():
        parts += [dot(at + 6, 40, COLOURS[series], series == 'ours', words), text(at + 18, 44, words)]
        at += 30 + 7 * len(words)
    for k in range(low, high + 1):
        x = place(10 ** k)
        parts += [line(x, top - 8, x, bottom, GRID), text(x, bottom + 16, power(k) + unit, 'middle', 11)]
    if one and low <= 0 <= high:
        parts += [line(place(1), top - 8, place(1), bottom, '#999999', 'stroke-dasharray="4 3"'),
                  text(place(1), bottom + 31, one, 'middle', 11, '#777777')]
    for number, (label, row) in enumerate(rows):
        y = top + step * (number + 0.5)
        parts.append(text(left - 10, y + 4, label, 'end'))
        goal = (goals or {}).get(label)
        if goal:
            parts.append(line(place(goal), y - 8, place(goal), y + 8, '#2e8b57', 'stroke-width="2.5"'))
        for series in reversed([s for s in names if row.get(s, 0) > 0]):
            parts.append(dot(place(row[series]), y, COLOURS[series], series == 'ours',
                             f'{label}, {names[series]}: {row[series]:.3g}{unit}'))
    if goals:
        parts += [line(at + 6, 32, at + 6, 48, '#2e8b57', 'stroke-width="2.5"'), text(at + 14, 44, 'goal of ours')]
    write(path, width, bottom + 44, parts)

# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""The list of benchmark scenes, and results kept as JSON by processor: bench/results/CPU/NAME.json, an entry a scene.
Runs of single scenes replace their entries; each says when, of which commit, and how busy the machine was."""
import datetime
import json
import os
import platform
import re
import subprocess

import both

FOLDER = both.ROOT + '/bench/results'


def scenes(options):
    return [json.loads(line) for line in both.run(options, options.ours, ['scenes']).stdout.splitlines()]


def processor():
    """The processor's name as a folder's, with family and model where /proc/cpuinfo has them: virtual machines shorten the name
    until two generations share it."""
    fields = {}
    if os.path.exists('/proc/cpuinfo'):
        for line in open('/proc/cpuinfo'):
            key, _, value = line.partition(':')
            fields.setdefault(key.strip(), value.strip())
    words = [fields.get('model name') or platform.processor() or platform.machine(), fields.get('cpu family', ''), fields.get('model', '')]
    return re.sub(r'[^a-z0-9]+', '-', ' '.join(words).lower()).strip('-')


def commit():
    def git(*words):
        return subprocess.run(['git', '-C', both.ROOT, *words], capture_output=True, text=True, check=False).stdout.strip()

    # What this very run has saved is no change of what it measures.
    changed = git('status', '--porcelain', '--untracked-files=no', '--', '.', ':!bench/results', ':!docs')
    described = git('describe', '--always')
    return (described + '-dirty' if changed else described) or 'unknown'


def load(name, folder=None):
    path = f'{folder or FOLDER + "/" + processor()}/{name}.json'
    return json.load(open(path)) if os.path.exists(path) else {}


def save(name, measured):
    """Puts entries by scene into the file; its path."""
    folder = f'{FOLDER}/{processor()}'
    os.makedirs(folder, exist_ok=True)
    kept = load(name)
    stamp = {'commit': commit(), 'when': datetime.datetime.now().strftime('%Y-%m-%d %H:%M'),
             'load': round(os.getloadavg()[0], 1), 'cores': os.cpu_count()}
    for scene, entry in measured.items():
        kept[scene] = {**stamp, **entry}
    path = f'{folder}/{name}.json'
    with open(path, 'w') as out:
        out.write(written(kept))
    return path


def written(kept):
    """JSON with a line a contestant, so that a difference of two states of the file can be read."""
    scenes_text = []
    for scene, entry in kept.items():
        head = {k: v for k, v in entry.items() if k != 'contestants'}
        runs = ',\n'.join(f'   {json.dumps(label)}: {json.dumps(run)}' for label, run in entry['contestants'].items())
        scenes_text.append(f' {json.dumps(scene)}: {json.dumps(head)[:-1]},\n  "contestants": {{\n{runs}}}}}')
    return '{\n' + ',\n'.join(scenes_text) + '\n}\n'

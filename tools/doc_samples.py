#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Compiles and runs every ```c and ```cpp block of README.md and docs/guide; there is no way to leave one out.

A block with `int main` is a whole program. Any other one is the body of a function: its lines that begin with `#`, and
what begins at a line's beginning with `static`, `struct` or `typedef` up to a `}` or `;` there, stand before that
function. A body without dWorldCreate finds a frame around itself: the library is open, `world` has gravity along -z,
`space` is empty, and `body` is a sphere of 1 kg and radius 0.5 m, its centre 2 m above the origin; all is destroyed after it.

What a block prints is what its comments `/* prints: ... */` (in C++ also `// prints: ...`) say, in order, word by word;
it prints nothing else, and nothing to stderr. Blocks with <epode/robots.h> are left out where libepode_robots is not built. Bad and deprecated calls are found by -Werror.

doc_samples.py --library DIR --name ode [--cc CC --cxx CXX -D...] [--show] [FILE...]"""
import argparse
import concurrent.futures
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
FLAGS = ["-O0", "-Wall", "-Wextra", "-Werror", "-Wno-unused-variable", "-Wno-unused-but-set-variable"]
INCLUDES = "".join(f"#include <{name}>\n" for name in ("math.h", "stdio.h", "ode/ode.h", "ode/ext.h"))
OPEN = """    dInitODE2(0);
    dWorldID world = dWorldCreate();
    dWorldSetGravity(world, 0, 0, -9.81);
    dSpaceID space = dHashSpaceCreate(0);
    dBodyID body = dBodyCreate(world);
    dGeomID frame_geom = dCreateSphere(space, 0.5);
    dGeomSetBody(frame_geom, body);
    dBodySetPosition(body, 0, 0, 2);
    { dMass frame_mass; dMassSetSphereTotal(&frame_mass, 1, 0.5); dBodySetMass(body, &frame_mass); }
"""
CLOSE = "    dSpaceDestroy(space);\n    dWorldDestroy(world);\n    dCloseODE();\n"


class Sample:
    def __init__(self, path, line, language, text):
        self.where, self.language, self.text = f"{path}:{line}", language, text
        said = re.findall(r"/\* prints: (.*?)\*/|// prints: ([^\n]*)", text, re.S)
        self.expected = " ".join(a or b for a, b in said).split()

    def source(self, function):
        head = f'extern "C" int {function}(void);\n' if self.language == "cpp" else f"int {function}(void);\n"
        if re.search(r"\bint main\b", self.text):
            return f"#define main {function}\n{head}#line 1 \"{self.where}\"\n{self.text}"
        outside, body = split(self.text)
        framed = "dWorldCreate" not in self.text
        return (f"{INCLUDES}{head}{outside}\nint {function}(void)\n{{\n{OPEN if framed else ''}{body}\n"
                f"{CLOSE if framed else ''}    return 0;\n}}\n")


def split(text):
    """What stands before the function that a body becomes, and the body."""
    outside, body, inside = [], [], False
    for line in text.split("\n"):
        begins = re.match(r"#|(?:static|struct|typedef)\b", line)
        (outside if inside or begins else body).append(line)
        if begins and not line.startswith("#"):
            inside = not (line.rstrip().endswith(";") or line.rstrip().endswith("}"))
        elif inside and re.match(r"\}", line):
            inside = False
    return "\n".join(outside), "\n".join(body)


def samples_of(path):
    text = path.read_text(encoding="utf-8")
    shown = path.relative_to(ROOT) if path.is_relative_to(ROOT) else path
    for block in re.finditer(r"^```(c|cpp)\n(.*?)^```$", text, re.S | re.M):
        yield Sample(shown, text.count("\n", 0, block.start()) + 1, block[1], block[2])


def compiled(sample, number, folder, options):
    source = folder / f"sample{number}.{sample.language}"
    source.write_text(sample.source(f"sample{number}"), encoding="utf-8")
    tool = [options.cc, "-std=c11", "-D_GNU_SOURCE"] if sample.language == "c" else [options.cxx, "-std=c++17"]
    command = tool + FLAGS + [f"-D{d}" for d in options.define] + ["-I", str(ROOT / "include"), "-c", str(source),
                                                                   "-o", str(source) + ".o"]
    done = subprocess.run(command, capture_output=True, text=True)
    return done.stderr if done.returncode else ""


def linked(count, folder, options):
    """One program for all samples: which one runs is its argument."""
    table = "".join(f"int sample{i}(void);\n" for i in range(count))
    cases = "".join(f"    case {i}: return sample{i}();\n" for i in range(count))
    (folder / "run.c").write_text(f"#include <stdlib.h>\n{table}int main(int n, char** a)\n{{\n    switch (n > 1 ? "
                                  f"atoi(a[1]) : -1) {{\n{cases}    default: return 99;\n    }}\n}}\n")
    objects = [str(one) for one in folder.glob("sample*.o")]
    subprocess.run([options.cc, "-c", str(folder / "run.c"), "-o", str(folder / "run.o")], check=True)
    robots = ["-Wl,--as-needed", "-lepode_robots"] if has_robots(options) else []
    subprocess.run([options.cxx, str(folder / "run.o"), *objects, "-o", str(folder / "run"), f"-L{options.library}",
                    *robots, f"-l{options.name}", f"-Wl,-rpath,{options.library}", "-lpthread", "-lm"], check=True)


def has_robots(options):
    return (pathlib.Path(options.library) / "libepode_robots.so").exists()


def judged(sample, number, folder, show):
    done = subprocess.run([str(folder / "run"), str(number)], capture_output=True, text=True, timeout=30)
    if show:
        print(f"{sample.where}:\n{done.stdout}{done.stderr}")
    if done.returncode:
        return f"{sample.where}: ends with {done.returncode}\n{done.stderr}"
    if done.stderr:
        return f"{sample.where}: writes to stderr: {done.stderr}"
    if done.stdout.split() != sample.expected:
        return f"{sample.where}: prints {done.stdout.split()}, and says {sample.expected}"
    return ""


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--library", required=True)
    parser.add_argument("--name", default="ode")
    parser.add_argument("--cc", default="cc")
    parser.add_argument("--cxx", default="c++")
    parser.add_argument("--show", action="store_true")
    parser.add_argument("-D", dest="define", action="append", default=[])
    parser.add_argument("files", nargs="*", type=pathlib.Path)
    options = parser.parse_args()
    files = [one.resolve() for one in options.files] or [ROOT / "README.md", *sorted((ROOT / "docs/guide").rglob("*.md"))]
    samples = [sample for path in files for sample in samples_of(path) if "<epode/" not in sample.text or has_robots(options)]
    with tempfile.TemporaryDirectory() as name, concurrent.futures.ThreadPoolExecutor(2) as pool:
        folder = pathlib.Path(name)
        said = list(pool.map(lambda pair: compiled(pair[1], pair[0], folder, options), enumerate(samples)))
        faults = [f"{sample.where}: does not compile\n{one}" for sample, one in zip(samples, said) if one]
        if not faults:
            linked(len(samples), folder, options)
            faults = [one for one in pool.map(lambda pair: judged(pair[1], pair[0], folder, options.show),
                                              enumerate(samples)) if one]
    print("\n".join(faults))
    print(f"{len(samples)} samples in {len(files)} files, {sum(len(s.expected) > 0 for s in samples)} of them with "
          f"output to compare, {len(faults)} faults")
    return bool(faults) or not samples


if __name__ == "__main__":
    sys.exit(main())

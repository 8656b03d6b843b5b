# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""The public headers as a C compiler sees them, for what is generated from them: the hostile calls (tests/hostile), the Python
package (python/tools) and the Rust crates (rust/tools). Exported functions begin with the word EPODE_EXPORTED."""
import glob
import os
import re
import subprocess


# Headers that others include for their programs, and those of C++, which export nothing.
INCLUDED_BY_OTHERS = r"(collision_trimesh|odemath_legacy|odecpp\w*)\.h$"


# What parameters are, and the numbers of C++ that they become.
HANDLES = {"dWorldID": "World", "dBodyID": "Body", "dJointID": "Joint", "dJointGroupID": "Group",
           "dFluidID": "Fluid", "dHeightfieldDataID": "Heights", "dTriMeshDataID": "Mesh", "dGeomID": "Geom", "dSpaceID": "Space"}
SCALARS = {"dReal": "double", "double": "double", "int": "int", "unsigned": "unsigned", "unsigned int": "unsigned",
           "unsigned long": "unsigned long", "size_t": "size_t", "dsizeint": "size_t", "dJointType": "int"}
FIXED = {"dVector3": 3, "dVector4": 4, "dQuaternion": 4, "dMatrix3": 12, "dMatrix4": 16, "dReal[4]": 4, "dReal[6]": 6}


def preprocessed(include, cc, folders=("ode",)):
    """All headers of these folders, in one line."""
    headers = [h for folder in folders for h in sorted(glob.glob(os.path.join(include, folder, "*.h")))]
    text = "".join(f'#include "{h}"\n' for h in headers if not re.search(INCLUDED_BY_OTHERS, h))
    command = [cc, "-E", "-P", "-x", "c", "-DODE_API=EPODE_EXPORTED", "-I" + include, "-"]
    out = subprocess.run(command, input=text, capture_output=True, text=True, check=True).stdout
    return " ".join(re.sub(r"__attribute__\s*\(\(.*?\)\)", "", out).split())


def split(parameters):
    """The parameters of a function; commas inside a callback's own list do not count."""
    parts, depth, part = [], 0, ""
    for c in parameters + ",":
        if c == "," and depth == 0:
            parts.append(part.strip())
            part = ""
            continue
        depth += (c == "(") - (c == ")")
        part += c
    return [p for p in parts if p not in ("", "void", "...")]


def type_and_name(parameter, index):
    """(type, name) of a parameter; "callback" is the type of a function that is declared in place."""
    callback = re.fullmatch(r"(\w+) ?\( ?\* ?(\w+)\) ?\((.*)\)", parameter)
    if callback:
        return "callback", callback[2]
    whole = re.fullmatch(r"(.*?[ *])(\w+)((?:\[\d*\])?)", parameter)
    bare = parameter.replace("const ", "").strip()
    if not whole or bare in SCALARS or bare in HANDLES:
        return parameter, f"arg{index}"
    return whole[1].strip().replace(" *", "*") + whole[3], whole[2]


def functions(text):
    """(result, name, [(type, name)]) of each exported function."""
    for m in re.finditer(r"EPODE_EXPORTED ([^;{]*?)(\bd[A-Z]\w*) ?\(([^;]*)\);", text):
        yield (m[1].replace("EPODE_EXPORTED", "").strip(), m[2],
               [type_and_name(p, i) for i, p in enumerate(split(m[3]))])


FIELD = re.compile(r"^(const )?(\w+(?: \w+)*?) ?(\*?) ?(\w+)((?:\[\d+\])?)$")


def structures(text):
    """{name: [(type, field)]} of structures whose fields are numbers, vectors, structures and handles."""
    found = {}
    for m in re.finditer(r"struct (?P<tag>d\w+ )?\{(?P<body>[^{}]*)\} ?(?P<name>d\w+)?;", text):
        fields = [FIELD.match(f.strip()) for f in m["body"].split(";") if f.strip()]
        name = m["name"] or (m["tag"] or "").strip()
        if name and all(f and not f[3] for f in fields):
            found[name] = [(f[2], f[4] + f[5] if f[5] and f[2] not in FIXED else f[4]) for f in fields]
    return found


def enumerators(text):
    """The names of all numbers of enumerations."""
    names = []
    for m in re.finditer(r"enum(?: \w+)? ?\{([^{}]*)\}", text):
        names += [re.match(r"\w+", e.strip())[0] for e in m[1].split(",") if e.strip()]
    return [n for n in dict.fromkeys(names) if n.startswith("d")]

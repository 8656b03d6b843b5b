# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""All types of the public headers, for bindings that declare them themselves (rust/tools): handles, types of functions,
enumerations and structures with every field, from the text that c_functions.preprocessed returns; and what the comments
say of them, from the headers as they are written."""
import dataclasses
import glob
import os
import re

import c_functions
import header_docs

OWN = r"d[A-Zx]\w*"  # the names of the interface begin so


@dataclasses.dataclass
class Declared:
    opaque: list  # structures that only the library knows
    names: dict  # typedef of a handle or a number: what it stands for
    callbacks: dict  # type of a function: (result, parameters)
    enums: dict  # name ("" where it has none): enumerators; several without a name are joined
    structures: dict  # name: [(type, field)], the type with the length of an array


def declared(text):
    """What a preprocessed text declares of the interface's own."""
    opaque = [m[1] for m in re.finditer(rf"(?<!typedef )struct ({OWN}) ?;", text)]
    opaque += [m[1] for m in re.finditer(rf"typedef struct ({OWN}) ?\* ?{OWN};", text)]
    names = {m[2]: f"struct {m[1]}*" for m in re.finditer(rf"typedef struct ({OWN}) ?\* ?({OWN});", text)}
    names |= {m[2]: m[1] for m in re.finditer(r"typedef ((?:unsigned|d\w+)) (d\w+);", text)}
    callbacks = {m[2]: (m[1].strip(), c_functions.split(m[3]))
                 for m in re.finditer(rf"typedef ([\w* ]+?)[ (]*\b({OWN})\)?\(([^;]*)\);", text)}
    return Declared(list(dict.fromkeys(opaque)), names, callbacks, _enums(text), _structures(text))


def _enums(text):
    found = {}
    for m in re.finditer(r"enum(?: (?P<tag>\w+))? ?\{(?P<body>[^{}]*)\} ?(?P<name>\w+)?;", text):
        of = [re.match(r"\w+", e.strip())[0] for e in m["body"].split(",") if e.strip()]
        if of[0].startswith("d"):
            found.setdefault(m["name"] or m["tag"] or "", []).extend(of)
    return {name: list(dict.fromkeys(of)) for name, of in found.items()}


def _structures(text):
    found = {}
    for m in re.finditer(rf"struct (?P<tag>{OWN} )?\{{(?P<body>[^{{}}]*)\}} ?(?P<name>{OWN})?;", text):
        name = m["name"] or (m["tag"] or "").strip()
        if name:
            found[name] = [_field(f.strip()) for f in m["body"].split(";") if f.strip()]
    return found


def _field(field):
    function = re.fullmatch(r"(.*?)\( ?\* ?(\w+)\) ?\((.*)\)", field)
    if function:
        return (f"{function[1].strip()} (*)({function[3]})", function[2])
    whole = re.fullmatch(r"(.*?[ *])(\w+)((?:\[\d+\])*)", field)
    return (whole[1].strip().replace(" *", "*") + whole[3], whole[2])


def comments(folder):
    """{name, or structure.field: what its comment says} of the types in the headers of a folder."""
    found = {}
    for path in sorted(glob.glob(os.path.join(folder, "*.h"))):
        with open(path, encoding="utf-8") as f:
            _comments_of(f.read(), found)
    return found


def _comments_of(text, found):
    whole = re.compile(r"(?:/\*\*(?!<)((?:(?!\*/).)*)\*/\s*)?(?:typedef )?(?:struct|enum) ?(\w+)? ?\{(.*?)\n?\}\s*(\w+)?;", re.S)
    for m in whole.finditer(text):
        name = m[4] or m[2] or ""
        if name and m[1]:
            found.setdefault(name, _said(m[1]))
        for part, said in re.findall(r"(\w+)(?:\[\w+\])?(?: ?= ?[^,\n/]+)?[,;]?\s*/\*\*<(.*?)\*/", m[3], re.S):
            found.setdefault(f"{name}.{part}", _said(said))
    for said, name in re.findall(r"/\*\*(?!<)((?:(?!\*/).)*)\*/\s*typedef [^;{]*?\b(d[A-Z]\w*)\)?(?:\([^;]*\))?;", text, re.S):
        found.setdefault(name, _said(said))
    for name, said in re.findall(r"typedef [^;{]*?\b(d\w+)(?:\[\w+\])?;\s*/\*\*<(.*?)\*/", text, re.S):
        found.setdefault(name, _said(said))


def _said(comment):
    text = header_docs.plain("/**" + comment + "*/")
    return re.sub(r"\s*\[(?:guide|0\.16|ours|, )+\]\s*$", "", text)

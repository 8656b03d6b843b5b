# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""The generated part of the safe crate: a method for each function whose first parameter is a world, a body, a joint or a geom, and
values for enumerations and structures. Setters take &mut self and return Result; what only reads takes &self. Everything that a
declaration does not say is in safe_rules.py; a function that is neither known nor left out stops the generator."""
import re

import raw
import safe_rules as rules

OF = {"dWorldID": "world", "dBodyID": "body", "dJointID": "joint", "dGeomID": "geom"}
VIEW = {"world": "World", "body": "Body<'_>", "joint": "Joint<'_>", "geom": "Geom<'_>"}
CHANGED = {"world": "World", "body": "BodyMut<'_>", "joint": "JointMut<'_>", "geom": "GeomMut<'_>"}
IDS = {"dBodyID": ("BodyId", "body"), "dJointID": ("JointId", "joint"), "dGeomID": ("GeomId", "geom")}
PLAIN = {"dReal": "Real", "int": "i32", "unsigned": "u32", "unsigned int": "u32", "unsigned long": "u64", "size_t": "usize",
         "double": "f64", "float": "f32"}
PADDED = {"dVector3": ("Vec3", "pad3", "vec3", 4), "dVector4": ("[Real; 4]", "same", "same", 4), "dQuaternion": ("Quat", "same", "same", 4),
          "dMatrix3": ("Mat3", "pad33", "mat3", 12), "dReal[6]": ("[Real; 6]", "same", "same", 6), "dReal[4]": ("[Real; 4]", "same", "same", 4)}
SPELLED = {"DBall": "Dball", "DHinge": "Dhinge", "AMotor": "Amotor", "LMotor": "Lmotor", "Plane2D": "Plane2d", "AABB": "Aabb", "ERP": "Erp",
           "CFM": "Cfm", "PR": "Pr", "PU": "Pu", "TriMesh": "Mesh", "Heightfield": "Heights"}
USE = ("#![allow(clippy::useless_conversion, clippy::unnecessary_cast, clippy::doc_lazy_continuation, clippy::doc_overindented_list_items)]\n"
       "use crate::prelude::*;\n\n")


class Unknown(Exception):
    """A declaration that no rule covers."""


def matches(patterns, name):
    return any(re.fullmatch(p, name) for p in patterns)


def snake(name):
    for long, short in SPELLED.items():
        name = name.replace(long, short)
    return re.sub(r"(?<=[a-z0-9])(?=[A-Z])", "_", name).lower()


def method_name(name):
    rest = re.sub(r"^d(World|Body|Joint|Geom)", "", name) if not name.startswith("dCharacter") else "Character" + name[10:]
    words = snake(rest)
    of_class = re.match(r"^(\w+?)_(set|get)_(\w+)$", words)
    if of_class and not words.startswith(("set_", "get_")):
        words = f"set_{of_class[1]}_{of_class[3]}" if of_class[2] == "set" else f"{of_class[1]}_{of_class[3]}"
    return words.removeprefix("get_")


class Method:
    """A method of a view, from a C function."""

    def __init__(self, name, result, parameters, api):
        self.name, self.api, self.c_result = name, api, result
        typed = [split_parameter(p, i) for i, p in enumerate(parameters)]
        self.of = OF[typed[0][0]]
        reads = re.search(r"Get|^d\w+?Is[A-Z]|PointDepth|VectorTo|VectorFrom|GetPosRel|ImpulseToForce", name)
        self.changes = not reads
        self.taken, self.before, self.passed, self.outs, self.vectors = [], [], ["self.raw()"], [], []
        self.read_parameters(typed[1:])
        self.result = self.read_result(result)

    def read_parameters(self, typed):
        i = 0
        while i < len(typed):
            names = tuple(n for _, n in typed[i:i + 3])
            if names in rules.VECTORS and all(t == "dReal" for t, _ in typed[i:i + 3]):
                vector = rules.VECTORS[names]
                self.taken.append(f"{vector}: Vec3")
                self.passed += [f"{vector}[{k}]" for k in range(3)]
                self.vectors.append(f"`{vector}` is ({', '.join(names)})")
                i += 3
                continue
            self.read_parameter(*typed[i])
            i += 1

    def read_parameter(self, ctype, name):
        base, rust = ctype.removeprefix("const ").strip(), snake(name)
        kind = next((k for p, k in rules.KINDS.items() if re.fullmatch(p, self.name)), None)
        if base == "int" and kind:
            self.taken.append(f"{rust}: {kind}")
            self.passed.append(f"{rust}.number()")
        elif base == "int" and name == "parameter":
            self.taken.append(f"{rust}: Param")
            self.passed.append(f"{rust}.number()")
        elif base == "int" and name not in ("axis",) and matches(rules.FLAGS, self.name):
            self.taken.append(f"{rust}: bool")
            self.passed.append(f"i32::from({rust})")
        elif base in PLAIN:
            self.taken.append(f"{rust}: {PLAIN[base]}")
            self.passed.append(f"{rust} as _" if base == "unsigned long" else rust)
        elif base in PADDED and ctype.startswith("const "):
            of, pad, _, _ = PADDED[base]
            self.taken.append(f"{rust}: {of}")
            self.before.append(f"let {rust} = {pad}({rust});")
            self.passed.append(f"{rust}.as_ptr()")
        elif base in PADDED:
            of, _, back, size = PADDED[base]
            self.before.append(f"let mut {rust}: [Real; {size}] = [0.0; {size}];")
            self.passed.append(f"{rust}.as_mut_ptr()")
            self.outs.append((of, f"{back}({rust})"))
        elif ctype in ("dReal*", "int*"):
            self.before.append(f"let mut {rust}: {PLAIN[ctype[:-1]]} = Default::default();")
            self.passed.append(f"&mut {rust}")
            self.outs.append((PLAIN[ctype[:-1]], rust))
        elif base.endswith("*") and base[:-1] in rules.STRUCTURES:
            self.structure(base[:-1], rust, ctype.startswith("const "))
        else:
            raise Unknown(f"{self.name}: {ctype} {name}")

    def structure(self, ctype, rust, const):
        of, fills, _ = rules.STRUCTURES[ctype]
        if const:
            self.taken.append(f"{rust}: Option<&{of}>" if ctype in ("dDrive", "dMaterial", "dEventSettings") else f"{rust}: &{of}")
            self.before.append(f"let {rust} = {rust}.map({of}::to_raw);")
            self.passed.append(f"{rust}.as_ref().map_or(std::ptr::null(), std::ptr::from_ref)")
        else:
            self.before.append(f"let mut {rust} = {of}::empty();")
            self.passed.append(f"&mut {rust}")
            self.outs.append((of, f"{of}::from_raw(&{rust}, self.shared())"))

    def read_result(self, ctype):
        kind = next((k for p, k in rules.KINDS.items() if re.fullmatch(p, self.name)), None)
        sets = re.search(r"Set[A-Z]|Add[A-Z]", self.name) and not re.fullmatch(r"dCharacterSetHeight", self.name)
        if matches(rules.OPTIONAL, self.name):
            (of, value), self.outs = self.outs[0], []
            return f"Option<{of}>", f"(r != 0).then(|| {value})"
        if ctype == "void" or ctype == "int" and (sets or self.outs):
            return None
        if ctype == "int" and kind:
            return kind, f"{kind}::of_number(r)"
        if ctype == "int" and matches(rules.FLAGS, self.name):
            return "bool", "r != 0"
        if ctype in PLAIN:
            return PLAIN[ctype], "r as u64" if ctype == "unsigned long" else "r"
        if ctype == "const dReal*":
            of = "Mat3" if "Rotation" in self.name else "Quat" if "Quaternion" in self.name else "Vec3"
            back = {"Mat3": "read_mat3(r)", "Quat": "read_quat(r)", "Vec3": "read_vec3(r)"}[of]
            return of, back
        raise Unknown(f"{self.name}: returns {ctype}")

    def text(self):
        doc = raw.doc(by_value(self.api.docs.get(self.name, "")), "    ")
        extra = "; ".join([f"C: `{self.name}`", *self.vectors])
        results = ([self.result] if self.result else []) + self.outs
        returned = results[0][0] if len(results) == 1 else f"({', '.join(t for t, _ in results)})"
        sure = not self.changes and len(self.taken) == 0 and matches(rules.NEVER_REFUSED, self.name)
        receiver = "&mut self" if self.changes else "&self"
        arguments = ", ".join([receiver, *self.taken])
        values = results[0][1] if len(results) == 1 else f"({', '.join(v for _, v in results)})"
        before = "".join(f"        {line}\n" for line in self.before)
        bound = "let r = " if self.result else ""
        how, wrapped = ("sure", values) if sure else ("call", f"Ok({values})")
        ok = "" if sure else "?"
        kept = returned if sure else f"Result<{returned}>"
        guard = f'        self.finish();\n' if self.name in ("dCharacterMove", "dCharacterWalk") else ""
        cast = "        let r = r as i32;\n" if self.result and self.result[1].endswith("of_number(r)") else ""
        body = (f"        {bound}{how}(|| unsafe {{ sys::{self.name}({', '.join(self.passed)}) }}){ok};\n{guard}{cast}        {wrapped}\n")
        if values == "r" or not results:
            body = f"        {how}(|| unsafe {{ sys::{self.name}({', '.join(self.passed)}) }})\n"
        if not results and self.c_result != "void":
            body = body.replace(" })\n", "; })\n")
        return (f"{doc}    ///\n    /// {extra}.\n    pub fn {method_name(self.name)}({arguments}) -> {kept} {{\n{before}"
                f"{body}    }}\n").replace(" -> ()", "").replace("        ()\n", "")


def by_value(text):
    """The text of a getter, without the pointers that C returns."""
    text = re.sub(r"^A pointer to (the|an?) ", lambda m: m[1].capitalize() + " ", text)
    return re.sub(r"\n*The pointer stays valid[^.]*\.", "", text)


def split_parameter(p, index):
    array = re.fullmatch(r"(\w+) (\w+)(\[\d+\])", p)
    if array:
        return array[1] + array[3], array[2]
    whole = re.fullmatch(r"(.*[ *])(\w+)", p)
    if not whole or p in PLAIN:
        return p, f"arg{index}"
    return whole[1].strip().replace(" *", "*"), whole[2]


def methods(api):
    found, unknown = {kind: ([], []) for kind in VIEW}, []
    for name, (result, parameters) in api.functions.items():
        first = split_parameter(parameters[0], 0)[0] if parameters else None
        mine = re.match(r"d(World|Body|Joint|Geom|Character)[A-Z]", name) and first in OF and name not in api.of_robots
        if not mine or matches(rules.WRITTEN, name) or matches(rules.LEFT_OUT, name):
            continue
        try:
            method = Method(name, result, parameters, api)
            found[method.of][method.changes].append(method)
        except Unknown as e:
            unknown.append(str(e))
    if unknown:
        raise SystemExit("safe.py: see rust/tools/safe_rules.py:\n  " + "\n  ".join(unknown))
    return found


def files(api):
    out = {}
    for kind, (reading, changing) in methods(api).items():
        text = raw.HEAD + USE
        text += f"impl {VIEW[kind]} {{\n" + "\n".join(m.text() for m in reading) + "}\n\n"
        text += f"impl {CHANGED[kind]} {{\n" + "\n".join(m.text() for m in changing) + "}\n"
        out[f"epode/src/generated/{kind}.rs"] = text
    out["epode/src/generated/enums.rs"] = raw.HEAD + "use crate::prelude::*;\n\n" + "\n".join(enum(api, *e) for e in rules.ENUMS)
    out["epode/src/generated/structures.rs"] = raw.HEAD + USE + "\n".join(structure(api, n, *s) for n, s in rules.STRUCTURES.items())
    return out


def enum(api, rust, of, prefix, said):
    names = api.declared.enums[of] if isinstance(of, str) else list(of)
    key = of if isinstance(of, str) else ""
    variants, numbers = "", ""
    for name in names:
        short = name.removeprefix(prefix).removesuffix("Class") or name
        short = "Ode016" if short == "016" else f"V{short}" if short[0].isdigit() else short
        text = api.comments.get(f"{key}.{name}", "") or f"C: {name}."
        variants += raw.doc(text, "    ") + f"    {short} = sys::{name} as isize,\n"
        numbers += f"            {api.numbers[name]} => Self::{short},\n"
        first = first if variants.count(" = sys::") > 1 else short
    doc = raw.doc(said or api.comments.get(of, ""))
    return (f"{doc}#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]\npub enum {rust} {{\n{variants}}}\n"
            f"#[allow(dead_code)]\nimpl {rust} {{\n    pub(crate) fn number(self) -> i32 {{\n        self as i32\n    }}\n"
            f"    pub(crate) fn of_number(number: i32) -> Self {{\n        match number {{\n{numbers}"
            f"            _ => Self::{first},\n        }}\n    }}\n}}\n")


def structure(api, ctype, rust, fills, left_out):
    fields, reads, writes = "", "", ""
    has_size = False
    for kind, name in api.declared.structures[ctype]:
        has_size |= name == "struct_size"
        if name == "struct_size" or name in left_out:
            continue
        of, read, write = field(ctype, kind, name)
        fields += raw.doc(api.comments.get(f"{ctype}.{name}", ""), "    ") + f"    pub {name}: {of},\n"
        reads += f"            {name}: {read},\n"
        writes += f"        raw.{name} = {write};\n" if fills else ""
    doc = raw.doc(api.comments.get(ctype, "") + f"\n\nC: {ctype}.")
    size = f"        raw.struct_size = std::mem::size_of::<sys::{ctype}>() as u32;\n" if has_size else ""
    text = (f"{doc}#[derive(Clone, Debug, PartialEq)]\npub struct {rust} {{\n{fields}}}\n"
            f"#[allow(unused_variables)]\nimpl {rust} {{\n    pub(crate) fn empty() -> sys::{ctype} {{\n"
            f"        // Numbers and null pointers: zeros are a value of every field.\n"
            f"        #[allow(unused_mut)]\n        let mut raw: sys::{ctype} = unsafe {{ std::mem::zeroed() }};\n{size}        raw\n    }}\n"
            f"    pub(crate) fn from_raw(raw: &sys::{ctype}, shared: &Shared) -> Self {{\n        Self {{\n{reads}        }}\n    }}\n")
    if fills:
        init = f"        sure(|| unsafe {{ sys::{ctype}Init(&mut raw, std::mem::size_of::<sys::{ctype}>() as u32) }});\n"
        text += (f"    pub(crate) fn to_raw(&self) -> sys::{ctype} {{\n        let mut raw = Self::empty();\n{writes}        raw\n    }}\n}}\n"
                 f"impl Default for {rust} {{\n    fn default() -> Self {{\n        let mut raw = Self::empty();\n{init}"
                 f"        Self::from_raw(&raw, &Shared::none())\n    }}\n")
    return text + "}\n"


def field(ctype, kind, name):
    """(type in Rust, from C, to C) of a field."""
    key = f"{ctype}.{name}"
    if key in rules.OPTIONAL_FIELDS:
        of = rules.OPTIONAL_FIELDS[key]
        return f"Option<{of}>", f"(raw.{name} != 0).then(|| {of}::of_number(raw.{name} as i32))", ""
    if key in rules.KINDS_OF_FIELDS:
        of = rules.KINDS_OF_FIELDS[key]
        return of, f"{of}::of_number(raw.{name} as i32)", f"self.{name}.number()"
    if key in rules.FLAGS_OF_FIELDS:
        return "bool", f"raw.{name} != 0", f"i32::from(self.{name})"
    if kind in PLAIN:
        return PLAIN[kind], f"raw.{name}", f"self.{name}"
    if kind == "dVector3":
        return "Vec3", f"vec3(raw.{name})", f"pad3(self.{name})"
    if kind in IDS:
        of, what = IDS[kind]
        return f"Option<{of}>", f"shared.{what}_of(raw.{name})", "std::ptr::null_mut()"
    raise Unknown(f"{key}: {kind}")

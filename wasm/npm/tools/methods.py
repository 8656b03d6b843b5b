# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""The JavaScript of one C function: a property where a getter takes nothing but its object, else a method. What a C int means is in
rust/tools/safe_rules.py and package_rules.py; a parameter that neither knows stops the generator."""
import re

import package_rules as rules
import safe_rules

INTEGERS = {"int": "int32", "unsigned": "uint32", "unsigned int": "uint32", "unsigned long": "uint32", "size_t": "uint32"}
FIXED = {"dVector3": ("Vector3", 3), "dVector4": ("Vector4", 4), "dQuaternion": ("Quaternion", 4), "dMatrix3": ("Matrix3", 9),
         "dReal[6]": ("Box6", 6)}
OBJECTS = {"dBodyID": "Body", "dGeomID": "Geom", "dJointID": "Joint"}
STRUCTURES = {**{n: s for n, s in safe_rules.STRUCTURES.items()}, **rules.STRUCTURES}
MAY_BE_NULL = {"dDrive", "dMaterial", "dEventSettings"}  # null: none, or the default


class Unknown(Exception):
    """A declaration that no rule covers."""


def matches(patterns, name):
    return any(re.fullmatch(p, name) for p in patterns)


def kind_of(name):
    return next((k for p, k in safe_rules.KINDS.items() if re.fullmatch(p, name)), None)


def camel(words):
    first, *rest = words.split("_")
    return first + "".join(w[:1].upper() + w[1:] for w in rest)


def decapital(text):
    """A C name in PascalCase as JavaScript begins it: acronyms wholly small, FDir1 and ERP alike."""
    acronym = re.match(r"[A-Z]+(?=[A-Z][a-z]|\d|$)", text)
    return text[:len(acronym[0])].lower() + text[len(acronym[0]):] if acronym else text[:1].lower() + text[1:]


def words(text):
    text = rules.RESTS.get(text, text)
    for short, long in rules.WORDS.items():
        text = re.sub(rf"{short}(?![a-z])", long, text)
    return text


def owner_of(name):
    """(class, verb, rest) of a function: dJointSetHingeAnchor is (Hinge, Set, Anchor)."""
    joint = re.fullmatch(rf"dJoint(Set|Get|Add)({'|'.join(sorted(rules.JOINTS, key=len, reverse=True))})(?![a-z])(\w*)", name)
    if joint:
        return joint[2], joint[1], joint[3]
    geom = re.fullmatch(rf"d(?:Geom)?({'|'.join(rules.GEOMS)})(Set|Get|)(?![a-z])(\w*)", name)
    if geom:
        return geom[1], geom[2], geom[3]
    plain = re.fullmatch(r"d(World|Body|Joint|Geom|Vehicle)(Set|Get|)(?![a-z])(\w+)", name)
    return plain.groups() if plain else None


class Method:
    """One function. `taken` are (name, type of JSDoc, what it is), `results` (type, expression)."""

    def __init__(self, name, result, typed, api):
        self.c, self.text = name, api.docs.get(name, "")
        self.owner, self.verb, self.rest = owner_of(name)
        self.taken, self.before, self.passed, self.results, self.used = [], [], ["this.handle"], [], 0
        self.enums = api.enums
        self.read_parameters(typed[1:])
        returned = self.read_result(result)
        if matches(safe_rules.OPTIONAL, name):
            (of, value), = self.results
            self.results = [(f"{of} | null", f"r ? {value} : null")]
            self.keeps = True
        else:
            self.keeps = returned is not None
            self.results = ([returned] if returned else []) + self.results
        self.name = self.js_name()

    def js_name(self):
        if self.c in rules.RENAMED:
            return rules.RENAMED[self.c]
        rest = words(self.rest)
        if self.verb in ("", "Get") and (self.verb == "Get" and not self.taken or re.match(r"Is[A-Z]", rest)):
            return decapital(rest)
        return decapital(self.verb + rest) if self.verb else decapital(rest)

    def scratch(self, count):
        at = self.used
        self.used += 8 * count
        return f"at + {at}" if at else "at"

    def read_parameters(self, typed):
        i = 0
        while i < len(typed):
            names = tuple(n for _, n in typed[i:i + 3])
            if names in safe_rules.VECTORS and all(t == "dReal" for t, _ in typed[i:i + 3]):
                js = {"xyz": "value", "px": "point"}.get(safe_rules.VECTORS[names], safe_rules.VECTORS[names])
                self.take(js, "VectorLike", f"vector({js}, {self.label(js)})", f"({', '.join(names)})")
                self.passed[-1:] = [f"{js}_[{k}]" for k in range(3)]
                i += 3
                continue
            self.read_parameter(*typed[i])
            i += 1

    def take(self, js, of, checked, what=""):
        self.taken.append((js, of, what))
        self.before.append(f"const {js}_ = {checked};")
        self.passed.append(f"{js}_")

    def label(self, js):
        return f"LABEL, '{js}'"

    def read_parameter(self, ctype, name):
        base, js = ctype.removeprefix("const ").strip(), camel(name)
        js = decapital(js) if js[0].isupper() else js
        const, kind = ctype.startswith("const "), kind_of(self.c)
        if base == "int" and kind:
            self.take(js, kind, f"number_of(enums.{kind}, {js}, {self.label(js)})")
        elif base == "int" and name == "parameter":
            self.take(js, "Parameter", f"number_of(enums.Parameter, {js}, {self.label(js)})")
        elif base == "int" and name not in ("axis", "wheel", "gear") and (matches(safe_rules.FLAGS, self.c) or matches(rules.FLAGS, self.c)):
            self.take(js, "boolean", f"flag({js}, {self.label(js)})")
        elif base in INTEGERS:
            self.take(js, "number", f"{INTEGERS[base]}({js}, {self.label(js)})")
        elif base == "dReal":
            self.take(js, "number", f"real({js}, {self.label(js)})")
        elif base in FIXED and const:
            of, count = FIXED[base]
            of_in = {"Vector3": ("VectorLike", "vector"), "Quaternion": ("QuaternionLike", "quaternion"), "Matrix3": ("MatrixLike", "matrix")}[of]
            at = self.scratch({"Matrix3": 12}.get(of, 4))
            may_be_null = (self.c, name) in rules.NULLABLE
            checked = f"{of_in[1]}({js}, {self.label(js)})"
            checked = f"{js} === null ? null : {checked}" if may_be_null else checked
            self.take(js, of_in[0] + (" | null" if may_be_null else ""), f"e.put_{of_in[1]}({at}, {checked})")
        elif base in FIXED:
            of, count = FIXED[base]
            at = self.scratch({"Matrix3": 12, "Box6": 6}.get(of, 4))
            self.passed.append(at)
            self.results.append((of, self.read_fixed(of, at)))
        elif ctype in ("dReal*", "int*"):
            at = self.scratch(1)
            self.passed.append(at)
            self.results.append(("number", f"e.f64[({at}) >> 3]" if ctype == "dReal*" else f"e.i32[({at}) >> 2]"))
            self.out_names = [*getattr(self, "out_names", []), js]
        elif base.endswith("*") and base[:-1] in STRUCTURES:
            self.structure(base[:-1], js, const)
        elif base in OBJECTS:
            self.take(js, OBJECTS[base], f"e.pointer_to({js}, {self.label(js)})")
        else:
            raise Unknown(f"{self.c}: {ctype} {name}")

    @staticmethod
    def read_fixed(of, at):
        return f"e.matrix({at})" if of == "Matrix3" else f"e.{dict(Vector3='vector', Vector4='four', Quaternion='four', Box6='six')[of]}({at})"

    def structure(self, ctype, js, const):
        of = STRUCTURES[ctype][0]
        at = self.scratch(128)
        if const:
            empty = " | null" if ctype in MAY_BE_NULL else ""
            self.take(js, f"Partial<{of}>{empty}", f"put_structure(e, '{ctype}', {js}, {at}, LABEL)")
        else:
            self.before.append(f"prepare_structure(e, '{ctype}', {at});")
            self.passed.append(at)
            self.results.append((of, f"get_structure(e, '{ctype}', {at})"))

    def read_result(self, ctype):
        kind = kind_of(self.c)
        sets = re.search(r"Set[A-Z]|Add[A-Z]", self.c) and not re.fullmatch(r"dCharacterSetHeight|dVehicleAddWheel", self.c)
        if ctype == "void" or ctype == "int" and (sets or self.results):
            return None
        if ctype == "int" and kind:
            return kind, f"name_of(enums.{kind}, r)"
        if ctype == "int" and (matches(safe_rules.FLAGS, self.c) or matches(rules.FLAGS, self.c)):
            return ("number", "r") if self.c in ("dVehicleUpdate", "dVehicleAddWheel") else ("boolean", "r !== 0")
        if ctype in INTEGERS:
            return "number", "r >>> 0" if INTEGERS[ctype] == "uint32" else "r"
        if ctype == "dReal":
            return "number", "r"
        if ctype == "const dReal*":
            of = "Matrix3" if "Rotation" in self.c else "Quaternion" if "Quaternion" in self.c else "Vector3"
            return of, self.read_fixed(of, "r")
        if ctype in OBJECTS:
            return f"{OBJECTS[ctype]} | null", f"/** @type {{{OBJECTS[ctype]} | null}} */ (e.object_at(r))"
        raise Unknown(f"{self.c}: returns {ctype}")

    def returned(self):
        """(type, expression) of all results together."""
        if len(self.results) <= 1:
            return self.results[0] if self.results else ("void", "")
        names = getattr(self, "out_names", None)
        if names and len(names) == len(self.results):
            return ("{" + ", ".join(f"{n}: {t}" for n, (t, _) in zip(names, self.results)) + "}",
                    "{" + ", ".join(f"{n}: {v}" for n, (_, v) in zip(names, self.results)) + "}")
        return "[" + ", ".join(t for t, _ in self.results) + "]", "[" + ", ".join(v for _, v in self.results) + "]"

    def body(self, label):
        lines = ["const e = this.engine" + (", at = e.base;" if self.used else ";"), *self.before]
        call = f"e.c.{self.c}({', '.join(self.passed)});"
        lines += [f"const r = {call}" if self.keeps else call, f"e.check({label!r});"]
        value = self.returned()[1]
        lines += [f"return {value};"] if value else []
        return "".join(f"        {line}\n" for line in lines).replace("LABEL", repr(label))


def comment(text, tags, indent="    "):
    lines = [*text.replace("*/", "* /").replace("@", "(at)").splitlines(), *tags]
    return f"{indent}/**\n" + "".join(f"{indent} * {line}".rstrip() + "\n" for line in lines) + f"{indent} */\n"

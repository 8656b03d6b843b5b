// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "script.h"

#include <sstream>

namespace epode::sequences {
namespace {

std::string print(const char* format, ...)
{
    char buffer[256];
    va_list arguments;
    va_start(arguments, format);
    std::vsnprintf(buffer, sizeof buffer, format, arguments);
    va_end(arguments);
    return buffer;
}

// The lines of one function's body; of a callback: as cases of its calls.
std::string body_of(const std::string& record, const std::string& function)
{
    std::istringstream lines(record);
    std::string all, line, last;
    while (std::getline(lines, line)) {
        const std::size_t colon = line.find(": ");
        const std::string owner = line.substr(0, colon);
        if (owner.rfind(function, 0) != 0) continue;
        if (owner != function && owner != last) {
            if (!last.empty()) all += "            break;\n";
            all += "        case " + owner.substr(function.size() + 1) + ":\n";
            last = owner;
        }
        all += (owner == function ? "    " : "            ") + line.substr(colon + 2) + "\n";
    }
    return all + (last.empty() ? "" : "            break;\n");
}

std::string callback(const std::string& name, const std::string& arguments, const std::string& record)
{
    return "static int " + name + "_calls;\nstatic void " + name + "(" + arguments + ")\n{\n    switch (" +
           name + "_calls++) {\n" + body_of(record, name) + "        default: break;\n    }\n}\n\n";
}

constexpr const char* kVariables =
    "enum { kRoom = 65536 };\n"
    "static dWorldID w[kRoom];\nstatic dBodyID b[kRoom];\nstatic dJointID j[kRoom];\n"
    "static dJointGroupID g[kRoom];\nstatic dGeomID o[kRoom];\nstatic dHeightfieldDataID f[kRoom];\n"
    "static dTriMeshDataID m[kRoom];\n\n"
    "static void near(void* data, dGeomID o1, dGeomID o2);\nstatic void moved(dBodyID body);\n\n";

}  // namespace

std::string Script::text(double x) { return print(sizeof(dReal) == 4 ? "(dReal)%.9g" : "%.17g", x); }

std::string Script::text(const Four& four)
{
    std::string all;
    for (int i = 0; i < four.count; ++i) all += (i ? ", " : "") + text(double(four.v[i]));
    return "(dReal[]){" + all + "}";
}

void Script::write(const std::string& line)
{
    if (record) std::fprintf(record, "%s: %s\n", open_.back().c_str(), line.c_str());
}

void Script::enter_callback(bool near)
{
    open_.push_back(near ? "near " + std::to_string(near_calls_++)
                         : "moved " + std::to_string(moved_calls_++));
}

std::string Script::program(const std::string& toolbox, const std::string& comment, const std::string& record)
{
    return "/* " + comment + " */\n" + toolbox + "\n" + kVariables +
           callback("near", "void* data, dGeomID o1, dGeomID o2", record) +
           callback("moved", "dBodyID body", record) + "int main(void)\n{\n    dInitODE2(0);\n" +
           body_of(record, "main") + "    dCloseODE();\n    return 0;\n}\n";
}

}  // namespace epode::sequences

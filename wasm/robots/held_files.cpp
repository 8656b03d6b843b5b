// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// robots/files/disk.h for WebAssembly: see held_files.h.
#include "held_files.h"

#include <algorithm>
#include <cstring>
#include <map>
#include <vector>

#include "robots/files/disk.h"

namespace {

std::map<std::string, std::string>& held()
{
    static auto* const its = new std::map<std::string, std::string>;
    return *its;
}

const std::string* find(const std::string& path)
{
    const auto found = held().find(path);
    return found == held().end() ? nullptr : &found->second;
}

}  // namespace

void epode_hold_file(const char* path, const void* bytes, unsigned size)
{
    held()[epode::robots::canonical(path)].assign(static_cast<const char*>(bytes), size);
}

void epode_drop_files() { held().clear(); }

namespace epode::robots {

std::string canonical(const std::string& path)
{
    if (path.empty() || path.size() > 4096 || path.find('\0') != std::string::npos) return {};
    std::vector<std::string> parts;
    for (size_t at = 0; at <= path.size();) {
        const size_t slash = std::min(path.find('/', at), path.size());
        const std::string part = path.substr(at, slash - at);
        at = slash + 1;
        if (part == ".." && !parts.empty()) parts.pop_back();
        if (!part.empty() && part != "." && part != "..") parts.push_back(part);
    }
    std::string whole;
    for (const std::string& part : parts) whole += "/" + part;
    return whole.empty() ? "/" : whole;
}

bool is_file(const std::string& path) { return find(path) != nullptr; }

std::optional<std::uintmax_t> size_of_file(const std::string& path)
{
    const std::string* const its = find(path);
    return its ? std::optional<std::uintmax_t>(its->size()) : std::nullopt;
}

bool read_file(const std::string& path, std::string& text)
{
    const std::string* const its = find(path);
    if (!its || its->size() < text.size()) return false;
    std::memcpy(text.data(), its->data(), text.size());
    return true;
}

}  // namespace epode::robots

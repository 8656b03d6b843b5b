// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See files.h.
#include "robots/files/files.h"

#include <algorithm>
#include <cstdlib>

namespace epode::robots {

namespace {

constexpr int kMaxAncestors = 8;

bool is_inside(const std::string& path, const std::string& root)
{
    if (root == "/") return true;
    return path.size() > root.size() && path.compare(0, root.size(), root) == 0 && path[root.size()] == '/';
}

// A program with other rights than its caller's (set-user-ID) ignores the caller's environment.
const char* environment_value(const char* name)
{
#if defined(__GLIBC__)
    return secure_getenv(name);
#else
    return std::getenv(name);
#endif
}

// Folders of ROS's environment.
std::vector<std::string> environment_paths()
{
    std::vector<std::string> out;
    for (const char* name : {"ROS_PACKAGE_PATH", "AMENT_PREFIX_PATH"}) {
        const char* value = environment_value(name);
        std::string text = value ? value : "";
        while (!text.empty()) {
            const size_t colon = text.find(':');
            const std::string one = text.substr(0, colon);
            if (!one.empty()) out.push_back(one), out.push_back(one + "/share");
            text = colon == std::string::npos ? "" : text.substr(colon + 1);
        }
    }
    return out;
}

}  // namespace

Files::Files(const std::string& path, std::vector<std::string> roots) : named_(std::move(roots))
{
    for (const std::string& root : named_) roots_.push_back(canonical(root));
    const std::string folder = folder_of(canonical(path));
    roots_.push_back(folder);
    const std::string parent = folder_of(folder);
    if (parent != "/") roots_.push_back(parent);
    std::string ancestor = folder;
    for (int i = 0; i < kMaxAncestors && ancestor.size() > 1; ++i, ancestor = folder_of(ancestor))
        if (is_file(ancestor + "/package.xml")) roots_.push_back(ancestor);
    roots_.erase(std::remove(roots_.begin(), roots_.end(), std::string()), roots_.end());
}

bool Files::is_allowed(const std::string& path) const
{
    return std::any_of(roots_.begin(), roots_.end(),
                       [&](const std::string& root) { return is_inside(path, root); });
}

// The file of a package in that folder, "" if it has none.
std::string Files::in_package(const std::string& root, const std::string& inner, std::string& tried) const
{
    const std::string whole = canonical(root + inner);
    if (is_file(whole) && is_inside(whole, canonical(root))) return whole;
    tried += (tried.empty() ? "" : ", ") + root + inner;
    return {};
}

// `rest` is PACKAGE/PATH. The package's folder becomes a root: named ones first, then ROS's, then upwards. A name that
// begins with a dot is none: hidden folders on the way up are nobody's package.
std::string Files::find_package(const std::string& rest, const std::string& folder, std::string& tried)
{
    const size_t slash = rest.find('/');
    const std::string package = rest.substr(0, slash);
    if (slash == std::string::npos || package.empty() || package[0] == '.') return {};
    const std::string inner = rest.substr(slash);
    if (const auto known = packages_.find(package); known != packages_.end())
        if (const std::string whole = in_package(known->second, inner, tried); !whole.empty()) return whole;
    std::vector<std::string> places = named_;
    for (const std::string& root : environment_paths()) places.push_back(root);
    std::string ancestor = canonical(folder);
    for (int i = 0; i < kMaxAncestors && ancestor.size() > 1; ++i, ancestor = folder_of(ancestor))
        places.push_back(ancestor);
    for (const std::string& place : places) {
        const bool is_it = name_of(place) == package;
        for (const std::string& root : {is_it ? place : std::string(), place + "/" + package}) {
            const std::string whole = root.empty() ? "" : in_package(root, inner, tried);
            if (whole.empty()) continue;
            packages_[package] = root;
            roots_.push_back(canonical(root));
            return whole;
        }
    }
    return {};
}

std::string Files::resolve(const std::string& reference, const std::string& folder, std::string& problem)
{
    std::string tried, path = reference;
    for (const char* scheme : {"package://", "model://"}) {
        if (!path.starts_with(scheme)) continue;
        const size_t begin = path.find_first_not_of('/', std::string(scheme).size());
        path = begin == std::string::npos ? "" : find_package(path.substr(begin), folder, tried);
        if (path.empty()) problem = "'" + reference + "' is not to be found; tried: " + tried;
        return path;
    }
    if (path.starts_with("file://")) path = path.substr(7);
    std::vector<std::string> places{path.starts_with("/") ? path : folder + "/" + path};
    if (!path.starts_with("/"))
        for (const std::string& root : named_) places.push_back(root + "/" + path);
    for (const std::string& place : places) {
        const std::string whole = canonical(place);
        if (is_file(whole) && is_allowed(whole)) return whole;
        if (is_file(whole)) tried += " (outside the folders that may be read)";
        tried = place + (tried.empty() ? "" : "; ") + tried;
    }
    problem = "'" + reference + "' is not to be found; tried: " + tried;
    return {};
}

std::optional<std::string> Files::read(const std::string& path, std::string& problem)
{
    const std::string whole = canonical(path);
    if (!is_file(whole)) {
        problem = "'" + path + "' is no file";
        return std::nullopt;
    }
    if (!is_allowed(whole)) {
        problem = "'" + path + "' is outside the folders that may be read";
        return std::nullopt;
    }
    const auto size = size_of_file(whole);
    if (!size || *size > kMaxFile || total_ + *size > kMaxTotal) {
        problem = "'" + path + "' has " + std::to_string(size.value_or(0)) +
                  " bytes; a file may have 256 MB, all together 1 GB";
        return std::nullopt;
    }
    std::string text(size_t(*size), '\0');
    if (!read_file(whole, text)) {
        problem = "'" + path + "' cannot be read";
        return std::nullopt;
    }
    total_ += size_t(*size);
    return text;
}

}  // namespace epode::robots

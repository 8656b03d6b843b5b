// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// XML with the file and line of every element, on pugixml. Entities of a document's own and depths over 512 are
// refused, so what is read is never larger than the file.
#pragma once

#include <memory>
#include <optional>
#include <pugixml.hpp>
#include <string>
#include <vector>

#include "robots/geometry.h"

namespace epode::robots {

struct Document {
    std::string path;
    pugi::xml_document tree;
    std::vector<size_t> line_ends;
    int line_at(ptrdiff_t offset) const;
};

// An element and where it stands. An empty one has no name and no children.
struct Element {
    pugi::xml_node node;
    const Document* document = nullptr;

    explicit operator bool() const { return bool(node); }
    std::string name() const { return node.name(); }
    bool has(const char* attribute) const { return bool(node.attribute(attribute)); }
    std::string text(const char* attribute) const { return node.attribute(attribute).value(); }
    Element child(const char* wanted) const { return {node.child(wanted), document}; }
    std::vector<Element> children() const;
    std::vector<Element> children(const char* wanted) const;
    int line() const { return document ? document->line_at(node.offset_debug()) : 0; }
    std::string file() const { return document ? document->path : std::string(); }
};

// Null and a problem, with its line, where the text is no XML or is refused.
std::unique_ptr<Document> parse_xml(const std::string& path, const std::string& text, std::string& problem);

// Numbers of a text, parted by blanks. False where there is anything else, or one that is not finite.
bool parse_numbers(const std::string& text, std::vector<double>& out);

}  // namespace epode::robots

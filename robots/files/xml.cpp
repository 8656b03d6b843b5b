// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See xml.h.
#include "robots/files/xml.h"

#include <algorithm>

#include "robots/files/number.h"

namespace epode::robots {

namespace {

constexpr int kMaxDepth = 512;

bool has_entities(const pugi::xml_node& root)
{
    for (const pugi::xml_node& node : root.children())
        if (node.type() == pugi::node_doctype &&
            std::string(node.value()).find("ENTITY") != std::string::npos)
            return true;
    return false;
}

class DepthWalker : public pugi::xml_tree_walker {
  public:
    bool for_each(pugi::xml_node&) override { return depth() <= kMaxDepth; }
};

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

}  // namespace

int Document::line_at(ptrdiff_t offset) const
{
    if (offset < 0) return 0;
    return 1 + int(std::lower_bound(line_ends.begin(), line_ends.end(), size_t(offset)) - line_ends.begin());
}

std::vector<Element> Element::children() const
{
    std::vector<Element> out;
    for (const pugi::xml_node& child : node.children())
        if (child.type() == pugi::node_element) out.push_back({child, document});
    return out;
}

std::vector<Element> Element::children(const char* wanted) const
{
    std::vector<Element> out;
    for (const pugi::xml_node& child : node.children(wanted)) out.push_back({child, document});
    return out;
}

std::unique_ptr<Document> parse_xml(const std::string& path, const std::string& text, std::string& problem)
{
    auto document = std::make_unique<Document>();
    document->path = path;
    for (size_t i = 0; i < text.size(); ++i)
        if (text[i] == '\n') document->line_ends.push_back(i);
    const pugi::xml_parse_result result = document->tree.load_buffer(
        text.data(), text.size(), pugi::parse_default | pugi::parse_doctype, pugi::encoding_utf8);
    DepthWalker walker;
    if (!result)
        problem = std::string(result.description()) + " at line " +
                  std::to_string(document->line_at(result.offset));
    else if (has_entities(document->tree))
        problem = "a document type with entities of its own is refused; write their values";
    else if (!document->tree.traverse(walker))
        problem = "elements are nested deeper than " + std::to_string(kMaxDepth);
    else
        return document;
    return nullptr;
}

bool parse_numbers(const std::string& text, std::vector<double>& out)
{
    out.clear();
    const char *at = text.data(), *end = at + text.size();
    while (at != end) {
        if (is_blank(*at)) {
            ++at;
            continue;
        }
        if (*at == '+' && at + 1 != end && at[1] != '-') ++at;
        double value = 0;
        const char* const next = read_number(at, end, value);
        if (!next || !std::isfinite(value) || (next != end && !is_blank(*next))) return false;
        out.push_back(value);
        at = next;
    }
    return true;
}

}  // namespace epode::robots

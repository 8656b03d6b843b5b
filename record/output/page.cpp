// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See page.h. The template has three marks, each the whole text of an element.
#include "record/output/page.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string_view>

#include "record/file/deflate.h"
#include "record/file/whole_file.h"
#include "record/output/animation.h"
#include "record/output/page_data.h"

namespace epode::record {

namespace {

namespace fs = std::filesystem;

std::vector<fs::path> places()
{
    if (const char* said = secure_getenv("EPODE_PAGE")) return {said};
    std::error_code error;
    const fs::path program = fs::read_symlink("/proc/self/exe", error);
    if (error) return {};
    const fs::path folder = program.parent_path();
    return {folder.parent_path() / "share/epode/replay.html",
            folder.parent_path().parent_path() / "page/replay.html"};
}

std::string base64(const std::vector<std::uint8_t>& bytes)
{
    static const char* const kLetters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (size_t i = 0; i < bytes.size(); i += 3) {
        const size_t left = bytes.size() - i;
        const std::uint32_t three = std::uint32_t(bytes[i]) << 16 |
                                    (left > 1 ? std::uint32_t(bytes[i + 1]) << 8 : 0) |
                                    (left > 2 ? std::uint32_t(bytes[i + 2]) : 0);
        text += kLetters[three >> 18];
        text += kLetters[three >> 12 & 63];
        text += left > 1 ? kLetters[three >> 6 & 63] : '=';
        text += left > 2 ? kLetters[three & 63] : '=';
    }
    return text;
}

void append_escaped(std::string& out, const std::string& text)
{
    for (char c : text) {
        if (c == '<') {
            out.append("&lt;");
        } else if (c == '&') {
            out.append("&amp;");
        } else {
            out.push_back(c);
        }
    }
}

// Everything up to the mark goes out, then the text in its stead; what follows the mark is left in `rest`.
bool replace_mark(std::string& out, std::string_view& rest, std::string_view mark, std::string_view text)
{
    const size_t at = rest.find(mark);
    if (at == std::string_view::npos) return false;
    out.append(rest.substr(0, at));
    out.append(text);
    rest.remove_prefix(at + mark.size());
    return true;
}

}  // namespace

std::string page_template(std::string& problem)
{
    problem = "there is no template of the replay page at";
    for (const fs::path& place : places()) {
        std::ifstream file(place, std::ios::binary);
        if (file) {
            problem.clear();
            return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
        }
        problem.append(" ").append(place.string());
    }
    problem += "; record/page/build makes it, with npm";
    return {};
}

bool write_page(const Recording& recording, const std::string& path, double fps, std::string& problem)
{
    const std::string text = page_template(problem);
    if (text.empty()) return false;
    if (!can_animate(recording, fps, problem)) return false;
    PageData data = make_page_data(recording, fps);
    for (const Columns& columns : data.smooth) rearrange(data.block, columns);
    const std::string name = recording.about_value("scene");
    std::string title, page;
    append_escaped(title, name.empty() ? "Recording" : name);
    std::string_view rest = text;
    if (!replace_mark(page, rest, "EPODE_TITLE", title) ||
        !replace_mark(page, rest, "EPODE_HEAD", data.head) ||
        !replace_mark(page, rest, "EPODE_DATA", base64(deflated(data.block)))) {
        problem = "the template of the replay page lacks a mark";
        return false;
    }
    page.append(rest);
    return write_whole(path, page, problem);
}

}  // namespace epode::record

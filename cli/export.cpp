// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See export.h.
#include "cli/export.h"

#include "record/file/writer.h"
#include "record/output/csv.h"
#include "record/output/glb.h"
#include "record/output/page.h"

namespace epode::cli {

namespace {

bool ends_with(const std::string& text, const std::string& ending)
{
    return text.size() > ending.size() &&
           text.compare(text.size() - ending.size(), ending.size(), ending) == 0;
}

}  // namespace

Format format_of(const std::string& path)
{
    if (ends_with(path, ".epr")) return Format::kRecording;
    if (ends_with(path, ".glb")) return Format::kGlb;
    if (ends_with(path, ".html")) return Format::kPage;
    if (ends_with(path, ".csv")) return Format::kCsv;
    return Format::kUnknown;
}

bool can_export(const std::string& path, std::string& problem)
{
    problem.clear();
    if (format_of(path) == Format::kUnknown)
        problem = "the ending of '" + path + "' is none of " + known_endings();
    if (format_of(path) == Format::kPage) record::page_template(problem);
    return problem.empty();
}

const char* known_endings() { return ".epr .glb .html .csv"; }

bool export_recording(const record::Recording& recording, const std::string& path, double fps,
                      std::string& problem)
{
    switch (format_of(path)) {
        case Format::kRecording:
            return record::write_file(recording, path, problem);
        case Format::kGlb:
            return record::write_glb(recording, path, fps, problem);
        case Format::kPage:
            return record::write_page(recording, path, fps, problem);
        case Format::kCsv:
            return record::write_csv(recording, path, problem);
        default:
            problem = std::string("its ending is none of ") + known_endings();
            return false;
    }
}

}  // namespace epode::cli

// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Height fields: see mjcf.h. An asset has its samples in a file, in the attribute elevation (row by row from the largest y down), or none:
// then they are 0, for a program to set. Each way they are scaled to 0 ... 1, and size has the half sides, the height of 1 and
// what is below 0.
#include "robots/heights/heights.h"

#include <algorithm>

#include "robots/read/mjcf.h"

namespace epode::robots {

bool Mjcf::read_field(const Attributes& a, Shape& shape)
{
    const std::string name = a.text("hfield");
    const auto it = fields_.find(name);
    if (it == fields_.end())
        return reading_.error(a.element(), "there is no height field '" + name + "'"), false;
    Field& asset = it->second;
    if (!asset.tried) asset.number = make_field(asset);
    asset.tried = true;
    shape.kind = ShapeKind::kHeights, shape.field = asset.number;
    return asset.number >= 0;
}

// -1 and an error where it is none.
int Mjcf::make_field(const Field& asset)
{
    HeightField field;
    std::string problem;
    std::vector<double> size;
    const std::string its = "height field '" + asset.element.text("name") + "' ";
    if (!reading_.numbers(asset.element, asset.element.text("size"), "size", 4, 4, size))
        return reading_.error(asset.element, its + "wants a size of four numbers"), -1;
    if (!(*std::min_element(size.begin(), size.end()) > 0))
        return reading_.error(asset.element, its + "has a size that is not positive"), -1;
    field.half_x = size[0], field.half_y = size[1], field.top = size[2], field.base = size[3];
    if (!read_samples(asset, field, problem)) return reading_.error(asset.element, its + problem), -1;
    size_t count = field.samples.size();
    for (const HeightField& other : model_.fields) count += other.samples.size();
    if (count > kMaxSamples)
        return reading_.error(asset.element, its + "is one too many: all fields may have " +
                                                 std::to_string(kMaxSamples) + " samples together"),
               -1;
    model_.fields.push_back(std::move(field));
    return int(model_.fields.size()) - 1;
}

bool Mjcf::read_samples(const Field& asset, HeightField& field, std::string& problem)
{
    if (asset.element.text("file").empty()) return read_elevation(asset.element, field, problem);
    field.path = reading_.files.resolve(asset.file, folder_of(root_.file()), problem);
    if (field.path.empty()) return false;
    const auto bytes = reading_.files.read(field.path, problem);
    if (!bytes) return false;
    const std::string type = asset.element.text("content_type");
    const bool is_png = type.empty() ? ending_of(field.path) == "png" : type == "image/png";
    if (read_heights(*bytes, is_png, field, problem)) return true;
    problem = "is read from '" + field.path + "', which " + problem;
    return false;
}

bool Mjcf::read_elevation(const Element& element, HeightField& field, std::string& problem)
{
    double rows = 0, columns = 0;
    reading_.number(element, "nrow", rows), reading_.number(element, "ncol", columns);
    if (!are_good_counts(rows, columns, problem)) return false;
    field.rows = int(rows), field.columns = int(columns);
    const size_t count = size_t(field.rows) * size_t(field.columns);
    field.samples.assign(count, 0);
    if (!element.has("elevation")) return true;
    if (!reading_.numbers(element, element.text("elevation"), "elevation", count, count, field.samples))
        return problem = "wants as many samples as rows times columns", false;
    turn_over(field), normalise(field.samples);
    return true;
}

}  // namespace epode::robots

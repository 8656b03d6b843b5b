// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// known.tsv: the cells that fail today, why, and how bad they may be. A cell that gets worse, a cell that fails
// and is not in the file, and a cell that is in the file and good are faults of a run. Its lines, parted by tabs:
//   reason NAME TEXT
//   fails SCENE.LAW METHOD REASON and six ceilings: steps of 1/60, 1/240 and 1 ms, awake, then with sleep; - is
//   a cell that is good
#pragma once

#include "result.h"

namespace epode::trials {

class Known {
  public:
    // Throws std::runtime_error, with the line, where the file is not as above.
    explicit Known(const std::string& path);

    // How bad the figure may be; below 0: the cell is not in the file.
    double ceiling(const Scene& scene, const Law& law, const Setting& setting) const;
    // Why a law fails in a method: the name of a reason, empty where there is none.
    std::string reason(const Scene& scene, const Law& law, Method method) const;
    const std::vector<std::pair<std::string, std::string>>& reasons() const { return reasons_; }
    // Writes the file again as these results are. Reasons stay; those of cells that did not fail before are "new".
    void write(const std::vector<Result>& results, const std::string& path) const;

  private:
    struct Line {
        std::string law, method, reason;
        double ceilings[6];
    };
    void read(const std::string& text);
    const Line* line(const std::string& law, const std::string& method) const;

    std::vector<std::pair<std::string, std::string>> reasons_;  // name, text
    std::vector<Line> lines_;
};

// What is wrong with the figure compared with the file, or empty.
std::string fault_of(const Known& known, const Result& result, const Law& law);

}  // namespace epode::trials

#pragma once

#include <cstdint>
#include <vector>

#include "core/accumulate/horizon/lanes16.h"

namespace noonmark {

/// The nearest few occluders of each cell in a band of rows, each building once.
class NearestLevels {
public:
    NearestLevels(int levels, int rows, int columns);

    void clear();

    /// A stretch of a row under one facet.
    struct Span {
        int row = 0;
        int first = 0;  ///< cells [first, end); 0 <= first < end <= columns
        int end = 0;
        double heightM = 0;  ///< of the occluding point above the ground, at column 0
        double slopeM = 0;   ///< what a column adds
        float nearestM = 0;  ///< heights below this are left out
        std::uint32_t building = 0;
    };
    /// Keeps, cell by cell, the lowest of each building and the lowest buildings of all.
    void add(const Span& span);

    /// One row of one level as ShadowSources has them: 0 = no occluder.
    void copyRow(int level, int row, float* heightM, std::uint32_t* building) const;

private:
    [[nodiscard]] std::size_t lineOf(int level, int row) const {
        return (std::size_t(level) * std::size_t(rows_) + std::size_t(row)) * std::size_t(linesPerRow_);
    }

    int levels_, rows_, columns_;
    int linesPerRow_;                   // of 16 cells
    std::vector<Line<float>> heightM_;  // level-major
    std::vector<Line<std::int32_t>> building_;
};

}  // namespace noonmark

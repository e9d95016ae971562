#pragma once

namespace noonmark {

/// Extends the ranges low[i] to high[i] by the values of a line at consecutive positions, minor + i x slope.
void widen(double minor, double slope, int count, double* low, double* high);

/// Where a block's lanes lie at consecutive positions: lane 0 at from + bend[i]; positions are clamped to
/// [first, end).
struct LanePlaces {
    const int* bend;
    int from, first, end;
};

/// The lanes, 0 to 16, at whole positions from low[i] up to but not including high[i]; none if firstLane[i]
/// is not below endLane[i].
void findLanesBetween(const double* low, const double* high, const LanePlaces& places, int count,
                      int* firstLane, int* endLane);

}  // namespace noonmark

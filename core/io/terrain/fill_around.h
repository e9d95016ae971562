#pragma once

#include <stop_token>
#include <vector>

namespace noonmark {

/// Interpolates every NaN cell of a row-major grid from the cells around it, weighted by their inverse
/// distance; gaps wider than 400 cells keep NaN cells in their middle. Ends early when stopped. Backend:
/// fill_around_gdal.cpp.
void fillFromAround(std::vector<float>& values, int columns, int rows, const std::stop_token& stop = {});

}  // namespace noonmark

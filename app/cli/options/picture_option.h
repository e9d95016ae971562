#pragma once

#include <CLI/CLI.hpp>

namespace noonmark::cli {

/// Adds --picture-width: the width of the PNG in pixels, in the range of makePicture().
void addPictureOption(CLI::App& command, int& widthPx);

}  // namespace noonmark::cli

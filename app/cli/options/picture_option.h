#pragma once

#include <CLI/CLI.hpp>

#include "core/measures/legend_choice.h"

namespace noonmark::cli {

/// Adds --picture-width: the width of the PNG in pixels, in the range of makePicture().
void addPictureOption(CLI::App& command, int& widthPx);

/// Adds the options of the legend: --show, --ramp, --reverse-ramp, --range, --classes.
void addLegendOptions(CLI::App& command, LegendChoice& legend);

}  // namespace noonmark::cli

#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/base/units.h"
#include "core/io/read_city.h"
#include "core/measures/legend_choice.h"

namespace noonmark::cli {

/// Accepts numbers from `lowest` to `highest`. CLI::Range would accept "nan".
CLI::Validator within(double lowest, double highest);

/// Parses LON,LAT in degrees; where there is a `heightM` to fill, also LON,LAT,H.
Result<LonLat> parseLonLat(const std::string& text, std::optional<double>* heightM = nullptr);

/// Adds an option that takes LON,LAT in degrees.
CLI::Option* addLonLatOption(CLI::App& command, const std::string& name, std::optional<LonLat>& place,
                             const std::string& about);

/// Adds --overwrite, for all commands that write files (core/io/files/check_output.h).
void addOverwriteOption(CLI::App& command, bool& overwrite);
/// Adds --with-project, for commands that measure a project (copyProject()).
void addProjectCopyOption(CLI::App& command, bool& withProject);

/// Adds --picture-width: the width of the PNG in pixels, in the range of makePicture().
void addPictureOption(CLI::App& command, int& widthPx);

/// Adds the options of the legend: --show, --ramp, --reverse-ramp, --range, --classes.
void addLegendOptions(CLI::App& command, LegendChoice& legend);

/// The files of a command and how to read them; shared by all commands that read a city.
struct ReadOptions {
    std::vector<std::string> files;
    std::string filesHelp = "City files, or sample:central-park-south, sample:grid";
    ReadSettings settings;
};

/// The city's files and its inventories of trees, none of which may be replaced.
std::vector<std::string> listNamedFiles(const ReadOptions& options);

/// Adds FILE... and one option per user-visible field of ReadSettings. `options` must outlive the parsing.
void addReadOptions(CLI::App& command, ReadOptions& options);

}  // namespace noonmark::cli

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/cli/command.h"
#include "core/base/warnings.h"
#include "core/io/shadows/shadow_drawing.h"
#include "scenarios/project/project.h"

namespace noonmark::cli {

/// The times at which shadows are drawn: of each day those named, or all of them while the sun is up.
struct DrawnTimeOptions {
    std::vector<std::string> days, times;
    int everyMin = 0;
    std::string zone;
};

/// --day, --times, --every and --zone. Returns --day, which is not required.
CLI::Option* addDrawnTimeOptions(CLI::App& command, DrawnTimeOptions& options);

/// The times with the sun up, in order. A time that was asked for by name and has no sun gives a warning.
/// Error: no time, a date, a time or a zone that cannot be read, or no time with the sun up.
Result<std::vector<DrawnTime>> listDrawnTimes(const DrawnTimeOptions& options, const City& city,
                                              Warnings& warnings);

/// What --region or --place asks to draw.
struct DrawnAreaOptions {
    std::string region;
    std::vector<std::string> places;
};
void addDrawnAreaOptions(CLI::App& command, DrawnAreaOptions& options);
/// The box around it; nothing where neither is given.
Result<std::optional<Box2>> findDrawnArea(const DrawnAreaOptions& options, const Project& project,
                                          const City& city);

}  // namespace noonmark::cli

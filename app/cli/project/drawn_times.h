#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/cli/base/command.h"
#include "core/io/shadows/shadow_drawing.h"
#include "core/io/shadows/write_shadows.h"
#include "scenarios/project/project.h"

namespace noonmark::cli {

/// --day, --times, --every and --zone. Returns --day, which is not required.
CLI::Option* addDrawnTimeOptions(CLI::App& command, DrawnTimeChoice& options);

/// Error: neither --times nor --every is given.
Result<void> checkTimesGiven(const DrawnTimeChoice& options);

/// --plane, of CAD files.
void addPlaneOption(CLI::App& command, DrawingPlane& plane, const char* help);

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

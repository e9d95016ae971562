#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "core/base/result.h"
#include "core/city/map_context.h"

namespace noonmark {

struct Project;

/// A picture of the ground that a project refers to: a file of its own, not copied into the project.
struct GroundPictureFile {
    std::filesystem::path path;  ///< absolute
    std::string sha256;          ///< lower-case hex, of the file when it was chosen
    std::string attribution;     ///< whose picture it is; printed wherever it is drawn; may be empty
    double opacity = 1;          ///< 0 to 1
    bool shown = true;           ///< on ground, maps and sheets
    bool operator==(const GroundPictureFile&) const = default;
};

/// As JSON, for the project's file.
std::string formatText(const GroundPictureFile& picture);
/// Nothing for any text that formatText() does not write: the file may come from anywhere.
std::optional<GroundPictureFile> parseGroundPicture(const std::string& text);

/// `project` with this picture on its ground, or none. `raster`: its pixels; null: they are not at hand, and
/// nothing is drawn.
Project withGroundPicture(Project project, std::optional<GroundPictureFile> file,
                          std::shared_ptr<const GroundRaster> raster);

}  // namespace noonmark

#pragma once

#include <stop_token>

#include "core/base/progress.h"
#include "scenarios/project/project.h"

namespace noonmark {

/// The ground that a photograph of this city is read for: its buildings with 500 m around them, local metres.
Box2 photographBox(const City& city);

/// A photograph's pixels, and its file with the file's hash.
struct Photograph {
    GroundPictureFile file;
    std::shared_ptr<const GroundRaster> raster;
};
/// Reads the file of `wanted`, whose hash is set. Error: readGroundRaster()'s; cancelled().
Result<Photograph> loadPhotograph(const GroundPictureFile& wanted, const City& city, Progress& progress,
                                  const std::stop_token& stop);

/// `project` with the photograph that its file names on the ground. A file that is missing, has changed or
/// cannot be read gives a warning, and the project stays as it is: without pixels.
Project withPhotographAtHand(Project project, Warnings& warnings, Progress& progress,
                             const std::stop_token& stop);

}  // namespace noonmark

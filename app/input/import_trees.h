#pragma once

#include <filesystem>
#include <memory>
#include <stop_token>
#include <vector>

#include "core/base/progress.h"
#include "core/io/trees/read_trees.h"
#include "scenarios/project/project.h"

namespace noonmark {

/// A project with the trees of files in its existing city.
struct TreesImported {
    std::shared_ptr<const City> before;  ///< the existing city without them
    Project project;
    std::size_t added = 0;
    Warnings warnings;  ///< of these files; the project's reading has them, too
};

/// Adds the trees of inventories, OpenStreetMap files and canopy rasters to the project's existing city, and
/// the files to its inputs. Files whose fields the user chose are not named in the settings of reading, which
/// cannot state them: only the project repeats them. Error: as readTrees().
Result<TreesImported> importTrees(Project project, const std::vector<std::filesystem::path>& files,
                                  const TreeReading& how, Progress& progress, const std::stop_token& stop);

}  // namespace noonmark

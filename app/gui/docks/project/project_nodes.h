#pragma once

#include <memory>

#include "app/gui/docks/project/project_model.h"

namespace noonmark {

/// The tree of a project. The displayed scenario is emphasized; the baseline is marked.
std::unique_ptr<ProjectNode> makeNodes(const Project& project, const std::string& shown,
                                       const std::string& baseline);

}  // namespace noonmark

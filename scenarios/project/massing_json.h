#pragma once

#include <nlohmann/json.hpp>

#include "scenarios/massing/tower_design.h"

namespace noonmark {

/// The design of a tower as it is saved with its edit (docs/project-file.md). What has its default is left
/// out.
nlohmann::ordered_json toJson(const TowerDesign& design);

/// The design that toJson() wrote. Throws nlohmann's exceptions or std::invalid_argument where a member is
/// missing, of the wrong type or out of range. The settings may still be impossible on the lot: makeMassing()
/// tells.
DesignOfShape parseDesign(const nlohmann::ordered_json& json);

}  // namespace noonmark

#pragma once

#include <string>
#include <vector>

#include "core/city/city.h"
#include "scenarios/edits/edit.h"
#include "scenarios/massing/massing.h"
#include "scenarios/project/project.h"

namespace noonmark {

/// A tower on a lot that is not built yet, as entered in the form.
struct TowerDraft {
    NamedLot lot;
    MassingSettings settings;
    std::string tower;     ///< id and name of the new building, not empty
    std::string replaces;  ///< id of the building that it replaces; empty: none
    bool operator==(const TowerDraft&) const = default;
};

/// The tower, and the edits that build it: the buildings on the lot are demolished; the tower replaces the
/// building it is meant for, or is added. Error: an invalid massing, with the limit. Takes about 5 ms.
struct DraftedTower {
    Massing massing;
    std::vector<Edit> edits;
};
Result<DraftedTower> draftTower(const City& city, const TowerDraft& draft);

/// "Tower 1", or with the first number that is not a building's id.
std::string freeTowerName(const City& city);
/// "Lot 1", or with the first number that is not used.
std::string freeLotName(const std::vector<NamedLot>& lots);

}  // namespace noonmark

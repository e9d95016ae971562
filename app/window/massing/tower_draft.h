#pragma once

#include <string>
#include <vector>

#include "core/city/city.h"
#include "scenarios/edits/edit.h"
#include "scenarios/massing/massing.h"
#include "scenarios/project/project.h"

namespace noonmark {

/// A tower on a lot that is not built yet: what the form states.
struct TowerDraft {
    NamedLot lot;
    MassingSettings settings;
    std::string tower;     ///< id and name of the new building, not empty
    std::string replaces;  ///< id of a building that it takes the place of; empty: none
    bool operator==(const TowerDraft&) const = default;
};

/// The tower, and the edits that build it: what stands on the lot is demolished, the tower replaces the
/// building it is for or is added. Error: a massing that cannot be, with the limit. Some 5 ms.
struct DraftedTower {
    Massing massing;
    std::vector<Edit> edits;
};
Result<DraftedTower> draftTower(const City& city, const TowerDraft& draft);

/// The height it would have: stated, or storeys x storey height. Metres.
double heightOf(const MassingSettings& settings);

/// The same with another height: whole storeys are stated as such.
MassingSettings withHeight(MassingSettings settings, double heightM);

/// "Tower 1", or the first number that no building has as its id.
std::string freeTowerName(const City& city);
/// "Lot 1", or the first number that no lot has.
std::string freeLotName(const std::vector<NamedLot>& lots);

}  // namespace noonmark

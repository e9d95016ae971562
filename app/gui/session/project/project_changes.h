#pragma once

#include <cstddef>
#include <string>

#include "scenarios/project/project.h"

namespace noonmark {

/// The kinds of parts that a project lists.
enum class ProjectPart { lot, region, place, scenario, weights, period, view, result };

/// "Proposal A", "Proposal B"... "Proposal Z", "Proposal 27": the first name that no scenario has.
std::string nextProposal(const std::vector<Scenario>& scenarios);

/// The name, or "name (2)", "name (3)"...: the first that no part of this kind has.
std::string freeName(const Project& project, ProjectPart part, const std::string& name);

/// Each function returns a changed project. ProjectSession::change() checks whether it is valid.
Project withScenario(Project project, const std::string& name, const std::string& base);
/// Error: the name is not allowed for a scenario.
Result<Project> renameIn(Project project, ProjectPart part, const std::string& from, const std::string& to);
/// Error: other scenarios start from this one.
Result<Project> without(Project project, ProjectPart part, const std::string& name);
/// Adds a copy under an unused name after the original; `made` receives the name.
Project duplicate(Project project, ProjectPart part, const std::string& name, std::string& made);
/// Changes the base of a scenario; empty or "Existing": the existing city.
Project rebase(Project project, const std::string& scenario, const std::string& base);
/// Changes the kind of a place.
Project withPlaceKind(Project project, const std::string& place, PlaceKind kind);
Project withOutline(Project project, const std::string& lot, Footprint outline);
Project withRoads(Project project, const std::string& lot, const std::vector<RoadFront>& roads);
/// What became of places that were added.
struct PlacesAdded {
    std::size_t added = 0;
    std::size_t replaced = 0;  ///< earlier places of the same source
    std::size_t same = 0;      ///< left out: the project has them, outline and all
};
/// Adds places. One with the source of an earlier place replaces it, so that a file can be read again; one
/// whose name is taken is numbered.
Project withPlaces(Project project, std::vector<Place> places, PlacesAdded& added);
/// The same, but every place of the project stays as it is.
Project withMorePlaces(Project project, std::vector<Place> places, PlacesAdded& added);
Project withoutEdit(Project project, const std::string& scenario, std::size_t position);

}  // namespace noonmark

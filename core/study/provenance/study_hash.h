#pragma once

#include <string>

#include "core/city/trees/tree.h"
#include "core/study/study.h"

namespace noonmark {

/// SHA-256 of a city's geometry, position, terrain and water, without names and sources: equal for cities
/// with identical shadows. Lower-case hex. O(points), some 0.1 s for 43,000 buildings.
std::string hashCity(const City& city);

/// SHA-256 of everything that a result depends on: the version of the program, the city's geometry, position,
/// terrain and water, and the settings. Names, sources and the memory limit are not included. Lower-case hex.
/// O(points).
std::string hashStudy(const City& city, const StudySettings& settings);

/// SHA-256 of the version of the program and the settings, region included, without any city.
std::string hashSettings(const StudySettings& settings);

/// "2:" and the SHA-256 of the settings on which figures depend, and of nothing else: period, air, engine,
/// cells and the region's outline, whatever its name; not the program's version. Equal before and after the
/// settings are stored in a project. The number is that of the way to hash; results of earlier ways stay
/// current (QuestionHashes).
std::string hashQuestion(const StudySettings& settings);

/// All hashes that results with the same settings may state.
struct QuestionHashes {
    std::string current;   ///< hashQuestion()
    std::string version1;  ///< without a number, in results saved before there were two ways
    [[nodiscard]] bool matches(const std::string& saved) const {
        return saved == current || saved == version1;
    }
};
QuestionHashes listHashes(const StudySettings& settings);

/// SHA-256 of what shades and stands: a building's geometry, without names and sources.
std::string hashBuilding(const Building& building);
/// The same of a tree.
std::string hashTree(const Tree& tree, const LeafDays& leafDays);

}  // namespace noonmark

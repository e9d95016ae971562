#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "core/city/trees/tree.h"
#include "core/engines/api/shadow_field.h"

namespace noonmark {

/// How many trees there are, by the source of height and of crown, and when those that lose their leaves have
/// them ("04-15").
nlohmann::ordered_json treesJson(const Trees& trees);
/// The same, and what was measured of them.
nlohmann::ordered_json treesJson(const Trees& trees, const ShadowField& field);

/// "1,204; heights: 1,000 measured, 204 estimated; crowns: 1,204 estimated"
std::string describeTrees(const Trees& trees);
/// "300 can reach a receiver, of 1,204; heights: ...; trunks are left out"
std::string describeTrees(const Trees& trees, const ShadowField& field);

}  // namespace noonmark

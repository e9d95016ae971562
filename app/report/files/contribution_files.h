#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/io/files/check_output.h"
#include "core/study/contributions/place_contributions.h"

namespace noonmark {

/// contributions.csv and contributions.gpkg of a place, as those of a study, and by_month.csv.
std::vector<std::string> contributionFileNames();

/// Writes them, all or none, as what `study` holds of the place. Returns the paths written.
Result<std::vector<std::filesystem::path>> writeContributionFiles(const Study& study,
                                                                  const PlaceContributions& of,
                                                                  const std::filesystem::path& folder,
                                                                  const OutputRules& rules);

}  // namespace noonmark

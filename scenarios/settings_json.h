#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/study/provenance/repeat_command.h"
#include "core/study/study.h"
#include "core/study/text/region_text.h"

namespace noonmark {

/// What a computation was asked: period, region, cells, engine and its settings, the program. Keys as in
/// study.json.
nlohmann::ordered_json settingsJson(const StudySettings& settings);

/// The question of an impact or a score, which takes a project and has its own `options`.
RepeatQuestion projectQuestion(const std::string& command, const StudySettings& settings,
                               const Provenance& provenance, const std::string& engineKey,
                               std::vector<RepeatOption> options);

/// Whether its command names region.geojson, which then lies beside the outputs.
inline bool needsRegionFile(const Provenance& provenance) { return provenance.region == regionFileName; }

}  // namespace noonmark

#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/study/provenance/repeat_command.h"
#include "core/study/study.h"
#include "core/study/text/region_text.h"

namespace noonmark {

/// The settings of a computation: period, air, region, cells, engine with its settings, and program version.
/// Keys as in study.json.
nlohmann::ordered_json settingsJson(const StudySettings& settings);

/// The inputs of makeRepeatCommand() for an impact or a score, which read a project and have their own
/// `options`.
RepeatQuestion projectQuestion(const std::string& command, const StudySettings& settings,
                               const Provenance& provenance, const std::string& engineKey,
                               std::vector<CommandOption> options);

/// Whether the repeat command names region.geojson, which must then be written beside the outputs.
inline bool needsRegionFile(const Provenance& provenance) { return provenance.region == regionFileName; }

}  // namespace noonmark

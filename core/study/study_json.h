#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "core/study/study.h"

namespace noonmark {

/// How long each file took to write, by its name, s. Files are written side by side.
using FileSeconds = std::map<std::string, double>;

/// studyJson() with the times of files that were written before it, as `write_seconds`.
std::string studyJson(const Study& study, const FileSeconds& writeSeconds);

/// `period` of study.json: as it was asked for, and what its steps count. The air of `observer` sets the
/// altitude of sunrise.
nlohmann::ordered_json periodJson(const Period& period, const SunSteps& sun, const Observer& observer);

/// `observer` of study.json: whose sun it is.
nlohmann::ordered_json observerJson(const Observer& observer);

/// `sun_frame` of study.json: the sun's direction in the frame of the geometry, with the remaining error at
/// the region's farthest corner.
nlohmann::ordered_json sunFrameJson(const City& city, const StudySettings& settings, const SunSteps& sun);

/// `region` of study.json: name, area, extent in degrees.
nlohmann::ordered_json regionJson(const Region& region, const Frame& frame);

}  // namespace noonmark

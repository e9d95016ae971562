#pragma once

#include <optional>
#include <string>

#include "core/io/settings/read_settings.h"

namespace noonmark {

/// The settings that differ from the defaults of ReadSettings, as JSON on one line; empty if none do. `frame`
/// is omitted: it belongs to the open city.
std::string formatText(const ReadSettings& reading);

/// Parses the output of formatText(); nothing for other text.
std::optional<ReadSettings> readSettingsFrom(const std::string& text);

}  // namespace noonmark

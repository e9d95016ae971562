#pragma once

#include <optional>
#include <string>

#include "core/io/read_city.h"

namespace noonmark {

/// What differs from the defaults of ReadSettings, as JSON of one line; empty where nothing does. `frame` is
/// left out: it belongs to the city that is open.
std::string textOf(const ReadSettings& reading);

/// What textOf() wrote; nothing for other text.
std::optional<ReadSettings> readSettingsFrom(const std::string& text);

}  // namespace noonmark

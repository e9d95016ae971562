#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/describe/field.h"
#include "core/io/settings/read_settings.h"

namespace noonmark {

/// All settings of reading a city but the frame, which no user sets; the two tables below are part of it.
const Fields<ReadSettings>& readSettingsFields();

/// Where buildings stand: also of a proposal being read.
const Fields<ReadSettings>& standFields();

/// The axis and the unit of a mesh's coordinates: also of a proposal being read.
const Fields<ReadSettings>& meshAxesFields();

/// How a user states the field with this key on the command line, for messages: "--stand absolute".
std::string readOption(std::string_view key, std::string_view value = {});

/// The settings that differ from the defaults of ReadSettings, as JSON on one line; empty if none do. `frame`
/// is omitted: it belongs to the open city.
std::string formatText(const ReadSettings& reading);

/// Parses the output of formatText(); nothing for other text.
std::optional<ReadSettings> readSettingsFrom(const std::string& text);

}  // namespace noonmark

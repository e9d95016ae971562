#pragma once

#include <QString>
#include <optional>

#include "core/io/read_city.h"

namespace noonmark {

/// What differs from the usual way of reading, as JSON of one line; empty where nothing does. Frame is left
/// out: it belongs to the city that is open.
QString textOf(const ReadSettings& reading);

/// What textOf() wrote; nothing for other text.
std::optional<ReadSettings> readingFrom(const QString& text);

}  // namespace noonmark

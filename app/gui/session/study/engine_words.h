#pragma once

#include <QString>
#include <string_view>

namespace noonmark {

/// A name or description of an engine or of one of its options, which core writes in English, in the language
/// of the window. A word that is not in the list stays.
QString translateEngineWord(std::string_view english);

}  // namespace noonmark
